// A scene's complementarity problem as a dense matrix in SI units.
#include "lcpush/desktop/pivots.hpp"
#include "solve/owned_assembly.hpp"

namespace lcpush::desktop {
namespace {

template <class S> ExactProblem si_problem(const SceneOf<S>& file) {
  const EvenSceneOf<S> even(file.view());
  OwnedAssembly<S> owned(even.scene);
  if (file.pressure == Pressure::pad)
    owned.enter_first_round(PressureOptions<S>().first_compliance);
  const Layout<S>& layout = owned.get().layout();
  const Problem<S> problem = owned.get().problem();
  const Index n = problem.size;
  std::vector<S> M(static_cast<std::size_t>(n * n));
  fill_matrix(problem, MatrixMap<S>(M.data(), n, n));

  ExactProblem exact{{n, n, {}}, {n, 1, {}}, n - problem.free_begin};
  std::vector<S> row_units;
  for (Index i = 0; i < n; ++i) {
    row_units.push_back(row_unit(layout, i));
    exact.q.values.push_back(Rational(S(problem.q[i] * row_units.back())));
  }
  exact.M.values.reserve(M.size());
  for (Index j = 0; j < n; ++j) {
    const S unit = unknown_unit(layout, j);
    for (Index i = 0; i < n; ++i) {
      const S& entry = M[static_cast<std::size_t>(j * n + i)];
      exact.M.values.push_back(Rational(S(entry * row_units[static_cast<std::size_t>(i)] / unit)));
    }
  }
  return exact;
}

} // namespace

ExactProblem exact_problem(const SceneOf<Rational>& scene) { return si_problem(scene); }
ExactProblem exact_problem(const SceneFile& scene) { return si_problem(scene); }

} // namespace lcpush::desktop
