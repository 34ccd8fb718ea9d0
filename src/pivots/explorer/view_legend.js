// All variables with their meanings; built when it is first opened.
(() => {
  const { h, name, by_id } = explorer.elements;

  function create(app) {
    const { problem } = app;
    const n = problem.size;
    const details = by_id('legend');
    const row = (i) => h('tr', {}, h('th', { scope: 'row' }, i + 1),
      [i, n + i].map((variable) => h('td', {}, name(problem.names[variable]),
        h('span', { class: 'meaning' }, problem.meanings[variable] || ''))));
    details.addEventListener('toggle', () => {
      if (!details.open || by_id('legend-list').hasChildNodes()) return;
      by_id('legend-list').append(
        h('table', { class: 'legend' }, h('thead', {}, h('tr', {}, ['pair', 'w, the residual',
          'z, the unknown'].map((x) => h('th', { scope: 'col' }, x)))),
        h('tbody', {}, [...Array(n).keys()].map(row))),
        h('p', {}, name('z0'), ' ', problem.meanings[2 * n] || 'the artificial variable'));
    });
  }

  explorer.view_legend = { create };
})();
