#include "dense/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dense/decompositions.hpp"
#include "dense/settings.hpp"

namespace lcpush::desktop {
namespace {

using Settings = SimplexSettings;

double largest(const Eigen::VectorXd& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }

/// Is v at least `floor` but for its first `free` entries?
bool is_above(double floor, const Eigen::VectorXd& v, Index free) {
  return v.size() == free || v.tail(v.size() - free).minCoeff() >= floor;
}

} // namespace

Simplex::Simplex(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, Index free, double price)
    : A_(A), b_(b), price_(price), free_(free), helper_(A.cols()), multipliers_(A.cols() + 1),
      value_(A.cols() + 1 + A.rows()), table_(Tableau::Zero(A.rows() + 1, value_ + 1)),
      basic_(static_cast<std::size_t>(A.rows()), -1),
      is_basic_(static_cast<std::size_t>(A.cols()) + 1, false),
      point_(Eigen::VectorXd::Zero(A.cols())) {
  const Index m = A.rows();
  table_.topLeftCorner(m, A.cols()) = A;
  table_.block(0, multipliers_, m, m).setIdentity();
  table_.col(value_).head(m) = b;
}

void Simplex::pivot(Index row, Index column) {
  table_.row(row) /= table_(row, column);
  table_(row, column) = 1;
  const Index width = table_.cols();
  const double* const source = table_.data() + row * width;
  for (Index i = 0; i < table_.rows(); ++i) {
    double* const target = table_.data() + i * width;
    const double by = target[column];
    if (i == row || by == 0) continue;
    for (Index j = 0; j < width; ++j) target[j] -= by * source[j];
    target[column] = 0;
    work_ += static_cast<double>(width);
  }
  Index& old = basic_[static_cast<std::size_t>(row)];
  if (old >= 0) is_basic_[static_cast<std::size_t>(old)] = false;
  old = column;
  is_basic_[static_cast<std::size_t>(column)] = true;
}

/// A basis: first all free variables, then for each row left the variable that is largest in it.
/// False: a row without one Settings::contradicts itself.
bool Simplex::start() {
  for (Index j = 0; j < free_; ++j) {
    Index best = -1;
    double largest = Settings::pivot;
    for (Index i = 0; i < rows(); ++i)
      if (basic_[static_cast<std::size_t>(i)] < 0 && std::abs(table_(i, j)) > largest) {
        largest = std::abs(table_(i, j));
        best = i;
      }
    if (best >= 0) pivot(best, j);
  }
  for (Index i = 0; i < rows(); ++i) {
    if (basic_[static_cast<std::size_t>(i)] >= 0) continue;
    Index best = -1;
    if (A_.cols() > free_)
      table_.row(i).segment(free_, A_.cols() - free_).cwiseAbs().maxCoeff(&best);
    if (best >= 0 && std::abs(table_(i, free_ + best)) > Settings::pivot)
      pivot(i, free_ + best);
    else if (std::abs(table_(i, value_)) > Settings::contradicts)
      return false;
    else
      table_.row(i).head(A_.cols()).setZero();
  }
  return true;
}

/// The last row for the costs c.
void Simplex::price(const Eigen::VectorXd& c) {
  const Index m = rows();
  table_.row(m).setZero();
  table_.row(m).head(c.size()) = c.transpose();
  for (Index i = 0; i < m; ++i) {
    const Index j = basic_[static_cast<std::size_t>(i)];
    if (j < 0 || j >= c.size() || c[j] == 0) continue;
    table_.row(m) -= c[j] * table_.row(i);
    work_ += static_cast<double>(table_.cols());
  }
}

/// The same afresh: the multipliers with one step of refinement by the basis's inverse.
void Simplex::refine_prices(const Eigen::VectorXd& c) {
  const Index m = rows();
  const Eigen::VectorXd y = multipliers(), off = c - product(A_.transpose(), y);
  Eigen::VectorXd better = y;
  for (Index i = 0; i < m; ++i)
    if (const Index j = basic_[static_cast<std::size_t>(i)]; j >= 0 && j < helper_)
      better += off[j] * table_.row(i).segment(multipliers_, m).transpose();
  table_.row(m).head(c.size()) = (c - product(A_.transpose(), better)).transpose();
  table_.row(m).segment(multipliers_, m) = -better.transpose();
  for (Index i = 0; i < m; ++i)
    if (const Index j = basic_[static_cast<std::size_t>(i)]; j >= 0) table_(m, j) = 0;
  work_ += static_cast<double>(2 * m * (A_.cols() + m));
}

/// The variable that lowers the cost fastest; `first`: the first one that does (no cycles).
Index Simplex::entering(bool first) const {
  const Index m = rows();
  Index best = -1;
  double lowest = -price_;
  for (Index j = free_; j < helper_; ++j) {
    if (is_basic_[static_cast<std::size_t>(j)] || !(table_(m, j) < lowest)) continue;
    best = j;
    if (first) break;
    lowest = table_(m, j);
  }
  return best;
}

/// The row that blocks `column`: among near ties the helper's, else the largest pivot's.
Index Simplex::leaving(Index column, bool first) const {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < rows(); ++i)
    if (has_sign(i) && table_(i, column) > Settings::pivot)
      least =
          std::min(least, (std::max(table_(i, value_), 0.0) + Settings::tie) / table_(i, column));
  Index best = -1;
  for (Index i = 0; i < rows(); ++i) {
    const double along = table_(i, column);
    if (!has_sign(i) || !(along > Settings::pivot) ||
        std::max(table_(i, value_), 0.0) / along > least)
      continue;
    const Index j = basic_[static_cast<std::size_t>(i)];
    if (j == helper_) return i;
    if (best < 0 ||
        (first ? j < basic_[static_cast<std::size_t>(best)] : along > table_(best, column)))
      best = i;
  }
  return best;
}

