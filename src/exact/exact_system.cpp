#include "exact/exact_system.hpp"

#include "exact/limbs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

// Whole numbers modulo the prime 2^61 - 1, whose remainders need no division.
using limbs::Limb;
constexpr int prime_bits = 61;
constexpr Limb prime = (Limb{1} << prime_bits) - 1;

Limb remainder(Limb a) {
  a = (a & prime) + (a >> prime_bits);
  return a >= prime ? a - prime : a;
}
Limb times(Limb a, Limb b) {
  const limbs::Wide product = limbs::Wide{a} * b;
  return remainder(static_cast<Limb>(product & prime) + static_cast<Limb>(product >> prime_bits));
}
Limb minus(Limb a, Limb b) { return a >= b ? a - b : a + prime - b; }

/// Fermat's little theorem.
Limb inverse_of(Limb a) {
  Limb result = 1;
  for (Limb exponent = prime - 2; exponent > 0; exponent >>= 1U, a = times(a, a))
    if ((exponent & 1U) != 0) result = times(result, a);
  return result;
}

/// A row times `unit`, in whole numbers.
struct WholeRow {
  std::vector<std::pair<std::size_t, BigInteger>> entries;
  BigInteger unit = 1;
};

std::vector<WholeRow> whole(const std::vector<ExactRow>& rows) {
  std::vector<WholeRow> result;
  for (const ExactRow& row : rows) {
    WholeRow& scaled = result.emplace_back();
    for (const ExactEntry& entry : row)
      scaled.unit = common_multiple(scaled.unit, entry.value.denominator());
    for (const ExactEntry& entry : row)
      scaled.entries.emplace_back(entry.column, entry.value.numerator() *
                                                    (scaled.unit / entry.value.denominator()));
  }
  return result;
}

/// Rows eliminated one by one modulo the prime: each gives up the pivots before it, and its first
/// column that is left is its own. Those of a row that is left with none depend on others.
class Factors {
public:
  struct Entry {
    std::size_t at;
    Limb value;
  };
  struct Step {
    std::size_t row, column;
    Limb inverse;             ///< of the pivot
    std::vector<Entry> taken; ///< earlier steps, and how often their rows were taken from this one
    std::vector<Entry> rest;  ///< columns beside the pivot, and their entries
  };
  std::vector<Step> steps;

  Factors(const std::vector<WholeRow>& rows, std::size_t columns) {
    std::vector<Limb> work(columns, 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const auto& [column, value] : rows[i].entries)
        work[column] = remainder(work[column] + value.modulo(prime));
      Step step{i, columns, 0, {}, {}};
      for (std::size_t k = 0; k < steps.size(); ++k) {
        if (work[steps[k].column] == 0) continue;
        const Limb by = times(std::exchange(work[steps[k].column], 0), steps[k].inverse);
        for (const Entry& e : steps[k].rest) work[e.at] = minus(work[e.at], times(by, e.value));
        step.taken.push_back({k, by});
      }
      for (std::size_t j = 0; j < columns; ++j) {
        const Limb value = std::exchange(work[j], 0);
        if (value == 0) continue;
        if (step.column < columns) {
          step.rest.push_back({j, value});
        } else {
          step.column = j;
          step.inverse = inverse_of(value);
        }
      }
      if (step.column < columns) steps.push_back(std::move(step));
    }
  }

  /// By columns, from right-hand sides by steps; what is no pivot is zero.
  std::vector<Limb> solve(std::vector<Limb> right, std::size_t columns) const {
    for (std::size_t k = 0; k < steps.size(); ++k)
      for (const Entry& e : steps[k].taken) right[k] = minus(right[k], times(e.value, right[e.at]));
    std::vector<Limb> x(columns, 0);
    for (std::size_t k = steps.size(); k-- > 0;) {
      Limb sum = right[k];
      for (const Entry& e : steps[k].rest) sum = minus(sum, times(e.value, x[e.at]));
      x[steps[k].column] = times(sum, steps[k].inverse);
    }
    return x;
  }
};

/// The fraction with numerator and denominator of at most `bits` that x is modulo `modulus`, by
/// Euclid's algorithm stopped half way; a denominator of 0 if there is none.
std::pair<BigInteger, BigInteger> fraction_of(const BigInteger& x, const BigInteger& modulus,
                                              std::size_t bits) {
  BigInteger a = modulus, b = x, s = 0, t = 1;
  while (b.bit_length() > bits) {
    BigInteger quotient, rest;
    BigInteger::divide(a, b, &quotient, &rest);
    a = std::exchange(b, std::move(rest));
    BigInteger next = s - quotient * t;
    s = std::exchange(t, std::move(next));
  }
  if (t.bit_length() > bits) return {0, 0};
  if (t.sign() < 0) {
    t.negate();
    b.negate();
  }
  return {std::move(b), std::move(t)};
}

/// The fractions over one denominator that these numbers are modulo `power`; false if they are too
/// long for it.
bool fractions_of(const std::vector<BigInteger>& numbers, const BigInteger& power,
                  std::vector<BigInteger>& numerators, BigInteger& denominator) {
  const std::size_t half = power.bit_length() / 2 - 1;
  for (const BigInteger& number : numbers) {
    BigInteger t = number * denominator % power;
    if (t + t > power) t -= power; // the one next to zero
    if (t.bit_length() > half) {
      auto [numerator, by] = fraction_of(t.sign() < 0 ? t + power : t, power, half);
      if (by.is_zero()) return false;
      for (BigInteger& earlier : numerators) earlier = earlier * by;
      denominator = denominator * by;
      t = std::move(numerator);
    }
    numerators.push_back(std::move(t));
  }
  return true;
}

