// [T.12] Holding: the smallest factor on the grip forces at which statics lets the hand and its
// environment, all at rest, hold the object. A linear program over the forces f and the factor phi:
//
//   minimise phi    G f + w = 0,   Q_a(f) = phi tau_a (actuators of fingers) or tau_a (others),
//                   mu_i lambda_i - sum_j beta_ij >= 0,   f >= 0,   phi >= 0.
//
// Every state of rest under [T.1] to [T.5], whatever the pressure law, is a point of it.
#pragma once

#include "lcpush/lcp/pivots/linear_program.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush {

template <class S> struct Holding {
  S factor{0}; ///< phi: no smaller one holds
  S unit{0};   ///< the factor that makes the largest grip force equal to the load; 0: there is none
  Index pivots = 0;
  Reason reason = Reason::none;
};

/// Of a program with these columns, equalities and inequalities, and its solver.
constexpr Index study_scalars(Index columns, Index m, Index k) {
  return (m + k + 1) * columns + m + linear_program_scalars(columns, m, k);
}

/// Sizes of the program: one column a force and one for phi, one equality a direction of motion and
/// an actuator, one inequality a point.
constexpr Index holding_columns(const AssemblySize& size) { return size.forces() + 1; }
constexpr Index holding_rows(const AssemblySize& size) { return 6 + size.actuators; }
constexpr Index holding_scalars(const AssemblySize& size) {
  return study_scalars(holding_columns(size), holding_rows(size), size.points);
}
constexpr Index holding_integers(const AssemblySize& size) {
  return linear_program_integers(holding_columns(size), holding_rows(size), size.points);
}

/// Of [T.12], and of the existence lemma's conditions.
template <class S> struct StudyMemory {
  Span<S> scalars;    ///< holding_scalars, existence_scalars
  Span<int> integers; ///< holding_integers, existence_integers
};

/// Does the actuator drive a finger, so that phi scales it?
template <class S> bool grips(const Scene<S>& scene, Index actuator) {
  for (const Drive<S>& drive : scene.drives)
    if (drive.actuator == actuator && scene.bodies[drive.body].role == Role::finger) return true;
  return false;
}

namespace detail {

/// A program's arrays, all zeros, cut off the front of a study's memory; `rest` is its solver's.
template <class S> struct StudyProgram {
  MatrixMap<S> A{nullptr, 0, 0}, H{nullptr, 0, 0};
  VectorMap<S> b{nullptr, 0}, c{nullptr, 0};
  Span<S> rest;
  bool fits;

  StudyProgram(Span<S> memory, Index columns, Index equalities, Index inequalities) {
    Block<S> scalars(memory);
    scalars.seat(A, equalities, columns);
    scalars.seat(H, inequalities, columns);
    scalars.seat(b, equalities);
    scalars.seat(c, columns);
    rest = scalars.take(linear_program_scalars(columns, equalities, inequalities));
    fits = !scalars.exhausted();
    for (S& x : memory) x = S(0);
  }
  LinearProgram<S> program() const {
    return {A.cols(), A.rows(), H.rows(), A.data(), b.data(), H.data(), c.data()};
  }
};

/// Points with friction: each has a row of H.
template <class S> Index rough_points(const Layout<S>& layout) {
  Index count = 0;
  for (const ConeGroup<S>& cone : layout.cones) count += cone.generators > 0 ? 1 : 0;
  return count;
}

/// Row by row, the component of a wrench that has to balance: x, y and the turn in the plane.
template <class S> Index balance_axis(const Scene<S>& scene, Index row) {
  return scene.planar && row == 2 ? 5 : row;
}

/// One a direction of motion and an actuator.
template <class S> Index balance_rows(const Assembly<S>& assembly) {
  return (assembly.scene().planar ? 3 : 6) + assembly.layout().actuators;
}

/// Minus the load, in the assembly's units, in the first rows of b; the largest of them.
template <class S> S fill_load(const Assembly<S>& assembly, VectorMap<S>& b) {
  const Scene<S>& scene = assembly.scene();
  const Vector6<S> load = laws::load(scene, assembly.layout().scales);
  const Index moving = scene.planar ? 3 : 6;
  for (Index row = 0; row < moving; ++row) b[row] = -load[balance_axis(scene, row)];
  return b.head(moving).cwiseAbs().maxCoeff();
}

/// The units that make a program's numbers about 1: forces are measured in the load (in the
/// assembly's units), phi in load over grip.
template <class S> struct HoldingProgram : StudyProgram<S> {
  using StudyProgram<S>::StudyProgram;
  S load{0}, grip{0};
};

/// b in the assembly's units: minus the load, and what actuators that drive no finger hold.
template <class S> void fill_loads(const Assembly<S>& assembly, HoldingProgram<S>& p) {
  using Eigen::numext::abs, Eigen::numext::maxi;
  p.load = fill_load(assembly, p.b);
  const Index moving = balance_rows(assembly) - assembly.layout().actuators;
  for (Index a = 0; a < assembly.layout().actuators; ++a) {
    const S& target = assembly.factored().sums[a].target;
    if (grips(assembly.scene(), a)) {
      p.grip = maxi(p.grip, S(abs(target)));
      continue;
    }
    p.b[moving + a] = target;
    p.load = maxi(p.load, S(abs(target)));
  }
  if (p.load > S(0)) p.b /= p.load;
}

/// G f in the first rows of A (in the plane only if the scene is planar), Q_a(f) in those after
/// them. Columns: the forces.
template <class S> void fill_balance(const Assembly<S>& assembly, MatrixMap<S>& A) {
  const Layout<S>& layout = assembly.layout();
  const FactoredProblem<S>& factored = assembly.factored();
  const Index moving = balance_rows(assembly) - layout.actuators;
  for (Index j = 0; j < layout.forces; ++j)
    for (Index row = 0; row < moving; ++row)
      A(row, j) = factored.wrenches[j][balance_axis(assembly.scene(), row)];
  for (Index a = 0; a < layout.actuators; ++a) {
    const SumGroup<S>& sum = factored.sums[a];
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const Index variable = factored.coupled_variable[k];
      const ConeGroup<S>& cone = layout.cones[cone_of(layout.cones, variable)];
      A(moving + a, cone.force + variable - cone.variable) += factored.coupling[k];
    }
  }
}

