// The dictionary in whole numbers over one common denominator (Bareiss): every division is exact
// and the numbers stay as short as determinants are, without a gcd in the inner loop.
//
// A variable x of a row with denominators is kept as x' = factor * x, so that the start is whole.
(() => {
  const { make, parse, gcd } = explorer.fractions;

  class FractionDictionary extends explorer.Dictionary {
    arithmetic = explorer.fractions;

    static from(rows, columns, entries, values) {
      const factor = Array(rows.length + columns.length).fill(1n);
      const table = [];
      const right = values[0].map(() => []);
      rows.forEach((variable, r) => {
        const row = entries[r].map(parse);
        const value = values[r].map(parse);
        let common = 1n;
        for (const { d } of [...row, ...value]) common = common / gcd(common, d) * d;
        factor[variable] = common;
        table.push(row.map(({ n, d }) => n * (common / d)));
        value.forEach(({ n, d }, k) => right[k].push(n * (common / d)));
      });
      const dictionary = new FractionDictionary(rows, columns, table, right);
      return Object.assign(dictionary, { denominator: 1n, factor });
    }

    pivot(r, c) {
      const { table, values, denominator } = this;
      // A negative pivot flips all signs, so that the denominator stays positive.
      const flip = table[r][c] < 0n ? -1n : 1n;
      const pivot = flip * table[r][c];
      const row = table[r];
      const updated = (x, factor, y) => {
        if (factor === 0n || y === 0n) return x === 0n ? 0n : x * pivot / denominator;
        return (x * pivot - flip * factor * y) / denominator;
      };
      for (let i = 0; i < this.size; ++i) {
        if (i === r) continue;
        const factor = table[i][c];
        table[i] = table[i].map((x, j) => (j === c ? flip * factor : updated(x, factor, row[j])));
        for (const value of values) value[i] = updated(value[i], factor, value[r]);
      }
      table[r] = row.map((x, j) => (j === c ? flip * denominator : -flip * x));
      for (const value of values) value[r] = -flip * value[r];
      this.denominator = pivot;
    }

    pivot_quality(r, c) { return this.table[r][c] === 0n ? 0 : 1; }

    entry(r, c) {
      const { factor, rows, columns } = this;
      const x = this.table[r][c];
      return x === 0n ? explorer.fractions.zero
        : make(x * factor[columns[c]], this.denominator * factor[rows[r]]);
    }

    value(r) {
      const common = this.denominator * this.factor[this.rows[r]];
      return this.values.map((value) => make(value[r], common));
    }

    // A row's own factor cancels in every ratio: nothing is scaled.
    scaled_entry(r, c) { return this.table[r][c]; }
    scaled_value(r, level) { return this.values[level][r]; }
    is_noise() { return false; }
    is_value_noise() { return false; }
    unit_column(row) { return this.rows.map((_, r) => (r === row ? this.denominator : 0n)); }
    least_rate() { return 0n; }

    keep_smallest(candidates, rates, values) {
      let kept = [];
      for (const r of candidates) {
        const best = kept[0];
        const difference = kept.length ? values[r] * rates[best] - values[best] * rates[r] : -1n;
        if (difference < 0n) kept = [r];
        else if (difference === 0n) kept.push(r);
      }
      return kept;
    }

    ratio(r, c) {
      const rate = -this.table[r][c] * this.factor[this.columns[c]];
      return this.values.map((value) => make(value[r], rate));
    }
  }

  explorer.FractionDictionary = FractionDictionary;
})();
