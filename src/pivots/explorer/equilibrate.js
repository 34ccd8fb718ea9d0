// Scales for the decisions in decimals: with every row, column and right-hand side near 1, one
// tolerance fits all problems. The numbers shown are never scaled.
(() => {
  /// The largest power of two p with p * p * x <= 1; 1 for zero.
  function reciprocal_root(x) {
    return x > 0 && Number.isFinite(x) ? 2 ** Math.floor(-Math.log2(x) / 2) : 1;
  }

  function largest(numbers) {
    let result = 0;
    for (const x of numbers) result = Math.max(result, Math.abs(x));
    return result;
  }

  /// scale[variable] with: scaled value = value * scale, for the variables of a start tableau;
  /// level[k] divides the k-th right-hand side by its largest scaled value.
  function equilibrate(rows, columns, table, values) {
    const n = rows.length;
    const artificial = 2 * n;
    const width = columns.length;
    const row_factor = new Float64Array(n).fill(1);
    const column_factor = new Float64Array(width).fill(1);
    const size = (r, c) => Math.abs(table[r][c]) * row_factor[r] * column_factor[c];
    const index = [...Array(n).keys()];
    for (let pass = 0; pass < 3; ++pass) {
      for (let c = 0; c < width; ++c) {
        if (columns[c] === artificial) continue;
        column_factor[c] *= reciprocal_root(largest(index.map((r) => size(r, c))));
      }
      for (let r = 0; r < n; ++r) {
        let most = 0;
        for (let c = 0; c < width; ++c)
          if (columns[c] !== artificial) most = Math.max(most, size(r, c));
        row_factor[r] *= reciprocal_root(most);
      }
    }
    const scale = new Float64Array(n + width).fill(1);
    rows.forEach((variable, r) => { scale[variable] = row_factor[r]; });
    columns.forEach((variable, c) => {
      if (variable === artificial)
        column_factor[c] = 1 / (largest(index.map((r) => size(r, c))) || 1);
      scale[variable] = 1 / column_factor[c];
    });
    const level = values.map((value) =>
      1 / (largest(index.map((r) => value[r] * row_factor[r])) || 1));
    return { scale, level };
  }

  explorer.equilibrate = equilibrate;
})();
