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
    static from(rows, columns, entries, values, levels) {
      const table = entries.map((row) => row.map(Number));
      const columns_of_values = Array.from({ length: levels }, (_, k) =>
        values.map((value) => Number(value[k])));
      const dictionary = new DecimalDictionary(rows, columns, table, columns_of_values);
      dictionary.scales = explorer.equilibrate(rows, columns, table, columns_of_values);
      return dictionary;
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
      const { scale } = this.scales;
      return this.table[r][c] * scale[this.rows[r]] / scale[this.columns[c]];
    }

    scaled_value(r, level) {
      return this.values[level][r] * this.scales.scale[this.rows[r]] * this.scales.level[level];
    }

    entry(r, c) { return this.table[r][c]; }
    value(r) { return this.values.map((value) => value[r]); }
    is_noise(r, c) { return Math.abs(this.scaled_entry(r, c)) < noise; }
    is_value_noise(r, level) { return Math.abs(this.scaled_value(r, level)) < noise; }

    // The ratio test: rates and values are scaled numbers.

    largest_rate(c) {
      let most = 0;
      for (let r = 0; r < this.size; ++r) most = Math.max(most, Math.abs(this.scaled_entry(r, c)));
      return most;
    }

    rates(c, direction) {
      const least = pivot_tolerance * this.largest_rate(c);
      return this.rows.map((_, r) => {
        const rate = direction * this.scaled_entry(r, c);
        return rate > least ? rate : null;
      });
    }

    value_column(level) { return this.rows.map((_, r) => this.scaled_value(r, level)); }
    table_column(c) { return this.rows.map((_, r) => -this.scaled_entry(r, c)); }
    unit_column(row) { return this.rows.map((_, r) => (r === row ? 1 : 0)); }

    /// Harris: a bound on the step with the tolerance, then all at or below it.
    keep_smallest(candidates, rates, values) {
      const bound = Math.min(...candidates.map((r) => (values[r] + tie_tolerance) / rates[r]));
      return candidates.filter((r) => values[r] <= bound * rates[r]);
    }

    is_negative(r) {
      for (let k = 0; k < this.levels; ++k)
        if (!this.is_value_noise(r, k)) return this.values[k][r] < 0;
      return false;
    }

    /// value / rate, level by level, in the units shown.
    ratio(r, c, direction) {
      const rate = direction * this.entry(r, c);
      return this.value(r).map((value) => value / rate + 0);
    }
  }

  explorer.DecimalDictionary = DecimalDictionary;
})();
