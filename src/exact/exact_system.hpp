// Linear equations in fractions, solved exactly.
#pragma once

#include "exact/p_adic.hpp"
#include "lcpush/desktop/rational.hpp"

#include <optional>
#include <vector>

namespace lcpush::desktop {

/// The least common multiple of two numbers > 0.
BigInteger common_multiple(const BigInteger& a, const BigInteger& b);

/// An entry of a sparse row.
struct ExactEntry {
  Index column;
  Rational value;
};
using ExactRow = std::vector<ExactEntry>;

/// A x = b for many b. Dixon's p-adic lifting: the factors modulo one prime give a digit of x for a
/// product with A, so that numbers only become long where x is (J. D. Dixon, Exact solution of
/// linear equations using p-adic expansions, Numer. Math. 40, 1982). Cost: at most n^3 word
/// operations, and a solve those of the factors' entries times the digits of x.
class ExactSystem {
public:
  /// `rows` is n x n.
  explicit ExactSystem(const std::vector<ExactRow>& rows);

  /// Has A no inverse? (Modulo 2^61 - 1, which a matrix that has one divides with a chance of 1e-18
  /// a digit of its determinant; then a true basis is refused, and nothing wrong is said.)
  bool is_singular() const { return is_singular_; }
  /// x, checked in A x = b; nullopt where its digits do not end within the bound for such an A.
  std::optional<std::vector<Rational>> solve(const std::vector<Rational>& b) const;

private:
  using Limb = BigInteger::Limb;
  std::size_t n_;
  std::vector<WholeRow> rows_; // whole numbers: row i times row_unit_[i]
  std::vector<BigInteger> row_unit_;
  std::vector<Rational> column_unit_; // x_j is the unit times the integer system's unknown
  std::optional<ModularFactors> factors_;
  std::size_t most_bits_ = 0; // of numerators and denominators, by Hadamard's bound
  bool is_singular_ = false;

  void scale(const std::vector<ExactRow>& rows);
  void factor();
  bool solves(const std::vector<BigInteger>& numerators, const BigInteger& denominator,
              const std::vector<BigInteger>& b) const;
};

/// Rows and columns of a largest minor that is not zero, modulo a prime. Rows in their order: what
/// depends on those before is left out.
struct ExactMinor {
  std::vector<std::size_t> rows, columns;
};
ExactMinor largest_minor(const std::vector<ExactRow>& rows, std::size_t columns);

/// x with `rows` x = right, as far as the rows do not depend on those before them: what they leave
/// open stays at `guess`, rounded to `bits` of the largest guess. nullopt if there is none.
std::optional<std::vector<Rational>> solution_near(const std::vector<ExactRow>& rows,
                                                   const std::vector<Rational>& right,
                                                   const std::vector<double>& guess, int bits);

} // namespace lcpush::desktop
