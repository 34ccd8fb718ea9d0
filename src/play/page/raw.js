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

  /// A CSV file of a language whose decimals take the comma, as others have it.
  const with_points = (text) => {
    const rows = text.trim().split(/\s*\n\s*/);
    const is_such = rows.length > 1 && rows.every((row) => /^[^\s;[\]]+(;[^\s;[\]]+)+$/.test(row));
    return is_such ? rows.map((row) => row.replace(/,/g, '.').replace(/;/g, ',')).join('\n') : text;
  };
  /// Brackets and names of other languages, and a semicolon at the end, say nothing.
  const plain = (text) => with_points(text).replace(/,\s*dtype=[^)]*/, '').replace(/^[^=]*=/, '')
    .replace(/\.\.\.\s*\n/g, ' ')
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

  /// The textbook's name of the problem that stands there, if it is one of its.
  const known_name = () => Object.keys(examples)
    .find((name) => examples[name].slice(0, 2).join('\n') === problem()) || '';

  /// Who follows a link wants its step: in view, and under the keys.
  function turn_to_frame() {
    by_id('frame').scrollIntoView({ block: 'center' });
    by_id('frame').contentWindow.focus();
  }

  /// The page of a typed problem, which begins with `linked` or with the first example.
  function start(module, { lcp: linked, at: linked_at }) {
    const background = new play.Background(module);
    const explore = async (at) => {
      say('tracing the pivots ..');
      by_id('examples').value = known_name();
      by_id('frame').addEventListener('load', () => {
        if (at && explorer_shown()?.open_at(at)) turn_to_frame();
      }, { once: true });
      say(await play.explore(background, 'lcp', problem()));
    };
    const take = (text, at) => {
      show(text);
      return explore(at);
    };
    by_id('examples').append(h('option', { value: '', hidden: true }, 'none: your own'), ...Object.entries(examples).map(([name, [, , words]]) =>
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
    return take(linked || examples.two_by_two.slice(0, 2).join('\n'), linked_at);
  }

  play.raw = { start, examples };
})();
