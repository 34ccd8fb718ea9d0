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

  /// Brackets of other languages, and a semicolon at the end, say nothing.
  const plain = (text) => text.replace(/\]\s*,?\s*\[/g, ';').replace(/[[\]]/g, ' ').trim()
    .replace(/[;,\s]+$/, '');
  const problem = () => `${plain(by_id('M').value).replace(/[,;]?\s*[\n;]\s*/g, '; ')}\n${
    plain(by_id('q').value).replace(/\s*[;,\n]\s*/g, ' ')}`;

  function create(app) {
    by_id('examples').append(...Object.entries(examples).map(([name, [, , words]]) =>
      h('option', { value: name }, words)));
    by_id('examples').addEventListener('change', () => {
      [by_id('M').value, by_id('q').value] = examples[by_id('examples').value];
    });
    by_id('raw-pivots').addEventListener('click', async () => {
      by_id('raw-said').textContent = 'tracing the pivots ..';
      by_id('raw-said').textContent = await app.explore('lcp', problem());
    });
    by_id('raw-link').addEventListener('click', async () => {
      by_id('raw-said').textContent = await play.links.copy('lcp', problem());
    });
  }

  /// From a link.
  function show(text) {
    const [M, q] = text.split('\n');
    by_id('M').value = M;
    by_id('q').value = q || '';
    by_id('raw').open = true;
    by_id('raw').scrollIntoView();
  }

  play.raw = { create, show, examples };
})();