/// The same, and the room in the friction cones in H.
template <class S> void fill_forces(const Assembly<S>& assembly, MatrixMap<S>& A, MatrixMap<S>& H) {
  fill_balance(assembly, A);
  Index row = 0;
  for (const ConeGroup<S>& cone : assembly.layout().cones) {
    if (cone.generators == 0) continue;
    for (Index k = 0; k < cone.forces(); ++k)
      H(row, cone.force + k) = k < cone.normals ? cone.friction : S(-1);
    ++row;
  }
}

/// A, H and c.
template <class S> void fill_rows(const Assembly<S>& assembly, HoldingProgram<S>& p) {
  const Scene<S>& scene = assembly.scene();
  const Index phi = assembly.layout().forces;
  const Index moving = balance_rows(assembly) - assembly.layout().actuators;
  fill_forces(assembly, p.A, p.H);
  p.c[phi] = S(1);
  for (Index a = 0; a < assembly.layout().actuators; ++a)
    if (grips(scene, a) && p.grip > S(0))
      p.A(moving + a, phi) = -assembly.factored().sums[a].target / p.grip;
}

} // namespace detail

/// The least factor on the forces of the actuators that drive a finger. Pushers of the assembled
/// scene are at rest and bear what they must. Post: solved (no factor below holding.factor holds);
/// does_not_hold (no factor holds at all); both proved, by multipliers that are checked on the
/// program itself; bad_input (memory too small), or the pivots' failure: nothing is known.
/// Cost: Lemke's on forces + points unknowns, and n^2 memory beside it.
template <class S, class Watcher = const Unwatched>
[[nodiscard]] Status find_holding(const Assembly<S>& assembly, const StudyMemory<S>& memory,
                                  const LemkeOptions<S>& options, Holding<S>& holding,
                                  Watcher& watcher = unwatched) {
  const Layout<S>& layout = assembly.layout();
  holding = {};
  detail::HoldingProgram<S> p(memory.scalars, layout.forces + 1, detail::balance_rows(assembly),
                              detail::rough_points(layout));
  if (!p.fits) {
    holding.reason = Reason::memory_too_small;
    return Status::bad_input;
  }
  detail::fill_loads(assembly, p);
  if (!(p.load > S(0))) return Status::solved; // nothing to hold
  detail::fill_rows(assembly, p);
  LinearProgramSolver<S> solver(p.rest, memory.integers);
  const Status status = solver.solve(p.program(), options, watcher);
  holding.pivots = solver.pivots();
  holding.reason = solver.reason();
  if (p.grip > S(0)) holding.unit = p.load / p.grip;
  if (status == Status::ray) return Status::does_not_hold;
  if (status == Status::solved) holding.factor = solver.x()[layout.forces] * holding.unit;
  return status;
}

} // namespace lcpush
