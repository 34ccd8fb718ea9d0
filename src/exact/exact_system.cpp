#include "exact/exact_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

using modular::prime;

/// The number whose digits to the base of the prime are those of unknown i, the last one first.
BigInteger of_digits(const std::vector<std::vector<modular::Limb>>& digits, std::size_t i) {
  std::vector<modular::Limb> number(digits.size(), 0); // 61 bits a digit
  for (std::size_t k = digits.size(); k-- > 0;) {
    modular::Limb carry = digits[k][i];
    for (modular::Limb& limb : number) {
      const limbs::Wide sum = limbs::Wide{limb} * prime + carry;
      limb = static_cast<modular::Limb>(sum);
      carry = static_cast<modular::Limb>(sum >> limbs::limb_bits);
    }
  }
  return BigInteger::of_magnitude(number.data(), number.size());
}

/// The representative of x modulo `modulus` next to zero. Pre: 0 <= x < modulus.
BigInteger nearest_zero(BigInteger x, const BigInteger& modulus) {
  return x + x > modulus ? std::move(x) - modulus : x;
}

/// The fraction t with numerator and denominator of at most `bits` that x is modulo `modulus`, by
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

/// The fractions over one denominator whose digits these are; false if they are too long for them.
bool fractions_of(const std::vector<std::vector<modular::Limb>>& digits,
                  std::vector<BigInteger>& numerators, BigInteger& denominator) {
  BigInteger power = 1;
  for (std::size_t k = 0; k < digits.size(); ++k) power = power * BigInteger(prime);
  const std::size_t half = power.bit_length() / 2 - 1;
  for (std::size_t i = 0; i < digits.front().size(); ++i) {
    BigInteger t = nearest_zero(of_digits(digits, i) * denominator % power, power);
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

} // namespace

BigInteger common_multiple(const BigInteger& a, const BigInteger& b) {
  return b.is_one() || a == b ? a : a / gcd(a, b) * b;
}

ExactSystem::ExactSystem(const std::vector<ExactRow>& rows) : n_(rows.size()) {
  scale(rows);
  factor();
}

/// Whole numbers. A row that shares its denominators is multiplied by them; of a row that has many
/// (Newton's law has one a direction), the columns are.
void ExactSystem::scale(const std::vector<ExactRow>& rows) {
  std::vector<BigInteger> by_row, by_column(n_, BigInteger(1));
  for (const ExactRow& row : rows) {
    std::size_t longest = 0;
    BigInteger multiple = 1;
    for (const ExactEntry& entry : row) {
      longest = std::max(longest, entry.value.denominator().bit_length());
      multiple = common_multiple(multiple, entry.value.denominator());
    }
    const bool shares = multiple.bit_length() <= 2 * longest + 64;
    by_row.push_back(shares ? std::move(multiple) : BigInteger(1));
    if (shares) continue;
    for (const ExactEntry& entry : row) {
      BigInteger& by = by_column[static_cast<std::size_t>(entry.column)];
      by = common_multiple(by, entry.value.denominator());
    }
  }
  for (const BigInteger& by : by_column) column_unit_.emplace_back(by, 1);
  for (std::size_t i = 0; i < n_; ++i) {
    WholeRow& scaled = rows_.emplace_back();
    for (const ExactEntry& entry : rows[i]) {
      const BigInteger by = by_row[i] * by_column[static_cast<std::size_t>(entry.column)];
      scaled.emplace_back(entry.column, entry.value.numerator() * (by / entry.value.denominator()));
    }
  }
  row_unit_ = std::move(by_row);
  for (const WholeRow& row : rows_) {
    std::size_t longest = 0;
    for (const auto& [column, value] : row) longest = std::max(longest, value.bit_length());
    most_bits_ += longest + 4; // sqrt(n) of at most 256 entries a row
  }
}

void ExactSystem::factor() {
  std::vector<ModularFactors::Row> table;
  std::vector<Limb> sums(n_, 0); // a row may name a column twice
  for (const WholeRow& row : rows_) {
    ModularFactors::Row& small = table.emplace_back();
    for (const auto& [column, value] : row) {
      Limb& sum = sums[static_cast<std::size_t>(column)];
      sum = modular::remainder(sum + value.modulo(prime));
    }
    for (const auto& [column, value] : row)
      if (Limb& sum = sums[static_cast<std::size_t>(column)]; sum != 0)
        small.push_back({column, std::exchange(sum, 0)});
  }
  factors_.emplace(std::move(table));
  is_singular_ = factors_->is_singular();
}

bool ExactSystem::solves(const std::vector<BigInteger>& numerators, const BigInteger& denominator,
                         const std::vector<BigInteger>& b) const {
  for (std::size_t i = 0; i < n_; ++i) {
    BigInteger sum = 0;
    for (const auto& [column, value] : rows_[i])
      sum += value * numerators[static_cast<std::size_t>(column)];
    if (sum != b[i] * denominator) return false;
  }
  return true;
}

std::optional<std::vector<Rational>> ExactSystem::solve(const std::vector<Rational>& b) const {
  if (is_singular_) return std::nullopt;
  // One denominator for the right-hand side: A y = c with x = column_unit y / denominator.
  BigInteger denominator = 1;
  for (std::size_t i = 0; i < n_; ++i) {
    const Rational scaled = b[i] * Rational(row_unit_[i], 1);
    denominator = common_multiple(denominator, scaled.denominator());
  }
  std::vector<BigInteger> c;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    const Rational scaled = b[i] * Rational(row_unit_[i], 1);
    c.push_back(scaled.numerator() * (denominator / scaled.denominator()));
    longest = std::max(longest, c.back().bit_length());
  }
  LiftedRest rest(rows_, c);
  std::vector<std::vector<Limb>> digits;
  const std::size_t most_digits = (2 * most_bits_ + longest) / 60 + 4;
  std::size_t next_try = 4;
  while (digits.size() < 2 * most_digits) {
    digits.push_back(rest.remainders());
    factors_->solve(digits.back());
    rest.take(digits.back());
    if (digits.size() < next_try && digits.size() < most_digits) continue;
    next_try = digits.size() + digits.size() / 2;
    std::vector<BigInteger> numerators;
    BigInteger common = 1;
    if (!fractions_of(digits, numerators, common) || !solves(numerators, common, c)) continue;
    std::vector<Rational> result;
    for (std::size_t i = 0; i < n_; ++i)
      result.push_back(Rational(numerators[i], common * denominator) * column_unit_[i]);
    return result;
  }
  return std::nullopt;
}

