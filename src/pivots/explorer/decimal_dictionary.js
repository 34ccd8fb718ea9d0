// The dictionary x_basic = values + table x_nonbasic in doubles.
//
// Both dictionaries (see fraction_dictionary.js) have one interface: rows and columns (variable
// numbers: w_i is i, z_i is n + i, z0 is 2n), exchange, toward, entry and value for showing, and
// the comparisons of the ratio test.
(() => {
  const tie_tolerance = 2 ** -37;   // as the solver's: 2^15 epsilons of scaled values
  const pivot_tolerance = 2 ** -30; // 2^22 epsilons of a scaled column's largest entry
  const noise = 2 ** -40;           // what is shown as a faint 0

  class DecimalDictionary {
    constructor(rows, columns, table, values, scales) {
      this.rows = rows;
      this.columns = columns;
      this.table = table;
      this.values = values;
      this.scales = scales;
      this.size = rows.length;
      this.width = columns.length;
      this.levels = values.length;
      this.exact = false;
    }

    /// rows, columns: variable numbers; entries: rows of numbers; values: rows of level arrays.
    static from(rows, columns, entries, values, levels) {
      const width = columns.length;
      const table = new Float64Array(rows.length * width);
      entries.forEach((row, r) => row.forEach((x, c) => { table[r * width + c] = Number(x); }));
      const columns_of_values = Array.from({ length: levels }, (_, k) =>
        Float64Array.from(values, (value) => Number(value[k])));
      const scales = explorer.equilibrate(rows, columns, table, columns_of_values, 2 * rows.length);
      return new DecimalDictionary([...rows], [...columns], table, columns_of_values, scales);
    }

    copy() {
      return new DecimalDictionary([...this.rows], [...this.columns], this.table.slice(),
        this.values.map((value) => value.slice()), this.scales);
    }

    exchange(r, c) {
      const { table, width, size } = this;
      const pivot = table[r * width + c];
      const row = table.slice(r * width, (r + 1) * width);
      const solved = row.map((x) => -x / pivot);
      const solved_values = this.values.map((value) => -value[r] / pivot);
      solved[c] = 1 / pivot;
      for (let i = 0; i < size; ++i) {
        const factor = table[i * width + c];
        if (i === r || factor === 0) continue;
        const start = i * width;
        for (let j = 0; j < width; ++j) table[start + j] += factor * solved[j];
        table[start + c] = factor * solved[c];
        this.values.forEach((value, k) => { value[i] += factor * solved_values[k]; });
      }
      table.set(solved, r * width);
      this.values.forEach((value, k) => { value[r] = solved_values[k]; });
      [this.rows[r], this.columns[c]] = [this.columns[c], this.rows[r]];
    }

    /// How good the entry is as a pivot: its scaled size.
    pivot_quality(r, c) {
      return Math.abs(this.scaled_entry(r, c));
    }

    scaled_entry(r, c) {
      const { scale } = this.scales;
      return this.table[r * this.width + c] * scale[this.rows[r]] / scale[this.columns[c]];
    }

    scaled_value(r, level) {
      return this.values[level][r] * this.scales.scale[this.rows[r]] * this.scales.level[level];
    }

    permute(rows, columns) {
      const from_row = rows.map((variable) => this.rows.indexOf(variable));
      const from_column = columns.map((variable) => this.columns.indexOf(variable));
      const table = new Float64Array(this.table.length);
      from_row.forEach((i, r) => from_column.forEach((j, c) => {
        table[r * this.width + c] = this.table[i * this.width + j];
      }));
      this.table = table;
      this.values = this.values.map((value) => Float64Array.from(from_row, (i) => value[i]));
      this.rows = [...rows];
      this.columns = [...columns];
    }

    entry(r, c) { return this.table[r * this.width + c]; }
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
