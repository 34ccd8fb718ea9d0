// Lemke's method from any almost complementary dictionary on: what a branch of the path does. And
// its ratio test: which basic variable blocks the entering one first, and who else ties with it.
(() => {
  /// Column i of the basis inverse decides for the i-th perturbation of w (lexicographic rule).
  function lexicographic(dictionary, candidates, rates) {
    let kept = candidates;
    for (let i = 0; i < dictionary.size && kept.length > 1; ++i) {
      const column = dictionary.columns.indexOf(i);
      const values = column >= 0 ? dictionary.table_column(column)
        : dictionary.unit_column(dictionary.rows.indexOf(i));
      kept = dictionary.keep_smallest(kept, rates, values);
    }
    return kept[0];
  }

  /// {row, ties, tie_break, ratios}: row -1 when nothing blocks; ties are rows, [] when alone.
  /// At the entry of z0 (`cover`) the most violated row blocks, so all signs are reversed.
  function ratio_test(dictionary, column, rule, cover = false) {
    const rates = dictionary.rates(column, cover);
    const ratios = rates.map((rate, r) => {
      if (rate === null || (cover && !dictionary.is_negative(r))) return null;
      return dictionary.ratio(r, column);
    });
    let candidates = [...rates.keys()].filter((r) => rates[r] !== null);
    const found = (row, tie_break = 'none', ties = []) => ({ row, ties, tie_break, ratios });
    if (candidates.length === 0) return found(-1);
    for (let k = 0; k < dictionary.levels && candidates.length > 1; ++k)
      candidates = dictionary.keep_smallest(candidates, rates, dictionary.value_column(k));
    const ties = candidates;
    if (ties.length === 1) return found(ties[0]);
    const z0_row = cover ? -1 : dictionary.rows.indexOf(2 * dictionary.size);
    if (ties.includes(z0_row)) return found(z0_row, 'artificial', ties);
    if (rule === 'first_row') return found(ties[0], 'first_row', ties);
    return found(lexicographic(dictionary, ties, rates), 'lexicographic', ties);
  }

  const complement = (variable, n) => (variable < n ? variable + n : variable - n);

  /// The basis and the variable about to enter: if both come back, so does everything after.
  function state_key(dictionary, entering) {
    return `${[...dictionary.rows].sort((a, b) => a - b).join(' ')};${entering}`;
  }

  /// The direction in which nothing blocks: v >= 0 by unknown and its artificial part v0, with the
  /// largest entry 1.
  function ray_of(dictionary, column) {
    const n = dictionary.size;
    const { zero, one, number, divide } = dictionary.arithmetic;
    const direction = Array(2 * n + 1).fill(zero);
    direction[dictionary.columns[column]] = one;
    dictionary.rows.forEach((variable, r) => {
      if (!dictionary.is_noise(r, column)) direction[variable] = dictionary.entry(r, column);
    });
    const relevant = direction.slice(n);
    const largest = relevant.reduce((a, b) => (number(b) > number(a) ? b : a));
    const scaled = relevant.map((x) => divide(x, number(largest) > 0 ? largest : one));
    return { entering: dictionary.columns[column], v: scaled.slice(0, n), v0: scaled[n] };
  }

  /// Pivots from `dictionary` (which is changed) with `row` leaving for `entering` first, then by
  /// `rule`. `seen` maps the keys of earlier states to their pivot numbers; `first` is the number
  /// of the first pivot here. -> {status, pivots, ray, cycle}
  function run_lemke(dictionary, entering, row, options) {
    const { rule, limit = 500, seen = new Map(), first = 0 } = options;
    const n = dictionary.size;
    const artificial = 2 * n;
    const pivots = [];
    const end = (status, how = {}) => ({ status, pivots, ray: null, cycle: null, ...how });
    let next = entering;
    let chosen = row;
    while (pivots.length < limit) {
      const column = dictionary.columns.indexOf(next);
      const test = ratio_test(dictionary, column, rule, next === artificial);
      if (test.row < 0 && chosen === null)
        return end('ray', { ray: ray_of(dictionary, column) });
      const leaving_row = chosen ?? test.row;
      const leaving = dictionary.rows[leaving_row];
      dictionary.exchange(leaving_row, column);
      const z0_row = dictionary.rows.indexOf(artificial);
      pivots.push({
        entering: next, leaving, ratios: test.ratios,
        ties: test.ties.map((r) => (r === leaving_row ? leaving : dictionary.rows[r])),
        tie_break: chosen !== null && chosen !== test.row ? 'chosen' : test.tie_break,
        z0: z0_row < 0 ? null : dictionary.value(z0_row), basis: [...dictionary.rows],
      });
      chosen = null;
      if (leaving === artificial) return end('solved');
      next = complement(leaving, n);
      const key = state_key(dictionary, next);
      const index = first + pivots.length - 1;
      if (seen.has(key)) {
        const from_pivot = seen.get(key);
        return end('cycle', { cycle: { from_pivot, length: index - from_pivot } });
      }
      seen.set(key, index);
    }
    return end('pivot_limit');
  }

  explorer.lemke = { ratio_test, state_key, run_lemke };
})();
