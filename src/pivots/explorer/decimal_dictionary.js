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

  class DecimalDictionary extends explorer.Dictionary {
    arithmetic = explorer.decimals;

    /// rows, columns: variable numbers; entries: rows of numbers; values: rows of level arrays.
    static from(rows, columns, entries, values) {
      const table = entries.map((row) => row.map(Number));
      const by_level = values[0].map((_, k) => values.map((value) => Number(value[k])));
      return Object.assign(new DecimalDictionary(rows, columns, table, by_level),
        explorer.equilibrate(rows, columns, table, by_level));
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