ExactMinor largest_minor(const std::vector<ExactRow>& rows, std::size_t columns) {
  const std::size_t m = rows.size(), n = columns;
  std::vector<modular::Limb> table(m * n, 0);
  for (std::size_t i = 0; i < m; ++i)
    for (const ExactEntry& entry : rows[i])
      table[i * n + static_cast<std::size_t>(entry.column)] =
          modular::times(entry.value.numerator().modulo(prime),
                         modular::inverse_of(entry.value.denominator().modulo(prime)));
  ExactMinor minor;
  for (std::size_t i = 0; i < m; ++i) {
    std::size_t pivot = 0;
    while (pivot < n && table[i * n + pivot] == 0) ++pivot;
    if (pivot == n) continue;
    minor.rows.push_back(i);
    minor.columns.push_back(pivot);
    const modular::Limb by = modular::inverse_of(table[i * n + pivot]);
    for (std::size_t k = i + 1; k < m; ++k) {
      if (table[k * n + pivot] == 0) continue;
      const modular::Limb factor = modular::times(table[k * n + pivot], by);
      for (std::size_t j = pivot; j < n; ++j)
        table[k * n + j] =
            modular::minus(table[k * n + j], modular::times(factor, table[i * n + j]));
    }
  }
  return minor;
}

std::optional<std::vector<Rational>> solution_near(const std::vector<ExactRow>& rows,
                                                   const std::vector<Rational>& right,
                                                   const std::vector<double>& guess, int bits) {
  double largest = 0;
  for (const double value : guess) largest = std::max(largest, std::abs(value));
  const double grid = largest > 0 ? std::exp2(std::floor(std::log2(largest)) - bits) : 1;
  std::vector<Rational> x;
  for (const double value : guess) x.emplace_back(std::round(value / grid) * grid);
  const ExactMinor minor = largest_minor(rows, guess.size());
  std::vector<Index> place(guess.size(), -1);
  for (std::size_t j = 0; j < minor.columns.size(); ++j)
    place[minor.columns[j]] = static_cast<Index>(j);
  std::vector<ExactRow> matrix;
  std::vector<Rational> b;
  for (const std::size_t i : minor.rows) {
    ExactRow& row = matrix.emplace_back();
    b.push_back(right[i]);
    for (const ExactEntry& entry : rows[i]) {
      const auto j = static_cast<std::size_t>(entry.column);
      if (place[j] >= 0)
        row.push_back({place[j], entry.value});
      else
        b.back() -= entry.value * x[j];
    }
  }
  const auto solution = ExactSystem(matrix).solve(b);
  if (!solution) return std::nullopt;
  for (std::size_t j = 0; j < minor.columns.size(); ++j) x[minor.columns[j]] = (*solution)[j];
  return x;
}

} // namespace lcpush::desktop
