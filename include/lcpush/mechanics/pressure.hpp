// Pressure laws: how a patch shares its force over its points. The paper fixes only the sum of a
// patch's normal forces [P.6]; docs/theory.md, "Pressure laws", says why that is not enough.
#pragma once

#include "lcpush/mechanics/answer.hpp"
#include "lcpush/mechanics/assemble.hpp"
#include "lcpush/mechanics/rounds.hpp"

namespace lcpush {

template <class S> struct PressureOptions {
  S first_compliance{S(1) / S(100)}; ///< eps of round 1
  S factor{S(0.31622776601683794)};  ///< eps falls by this a round
  Index max_rounds = 60;
  S tolerance = Tolerances<S>().settled; ///< scaled violation of the literal [T.2] allowed
};

/// Is there nothing to solve? True, with run.reason, if the assembly did not fit its memory, if the
/// pressure is to be even but spread_evenly was not called, or if a soft contact is no single
/// point.
template <class S> bool refuses(const Assembly<S>& assembly, PressureRun& run) {
  const Scene<S>& scene = assembly.scene();
  if (assembly.layout().points < scene.points.size) run.reason = Reason::memory_too_small;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    if (scene.bodies[b].point_count == 1) continue;
    if (scene.bodies[b].torsion_radius > S(0)) run.reason = Reason::unsupported;
    if (scene.pressure == Pressure::even && is_driven(scene, b)) run.reason = Reason::unsupported;
  }
  return run.reason != Reason::none;
}

/// [T.7] Pad: round r adds eps_r c_i (lambda_i - lambda_i^(r-1)) to [T.2].
/// Sets c_i: k / m on a force-controlled patch of k > 1 points; 1e-3 k / m on a position-controlled
/// body whose k normals are linearly dependent; 0 otherwise. And lambda^(0): each patch's own force
/// shared evenly over its points, 0 where no force is prescribed.
template <class S> void pad_preload(const Assembly<S>& assembly, const PressureMemory<S>& memory);

/// Solves assembly.problem() under the scene's pressure law, by one of the solvers of rounds.hpp.
/// Post: solved (memory.z holds the unknowns), or the solver's failure.
/// Cost: rigid and even one run; pad one cold and a few warm ones.
template <class S, class Rounds>
[[nodiscard]] Status solve_pressure(Assembly<S>& assembly, Rounds rounds,
                                    const PressureMemory<S>& memory,
                                    const PressureOptions<S>& options, PressureRun& run);

/// The same by Lemke's pivots with their usual options.
template <class S>
[[nodiscard]] Status solve_pressure(Assembly<S>& assembly, Lemke<S>& lemke,
                                    const PressureMemory<S>& memory,
                                    const PressureOptions<S>& options, PressureRun& run) {
  return solve_pressure(assembly, LemkeRounds<S>{lemke}, memory, options, run);
}

namespace detail {

/// Dimension (0 to 2) of the affine hull of a body's points, projected onto its contact plane.
template <class S> Index affine_rank(const Scene<S>& scene, const Body<S>& body) {
  using std::abs;
  Vector3<S> basis[2];
  Index rank = 0;
  S size(0);
  const Vector3<S>& origin = scene.points[body.first_point];
  for (Index i = 1; i < body.point_count; ++i) {
    const S distance = (scene.points[body.first_point + i] - origin).norm();
    if (distance > size) size = distance;
  }
  for (Index i = 1; i < body.point_count && rank < 2; ++i) {
    // Only the part in the contact plane tells the columns W(n) of two points apart.
    Vector3<S> between = scene.points[body.first_point + i] - origin;
    between -= between.dot(body.normal) * body.normal;
    for (Index k = 0; k < rank; ++k) between -= between.dot(basis[k]) * basis[k];
    const S rest = between.norm();
    if (rest > size * S(1) / S(1000)) basis[rank++] = between / rest;
  }
  return rank;
}

} // namespace detail

template <class S> void pad_preload(const Assembly<S>& assembly, const PressureMemory<S>& memory) {
  const Scene<S>& scene = assembly.scene();
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    const Index k = body.point_count;
    S share(0);
    bool driven = false;
    for (const Drive<S>& drive : scene.drives) {
      if (drive.body != b) continue;
      Index driven_bodies = 0;
      for (const Drive<S>& other : scene.drives)
        if (other.actuator == drive.actuator) ++driven_bodies;
      const S along = closing_speed(scene, body, drive);
      driven = true;
      if (along > S(0))
        share += scene.actuators[drive.actuator].force / (along * S(driven_bodies) * S(k));
    }
    const bool dependent = k > detail::affine_rank(scene, body) + 1;
    const S c = driven ? (k > 1 ? S(k) : S(0)) : dependent ? S(k) / S(1000) : S(0);
    for (Index i = body.first_point; i < body.first_point + k; ++i) {
      memory.preload[i] = share / assembly.layout().scales.force;
      memory.compliance[i] = c;
    }
  }
}

