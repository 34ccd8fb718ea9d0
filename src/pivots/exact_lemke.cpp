#include "pivots/exact_lemke.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

/// The least common multiple, both > 0.
BigInteger common_multiple(const BigInteger& a, const BigInteger& b) {
  if (a.is_one() || a == b) return b;
  return a / gcd(a, b) * b;
}

Rational whole(BigInteger number) { return {std::move(number), 1}; }
Rational reduced(const Quotient& x) { return {x.above, x.below}; }

} // namespace

ExactLemke::ExactLemke(Index n)
    : n_(n), memory_(n * (n + 3), 3 * n + 1), denominator_(static_cast<std::size_t>(n), 1),
      solution_(static_cast<std::size_t>(n)), ray_(static_cast<std::size_t>(n)) {}

void ExactLemke::end(Status status, Reason reason) {
  reason_ = reason;
  status_ = status;
}

Status ExactLemke::init(const Problem<Rational>& problem, const LemkeOptions<Rational>& options) {
  rule_ = options.tie_rule;
  limit_ = options.max_pivots;
  free_begin_ = problem.free_begin;
  rhs_count_ = problem.free_begin < n_ ? 2 : 1;
  Block<Rational> scalars(span_of(memory_.scalars));
  Block<int> integers(span_of(memory_.integers));
  dictionary_.carve(n_, n_ + 1, rhs_count_, scalars, integers);
  candidates_ = integers.take(n_);
  dictionary_.reset_basis();
  fill_matrix(problem, MatrixMap<Rational>(dictionary_.table.data(), n_, n_));
  for (Index i = 0; i < n_; ++i) {
    dictionary_.table(i, n_) = options.cover[i];
    dictionary_.values(i, rhs_count_ - 1) = problem.q[i];
    // The free unknowns' bound is at -S: one more right-hand side.
    for (Index j = free_begin_; j < n_; ++j) dictionary_.values(i, 0) -= dictionary_.table(i, j);
    make_whole(i);
  }
  end(Status::running);
  return status_;
}

void ExactLemke::make_whole(Index row) {
  BigInteger& multiple = denominator_[static_cast<std::size_t>(row)];
  for (Index k = 0; k < width(); ++k)
    multiple = common_multiple(multiple, number(row, k).denominator());
  if (multiple.is_one()) return;
  const Rational by = whole(multiple);
  for (Index k = 0; k < width(); ++k) number(row, k) *= by;
}

/// False: the run has ended.
bool ExactLemke::find_pivot() {
  RatioTest<Rational> test(dictionary_, rhs_count_, rule_, {}, candidates_);
  if (entering_ < 0) return find_first_pivot(test);
  if (pivots_ >= limit_) {
    end(Status::pivot_limit);
    return false;
  }
  const Index column = dictionary_.column_of(entering_);
  const Blocking blocking = test.blocking_row(column);
  if (blocking.row < 0) {
    conclude_ray(column);
    return false;
  }
  pending_ = {entering_, column, blocking, test.tied_rows()};
  return true;
}

/// z0 enters for the row that needs it most, if one does.
bool ExactLemke::find_first_pivot(RatioTest<Rational>& test) {
  int sign = 0;
  Blocking worst;
  if (n_ > 0) worst = test.most_violated_row(n_);
  for (Index k = 0; k < rhs_count_ && n_ > 0 && sign == 0; ++k)
    sign = dictionary_.values(worst.row, k).sign();
  if (sign >= 0) {
    accept();
    return false;
  }
  pending_ = {artificial(n_), n_, worst, test.tied_rows(), true};
  return true;
}

