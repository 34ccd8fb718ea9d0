// What p-adic lifting is made of: numbers modulo a prime, a matrix factored there, and what the
// digits found have not yet explained of a right-hand side.
#pragma once

#include <utility>
#include <vector>

#include "exact/limbs.hpp"
#include "lcpush/desktop/big_integer.hpp"
#include "lcpush/types.hpp"

/// Whole numbers modulo the prime 2^61 - 1, whose remainders need no division.
namespace lcpush::desktop::modular {

using limbs::Limb, limbs::Wide;

constexpr int bits = 61;
constexpr Limb prime = (Limb{1} << bits) - 1;

inline Limb remainder(Limb a) {
  a = (a & prime) + (a >> bits);
  return a >= prime ? a - prime : a;
}
inline Limb times(Limb a, Limb b) {
  const Wide product = Wide{a} * b;
  return remainder(static_cast<Limb>(product & prime) + static_cast<Limb>(product >> bits));
}
inline Limb minus(Limb a, Limb b) { return a >= b ? a - b : a + prime - b; }

/// Fermat's little theorem.
inline Limb inverse_of(Limb a) {
  Limb result = 1;
  for (Limb exponent = prime - 2; exponent > 0; exponent >>= 1U, a = times(a, a))
    if ((exponent & 1U) != 0) result = times(result, a);
  return result;
}

} // namespace lcpush::desktop::modular

namespace lcpush::desktop {

/// A = L U by rows and columns in the order that keeps both sparse: the next pivot is in the
/// shortest row that is left, and there in the column of the fewest rows (Markowitz).
class ModularFactors {
public:
  struct Entry {
    Index at; // a column, or of a step of elimination the row
    modular::Limb value;
  };
  using Row = std::vector<Entry>;

  /// `rows` is n x n, none of its entries zero.
  explicit ModularFactors(std::vector<Row> rows);

  bool is_singular() const { return is_singular_; }
  /// b becomes x with A x = b. Pre: not singular.
  void solve(std::vector<modular::Limb>& b) const;

private:
  struct Step {
    std::size_t row, column;
    modular::Limb inverse; // of the pivot
    Row eliminates;        // how often this row was taken from which rows
  };
  std::vector<Row> rows_; // when they became pivots, without these
  std::vector<Step> steps_;
  bool is_singular_ = false;
};

/// Sparse rows of whole numbers.
using WholeRow = std::vector<std::pair<Index, BigInteger>>;

/// c, then (c - A d) / p, and so on: numbers of one length, in two's complement.
class LiftedRest {
public:
  LiftedRest(const std::vector<WholeRow>& rows, const std::vector<BigInteger>& c);
  /// Modulo the prime.
  std::vector<limbs::Limb> remainders() const;
  /// Pre: A d = the remainders, modulo the prime.
  void take(const std::vector<limbs::Limb>& digits);

private:
  const std::vector<WholeRow>& rows_;
  std::size_t width_ = 0; // limbs of a number
  std::vector<limbs::Limb> rest_;
};

} // namespace lcpush::desktop
