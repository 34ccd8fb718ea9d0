#include "dense/nonnegative_least_squares.hpp"

#include <algorithm>
#include <vector>

#include "dense/decompositions.hpp"

namespace lcpush::desktop {

namespace {

/// The least squares of the chosen columns, 0 elsewhere.
Eigen::VectorXd solve_chosen(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                             const std::vector<Index>& chosen) {
  Eigen::MatrixXd columns(A.rows(), static_cast<Index>(chosen.size()));
  for (std::size_t k = 0; k < chosen.size(); ++k)
    columns.col(static_cast<Index>(k)) = A.col(chosen[k]);
  const Eigen::VectorXd found = least_squares(columns, b);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  for (std::size_t k = 0; k < chosen.size(); ++k) x[chosen[k]] = found[static_cast<Index>(k)];
  return x;
}

} // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  constexpr double rounding = 1e-13;
  const Index n = A.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<Index> chosen;
  for (Index exchange = 0; exchange < 3 * n; ++exchange) {
    Eigen::VectorXd gain = A.transpose() * (b - A * x);
    for (const Index j : chosen) gain[j] = 0;
    Index entering = 0;
    if (!(gain.size() > 0 && gain.maxCoeff(&entering) > rounding * (1 + b.norm()))) break;
    chosen.push_back(entering);
    for (;;) {
      const Eigen::VectorXd target = solve_chosen(A, b, chosen);
      double step = 1;
      for (const Index j : chosen)
        if (target[j] <= 0) step = std::min(step, x[j] > 0 ? x[j] / (x[j] - target[j]) : 0.0);
      x += step * (target - x);
      if (!(step < 1)) break;
      const auto leaves = [&](Index j) { return !(x[j] > rounding); };
      for (const Index j : chosen)
        if (leaves(j)) x[j] = 0;
      chosen.erase(std::remove_if(chosen.begin(), chosen.end(), leaves), chosen.end());
    }
  }
  return x;
}

} // namespace lcpush::desktop
