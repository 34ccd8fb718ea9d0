// Families of raw problems that are solvable by construction, in units of all sizes.
#pragma once

#include <cmath>

#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "support/random_grasp.hpp"

namespace lcpush::test {

/// A dense matrix under construction, with its q and free rows.
struct DenseRaw {
  Eigen::MatrixXd M;
  Eigen::VectorXd q;
  std::vector<unsigned char> free;
  std::vector<double> unit; ///< what an unknown of size 1 reads like in the problem's units

  Index size() const { return q.size(); }
  desktop::RawProblem raw() const {
    desktop::RawProblem problem;
    problem.M = desktop::rows_of({M.rows(), M.cols(), {M.data(), M.data() + M.size()}});
    problem.q.assign(q.data(), q.data() + q.size());
    problem.free = free;
    return problem;
  }
};

inline DenseRaw dense_raw(const Eigen::MatrixXd& M, const Eigen::VectorXd& q) {
  const auto n = static_cast<std::size_t>(q.size());
  return {M, q, std::vector<unsigned char>(n, 0), std::vector<double>(n, 1.0)};
}

/// The first problem of a random grasp, without its push: the pusher stands still, or is not there.
inline DenseRaw grasp_at_rest(std::uint64_t seed, bool has_pusher) {
  OwnedScene<double> grasp = random_grasp<double>(seed);
  grasp.base.pressure = Pressure::rigid;
  if (has_pusher) {
    grasp.bodies.back().acceleration.setZero();
  } else {
    grasp.points.resize(static_cast<std::size_t>(grasp.bodies.back().first_point));
    grasp.bodies.pop_back();
  }
  const Scene<double> scene = grasp.view();
  desktop::AssembledScene assembled(scene);
  (void)assembled.assembly.assemble(assembled.scene);
  const Problem<double>& problem = assembled.assembly.problem();
  DenseRaw made{Eigen::MatrixXd(problem.size, problem.size),
                Eigen::Map<const Eigen::VectorXd>(problem.q, problem.size),
                {},
                std::vector<double>(static_cast<std::size_t>(problem.size), 1.0)};
  fill_matrix(problem, MatrixMap<double>(made.M.data(), problem.size, problem.size));
  for (Index i = 0; i < problem.size; ++i) made.free.push_back(i >= problem.free_begin ? 1 : 0);
  return made;
}

/// Rows and columns times powers of ten between 10^-decades and 10^decades: other units.
inline DenseRaw in_other_units(DenseRaw given, Random& random, Index decades) {
  for (Index i = 0; i < given.size(); ++i) {
    const double row = std::pow(10.0, static_cast<double>(random.integer(-decades, decades)));
    given.M.row(i) *= row;
    given.q[i] *= row;
    const double column = std::pow(10.0, static_cast<double>(random.integer(-decades, decades)));
    given.M.col(i) *= column;
    given.unit[static_cast<std::size_t>(i)] /= column;
  }
  return given;
}

/// One more row and column of zeros.
inline void grow(DenseRaw& given, double q) {
  const Index n = given.size();
  given.M.conservativeResizeLike(Eigen::MatrixXd::Zero(n + 1, n + 1));
  given.q.conservativeResize(n + 1);
  given.q[n] = q;
  given.free.push_back(0);
  given.unit.push_back(1);
}

/// Each free unknown as the difference of two that are not, its equality as two inequalities.
inline DenseRaw with_free_split(DenseRaw given) {
  const Index n = given.size();
  for (Index i = 0; i < n; ++i) {
    if (given.free[static_cast<std::size_t>(i)] == 0) continue;
    given.free[static_cast<std::size_t>(i)] = 0;
    grow(given, -given.q[i]);
    const Index last = given.size() - 1;
    given.M.col(last) = -given.M.col(i);
    given.M.row(last) = -given.M.row(i);
  }
  return given;
}

/// Side by side, the second one's q times `scale`.
inline DenseRaw side_by_side(const DenseRaw& a, const DenseRaw& b, double scale) {
  DenseRaw both = a;
  for (Index i = 0; i < b.size(); ++i) grow(both, b.q[i] * scale);
  both.M.bottomRightCorner(b.size(), b.size()) = b.M;
  for (Index i = 0; i < b.size(); ++i)
    both.free[static_cast<std::size_t>(a.size() + i)] = b.free[static_cast<std::size_t>(i)];
  return both;
}

/// The largest violation of z >= 0, w >= 0, z w = 0 by arithmetic of its own, in long double: a row
/// by the size of its own terms, but for 1e-13 of the largest unknowns that share a row with one
/// that is not zero: what rounding leaves of them.
inline double violation(const DenseRaw& given, const std::vector<double>& z, double bound) {
  using Long = long double;
  const Index n = given.size();
  std::vector<Long> row_largest(z.size(), 0), largest(z.size(), 0);
  const auto scaled = [&](Index j) {
    const auto at = static_cast<std::size_t>(j);
    return std::abs(static_cast<Long>(z[at])) / static_cast<Long>(given.unit[at]);
  };
  for (Index i = 0; i < n; ++i) {
    Long& row = row_largest[static_cast<std::size_t>(i)];
    for (Index j = 0; j < n; ++j)
      if (given.M(i, j) != 0) row = std::max(row, scaled(j));
    for (Index j = 0; j < n; ++j)
      if (given.M(i, j) != 0)
        largest[static_cast<std::size_t>(j)] = std::max(largest[static_cast<std::size_t>(j)], row);
  }
  Long worst = 0, z_size = 0;
  for (Index j = 0; j < n; ++j) z_size = std::max(z_size, scaled(j));
  for (Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    Long w = static_cast<Long>(given.q[i]), size = std::abs(w);
    for (Index j = 0; j < n; ++j) {
      const auto column = static_cast<std::size_t>(j);
      const Long entry = static_cast<Long>(given.M(i, j)), x = static_cast<Long>(z[column]);
      w += entry * x;
      size += std::abs(entry * x);
      if (x != 0)
        size += std::abs(entry) * largest[column] * static_cast<Long>(given.unit[column]) *
                static_cast<Long>(1e-13 / bound);
    }
    const Long scaled_w = size > 0 ? w / size : 0;
    const Long sign = z[at] < 0 ? -1 : 1;
    const Long scaled_z = z_size > 0 ? sign * scaled(i) / z_size : 0;
    worst =
        std::max(worst, std::abs(given.free[at] != 0 ? scaled_w : std::min(scaled_w, scaled_z)));
  }
  return static_cast<double>(worst);
}

/// Symmetric and positive definite, with zeros in it.
inline Eigen::MatrixXd definite(Index n, Random& random) {
  Eigen::MatrixXd A(n, n);
  for (Index k = 0; k < A.size(); ++k)
    A.data()[k] = random.integer(0, 2) == 0 ? random.uniform(-1, 1) : 0.0;
  return A * A.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
}

} // namespace lcpush::test
