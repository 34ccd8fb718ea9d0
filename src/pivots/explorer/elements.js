// Variables as mathematics writes them, and pictures with their names.
(() => {
  const { h, svg } = drawing.elements;

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

  explorer.elements = { name, names, picture };
})();
