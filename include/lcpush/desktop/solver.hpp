// The solvers by name.
#pragma once

namespace lcpush::desktop {

enum class Solver { lemke, gauss_seidel, hybrid };

/// As --solver spells it.
constexpr const char* solver_text(Solver solver) {
  return solver == Solver::lemke ? "lemke" : solver == Solver::hybrid ? "hybrid" : "gauss-seidel";
}

} // namespace lcpush::desktop
