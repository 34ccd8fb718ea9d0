// Finds and changes values in a scene's text and leaves all else as it is, comments included. It
// judges nothing: what is no scene, the solver says.
(() => {
  /// The text with what stands in comments and strings blanked out, character for character.
  function bare(text) {
    return text.replace(/"(?:[^"\\\n]|\\.)*"?|#[^\n]*/g, (part) => (part[0] === '"'
      ? `"${' '.repeat(Math.max(0, part.length - 2))}${part.length > 1 ? '"' : ''}`
      : ' '.repeat(part.length)));
  }

  /// Where a value ends that begins at `at`: at the line's end, or where its brackets close.
  function end_of_value(shown, at) {
    let depth = 0;
    for (let k = at; k < shown.length; k += 1) {
      if (shown[k] === '[') depth += 1;
      if (shown[k] === ']') depth -= 1;
      if (shown[k] === '\n' && depth <= 0) return k;
    }
    return shown.length;
  }

  function value_of(text) {
    const plain = text.replace(/"(?:[^"\\]|\\.)*"|#[^\n]*/g, (s) => (s[0] === '"' ? s : ''))
      .replace(/,\s*]/g, ']').replace(/(^|[[,\s])\+/g, '$1').replace(/\b_(?=\d)|(?<=\d)_/g, '');
    try {
      return JSON.parse(plain);
    } catch {
      return undefined;
    }
  }

  /// Powers of ten of the units that scenes know.
  const powers = { kg: 0, g: -3, m: 0, cm: -2, mm: -3, um: -6, N: 0, mN: -3, kN: 3, 'N m': 0,
    'N mm': -3, s: 0, ms: -3, 'rad/s': 0, 'm/s': 0, 'mm/s': -3, 'rad/s^2': 0, 'm/s^2': 0,
    'mm/s^2': -3, 'kg m^2': 0 };

  /// "120 g" is 0.12; every other text stays one.
  function in_si(value) {
    if (Array.isArray(value)) return value.map(in_si);
    const [, number, unit] = typeof value === 'string'
      && /^\s*\+?(-?\d[\d.]*(?:e[+-]?\d+)?)\s*(\D.*?)\s*$/i.exec(value) || [];
    if (/^deg(\/s(\^2)?)?$/.test(unit)) return number * Math.PI / 180;
    if (!Object.hasOwn(powers, unit ?? '')) return value;
    return powers[unit] < 0 ? number / 10 ** -powers[unit] : number * 10 ** powers[unit];
  }

  class Toml {
    constructor(text) {
      this.text = text;
      const shown = bare(text);
      /// {name, header, end, keys: {key: {from, to}}}, the first without a name.
      this.sections = [{ name: '', header: 0, end: 0, keys: {} }];
      let at = 0;
      while (at < shown.length) {
        const line_end = shown.indexOf('\n', at) < 0 ? shown.length : shown.indexOf('\n', at);
        const line = shown.slice(at, line_end);
        const header = /^\s*\[\[?\s*([\w-]+)\s*\]\]?\s*$/.exec(line);
        const entry = /^\s*([\w-]+)\s*=\s*/.exec(line);
        let next = line_end;
        if (header) {
          this.sections.push({ name: header[1], header: at, end: line_end, keys: {} });
        } else if (entry) {
          const from = at + entry[0].length;
          next = end_of_value(shown, from);
          const to = from + shown.slice(from, next).trimEnd().length;
          const section = this.sections.at(-1);
          section.keys[entry[1]] = { from, to };
          section.end = next;
        }
        at = next + 1;
      }
    }

    get(section, key) {
      const place = section?.keys[key];
      const value = place && value_of(this.text.slice(place.from, place.to));
      if (['name', 'title', 'bodies'].includes(key)) return value;
      const number = in_si(value);
      return key.startsWith('angular_') && number !== value && !Array.isArray(number)
        ? [0, 0, number] : number; // in a plane, about z
    }
    first(name) { return this.sections.find((section) => section.name === name); }
    /// The section of the finger or pusher called `name`.
    body(name) {
      return this.sections.find((section) => this.get(section, 'name') === name);
    }

    /// The text with another value there.
    with_value(section, key, value) {
      const written = written_value(value);
      const { text } = this;
      const place = section.keys[key];
      if (place) return text.slice(0, place.from) + written + text.slice(place.to);
      if (section.name === '') return `${key} = ${written}\n${text}`;
      return `${text.slice(0, section.end)}\n${key} = ${written}${text.slice(section.end)}`;
    }
    without(section, key) {
      const place = section.keys[key];
      if (!place) return this.text;
      const from = this.text.lastIndexOf('\n', place.from) + 1;
      const to = this.text.indexOf('\n', place.to);
      return this.text.slice(0, from) + (to < 0 ? '' : this.text.slice(to + 1));
    }
  }

  function written_value(value) {
    if (Array.isArray(value)) return `[${value.map(written_value).join(', ')}]`;
    return typeof value === 'string' ? JSON.stringify(value) : String(value);
  }

  play.Toml = Toml;
})();
