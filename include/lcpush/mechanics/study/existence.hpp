// Does the existence lemma [T.8] hold for a scene (theory.md 5.3, 5.4)? By linear programs:
//
//   (H1) fails if   s' >= 0, sum s' = 1,   sum_a W(n_i)' J_a s'_a <= 0 at every contact
//                   has a solution for the massless actuators;
//   (H2) fails if   f >= 0 in the cones,   G f = 0,   Q_a(f) = 0,   P(f) = 1
//                   has one: a squeeze that no actuator feels and that the prescribed motions
//                   tighten.
//
// Asked for contacts without compliance: that covers the literal laws and, as compliance only takes
// squeezes away, every first round of the pads.
#pragma once

#include "lcpush/mechanics/study/holding.hpp"

namespace lcpush {

enum class Existence {
  not_known,         ///< a linear program failed, or the memory is too small
  proved,            ///< an answer exists for every load and grip force
  closes_on_nothing, ///< (H1) fails
  can_be_squeezed,   ///< (H2) fails
  may_retreat,       ///< they hold, but an actuator could end at its bound (5.4)
};

constexpr Index existence_scalars(const AssemblySize& size) {
  const Index a = size.actuators, normals = size.points + size.pulls;
  const Index squeeze = study_scalars(size.forces(), 7 + a, size.points);
  const Index closing = study_scalars(a, 1, normals);
  return squeeze > closing ? squeeze : closing;
}
constexpr Index existence_integers(const AssemblySize& size) {
  const Index a = size.actuators, normals = size.points + size.pulls;
  const Index squeeze = linear_program_integers(size.forces(), 7 + a, size.points);
  const Index closing = linear_program_integers(a, 1, normals);
  return squeeze > closing ? squeeze : closing;
}

namespace detail {

/// (H1). `witness` receives s' of the massless actuators, per actuator.
template <class S>
Status find_idle_closing(const Assembly<S>& assembly, const StudyMemory<S>& memory,
                         const LemkeOptions<S>& options, S* witness) {
  const Layout<S>& layout = assembly.layout();
  const FactoredProblem<S>& factored = assembly.factored();
  Index massless = 0, normals = 0;
  for (const SumGroup<S>& sum : factored.sums) massless += sum.inertia > S(0) ? 0 : 1;
  for (const ConeGroup<S>& cone : layout.cones) normals += cone.normals;
  if (massless == 0) return Status::ray; // there is none
  StudyProgram<S> p(memory.scalars, massless, 1, normals);
  if (!p.fits) return Status::bad_input;
  p.A.setOnes();
  p.b.setOnes();
  Index column = 0;
  for (const SumGroup<S>& sum : factored.sums) {
    if (sum.inertia > S(0)) continue;
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      Index row = 0;
      for (const ConeGroup<S>& cone : layout.cones) {
        const Index offset = factored.coupled_variable[k] - cone.variable;
        if (offset >= 0 && offset < cone.normals) p.H(row + offset, column) -= factored.coupling[k];
        row += cone.normals;
      }
    }
    ++column;
  }
  LinearProgramSolver<S> solver(p.rest, memory.integers);
  const Status status = solver.solve(p.program(), options);
  column = 0;
  for (Index a = 0; status == Status::solved && a < factored.sums.size; ++a)
    witness[a] = factored.sums[a].inertia > S(0) ? S(0) : solver.x()[column++];
  return status;
}

/// (H2). `witness` receives the squeeze, per force column.
template <class S>
Status find_tightened_squeeze(const Assembly<S>& assembly, const StudyMemory<S>& memory,
                              const LemkeOptions<S>& options, S* witness) {
  const Scene<S>& scene = assembly.scene();
  const Layout<S>& layout = assembly.layout();
  const Index forces = layout.forces, power = (scene.planar ? 3 : 6) + layout.actuators;
  S largest(0);
  for (const Body<S>& body : scene.bodies)
    largest = Eigen::numext::maxi(largest, S(laws::prescribed(body, layout.scales).norm()));
  if (!(largest > S(0))) return Status::ray; // nothing moves: P = 0
  StudyProgram<S> p(memory.scalars, forces, power + 1, rough_points(layout));
  if (!p.fits) return Status::bad_input;
  fill_forces(assembly, p.A, p.H);
  for (Index i = 0; i < layout.points; ++i) {
    const ConeGroup<S>& cone = layout.cones[i];
    const Vector6<S> motion =
        laws::prescribed(scene.bodies[layout.body[i]], layout.scales) / largest;
    for (Index j = cone.force; j < cone.force + cone.forces(); ++j)
      p.A(power, j) = assembly.factored().wrenches[j].dot(motion);
  }
  p.b[power] = S(1);
  LinearProgramSolver<S> solver(p.rest, memory.integers);
  const Status status = solver.solve(p.program(), options);
  for (Index j = 0; status == Status::solved && j < forces; ++j) witness[j] = solver.x()[j];
  return status;
}

} // namespace detail

/// 5.4: no actuator can end at its symbolic bound. A massless one has a force, alone drives its
/// bodies, and moves each of their contacts along the normal.
template <class S> bool cannot_retreat(const Assembly<S>& assembly) {
  const Scene<S>& scene = assembly.scene();
  for (const Drive<S>& drive : scene.drives) {
    const Actuator<S>& actuator = scene.actuators[drive.actuator];
    if (actuator.inertia > S(0)) continue;
    if (!(actuator.force > S(0))) return false;
    for (const Drive<S>& other : scene.drives)
      if (other.body == drive.body && other.actuator != drive.actuator) return false;
    const Body<S>& body = scene.bodies[drive.body];
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const Vector3<S> motion = acceleration_at(scene.points[i], drive.twist);
      const S slack = S(64) * Eigen::NumTraits<S>::epsilon() * motion.norm();
      if (!(Eigen::numext::abs(motion.dot(body.normal)) > slack)) return false;
    }
  }
  return true;
}

/// Reads the assembled scene's laws, not its loads. `witness`, of the larger of forces and
/// actuators, receives what shows that (H1) or (H2) fails: closings per actuator, or forces per
/// column. Cost: two linear programs, Lemke's on forces + points unknowns.
template <class S>
[[nodiscard]] Existence study_existence(const Assembly<S>& assembly, const StudyMemory<S>& memory,
                                        const LemkeOptions<S>& options, S* witness) {
  const Status closing = detail::find_idle_closing(assembly, memory, options, witness);
  if (closing == Status::solved) return Existence::closes_on_nothing;
  if (closing != Status::ray) return Existence::not_known;
  const Status squeeze = detail::find_tightened_squeeze(assembly, memory, options, witness);
  if (squeeze == Status::solved) return Existence::can_be_squeezed;
  if (squeeze != Status::ray) return Existence::not_known;
  return cannot_retreat(assembly) ? Existence::proved : Existence::may_retreat;
}

} // namespace lcpush