/// Row `from` solved for the entering variable is put into `row`, where that variable has a factor.
/// The pivot's column waits for exchange().
void ExactLemke::subtract(Index row, Index from) {
  const Index c = pending_.column;
  const BigInteger& pivot = number(from, c).numerator();
  BigInteger& denominator = denominator_[static_cast<std::size_t>(row)];
  BigInteger factor = number(row, c).numerator(), size = abs(pivot);
  if (pivot.sign() < 0) factor.negate();
  if (const BigInteger common = gcd(factor, size); !common.is_one()) {
    factor = factor / common;
    size = size / common;
  }
  for (Index k = 0; k < width(); ++k) {
    const BigInteger& x = number(from, k).numerator();
    BigInteger y = number(row, k).numerator();
    if (k == c) continue;
    if (!size.is_one() && !y.is_zero()) y = y * size;
    if (!x.is_zero()) y -= x * factor;
    number(row, k) = whole(std::move(y));
  }
  if (!size.is_one()) denominator = denominator * size;
  number(row, c) = whole(factor * denominator_[static_cast<std::size_t>(from)]);
  shorten(row);
}

/// Takes out what divides the whole row.
void ExactLemke::shorten(Index row) {
  BigInteger& denominator = denominator_[static_cast<std::size_t>(row)];
  BigInteger divisor = denominator;
  for (Index k = 0; k < width() && !divisor.is_one(); ++k)
    if (const BigInteger& x = number(row, k).numerator(); !x.is_zero()) divisor = gcd(x, divisor);
  if (divisor.is_one()) return;
  denominator = denominator / divisor;
  for (Index k = 0; k < width(); ++k)
    if (const BigInteger& x = number(row, k).numerator(); !x.is_zero())
      number(row, k) = whole(x / divisor);
}

void ExactLemke::exchange(Index row) {
  const Index c = pending_.column;
  for (Index i = 0; i < n_; ++i)
    if (i != row && number(i, c).sign() != 0) subtract(i, row);
  // p x_c = d x_r - (the rest of the row)
  BigInteger pivot = number(row, c).numerator();
  BigInteger& denominator = denominator_[static_cast<std::size_t>(row)];
  const bool is_negative = pivot.sign() < 0;
  for (Index k = 0; k < width() && !is_negative; ++k) number(row, k).negate();
  if (is_negative) pivot.negate();
  number(row, c) = whole(is_negative ? -std::move(denominator) : std::move(denominator));
  denominator = std::move(pivot);
  std::swap(dictionary_.basic[row], dictionary_.nonbasic[c]);
  ++pivots_;
  const Index leaving = dictionary_.nonbasic[c];
  if (leaving == artificial(n_))
    accept();
  else
    entering_ = complement(leaving, n_);
}

/// z0 has left, or was never needed. Every free unknown has to be at S plus something finite, and
/// nothing else of order S.
void ExactLemke::accept() {
  for (Rational& z : solution_) z = 0;
  std::vector<Rational> with_S(solution_.size());
  for (Index i = 0; i < n_; ++i) {
    const Index variable = dictionary_.basic[i];
    if (variable < n_ || variable == artificial(n_)) continue;
    const auto at = static_cast<std::size_t>(variable - n_);
    solution_[at] = reduced(value(i, rhs_count_ - 1));
    if (rhs_count_ > 1) with_S[at] = reduced(value(i, 0));
  }
  for (Index i = 0; i < n_ && rhs_count_ > 1; ++i)
    if (with_S[static_cast<std::size_t>(i)] != Rational(i < free_begin_ ? 0 : 1))
      return end(Status::numerical_breakdown, Reason::retreat);
  end(Status::solved);
}

/// Nothing blocks the entering variable: it may grow, and the basic ones with it, without end.
void ExactLemke::conclude_ray(Index column) {
  for (Rational& v : ray_) v = 0;
  ray_artificial_ = 0;
  const auto record = [this](Index variable, const Rational& rate) {
    if (variable == artificial(n_))
      ray_artificial_ = rate;
    else if (variable >= n_)
      ray_[static_cast<std::size_t>(variable - n_)] = rate;
  };
  record(entering_, 1);
  for (Index i = 0; i < n_; ++i) record(dictionary_.basic[i], reduced(entry(i, column)));
  const Rational largest = *std::max_element(ray_.begin(), ray_.end());
  if (largest.sign() <= 0) return end(Status::numerical_breakdown, Reason::false_ray);
  for (Rational& v : ray_) v /= largest;
  ray_artificial_ /= largest;
  end(Status::ray);
}

} // namespace lcpush::desktop
