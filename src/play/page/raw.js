// A problem that is typed: M and q, with textbook examples, explored pivot by pivot.
(() => {
  const { h, by_id } = drawing.elements;

  /// Of fixtures/textbook, by their names there.
  const examples = {
    two_by_two: ['2 1; 1 2', '-5 -6', 'the first one to do by hand'],
    cps_4_4_7: ['0 -1 2; 2 0 -2; -1 1 0', '-3 6 -1',
      'Cottle, Pang, Stone, Example 4.4.7: a plain run'],
    cps_4_4_16: ['1 -1; -1 1', '1 -1',
      'Cottle, Pang, Stone, Example 4.4.16: a tie that z0 must win'],
    murty_2_8: ['1 -1 -1 -1; -1 1 -1 -1; 1 1 2 0; 1 1 0 2', '3 5 -9 -5',
      'Murty, Example 2.8: a quadratic program'],
    murty_2_9: ['-1 0 -3; 1 -2 -5; -2 -1 -2', '-3 -2 -1', 'Murty, Example 2.9: a ray'],
    murty_2_11: ['-1.5 2; -4 4', '-5 17', 'Murty, Example 2.11: the cover decides'],
    murty_6_4: ['1 0 0 0; 2 1 0 0; 2 2 1 0; 2 2 2 1', '-16 -24 -28 -30',
      'Murty, chapter 6: 2^n pivots'],
    kostreva_1: ['1 2 0; 0 1 2; 2 0 1', '-1 -1 -1',
      'Kostreva, example 1: cycles if the first tied row leaves'],
    infeasible_psd: ['1 -1; -1 1', '1 -2', 'no solution, and the ray proves it'],
    copositive_ray: ['0 1; 0 0', '-1 1', 'no solution, and the ray proves nothing'],
    solvable_ray: ['-2 2 -2; 0 -1 -1; 3 3 0', '3 0 -4', 'a ray, although there is a solution'],
    floudas_10_2_2: ['1 1; 1 1', '-1 -1', 'a whole segment of solutions'],
  };

  /// Brackets and names of other languages, and a semicolon at the end, say nothing.
  const plain = (text) => text.replace(/^[^=]*=/, '').replace(/\.\.\.\s*\n/g, ' ')
    .replace(/(np|numpy)\.|(array|matrix)\(|\)/g, '').replace(/\]\s*,?\s*\[/g, ';').replace(/[[\]]/g, ' ').trim()
    .replace(/[;,\s]+$/, '');
  const problem = () => `${plain(by_id('M').value).replace(/[,;]?\s*[\n;]\s*/g, '; ')}\n${
    plain(by_id('q').value).replace(/\s*[;,\n]\s*/g, ' ')}`;

  const say = (words) => { by_id('raw-said').textContent = words; };

  /// "M\nq"
  function show(text) {
    const [M, q] = text.split('\n');
    by_id('M').value = M.replace(/; /g, ';\n');
    by_id('q').value = q || '';
  }

  /// The explorer in the frame, once it stands there.
  const explorer_shown = () => by_id('frame').contentWindow.lcpush?.app;

  /// The page of a typed problem, which begins with `linked` or with the first example.
  function start(module, { lcp: linked, at: linked_at }) {
    const background = new play.Background(module);
    const explore = async (at = '') => {
      say('tracing the pivots ..');
      by_id('frame').addEventListener('load', () => explorer_shown()?.open_at(at), { once: true });
      say(await play.explore(background, 'lcp', problem()));
    };
    const take = (text, at) => {
      show(text);
      return explore(at);
    };
    by_id('examples').append(...Object.entries(examples).map(([name, [, , words]]) =>
      h('option', { value: name }, words)));
    const example = () => take(examples[by_id('examples').value].slice(0, 2).join('\n'));
    by_id('examples').addEventListener('change', example);
    by_id('raw-pivots').addEventListener('click', () => explore());
    by_id('raw-link').addEventListener('click', async () =>
      say(await play.links.copy('lcp', problem(), explorer_shown()?.address.replace('#', '&'))));
    window.addEventListener('hashchange', async () => {
      const { lcp, at } = await play.links.carried();
      if (lcp && lcp !== problem()) take(lcp, at);
      else if (lcp) explorer_shown()?.open_at(at);
    });
    return linked ? take(linked, linked_at) : example();
  }

  play.raw = { start, examples };
})();
