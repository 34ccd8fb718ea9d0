// Variables as mathematics writes them, pictures with their names, and what pictures of a basis are
// made of, as src/draw/markup.cpp writes it for those that stand still.
(() => {
  const { h, svg, parsed } = drawing.elements;

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

  let number = 0;
  /// A drawing with a title and a description that name it to a screen reader.
  function picture(attributes, title, description, ...children) {
    number += 1;
    const ids = [`title-${number}`, `description-${number}`];
    return svg('svg', { role: 'img', 'aria-labelledby': ids.join(' '), ...attributes },
      svg('title', { id: ids[0] }, title), svg('desc', { id: ids[1] }, description), ...children);
  }

  const polygon = (kind, corners) => svg('polygon',
    { class: kind, points: corners.map((p) => p.map((x) => x.toFixed(1)).join()).join(' ') });

  /// An arrow with its own head, so that colour is not needed to see its end; nothing if it is
  /// short.
  function arrow(kind, [x0, y0], [x1, y1]) {
    const size = Math.hypot(x1 - x0, y1 - y0);
    if (size < 2.5) return null;
    const [dx, dy] = [(x1 - x0) / size, (y1 - y0) / size];
    const head = Math.min(9, size * 0.6);
    const back = [x1 - dx * head, y1 - dy * head];
    const wing = (s) => [back[0] - dy * s * head * 0.42, back[1] + dx * s * head * 0.42];
    return svg('g', { class: kind },
      svg('line', { class: 'shaft', x1: x0, y1: y0, x2: back[0], y2: back[1] }),
      polygon('head', [[x1, y1], wing(1), wing(-1)]));
  }

  const marks = new Map();

  /// A mark that lcpush drew about 0.
  function mark(markup, [x, y]) {
    if (!marks.has(markup)) marks.set(markup, parsed(svg('g', {}), markup));
    const copy = marks.get(markup).cloneNode(true);
    copy.setAttribute('transform', `translate(${x} ${y})`);
    return copy;
  }

  explorer.elements = { name, names, picture, polygon, arrow, mark };
})();