Simplex::Ending Simplex::descend() {
  const Index m = rows(), most = Settings::pivots + Settings::pivots_a_row * m;
  const bool is_lifted = is_basic_[static_cast<std::size_t>(helper_)];
  Index idle = 0;
  for (Index k = 0; k < most; ++k) {
    if (is_lifted && !is_basic_[static_cast<std::size_t>(helper_)]) return Ending::found;
    const bool first = idle > 2 * m; // at a corner of many: the largest pivots may go in circles
    const Index column = entering(first);
    if (column < 0) return Ending::found;
    const Index row = leaving(column, first);
    if (row < 0) {
      ray_ = Eigen::VectorXd::Zero(A_.cols());
      ray_[column] = 1;
      for (Index i = 0; i < m; ++i)
        if (const Index j = basic_[static_cast<std::size_t>(i)]; j >= 0 && j < helper_)
          ray_[j] = -table_(i, column);
      ray_ /= ray_.cwiseAbs().maxCoeff();
      return Ending::unbounded;
    }
    idle = table_(row, value_) > Settings::tie ? 0 : idle + 1;
    pivot(row, column);
  }
  return Ending::failed;
}

void Simplex::add(const Eigen::MatrixXd& columns) {
  const Index m = rows(), n = A_.cols(), k = columns.cols();
  A_.conservativeResize(Eigen::NoChange, n + k);
  A_.rightCols(k) = columns;
  Tableau wider = Tableau::Zero(m + 1, table_.cols() + k);
  wider.leftCols(n) = table_.leftCols(n);
  wider.block(0, n, m, k) = product(table_.block(0, multipliers_, m, m), columns);
  wider.rightCols(table_.cols() - n) = table_.rightCols(table_.cols() - n);
  table_.swap(wider);
  for (Index& j : basic_)
    if (j == helper_) j += k;
  helper_ += k;
  multipliers_ += k;
  value_ += k;
  is_basic_.insert(is_basic_.end() - 1, static_cast<std::size_t>(k), false);
  point_.conservativeResize(n + k);
  point_.tail(k).setZero();
  for (Index i = 0; i < m; ++i) { // a row that followed from others need not any more
    if (basic_[static_cast<std::size_t>(i)] >= 0) continue;
    Index best = 0;
    table_.row(i).segment(n, k).cwiseAbs().maxCoeff(&best);
    if (k > 0 && std::abs(table_(i, n + best)) > Settings::pivot) pivot(i, n + best);
  }
}

Eigen::VectorXd Simplex::multipliers() const {
  return -table_.row(rows()).segment(multipliers_, rows()).transpose();
}

/// The corner, with one step of refinement by the basis's inverse.
void Simplex::read_point() {
  const Index m = rows();
  point_.setZero();
  const auto add = [&](const Eigen::VectorXd& values) {
    for (Index i = 0; i < m; ++i)
      if (const Index j = basic_[static_cast<std::size_t>(i)]; j >= 0 && j < helper_)
        point_[j] += values[i];
  };
  add(table_.col(value_).head(m));
  const Eigen::VectorXd off = b_ - product(A_, point_);
  add(product(table_.block(0, multipliers_, m, m), off));
  work_ += static_cast<double>(m * (A_.cols() + m));
  for (Index j = free_; j < point_.size(); ++j)
    if (point_[j] < 0 && point_[j] > -Settings::balances) point_[j] = 0;
}