BigInteger product(const WholeRow& row, const std::vector<BigInteger>& x) {
  BigInteger sum = 0;
  for (const auto& [column, value] : row.entries)
    if (!x[column].is_zero()) sum += value * x[column];
  return sum;
}

/// x takes the place of its pivots' columns: rows x = right in the rows of the steps, what is no
/// pivot as it is.
bool solve(const std::vector<WholeRow>& rows, const Factors& factors,
           const std::vector<Rational>& right, std::vector<Rational>& x) {
  const auto& steps = factors.steps;
  // What x leaves of the right-hand sides, over one denominator, with how many bits.
  for (const Factors::Step& step : steps) x[step.column] = 0;
  std::vector<Rational> left;
  BigInteger unit = 1;
  for (const Factors::Step& step : steps) {
    Rational sum = right[step.row] * Rational(rows[step.row].unit, 1);
    for (const auto& [column, value] : rows[step.row].entries)
      if (x[column].sign() != 0) sum -= Rational(value, 1) * x[column];
    unit = common_multiple(unit, sum.denominator());
    left.push_back(std::move(sum));
  }
  std::vector<BigInteger> c;
  std::size_t bits = 0, longest = 0; // Hadamard's bound: sqrt(n) of at most 256 entries a row
  std::vector<WholeRow> minor;
  std::vector<bool> is_pivot(x.size(), false);
  for (const Factors::Step& step : steps) is_pivot[step.column] = true;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    c.push_back(left[k].numerator() * (unit / left[k].denominator()));
    longest = std::max(longest, c.back().bit_length());
    std::size_t entry = 0;
    WholeRow& row = minor.emplace_back();
    for (const auto& [column, value] : rows[steps[k].row].entries)
      if (is_pivot[column]) {
        row.entries.emplace_back(column, value);
        entry = std::max(entry, value.bit_length());
      }
    bits += entry + 4;
  }
  // Digit by digit; now and then: are they those of fractions?
  const std::size_t most = 2 * ((2 * bits + longest) / (prime_bits - 1) + 4);
  std::size_t next_try = 4;
  std::vector<BigInteger> rest = c, number(x.size(), 0);
  BigInteger power = 1;
  for (std::size_t count = 1; count <= most; ++count) {
    std::vector<Limb> remainders;
    for (const BigInteger& value : rest) remainders.push_back(value.modulo(prime));
    const std::vector<Limb> digits = factors.solve(std::move(remainders), x.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      for (const auto& [column, value] : minor[k].entries)
        if (digits[column] != 0) rest[k] -= value * BigInteger(digits[column]);
      rest[k] = rest[k] / BigInteger(prime);
      number[steps[k].column] += power * BigInteger(digits[steps[k].column]);
    }
    power = power * BigInteger(prime);
    if (count < next_try && count < most / 2) continue;
    next_try = count + count / 2;
    std::vector<BigInteger> numerators;
    BigInteger denominator = 1;
    bool solves = fractions_of(number, power, numerators, denominator);
    for (std::size_t k = 0; solves && k < steps.size(); ++k)
      solves = product(minor[k], numerators) == c[k] * denominator;
    if (!solves) continue;
    for (const Factors::Step& step : steps)
      if (BigInteger& numerator = numerators[step.column]; !numerator.is_zero())
        x[step.column] = Rational::unreduced(std::move(numerator), denominator * unit);
    return true;
  }
  return false;
}

} // namespace

BigInteger common_multiple(const BigInteger& a, const BigInteger& b) {
  return b.is_one() || a == b ? a : a / gcd(a, b) * b;
}

std::optional<std::vector<std::vector<Rational>>>
exact_solutions(const std::vector<ExactRow>& rows,
                const std::vector<std::vector<Rational>>& right) {
  const std::vector<WholeRow> scaled = whole(rows);
  const Factors factors(scaled, rows.size());
  if (factors.steps.size() < rows.size()) return std::nullopt;
  std::vector<std::vector<Rational>> x(right.size(), std::vector<Rational>(rows.size()));
  for (std::size_t k = 0; k < right.size(); ++k)
    if (!solve(scaled, factors, right[k], x[k])) return std::nullopt;
  return x;
}

std::optional<std::vector<Rational>> solution_near(const std::vector<ExactRow>& rows,
                                                   const std::vector<Rational>& right,
                                                   const std::vector<double>& guess, int bits) {
  double largest = 0;
  for (const double value : guess) largest = std::max(largest, std::abs(value));
  const double grid = largest > 0 ? std::exp2(std::floor(std::log2(largest)) - bits) : 1;
  std::vector<Rational> x;
  for (const double value : guess) x.emplace_back(std::round(value / grid) * grid);
  const std::vector<WholeRow> scaled = whole(rows);
  if (!solve(scaled, Factors(scaled, guess.size()), right, x)) return std::nullopt;
  return x;
}

std::vector<std::size_t> independent_columns(const std::vector<ExactRow>& rows,
                                             std::size_t columns) {
  std::vector<std::size_t> result;
  for (const Factors::Step& step : Factors(whole(rows), columns).steps)
    result.push_back(step.column);
  return result;
}

} // namespace lcpush::desktop
