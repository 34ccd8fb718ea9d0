// Making elements, and numbers for people.
(() => {
  const drawing = 'http://www.w3.org/2000/svg';

  function fill(element, attributes, children) {
    for (const [key, value] of Object.entries(attributes || {})) {
      if (value === null || value === undefined || value === false) continue;
      if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
      else element.setAttribute(key, value === true ? '' : String(value));
    }
    element.append(...children.flat(Infinity)
      .filter((x) => x !== null && x !== undefined && x !== false));
    return element;
  }

  const h = (tag, attributes, ...children) =>
    fill(document.createElement(tag), attributes, children);
  const svg = (tag, attributes, ...children) =>
    fill(document.createElementNS(drawing, tag), attributes, children);
  /// Filled with markup that the solver wrote of its own; never with what a user named.
  function parsed(element, markup) {
    element.innerHTML = markup;
    return element;
  }
  const by_id = (id) => document.getElementById(id);

  /// Three digits, no exponent where it can be helped.
  function decimal(x) {
    if (!Number.isFinite(x)) return '\u2013';
    const rounded = Number(x.toPrecision(3));
    if (rounded !== 0 && (Math.abs(rounded) >= 1e6 || Math.abs(rounded) < 1e-4))
      return rounded.toExponential().replace('e+', 'e');
    return String(rounded);
  }

  play.elements = { h, svg, parsed, by_id, decimal };
})();
