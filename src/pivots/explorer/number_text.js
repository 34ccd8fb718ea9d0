// Numbers as text. A minus is a real minus sign; a fraction too long to read becomes a decimal.
(() => {
  const { minus, decimal } = drawing.numbers;
  const longest_fraction = 10;
  const longest_decimal = 8;

  /// With as many of the digits as fit into a cell.
  function short_decimal(x, digits) {
    for (let fewer = digits; fewer > 2; --fewer) {
      const text = decimal(x, fewer);
      if (text.length <= longest_decimal) return text;
    }
    return decimal(x, 2);
  }

  /// Is the decimal all of the fraction n/d?
  function is_whole(text, { n, d }) {
    const match = /^(-?)(\d+)(?:\.(\d+))?$/.exec(text.replace(minus, '-'));
    if (!match) return false;
    const [, sign, whole, rest = ''] = match;
    return BigInt(`${sign}${whole}${rest}`) * d === n * 10n ** BigInt(rest.length);
  }

  /// A fraction's decimal, marked where it is rounded.
  function fraction_decimal(x, number) {
    const whole = short_decimal(number, longest_decimal);
    if (is_whole(whole, x)) return whole;
    return `\u2248${short_decimal(number, 4)}`;
  }

  /// A scalar of the problem's arithmetic, for people.
  function scalar(problem, x, as_fraction = true, digits = 5) {
    if (!problem.exact) return short_decimal(x, digits);
    const text = explorer.fractions.text(x);
    if (as_fraction && text.length <= longest_fraction) return text.replace('-', minus);
    return fraction_decimal(x, problem.number(x));
  }

  /// A value by level: "3 S + 1/2".
  function value(problem, levels, as_fraction = true) {
    const digits = levels.length > 1 ? 4 : 5;
    const parts = levels.map((x) => scalar(problem, x, as_fraction, digits));
    if (levels.length === 1 || problem.number(levels[0]) === 0) return parts[parts.length - 1];
    const times = parts[0] === '1' ? 'S' : parts[0] === `${minus}1` ? `${minus}S` : `${parts[0]} S`;
    if (problem.number(levels[1]) === 0) return times;
    const about = [times, parts[1]].some((text) => text.startsWith('\u2248'));
    const [large, finite] = [times, parts[1]].map((text) => text.replace('\u2248', ''));
    const negative = finite.startsWith(minus);
    return `${about ? '\u2248' : ''}${large} ${negative ? minus : '+'} ${
      negative ? finite.slice(1) : finite}`;
  }

  /// Every digit, as the trace writes it.
  const full_scalar = (problem, x) => problem.arithmetic.text(x);

  function full_value(problem, levels) {
    const parts = levels.map((x) => full_scalar(problem, x));
    return levels.length === 1 || problem.number(levels[0]) === 0 ? parts[parts.length - 1] : parts;
  }

  /// The value of a row with the parts that are rounding alone set to 0.
  function value_of_row(problem, dictionary, r, as_fraction = true) {
    const levels = dictionary.value(r).map((x, k) =>
      (dictionary.is_value_noise(r, k) ? problem.scalar(0) : x));
    return value(problem, levels, as_fraction);
  }

  /// Numbers that are rounding beside the largest of their kind become 0.
  function without_noise(problem, list) {
    if (problem.exact) return list;
    const sizes = list.map((levels) => levels.map(Math.abs));
    const most = sizes.reduce((known, levels) => levels.map((x, k) => Math.max(x, known[k])));
    return list.map((levels) => levels.map((x, k) => (Math.abs(x) < 1e-12 * most[k] ? 0 : x)));
  }

  explorer.number_text = {
    value_of_row, without_noise, is_whole, decimal, scalar, value, full_scalar, full_value, minus,
  };
})();
