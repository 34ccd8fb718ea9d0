// A linear program with its memory: minimise c x subject to A x = b, x >= 0.
#pragma once

#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/pivots/linear_program.hpp"

namespace lcpush::desktop {

struct OwnedProgram {
  Eigen::MatrixXd A;
  Eigen::VectorXd b, c;
  Eigen::VectorXd x;           ///< solved: a cheapest one
  Eigen::VectorXd multipliers; ///< solved or ray: of the rows, as LinearProgramSolver gives them
  Index pivots = 0;

  OwnedProgram(Index columns, Index equalities)
      : A(Eigen::MatrixXd::Zero(equalities, columns)), b(Eigen::VectorXd::Zero(equalities)),
        c(Eigen::VectorXd::Zero(columns)) {}

  Status solve(const LemkeOptions<double>& options = {}) {
    const Index n = A.cols(), m = A.rows();
    Owned<LinearProgramSolver<double>> solver(linear_program_scalars(n, m, 0),
                                              linear_program_integers(n, m, 0));
    const LinearProgram<double> program{n, m, 0, A.data(), b.data(), nullptr, c.data()};
    const Status status = solver.solve(program, options);
    pivots = solver.pivots();
    if (status == Status::solved) x = Eigen::Map<const Eigen::VectorXd>(solver.x(), n);
    if (status == Status::solved || status == Status::ray)
      multipliers = Eigen::Map<const Eigen::VectorXd>(solver.equality_multipliers(), m);
    return status;
  }
};

} // namespace lcpush::desktop
