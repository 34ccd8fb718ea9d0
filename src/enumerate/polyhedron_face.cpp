#include "enumerate/polyhedron_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

/// -1: nowhere.
Index place_of(Index variable, const Eigen::VectorXi& among) {
  Index k = among.size() - 1;
  while (k >= 0 && among[k] != variable) --k;
  return k;
}

} // namespace
Rational largest_size(const ExactVector& numbers) {
  Rational most;
  for (const Rational& x : numbers)
    if (abs(x) > most) most = abs(x);
  return most;
}

void divide_by(ExactVector& numbers, const Rational& divisor) {
  for (Rational& x : numbers) x /= divisor;
}

PolyhedronFace::PolyhedronFace(const ExactMatrix& M, const ExactMatrix& q,
                               const std::vector<unsigned char>& free)
    : table_(M.rows, M.rows), values_(M.rows, 1), basic_(M.rows), nonbasic_(M.rows) {
  const Index n = M.rows;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) table_(i, j) = M(i, j);
    values_(i) = q(i, 0);
    basic_[i] = static_cast<int>(slack(i));
    nonbasic_[i] = static_cast<int>(unknown(i, n));
    if (free[static_cast<std::size_t>(i)] == 0) continue;
    add(free_, unknown(i, n));
    add(fixed_, slack(i));
  }
}

void PolyhedronFace::exchange(Index row, Index column) {
  const Index n = size();
  Dictionary<Rational> dictionary;
  new (&dictionary.table) MatrixMap<Rational>(table_.data(), n, n);
  new (&dictionary.values) MatrixMap<Rational>(values_.data(), n, 1);
  dictionary.basic = {basic_.data(), n};
  dictionary.nonbasic = {nonbasic_.data(), n};
  dictionary.exchange(row, column, VectorMap<Rational>(nullptr, 0)); // fractions need no scratch
}

/// A column that moves the row's variable in the direction of `sign`: by Bland's rule, which never
/// cycles, or the one that moves it farthest, as rounded numbers tell.
Index PolyhedronFace::entering(Index row, int sign, bool by_bland) const {
  Index best = -1;
  double farthest = 0;
  for (Index c = 0; c < size(); ++c) {
    if (table_(row, c).sign() * sign <= 0) continue;
    double step = by_bland ? 0 : std::numeric_limits<double>::infinity();
    for (Index i = 0; i < size() && !by_bland; ++i)
      if (i != row && table_(i, c).sign() < 0 && values_(i).sign() >= 0 && !has(free_, basic_[i]))
        step = std::min(step, -values_(i).value() / table_(i, c).value());
    const double far = step * std::abs(table_(row, c).value());
    if (best < 0 || (by_bland ? nonbasic_[c] < nonbasic_[best] : far > farthest)) {
      best = c;
      farthest = far;
    }
  }
  return best;
}

/// The row whose variable is the first that becomes zero as the column's grows, by Bland's rule but
/// that `ending` wins; -1: none. Rows that are negative still do not count, but for `ending`.
Index PolyhedronFace::blocking(Index column, Index ending) const {
  Index best = -1;
  Rational least;
  for (Index i = 0; i < size(); ++i) {
    const Rational& slope = table_(i, column);
    const int sign = values_(i).sign();
    const bool falls = i == ending && sign < 0 ? slope.sign() > 0 : sign >= 0 && slope.sign() < 0;
    if (!falls || has(free_, basic_[i])) continue;
    const Rational step = abs(values_(i) / slope);
    const int order = best < 0 ? -1 : Rational::compare(step, least);
    if (order < 0 || (order == 0 && best != ending && (i == ending || basic_[i] < basic_[best]))) {
      best = i;
      least = step;
    }
  }
  return best;
}

/// Free unknowns become basic for good. One that moves nothing but others of them is the direction
/// of a line; it is left at zero.
void PolyhedronFace::take_in_free() {
  const Index n = size();
  for (Index z = n; z < 2 * n; ++z) {
    if (!has(free_, z)) continue;
    const Index c = place_of(z, nonbasic_);
    Index row = -1;
    for (Index i = 0; i < n; ++i)
      if (!has(free_, basic_[i]) && table_(i, c).sign() != 0 &&
          (row < 0 || (has(fixed_, basic_[i]) && !has(fixed_, basic_[row]))))
        row = i;
    if (row >= 0) {
      const Index leaving = basic_[row];
      exchange(row, c);
      if (has(fixed_, leaving)) pin(leaving);
      continue;
    }
    ExactVector line(static_cast<std::size_t>(n));
    line[static_cast<std::size_t>(z - n)] = 1;
    for (Index i = 0; i < n; ++i)
      if (has(free_, basic_[i])) line[static_cast<std::size_t>(basic_[i] - n)] = table_(i, c);
    divide_by(line, largest_size(line));
    lines_.push_back(std::move(line));
    pin(z);
  }
}

