// Which basic variable blocks the entering one first, and who else ties with it.
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

  explorer.ratio_test = ratio_test;
})();
