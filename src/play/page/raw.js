// A problem that is typed: M and q, with textbook examples, explored pivot by pivot.
(() => {
  const { h, by_id } = play.elements;

  const examples = {
    'two unknowns, one pivot after the other': ['2 1; 1 2', '-5 -6'],
    'a ray: no solution': ['-1 0; 0 -1', '-1 -1'],
    'two solutions': ['1 2; 2 1', '-4 -5'],
    'a skew matrix: a linear program': ['0 0 -1; 0 0 -2; 1 2 0', '3 4 -2'],
    'Murty, 3 unknowns: as many pivots as can be': ['1 2 2; 0 1 2; 0 0 1', '-4 -6 -7'],
    'Fathi, 3 unknowns': ['1 2 2; 2 5 6; 2 6 9', '-1 -1 -1'],
  };

  const problem = () => `${by_id('M').value.trim().replace(/;?\s*\n\s*/g, '; ')}\n${
    by_id('q').value.trim().replace(/\s*[;,\n]\s*/g, ' ')}`;

  function create(app) {
    by_id('examples').append(...Object.keys(examples).map((name) => h('option', {}, name)));
    by_id('examples').addEventListener('change', () => {
      [by_id('M').value, by_id('q').value] = examples[by_id('examples').value];
    });
    by_id('raw-pivots').addEventListener('click', async () => {
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

  play.raw = { create, show };
})();