namespace detail {

/// Sets eps c_i on the normal rows, around the last round's pressure.
template <class S>
void set_compliance(Assembly<S>& assembly, const PressureMemory<S>& memory, S eps) {
  assembly.push_by(assembly.sigma());
  for (Index i = 0; i < assembly.layout().points; ++i) {
    const S c = eps * memory.compliance[i];
    const ConeGroup<S>& cone = assembly.cones()[i];
    assembly.cones()[i].compliance = c;
    assembly.q()[cone.variable] -= c * memory.preload[i];
    if (cone.normals == 2) assembly.q()[cone.variable + 1] += c * memory.preload[i];
  }
}

/// By how much the round's answer violates the literal [T.2]; the pressure becomes the next
/// round's preload. `largest` receives the largest normal force.
template <class S>
S take_pressure(const Assembly<S>& assembly, const PressureMemory<S>& memory, S& largest) {
  S violation(0);
  largest = S(0);
  for (Index i = 0; i < assembly.layout().points; ++i) {
    const ConeGroup<S>& cone = assembly.cones()[i];
    const S lambda = cone.normal_force(memory.z.data);
    const S change = cone.compliance * (lambda - memory.preload[i]);
    violation = Eigen::numext::maxi(violation, Eigen::numext::abs(change));
    largest = Eigen::numext::maxi(largest, Eigen::numext::abs(lambda));
    memory.preload[i] = lambda;
  }
  return violation;
}

/// A normal force beyond this is a squeeze that the rounds only tighten: a thousand times what the
/// scene's forces and prescribed motions ask for.
template <class S> S runaway_force(const Assembly<S>& assembly) {
  S largest(1);
  for (const S& x : assembly.q()) largest = Eigen::numext::maxi(largest, S(Eigen::numext::abs(x)));
  return S(1000) * largest;
}

} // namespace detail

/// The rounds, the first of them cold or from the last answer in `memory`.
template <class S, class Rounds>
Status solve_pad(Assembly<S>& assembly, Rounds& rounds, const PressureMemory<S>& memory,
                 const PressureOptions<S>& options, bool warm, PressureRun& run) {
  S eps = options.first_compliance, factor = options.factor, last_eps = eps;
  pad_preload(assembly, memory);
  for (Index round = 0; round < options.max_rounds; ++round, warm = true) {
    ++run.rounds;
    detail::set_compliance(assembly, memory, eps);
    Status status = rounds.solve(assembly.problem(), warm, memory, run);
    if (status != Status::solved && warm && factor < S(0.7)) {
      factor = Eigen::numext::sqrt(factor); // come down more slowly
      eps = last_eps * factor;
      continue;
    }
    if (status != Status::solved && warm) {
      ++run.cold_restarts;
      status = rounds.solve(assembly.problem(), false, memory, run);
    }
    if (status != Status::solved) return status;
    S largest(0);
    const S violation = detail::take_pressure(assembly, memory, largest);
    if (violation <= options.tolerance) return Status::solved;
    if (largest > detail::runaway_force(assembly)) return Status::numerical_breakdown;
    last_eps = eps;
    factor = Eigen::numext::maxi(options.factor, S(factor * factor));
    eps *= factor;
  }
  return Status::numerical_breakdown;
}

template <class S, class Rounds>
Status solve_pressure(Assembly<S>& assembly, Rounds rounds, const PressureMemory<S>& memory,
                      const PressureOptions<S>& options, PressureRun& run) {
  run = {};
  if (refuses(assembly, run)) return Status::bad_input;
  const bool pad = assembly.scene().pressure == Pressure::pad;
  PressureOptions<S> now = options;
  if (pad) {
    const Status status = solve_pad(assembly, rounds, memory, now, false, run);
    if (status == Status::solved || status == Status::bad_input) return status;
  }
  // Compliance hides a jam: a squeezed pad just gives way. Without it the ray shows. If there is
  // none, soft pads followed a squeeze that stiff ones resist: start stiff, from the literal basis.
  constexpr int stiffer_starts = 2;
  for (int k = 0; k < stiffer_starts; ++k) {
    detail::set_compliance(assembly, memory, S(0));
    Status status = rounds.solve(assembly.problem(), false, memory, run);
    run.jammed = status == Status::ray;
    if (!pad || status != Status::solved) return status;
    ++run.cold_restarts;
    now.first_compliance /= S(100);
    rounds.vary();
    status = solve_pad(assembly, rounds, memory, now, true, run);
    if (status == Status::solved) return status;
  }
  return Status::numerical_breakdown;
}

} // namespace lcpush