/// By the simplex method; false: it cannot be zero.
bool PolyhedronFace::drive_to_zero(Index variable) {
  bool is_stuck = false; // the last step had no length
  for (;;) {
    const Index row = place_of(variable, basic_);
    const int sign = row < 0 ? 0 : values_(row).sign();
    if (sign == 0) return true;
    const Index column = entering(row, -sign, is_stuck);
    if (column < 0) return false;
    const Index leaving = blocking(column, row);
    is_stuck = values_(leaving).sign() == 0;
    exchange(leaving, column);
  }
}

bool PolyhedronFace::find_vertex() {
  take_in_free();
  for (Index w = 0; w < size(); ++w) {
    const Index row = place_of(w, basic_);
    const bool is_below = row >= 0 && values_(row).sign() < 0;
    if ((is_below || has(fixed_, w)) && !drive_to_zero(w)) return false;
    if (has(fixed_, w)) pin(w);
  }
  note_positive();
  return true;
}

/// A variable that is zero on the whole face leaves the dictionary's rows, unless its row is empty;
/// its column is not needed any more.
void PolyhedronFace::pin(Index variable) {
  if (const Index row = place_of(variable, basic_); row >= 0)
    for (Index c = 0; c < size(); ++c)
      if (table_(row, c).sign() != 0) {
        exchange(row, c);
        break;
      }
  add(fixed_, variable);
  if (const Index column = place_of(variable, nonbasic_); column >= 0) table_.col(column).setZero();
}

bool PolyhedronFace::fix(Index variable) {
  if (!drive_to_zero(variable)) return false;
  pin(variable);
  positive_.reset();
  note_positive();
  return true;
}

void PolyhedronFace::note_positive() {
  for (Index i = 0; i < size(); ++i)
    if (values_(i).sign() > 0) add(positive_, basic_[i]);
}

bool PolyhedronFace::can_be_positive(Index variable) {
  while (!has(positive_, variable)) {
    if (has(fixed_, variable)) return false;
    const Index row = place_of(variable, basic_);
    const Index column = row < 0 ? place_of(variable, nonbasic_) : entering(row, 1, true);
    if (column < 0) {
      pin(variable);
      return false;
    }
    const Index leaving = blocking(column, -1);
    if (leaving < 0) {
      add(positive_, variable); // it grows without end
    } else {
      exchange(leaving, column);
      note_positive();
    }
  }
  return true;
}

/// The smallest step, as rounded numbers tell, by which all columns together take it to zero;
/// infinite: they cannot.
double PolyhedronFace::distance(Index variable) const {
  const Index row = place_of(variable, basic_);
  if (row < 0 || values_(row).sign() == 0) return 0;
  double slope = 0;
  for (Index c = 0; c < size(); ++c)
    if (table_(row, c).sign() < 0) slope -= table_(row, c).value();
  return values_(row).value() / slope;
}

bool PolyhedronFace::is_always_positive(Index variable) const {
  const Index row = place_of(variable, basic_);
  return row >= 0 && values_(row).sign() > 0 && entering(row, -1, true) < 0;
}

Index PolyhedronFace::open_pair() {
  const Index n = size();
  Index best = -1;
  double farthest = -1;
  for (Index i = 0; i < n; ++i) {
    const Index w = slack(i), z = unknown(i, n);
    if (!has(positive_, w) || !has(positive_, z) || has(free_, z)) continue;
    if (is_always_positive(w) || is_always_positive(z)) return i;
    if (const double far = std::min(distance(w), distance(z)); best < 0 || far > farthest) {
      best = i;
      farthest = far;
    }
  }
  for (Index i = 0; i < n && best < 0; ++i)
    if (!has(fixed_, slack(i)) && !has(fixed_, unknown(i, n)) && can_be_positive(slack(i)) &&
        can_be_positive(unknown(i, n)))
      best = i;
  return best;
}

Index PolyhedronFace::dimension() {
  Index count = 0;
  for (Index v = 0; v < 2 * size(); ++v)
    if (!has(free_, v) && !has(fixed_, v)) static_cast<void>(can_be_positive(v));
  for (Index c = 0; c < size(); ++c) count += has(fixed_, nonbasic_[c]) ? 0 : 1;
  return count;
}

} // namespace lcpush::desktop
