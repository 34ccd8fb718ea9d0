// Pressure laws: how a patch shares its force over its points. The paper fixes only the sum of a
// patch's normal forces [P.6]; docs/theory.md, "Pressure laws", says why that is not enough.
#pragma once

#include "lcpush/lcp/lemke.hpp"
#include "lcpush/mechanics/answer.hpp"
#include "lcpush/mechanics/assemble.hpp"

namespace lcpush {

template <class S> struct PressureOptions {
  LemkeOptions<S> lemke{};
  S first_compliance{S(1) / S(100)}; ///< eps of round 1
  S factor{S(0.31622776601683794)};  ///< eps falls by this a round
  Index max_rounds = 60;
  S tolerance = Tolerances<S>().settled; ///< scaled violation of the literal [T.2] allowed
};

/// What a pressure solve did, for reports.
struct PressureRun {
  Index rounds = 0;
  Index pivots = 0;
  Index cold_restarts = 0; ///< rounds that could not go on from the last basis
  Reason reason = Reason::none;
  bool jammed = false; ///< a ray of the problem without compliance: a squeeze, not a pad's failure
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

/// Memory beside Lemke's: one Scalar a point for the last round's pressure, three a point and
/// unknown for bookkeeping, one flag an unknown.
template <class S> struct PressureMemory {
  Span<S> preload;            ///< points: lambda of the last round
  Span<S> compliance;         ///< points: c_i
  Span<S> z;                  ///< unknowns: the last round's solution
  Span<unsigned char> active; ///< unknowns: its basis
};

/// [T.7] Pad: round r adds eps_r c_i (lambda_i - lambda_i^(r-1)) to [T.2].
/// Sets c_i: k / m on a force-controlled patch of k > 1 points; 1e-3 k / m on a position-controlled
/// body whose k normals are linearly dependent; 0 otherwise. And lambda^(0): each patch's own force
/// shared evenly over its points, 0 where no force is prescribed.
template <class S> void pad_preload(const Assembly<S>& assembly, const PressureMemory<S>& memory);

/// Solves assembly.problem() under the scene's pressure law. `lemke` keeps the last factored basis.
/// Post: solved (memory.z holds the unknowns), or Lemke's failure.
/// Cost: rigid one Lemke run; pad one cold and a few warm ones.
template <class S>
[[nodiscard]] Status solve_pressure(Assembly<S>& assembly, Lemke<S>& lemke,
                                    const PressureMemory<S>& memory,
                                    const PressureOptions<S>& options, PressureRun& run);

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

/// One solver run with the present compliance. Post: solved, with memory.z and memory.active set.
template <class S>
Status run_round(Assembly<S>& assembly, Lemke<S>& lemke, const PressureMemory<S>& memory,
                 const LemkeOptions<S>& options, bool warm, PressureRun& run) {
  const Problem<S> problem = assembly.problem();
  Status status =
      warm ? lemke.init(problem, options, memory.active.data) : lemke.init(problem, options);
  if (status == Status::running) status = lemke.solve();
  run.pivots += lemke.pivots();
  run.reason = lemke.reason();
  if (status != Status::solved) return status;
  for (Index i = 0; i < problem.size; ++i) {
    memory.z[i] = lemke.z()[i];
    memory.active[i] = lemke.is_basic(i) ? 1 : 0;
  }
  return status;
}

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

/// One warm round: from the last basis, under other covers if one of them ends in a ray
/// (copositivity does not protect a warm start).
template <class S>
Status run_warm_round(Assembly<S>& assembly, Lemke<S>& lemke, const PressureMemory<S>& memory,
                      LemkeOptions<S> options, PressureRun& run) {
  const Index covers = options.covers;
  options.covers = 1;
  Status status = Status::ray;
  for (Index k = 0; k < covers && status != Status::solved; ++k, ++options.first_cover)
    status = run_round(assembly, lemke, memory, options, true, run);
  return status;
}

} // namespace detail

/// The rounds, the first of them cold or from the basis in memory.active.
template <class S>
Status solve_pad(Assembly<S>& assembly, Lemke<S>& lemke, const PressureMemory<S>& memory,
                 const PressureOptions<S>& options, bool warm, PressureRun& run) {
  S eps = options.first_compliance, factor = options.factor, last_eps = eps;
  pad_preload(assembly, memory);
  for (Index round = 0; round < options.max_rounds; ++round, warm = true) {
    ++run.rounds;
    detail::set_compliance(assembly, memory, eps);
    Status status = warm ? detail::run_warm_round(assembly, lemke, memory, options.lemke, run)
                         : detail::run_round(assembly, lemke, memory, options.lemke, false, run);
    if (status != Status::solved && warm && factor < S(0.7)) {
      factor = Eigen::numext::sqrt(factor); // come down more slowly
      eps = last_eps * factor;
      continue;
    }
    if (status != Status::solved && warm) {
      ++run.cold_restarts;
      status = detail::run_round(assembly, lemke, memory, options.lemke, false, run);
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

template <class S>
Status solve_pressure(Assembly<S>& assembly, Lemke<S>& lemke, const PressureMemory<S>& memory,
                      const PressureOptions<S>& options, PressureRun& run) {
  run = {};
  if (refuses(assembly, run)) return Status::bad_input;
  const bool pad = assembly.scene().pressure == Pressure::pad;
  PressureOptions<S> now = options;
  if (pad) {
    const Status status = solve_pad(assembly, lemke, memory, now, false, run);
    if (status == Status::solved || status == Status::bad_input) return status;
  }
  // Compliance hides a jam: a squeezed pad just gives way. Without it the ray shows. If there is
  // none, soft pads followed a squeeze that stiff ones resist: start stiff, from the literal basis.
  constexpr int stiffer_starts = 2;
  for (int k = 0; k < stiffer_starts; ++k) {
    detail::set_compliance(assembly, memory, S(0));
    Status status = detail::run_round(assembly, lemke, memory, now.lemke, false, run);
    run.jammed = status == Status::ray;
    if (!pad || status != Status::solved) return status;
    ++run.cold_restarts;
    now.first_compliance /= S(100);
    now.lemke.first_cover += now.lemke.covers;
    status = solve_pad(assembly, lemke, memory, now, true, run);
    if (status == Status::solved) return status;
  }
  return Status::numerical_breakdown;
}

} // namespace lcpush