bool Simplex::is_point() const {
  return largest(product(A_, point_) - b_) <= Settings::balances * (1 + largest(b_)) &&
         is_above(0, point_, free_);
}

bool Simplex::is_proved(const Eigen::VectorXd& c) const {
  const Eigen::VectorXd reduced = c - product(A_.transpose(), multipliers());
  return largest(reduced.head(free_)) <= Settings::proof &&
         is_above(-Settings::proof, reduced, free_);
}

bool Simplex::is_ray(const Eigen::VectorXd& c) {
  for (Index j = free_; j < ray_.size(); ++j)
    if (ray_[j] < 0 && ray_[j] > -Settings::agrees) ray_[j] = 0;
  return largest(product(A_, ray_)) <= Settings::agrees && c.dot(ray_) < 0 &&
         is_above(0, ray_, free_);
}

Simplex::Ending Simplex::find_point() {
  ++programs_;
  const Index m = rows();
  if (m == 0) return Ending::found;
  if (!start()) return Ending::none;
  Index worst = -1;
  double lowest = -Settings::tie;
  for (Index i = 0; i < m; ++i) {
    if (!has_sign(i) || table_(i, value_) >= -Settings::tie) continue;
    table_(i, helper_) = -1;
    if (table_(i, value_) < lowest) {
      lowest = table_(i, value_);
      worst = i;
    }
  }
  if (worst >= 0) {
    pivot(worst, helper_);
    table_.row(m) = -table_.row(worst);
    table_(m, helper_) = 0;
    if (descend() != Ending::found) return Ending::failed;
    for (Index i = 0; i < m; ++i) {
      if (basic_[static_cast<std::size_t>(i)] != helper_) continue;
      const double left = table_(i, value_);
      // Row i says: helper + (what is not negative) = left, a combination of the rows as given.
      const Eigen::VectorXd y = table_.row(i).segment(multipliers_, m).transpose();
      const Eigen::VectorXd sum = -product(A_.transpose(), y);
      const bool refuted = y.dot(b_) > Settings::contradicts / 2 &&
                           largest(sum.head(free_)) <= Settings::proof &&
                           is_above(-Settings::proof, sum, free_);
      if (left > Settings::contradicts) return refuted ? Ending::none : Ending::failed;
      if (left > Settings::agrees) return Ending::failed;
      Index best = -1;
      table_.row(i).segment(free_, helper_ - free_).cwiseAbs().maxCoeff(&best);
      if (best >= 0 && std::abs(table_(i, free_ + best)) > Settings::pivot) {
        pivot(i, free_ + best);
      } else {
        table_.row(i).head(helper_).setZero();
        basic_[static_cast<std::size_t>(i)] = -1;
        is_basic_[static_cast<std::size_t>(helper_)] = false;
      }
    }
    table_.col(helper_).setZero();
  }
  read_point();
  return is_point() ? Ending::found : Ending::failed;
}

Simplex::Ending Simplex::minimise(const Eigen::VectorXd& c) {
  ++programs_;
  const double size = largest(c);
  if (!(size > 0)) return Ending::found;
  const Eigen::VectorXd costs = c / size;
  price(costs);
  for (Index j = 0; j < free_; ++j) // a free variable that no row holds
    if (!is_basic_[static_cast<std::size_t>(j)] && std::abs(table_(rows(), j)) > Settings::proof)
      return Ending::failed;
  Ending ending = descend();
  if (ending == Ending::found && !is_proved(costs)) { // small pivots have cost digits
    refine_prices(costs);
    ending = descend();
  }
  read_point();
  if (ending == Ending::failed || !is_point()) return Ending::failed;
  if (ending == Ending::unbounded) return is_ray(costs) ? ending : Ending::failed;
  return is_proved(costs) ? ending : Ending::failed;
}

std::optional<Eigen::VectorXd> cheapest_point(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                              const Eigen::VectorXd& c, Index free) {
  Simplex program(A, b, free);
  if (program.find_point() != Simplex::Ending::found ||
      program.minimise(c) != Simplex::Ending::found)
    return std::nullopt;
  return program.point();
}

} // namespace lcpush::desktop
