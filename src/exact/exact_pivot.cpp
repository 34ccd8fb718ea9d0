// A pivot in fractions. The numbers of a row share one denominator: a pivot multiplies and adds,
// and takes out of every row that it changes what divides all of it: one long divisor a row, not
// several an entry. [Edmonds 1967; with one denominator for all rows, Bareiss 1968, the numbers of
// sparse problems would be longer.]
#include <utility>
#include <vector>

#include "exact/exact_system.hpp"
#include "lcpush/desktop/exact_pivots.hpp"

namespace lcpush::desktop {

/// A row of a dictionary in whole numbers: of the columns, then of the right-hand sides.
class SharedRow {
public:
  std::vector<BigInteger> whole;
  BigInteger denominator = 1; ///< > 0

  SharedRow(Dictionary<Rational>& dictionary, Index row) : dictionary_(dictionary), row_(row) {
    const Index width = dictionary.table.cols() + dictionary.values.cols();
    for (Index k = 0; k < width; ++k)
      if (number(k).sign() != 0)
        denominator = common_multiple(denominator, number(k).denominator());
    for (Index k = 0; k < width; ++k) {
      const Rational& x = number(k);
      whole.push_back(x.denominator() == denominator || x.sign() == 0
                          ? x.numerator()
                          : x.numerator() * (denominator / x.denominator()));
    }
  }

  void write() {
    BigInteger divisor = denominator;
    for (std::size_t k = 0; k < whole.size() && !divisor.is_one(); ++k)
      if (!whole[k].is_zero()) divisor = gcd(whole[k], divisor);
    if (!divisor.is_one()) {
      denominator = denominator / divisor;
      for (BigInteger& x : whole)
        if (!x.is_zero()) x = x / divisor;
    }
    for (std::size_t k = 0; k < whole.size(); ++k)
      number(static_cast<Index>(k)) =
          whole[k].is_zero() ? Rational() : Rational::unreduced(std::move(whole[k]), denominator);
  }

private:
  Dictionary<Rational>& dictionary_;
  Index row_;

  Rational& number(Index k) {
    const Index columns = dictionary_.table.cols();
    return k < columns ? dictionary_.table(row_, k) : dictionary_.values(row_, k - columns);
  }
};

} // namespace lcpush::desktop

namespace lcpush {

template <>
void Dictionary<desktop::Rational>::exchange(Index r, Index c, VectorMap<desktop::Rational>) {
  using desktop::BigInteger, desktop::SharedRow;
  const auto at = static_cast<std::size_t>(c);
  // d x_r = p x_c + rest becomes |p| x_c = +-(d x_r - rest).
  SharedRow solved(*this, r);
  const bool is_positive = solved.whole[at].sign() > 0;
  BigInteger size = abs(solved.whole[at]);
  solved.whole[at] = -solved.denominator;
  if (is_positive)
    for (BigInteger& x : solved.whole) x.negate();
  // Which is put into the other rows.
  for (Index i = 0; i < table.rows(); ++i) {
    if (i == r || table(i, c).sign() == 0) continue;
    SharedRow row(*this, i);
    const BigInteger common = gcd(row.whole[at], size);
    const BigInteger factor = std::exchange(row.whole[at], 0) / common, by = size / common;
    for (std::size_t k = 0; k < row.whole.size(); ++k) {
      BigInteger& x = row.whole[k];
      if (!x.is_zero() && !by.is_one()) x = x * by;
      if (!solved.whole[k].is_zero()) x += factor * solved.whole[k];
    }
    row.denominator = row.denominator * by;
    row.write();
  }
  solved.denominator = std::move(size);
  solved.write();
  Eigen::numext::swap(basic[r], nonbasic[c]);
}

} // namespace lcpush
