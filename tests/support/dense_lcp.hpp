// Small dense complementarity problems for the tests: a run that owns its memory, and checks that
// share no code with the library.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include <Eigen/Core>

#include "lcpush/lcp/pivots/lemke.hpp"
#include "support/random_grasp.hpp"

namespace lcpush::test {

template <class S> using MatrixX = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
template <class S> using VectorX = Eigen::Matrix<S, Eigen::Dynamic, 1>;

/// w = M z + q; the last `free_count` unknowns are free.
template <class S> struct DenseLcp {
  MatrixX<S> M;
  VectorX<S> q;
  Index free_count = 0;

  Index size() const { return q.size(); }
  Problem<S> view() const {
    Problem<S> problem;
    problem.size = size();
    problem.free_begin = size() - free_count;
    problem.matrix = M.data();
    problem.q = q.data();
    return problem;
  }
};

/// Row by row, as a book prints it: n n numbers of M, then n of q.
template <class S>
DenseLcp<S> dense_lcp(Index n, std::initializer_list<int> M, std::initializer_list<int> q) {
  DenseLcp<S> lcp{MatrixX<S>(n, n), VectorX<S>(n)};
  Index k = 0;
  for (const int x : M) {
    lcp.M(k / n, k % n) = S(x);
    ++k;
  }
  k = 0;
  for (const int x : q) lcp.q[k++] = S(x);
  return lcp;
}

inline MatrixX<double> random_matrix(Random& random, Index rows, Index cols) {
  MatrixX<double> A(rows, cols);
  for (Index j = 0; j < cols; ++j)
    for (Index i = 0; i < rows; ++i) A(i, j) = random.uniform(-1, 1);
  return A;
}
inline VectorX<double> random_vector(Random& random, Index n) {
  return random_matrix(random, n, 1);
}

/// Memory and a solver on it.
template <class S> struct LemkeRun {
  std::vector<S> scalars;
  std::vector<int> integers;
  Lemke<S> lemke;

  explicit LemkeRun(Index n)
      : scalars(static_cast<std::size_t>(lemke_scalars(n))),
        integers(static_cast<std::size_t>(lemke_integers(n))),
        lemke({scalars.data(), lemke_scalars(n)}, {integers.data(), lemke_integers(n)}) {}

  Status solve(const Problem<S>& problem, const LemkeOptions<S>& options = {}) {
    const Status status = lemke.init(problem, options);
    return status == Status::running ? lemke.solve() : status;
  }
  Status solve(const DenseLcp<S>& lcp, const LemkeOptions<S>& options = {}) {
    return solve(lcp.view(), options);
  }
  VectorX<S> z() const {
    return Eigen::Map<const VectorX<S>>(lemke.z(), lemke.dictionary().size());
  }
  VectorX<S> ray() const {
    return Eigen::Map<const VectorX<S>>(lemke.ray(), lemke.dictionary().size());
  }
};

inline double absolute(double x) { return x < 0 ? -x : x; }
inline double larger(double x, double y) { return !(x >= y) ? y : x; } // keeps a NaN in y

/// How far z is from solving the problem, each row against the size of its own terms and each z
/// against the largest one. NaN if anything is NaN.
inline double solution_error(const DenseLcp<double>& lcp, const VectorX<double>& z) {
  const Index n = lcp.size();
  double worst = 0, z_max = 0;
  for (Index i = 0; i < n; ++i) z_max = larger(z_max, absolute(z[i]));
  for (Index i = 0; i < n; ++i) {
    using Long = long double;
    Long w = Long(lcp.q[i]), terms = Long(absolute(lcp.q[i]));
    for (Index j = 0; j < n; ++j) {
      w += Long(lcp.M(i, j)) * Long(z[j]);
      terms += Long(absolute(lcp.M(i, j)) * absolute(z[j]));
    }
    const double row = static_cast<double>(terms > 0 ? w / terms : w);
    const double own = z_max > 0 ? z[i] / z_max : 0;
    const bool is_free = i >= n - lcp.free_count;
    const double error = absolute(is_free ? row : row < own ? row : own);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

/// How far (v, v0) is from v >= 0, v0 >= 0, u = M v + d v0 >= 0, v_i u_i = 0, with max v = 1.
/// `d` may be empty when v0 is 0.
inline double ray_error(const MatrixX<double>& M, const VectorX<double>& d,
                        const VectorX<double>& v, double v0) {
  const double size = larger(M.cwiseAbs().rowwise().sum().maxCoeff(), 1e-300);
  VectorX<double> u = M * v;
  if (v0 != 0) u += d * v0;
  double worst = absolute(v.maxCoeff() - 1);
  worst = larger(worst, -v0);
  for (Index i = 0; i < v.size(); ++i) {
    worst = larger(worst, -v[i]);
    worst = larger(worst, -u[i] / size);
    worst = larger(worst, absolute(v[i] * u[i]) / size);
  }
  return worst;
}

} // namespace lcpush::test
