// The dictionary x_basic = values + table x_nonbasic: what both arithmetics share.
//
// rows and columns are variable numbers: w_i is i, z_i is n + i, z0 is 2n. table is a list of rows;
// values has a list for each level, [times S, finite] or [finite].
(() => {
  class Dictionary {
    constructor(rows, columns, table, values) {
      this.rows = [...rows];
      this.columns = [...columns];
      this.table = table;
      this.values = values;
      this.size = rows.length;
      this.width = columns.length;
      this.levels = values.length;
    }

    copy() {
      const twin = Object.assign(Object.create(Object.getPrototypeOf(this)), this);
      twin.rows = [...this.rows];
      twin.columns = [...this.columns];
      twin.table = this.table.map((row) => row.slice());
      twin.values = this.values.map((value) => value.slice());
      return twin;
    }

    exchange(r, c) {
      this.pivot(r, c);
      [this.rows[r], this.columns[c]] = [this.columns[c], this.rows[r]];
    }

    permute(rows, columns) {
      const from_row = rows.map((variable) => this.rows.indexOf(variable));
      const from_column = columns.map((variable) => this.columns.indexOf(variable));
      this.table = from_row.map((i) => from_column.map((j) => this.table[i][j]));
      this.values = this.values.map((value) => from_row.map((i) => value[i]));
      this.rows = [...rows];
      this.columns = [...columns];
    }

    // The ratio test: on scaled numbers, if the arithmetic scales.

    value_column(level) { return this.rows.map((_, r) => this.scaled_value(r, level)); }
    table_column(c) { return this.rows.map((_, r) => -this.scaled_entry(r, c)); }

    /// How fast each row falls as the column grows, or rises with `cover`; null: it cannot block.
    rates(c, cover) {
      const least = this.least_rate(c);
      return this.table_column(c).map((fall) => (cover ? -fall : fall))
        .map((rate) => (rate > least ? rate : null));
    }

    /// By its first level that is not zero.
    is_negative(r) {
      const k = this.values.findIndex((value, level) =>
        value[r] && !this.is_value_noise(r, level));
      return k >= 0 && this.values[k][r] < 0;
    }
  }

  explorer.Dictionary = Dictionary;

  /// Brings a dictionary to the given rows and columns, whatever pivots led there. The best pivot
  /// of those left is taken, so that doubles lose no more than a factorisation loses.
  explorer.toward = (dictionary, rows, columns) => {
    const target = new Set(rows);
    for (;;) {
      const leaving = [...dictionary.rows.keys()].filter((r) => !target.has(dictionary.rows[r]));
      if (leaving.length === 0) break;
      const entering = [...dictionary.columns.keys()]
        .filter((c) => target.has(dictionary.columns[c]));
      let [best, row, column] = [0, -1, -1];
      for (const r of leaving) {
        if (dictionary.arithmetic.exact && best > 0) break;
        for (const c of entering) {
          const quality = dictionary.pivot_quality(r, c);
          if (quality > best) [best, row, column] = [quality, r, c];
        }
      }
      if (row < 0) throw new Error('singular basis');
      dictionary.exchange(row, column);
    }
    dictionary.permute(rows, columns);
    return dictionary;
  };
})();
