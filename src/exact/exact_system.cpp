#include "exact/exact_system.hpp"

#include "exact/limbs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

constexpr std::uint64_t prime = (std::uint64_t{1} << 61U) - 1;

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  const limbs::Wide product = limbs::Wide{a} * b;
  const std::uint64_t sum =
      static_cast<std::uint64_t>(product & prime) + static_cast<std::uint64_t>(product >> 61U);
  return sum >= prime ? sum - prime : sum;
}
std::uint64_t minus(std::uint64_t a, std::uint64_t b) { return a >= b ? a - b : a + prime - b; }

std::uint64_t inverse_of(std::uint64_t a) { // Fermat's little theorem
  std::uint64_t result = 1;
  for (std::uint64_t exponent = prime - 2; exponent > 0; exponent >>= 1U, a = times(a, a))
    if ((exponent & 1U) != 0) result = times(result, a);
  return result;
}

BigInteger common_multiple(const BigInteger& a, const BigInteger& b) {
  return b.is_one() ? a : a / gcd(a, b) * b;
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

} // namespace

ExactSystem::ExactSystem(const std::vector<ExactRow>& rows) : n_(rows.size()) {
  scale(rows);
  invert();
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
    std::vector<Entry>& scaled = rows_.emplace_back();
    for (const ExactEntry& entry : rows[i]) {
      const BigInteger by = by_row[i] * by_column[static_cast<std::size_t>(entry.column)];
      scaled.push_back({entry.column, entry.value.numerator() * (by / entry.value.denominator())});
    }
  }
  row_unit_ = std::move(by_row);
  for (const std::vector<Entry>& row : rows_) {
    std::size_t longest = 0;
    for (const Entry& entry : row) longest = std::max(longest, entry.value.bit_length());
    most_bits_ += longest + 4; // sqrt(n) of at most 256 entries a row
  }
}

/// Gauss-Jordan elimination modulo the prime.
void ExactSystem::invert() {
  const std::size_t n = n_, width = 2 * n;
  std::vector<Limb> table(n * width, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (const Entry& entry : rows_[i])
      table[i * width + static_cast<std::size_t>(entry.column)] = entry.value.modulo(prime);
    table[i * width + n + i] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && table[pivot * width + k] == 0) ++pivot;
    if (pivot == n) {
      is_singular_ = true;
      return;
    }
    if (pivot != k)
      std::swap_ranges(&table[k * width], &table[k * width] + width, &table[pivot * width]);
    const Limb by = inverse_of(table[k * width + k]);
    for (std::size_t j = k; j < width; ++j) table[k * width + j] = times(table[k * width + j], by);
    for (std::size_t i = 0; i < n; ++i) {
      const Limb factor = table[i * width + k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = k; j < width; ++j)
        if (table[k * width + j] != 0)
          table[i * width + j] = minus(table[i * width + j], times(factor, table[k * width + j]));
    }
  }
  inverse_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) std::copy_n(&table[i * width + n], n, &inverse_[i * n]);
}

/// The next digit of every unknown.
std::vector<BigInteger::Limb> ExactSystem::digit(const std::vector<BigInteger>& rest) const {
  std::vector<Limb> small;
  for (const BigInteger& r : rest) small.push_back(r.modulo(prime));
  std::vector<Limb> result(n_, 0);
  for (std::size_t i = 0; i < n_; ++i) {
    Limb sum = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      sum += times(inverse_[i * n_ + j], small[j]);
      if (sum >= prime) sum -= prime;
    }
    result[i] = sum;
  }
  return result;
}

