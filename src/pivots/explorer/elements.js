// Making elements: h for HTML, svg for drawings, name for a variable as mathematics writes it.
(() => {
  const drawing = 'http://www.w3.org/2000/svg';

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
    fill(document.createElementNS(drawing, tag), attributes, children);

  /// Filled with markup that the tool wrote; never with anything that a user named.
  function parsed(element, markup) {
    element.innerHTML = markup;
    return element;
  }

  /// w12 with its number below; other names as they are.
  function name(text) {
    const match = /^([a-z])(\d+)$/.exec(text);
    if (!match) return h('span', { class: 'name' }, text);
    return h('span', { class: 'name' }, h('i', {}, match[1]), h('sub', {}, match[2]));
  }

  /// Names with commas between them; of many the first.
  const names = (texts, most) => [
    texts.slice(0, most).map((text, i) => [i > 0 && ', ', name(text)]),
    texts.length > most && ` and ${texts.length - most} more`];

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

  let number = 0;
  /// A drawing with a title and a description that name it to a screen reader.
  function picture(attributes, title, description, ...children) {
    number += 1;
    const ids = [`title-${number}`, `description-${number}`];
    return svg('svg', { role: 'img', 'aria-labelledby': ids.join(' '), ...attributes },
      svg('title', { id: ids[0] }, title), svg('desc', { id: ids[1] }, description), ...children);
  }

  explorer.elements = { h, svg, parsed, name, names, table, by_id, replace, picture };
})();
