// All variables with their meanings; built when it is first opened.
(() => {
  const { h, table, by_id } = drawing.elements;
  const { name } = explorer.elements;

  function create(app) {
    const { problem } = app;
    const n = problem.size;
    const details = by_id('legend');
    const named = (variable) => [name(problem.names[variable]),
      h('span', { class: 'meaning' }, problem.meanings[variable] || '')];
    details.addEventListener('toggle', () => {
      if (!details.open || by_id('legend-list').hasChildNodes()) return;
      by_id('legend-list').append(
        table('legend', ['pair', 'w, the residual', 'z, the unknown'],
          [...Array(n).keys()].map((i) => [i + 1, named(i), named(n + i)])),
        h('p', {}, name('z0'), ' ', problem.meanings[2 * n] || 'the artificial variable'));
    });
  }

  explorer.view_legend = { create };
})();
