#include "certify/exact_columns.hpp"

namespace lcpush::desktop {

// All over one denominator first, so that of long numbers no more than one divisor a row is sought.
Column times(const MixedProblem& problem, Column x, const Column& constant, const Column& cover,
             const Rational& z0) {
  x.push_back(z0);
  BigInteger below = 1;
  for (const Rational& number : x)
    if (const BigInteger& its = number.denominator(); !(below % its).is_zero())
      below = below / gcd(below, its) * its;
  for (Rational& number : x)
    number = Rational(number.numerator() * (below / number.denominator()), 1);
  Column result;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    Rational sum = constant.empty() ? Rational(0) : constant[i] * Rational(below, 1);
    for (const ExactEntry& entry : problem.rows[i]) {
      const Rational& by = x[static_cast<std::size_t>(entry.column)];
      if (by.sign() != 0) sum += entry.value * by;
    }
    if (z0.sign() != 0) sum += cover[i] * x.back();
    result.push_back(sum.sign() == 0 ? sum : Rational(sum.numerator(), sum.denominator() * below));
  }
  return result;
}

int sign_at(const std::vector<Column>& columns, std::size_t i) {
  for (const Column& column : columns)
    if (column[i].sign() != 0) return column[i].sign();
  return 0;
}

std::vector<ExactRow> cut(const MixedProblem& problem, const std::vector<std::size_t>& rows,
                          const std::vector<std::size_t>& columns) {
  std::vector<Index> place(problem.size(), -1);
  for (std::size_t j = 0; j < columns.size(); ++j) place[columns[j]] = static_cast<Index>(j);
  std::vector<ExactRow> result;
  for (const std::size_t i : rows) {
    ExactRow& row = result.emplace_back();
    for (const ExactEntry& entry : problem.rows[i])
      if (place[static_cast<std::size_t>(entry.column)] >= 0)
        row.push_back({place[static_cast<std::size_t>(entry.column)], entry.value});
  }
  return result;
}

} // namespace lcpush::desktop
