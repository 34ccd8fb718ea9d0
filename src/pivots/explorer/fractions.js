// Exact numbers: reduced fractions of BigInts, {n, d} with d > 0.
(() => {
  const absolute = (x) => (x < 0n ? -x : x);
  const bit_length = (x) => absolute(x).toString(16).length * 4;

  /// Lehmer's method: most quotients of Euclid's are found from the leading 50 bits alone.
  function gcd(first, second) {
    let a = absolute(first);
    let b = absolute(second);
    if (a < b) [a, b] = [b, a];
    while (b > 0xFFFFFFFFFFFFFn) {
      const shift = BigInt(Math.max(0, bit_length(a) - 50));
      let x = Number(a >> shift);
      let y = Number(b >> shift);
      let [A, B, C, D] = [1, 0, 0, 1];
      while (y + C !== 0 && y + D !== 0) {
        const quotient = Math.floor((x + A) / (y + C));
        if (quotient !== Math.floor((x + B) / (y + D))) break;
        [A, C] = [C, A - quotient * C];
        [B, D] = [D, B - quotient * D];
        [x, y] = [y, x - quotient * y];
      }
      if (B === 0) [a, b] = [b, a % b];
      else [a, b] = [BigInt(A) * a + BigInt(B) * b, BigInt(C) * a + BigInt(D) * b];
      if (a < b) [a, b] = [b, a];
    }
    if (b === 0n) return a;
    let small = Number(b);
    let rest = Number(a % b);
    while (rest > 0) [small, rest] = [rest, small % rest];
    return BigInt(small);
  }

  function make(n, d) {
    if (n === 0n) return { n: 0n, d: 1n };
    if (d === 1n) return { n, d };
    const g = d < 0n ? -gcd(n, d) : gcd(n, d);
    return { n: n / g, d: d / g };
  }

  /// "p/q", "p" or a whole number. Decimals belong to the other arithmetic.
  function parse(text) {
    const match = /^\s*([+-]?\d+)\s*(?:\/\s*(\d+))?\s*$/.exec(String(text));
    if (!match || (match[2] && BigInt(match[2]) === 0n)) throw new Error(`no fraction: ${text}`);
    return make(BigInt(match[1]), match[2] ? BigInt(match[2]) : 1n);
  }

  const text = (a) => (a.d === 1n ? String(a.n) : `${a.n}/${a.d}`);

  /// The nearest double, for numbers of any length.
  function to_number(n, d = 1n) {
    if (n === 0n) return 0;
    const shift = 64 - bit_length(n) + bit_length(d);
    const quotient = shift >= 0 ? (n << BigInt(shift)) / d : n / (d << BigInt(-shift));
    const half = Math.trunc(shift / 2); // in two steps: 2^-shift alone may underflow
    return Number(quotient) * 2 ** -half * 2 ** (half - shift);
  }

  const add = (a, b) => make(a.n * b.d + b.n * a.d, a.d * b.d);
  const multiply = (a, b) => make(a.n * b.n, a.d * b.d);
  const divide = (a, b) => make(a.n * b.d, a.d * b.n);
  const [zero, one] = [0n, 1n].map((n) => ({ n, d: 1n }));

  explorer.fractions = {
    exact: true, gcd, make, parse, text, to_number, number: ({ n, d }) => to_number(n, d),
    add, multiply, divide, zero, one,
  };
})();
