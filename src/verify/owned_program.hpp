// A linear program with its memory: minimise c x subject to A x = b, x >= 0.
#pragma once

#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/pivots/linear_program.hpp"

#include <optional>

namespace lcpush::desktop {

class OwnedProgram {
public:
  Eigen::MatrixXd A;
  Eigen::VectorXd b, c;

  OwnedProgram(Index columns, Index equalities)
      : A(Eigen::MatrixXd::Zero(equalities, columns)), b(Eigen::VectorXd::Zero(equalities)),
        c(Eigen::VectorXd::Zero(columns)) {}

  /// A cheapest x; nothing if there is none, or if it was not found.
  std::optional<Eigen::VectorXd> solve() const {
    const Index n = A.cols(), m = A.rows();
    Owned<LinearProgramSolver<double>> solver(linear_program_scalars(n, m, 0),
                                              linear_program_integers(n, m, 0));
    const LinearProgram<double> program{n, m, 0, A.data(), b.data(), nullptr, c.data()};
    if (solver.solve(program, LemkeOptions<double>()) != Status::solved) return std::nullopt;
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(solver.x(), n));
  }
};

} // namespace lcpush::desktop
