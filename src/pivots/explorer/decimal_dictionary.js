// The dictionary in doubles. Decisions are taken on scaled numbers, those shown are not scaled.
(() => {
  const tie_tolerance = 2 ** -37;   // as the solver's: 2^15 epsilons of scaled values
  const pivot_tolerance = 2 ** -30; // 2^22 epsilons of a scaled column's largest entry
  const noise = 2 ** -40;           // what is shown as a faint 0

  /// The same operations as explorer.fractions has, on plain numbers.
  explorer.decimals = {
    exact: false, zero: 0, one: 1, parse: Number, text: String, number: (x) => x,
    add: (a, b) => a + b, multiply: (a, b) => a * b, divide: (a, b) => a / b,
  };

  /// The largest power of two p with p * p * x <= 1; 1 for zero.
  const reciprocal_root = (x) =>
    (x > 0 && Number.isFinite(x) ? 2 ** Math.floor(-Math.log2(x) / 2) : 1);
  const largest = (numbers) => numbers.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

  /// With every row, column and right-hand side near 1, one tolerance fits all problems.
  /// scale[variable] with: scaled value = value * scale, for the variables of a start tableau;
  /// level[k] divides the k-th right-hand side by its largest scaled value.
  function equilibrate(rows, columns, table, values) {
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
  }

  class DecimalDictionary extends explorer.Dictionary {
    arithmetic = explorer.decimals;

    /// rows, columns: variable numbers; entries: rows of numbers; values: rows of level arrays.
    static from(rows, columns, entries, values) {
      const table = entries.map((row) => row.map(Number));
      const by_level = values[0].map((_, k) => values.map((value) => Number(value[k])));
      return Object.assign(new DecimalDictionary(rows, columns, table, by_level),
        equilibrate(rows, columns, table, by_level));
    }

    pivot(r, c) {
      const { table, values } = this;
      const pivot = table[r][c];
      const solved = table[r].map((x, j) => (j === c ? 1 / pivot : -x / pivot));
      const solved_values = values.map((value) => -value[r] / pivot);
      table.forEach((row, i) => {
        const factor = row[c];
        if (i === r || factor === 0) return;
        for (let j = 0; j < row.length; ++j)
          row[j] = j === c ? factor * solved[c] : row[j] + factor * solved[j];
        values.forEach((value, k) => { value[i] += factor * solved_values[k]; });
      });
      table[r] = solved;
      values.forEach((value, k) => { value[r] = solved_values[k]; });
    }

    /// How good the entry is as a pivot: its scaled size.
    pivot_quality(r, c) {
      return Math.abs(this.scaled_entry(r, c));
    }

    scaled_entry(r, c) {
      return this.table[r][c] * this.scale[this.rows[r]] / this.scale[this.columns[c]];
    }

    scaled_value(r, level) {
      return this.values[level][r] * this.scale[this.rows[r]] * this.level[level];
    }

    entry(r, c) { return this.table[r][c]; }
    value(r) { return this.values.map((value) => value[r]); }
    is_noise(r, c) { return Math.abs(this.scaled_entry(r, c)) < noise; }
    is_value_noise(r, level) { return Math.abs(this.scaled_value(r, level)) < noise; }
    unit_column(row) { return this.rows.map((_, r) => (r === row ? 1 : 0)); }
    least_rate(c) {
      return this.rows.reduce((most, _, r) => Math.max(most, pivot_tolerance
        * Math.abs(this.scaled_entry(r, c))), 0);
    }

    /// Harris: a bound on the step with the tolerance, then all at or below it.
    keep_smallest(candidates, rates, values) {
      const bound = Math.min(...candidates.map((r) => (values[r] + tie_tolerance) / rates[r]));
      return candidates.filter((r) => values[r] <= bound * rates[r]);
    }

    /// value / -entry, level by level, in the units shown.
    ratio(r, c) { return this.value(r).map((value) => value / -this.entry(r, c) + 0); }
  }

  explorer.DecimalDictionary = DecimalDictionary;
})();
