// Making elements: h for HTML, svg for drawings.
(() => {
  const present = (children) => children.flat(Infinity)
    .filter((x) => x !== null && x !== undefined && x !== false);

  function fill(element, attributes, children) {
    for (const [key, value] of Object.entries(attributes || {})) {
      if (value === null || value === undefined || value === false) continue;
      if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
      else element.setAttribute(key, value === true ? '' : String(value));
    }
    element.append(...present(children));
    return element;
  }

  const h = (tag, attributes, ...children) =>
    fill(document.createElement(tag), attributes, children);
  const svg = (tag, attributes, ...children) =>
    fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

  /// Filled with markup that lcpush wrote of its own; never with anything that a user named.
  function parsed(element, markup) {
    element.innerHTML = markup;
    return element;
  }

  /// heads: texts; rows: lists of cells, the first of them the row's head. `words`: a class for the
  /// last column.
  function table(kind, heads, rows, { caption, words } = {}) {
    const cell = (x, c, row) => (c === 0 ? h('th', { scope: 'row' }, x)
      : h('td', { class: c === row.length - 1 && words }, x));
    return h('table', { class: kind }, caption && h('caption', {}, caption),
      h('thead', {}, h('tr', {}, heads.map((text) => h('th', { scope: 'col' }, text)))),
      h('tbody', {}, rows.map((row) => h('tr', {}, row.map(cell)))));
  }

  const by_id = (id) => document.getElementById(id);

  const replace = (id, ...children) => by_id(id).replaceChildren(...present(children));

  drawing.elements = { h, svg, parsed, table, by_id, replace };
})();
