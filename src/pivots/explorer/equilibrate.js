// Scales for the decisions in decimals: with every row, column and right-hand side near 1, one
// tolerance fits all problems. The numbers shown are never scaled.
(() => {
  /// The largest power of two p with p * p * x <= 1; 1 for zero.
  const reciprocal_root = (x) =>
    (x > 0 && Number.isFinite(x) ? 2 ** Math.floor(-Math.log2(x) / 2) : 1);
  const largest = (numbers) => numbers.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

  /// scale[variable] with: scaled value = value * scale, for the variables of a start tableau;
  /// level[k] divides the k-th right-hand side by its largest scaled value.
  explorer.equilibrate = (rows, columns, table, values) => {
    const artificial = 2 * rows.length;
    const row_factor = rows.map(() => 1);
    const column_factor = columns.map(() => 1);
    const size = (r, c) => Math.abs(table[r][c]) * row_factor[r] * column_factor[c];
    const of_column = (c) => largest(rows.map((_, r) => size(r, c)));
    const of_row = (r) =>
      largest(columns.map((variable, c) => (variable === artificial ? 0 : size(r, c))));
    for (let pass = 0; pass < 3; ++pass) {
      columns.forEach((variable, c) => {
        if (variable !== artificial) column_factor[c] *= reciprocal_root(of_column(c));
      });
      rows.forEach((_, r) => { row_factor[r] *= reciprocal_root(of_row(r)); });
    }
    const scale = [];
    rows.forEach((variable, r) => { scale[variable] = row_factor[r]; });
    columns.forEach((variable, c) => {
      scale[variable] = variable === artificial ? of_column(c) || 1 : 1 / column_factor[c];
    });
    const level = values.map((value) => 1 / (largest(value.map((x, r) => x * row_factor[r])) || 1));
    return { scale, level };
  };
})();