bool ExactSystem::solves(const std::vector<BigInteger>& numerators, const BigInteger& denominator,
                         const std::vector<BigInteger>& b) const {
  for (std::size_t i = 0; i < n_; ++i) {
    BigInteger sum = 0;
    for (const Entry& entry : rows_[i])
      sum += entry.value * numerators[static_cast<std::size_t>(entry.column)];
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
  std::vector<BigInteger> c, rest, x(n_, BigInteger(0));
  std::size_t longest = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    const Rational scaled = b[i] * Rational(row_unit_[i], 1);
    c.push_back(scaled.numerator() * (denominator / scaled.denominator()));
    longest = std::max(longest, c.back().bit_length());
  }
  rest = c;
  BigInteger power = 1;
  const std::size_t most_digits = (2 * most_bits_ + longest) / 60 + 4;
  std::size_t next_try = 4;
  for (std::size_t count = 1; count <= 2 * most_digits; ++count) {
    const std::vector<Limb> digits = digit(rest);
    for (std::size_t i = 0; i < n_; ++i) {
      if (digits[i] != 0) x[i] += power * BigInteger(digits[i]);
      BigInteger sum = rest[i];
      for (const Entry& entry : rows_[i]) {
        const Limb by = digits[static_cast<std::size_t>(entry.column)];
        if (by != 0) sum -= entry.value * BigInteger(by);
      }
      rest[i] = sum / BigInteger(prime);
    }
    power = power * BigInteger(prime);
    if (count < next_try && count < most_digits) continue;
    next_try = 2 * count;
    // The digits so far, as fractions over one denominator.
    const std::size_t half = power.bit_length() / 2 - 1;
    BigInteger common = 1;
    bool found = true;
    std::vector<BigInteger> numerators;
    for (std::size_t i = 0; i < n_ && found; ++i) {
      BigInteger t = nearest_zero(x[i] * common % power, power);
      if (t.bit_length() > half) {
        BigInteger positive = t.sign() < 0 ? t + power : t;
        auto [numerator, by] = fraction_of(positive, power, half);
        found = !by.is_zero();
        if (!found) break;
        for (BigInteger& earlier : numerators) earlier = earlier * by;
        common = common * by;
        t = std::move(numerator);
      }
      numerators.push_back(std::move(t));
    }
    if (!found || !solves(numerators, common, c)) continue;
    std::vector<Rational> result;
    for (std::size_t i = 0; i < n_; ++i)
      result.push_back(Rational(numerators[i], common * denominator) * column_unit_[i]);
    return result;
  }
  return std::nullopt;
}

ExactMinor largest_minor(const std::vector<ExactRow>& rows, std::size_t columns) {
  const std::size_t m = rows.size(), n = columns;
  std::vector<std::uint64_t> table(m * n, 0);
  for (std::size_t i = 0; i < m; ++i)
    for (const ExactEntry& entry : rows[i])
      table[i * n + static_cast<std::size_t>(entry.column)] =
          times(entry.value.numerator().modulo(prime),
                inverse_of(entry.value.denominator().modulo(prime)));
  ExactMinor minor;
  for (std::size_t i = 0; i < m; ++i) {
    std::size_t pivot = 0;
    while (pivot < n && table[i * n + pivot] == 0) ++pivot;
    if (pivot == n) continue;
    minor.rows.push_back(i);
    minor.columns.push_back(pivot);
    const std::uint64_t by = inverse_of(table[i * n + pivot]);
    for (std::size_t k = i + 1; k < m; ++k) {
      if (table[k * n + pivot] == 0) continue;
      const std::uint64_t factor = times(table[k * n + pivot], by);
      for (std::size_t j = pivot; j < n; ++j)
        table[k * n + j] = minus(table[k * n + j], times(factor, table[i * n + j]));
    }
  }
  return minor;
}

std::optional<std::vector<Rational>> solution_near(const std::vector<ExactRow>& rows,
                                                   const std::vector<Rational>& right,
                                                   const std::vector<double>& guess) {
  double largest = 0;
  for (const double value : guess) largest = std::max(largest, std::abs(value));
  const double grid = largest > 0 ? std::exp2(std::floor(std::log2(largest)) - 40) : 1;
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
