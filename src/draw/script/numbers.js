// Numbers for people.
(() => {
  const minus = '\u2212';

  /// At most so many digits, no exponent where it can be helped; a dash for what is not known.
  function decimal(x, digits = 3) {
    if (x === 0) return '0';
    if (x === null || Number.isNaN(x)) return '\u2013';
    if (!Number.isFinite(x)) return x > 0 ? '\u221e' : `${minus}\u221e`;
    const size = Math.abs(x);
    let text;
    if (size >= 1e6 || size < 1e-4) {
      const [mantissa, exponent] = x.toExponential(Math.max(1, digits - 3)).split('e');
      text = `${Number(mantissa)}e${Number(exponent)}`;
    } else {
      text = String(Number(x.toPrecision(digits)));
    }
    return text.replace(/-/g, minus);
  }

  drawing.numbers = { minus, decimal };
})();
