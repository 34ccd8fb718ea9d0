// What is wrong with a page's looks. Each of these runs in the page and uses nothing from outside.

/// Runs in the page: what lies outside its place, as sentences. `least`: pixels of text.
export function layout_faults({ viewport, least }) {
  const found = [];
  // Not innerWidth: a phone widens that to what it has to show.
  if (document.documentElement.scrollWidth > viewport) found.push('scrolls sideways');
  for (const text of document.querySelectorAll('svg text')) {
    const drawing = text.ownerSVGElement;
    const factor = drawing.getBoundingClientRect().width / drawing.viewBox.baseVal.width;
    if (parseFloat(getComputedStyle(text).fontSize) * factor < least)
      found.push(`small text in a drawing: ${text.textContent}`);
    const [inner, outer] = [text.getBoundingClientRect(), drawing.getBoundingClientRect()];
    if (inner.width > 0 && (inner.left < outer.left - 2 || inner.right > outer.right + 2
      || inner.top < outer.top - 3 || inner.bottom > outer.bottom + 3))
      found.push(`cut text in a drawing: ${text.textContent}`);
  }
  return found;
}

/// Runs in the page: words of plots and panels that cover each other, as sentences.
export function covered_words() {
  const found = [];
  for (const drawing of document.querySelectorAll('svg.drawing')) {
    const texts = [...drawing.querySelectorAll('text')]
      .map((text) => [text.textContent, text.getBoundingClientRect()]);
    const factor = drawing.getBoundingClientRect().width / drawing.viewBox.baseVal.width;
    texts.forEach(([a, p], i) => texts.slice(i + 1).forEach(([b, q]) => {
      const across = Math.min(p.right, q.right) - Math.max(p.left, q.left);
      const down = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
      if (across > 3 * factor && down > 4 * factor) found.push(`"${a}" covers "${b}"`);
    }));
  }
  return found;
}

/// Runs in the page: colours that stand out too little, as sentences.
export function contrast_faults() {
  const parse = (text) => {
    const parts = text.match(/[\d.]+/g).map(Number);
    return { rgb: parts.slice(0, 3), alpha: parts.length > 3 ? parts[3] : 1 };
  };
  const luminance = (rgb) => rgb.map((x) => x / 255)
    .map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4))
    .reduce((sum, x, k) => sum + x * [0.2126, 0.7152, 0.0722][k], 0);
  const contrast = (a, b) => {
    const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  };
  const background = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const { rgb, alpha } = parse(getComputedStyle(e).backgroundColor);
      if (alpha === 1) return rgb;
    }
    return [255, 255, 255];
  };
  const found = new Set();
  let texts = 0;
  let lines = 0;
  for (const element of document.querySelectorAll('body *, svg text')) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3
      && node.textContent.trim());
    const style = getComputedStyle(element);
    const drawing = element.ownerSVGElement;
    if (own && !['STYLE', 'title', 'desc', 'style'].includes(element.tagName)
      && element.getClientRects().length > 0) {
      texts += 1;
      const ratio = contrast(parse(drawing ? style.fill : style.color).rgb, background(element));
      if (!(ratio >= 4.5)) found.add(`text "${element.textContent.slice(0, 30)}": ${ratio}`);
    }
    if (!drawing || !element.matches('.shaft, .head, .turning, .screw, .arc, .ring, .bar, .line'))
      continue;
    lines += 1;
    const paint = element.matches('.head, .bar') ? style.fill : style.stroke;
    const behind = [background(element)];
    const object = drawing.querySelector('.object');
    if (object) behind.push(parse(getComputedStyle(object).fill).rgb);
    for (const under of behind) {
      const ratio = contrast(parse(paint).rgb, under);
      if (!(ratio >= 3)) found.add(`line of class ${element.getAttribute('class')}: ${ratio}`);
    }
  }
  return { found: [...found], texts, lines, paper: luminance(background(document.body)) };
}
