// Pressure laws: how a patch shares its force over its points. The paper fixes only the sum of a
// patch's normal forces [P.6]; docs/theory/theory.md, "Pressure laws", says why that is not enough.
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/assemble.hpp"
#include "lcpush/mechanics/solve/rounds.hpp"

namespace lcpush {

template <class S> struct PressureOptions {
  S first_compliance{S(1) / S(100)}; ///< eps of round 1
  S factor{S(0.31622776601683794)};  ///< eps falls by this a round
  Index max_rounds = 60;
  S tolerance = Tolerances<S>().settled; ///< scaled violation of the literal [T.2] allowed
};

/// Why there is nothing to solve, if so: the assembly did not fit its memory, the pressure is to be
/// even but spread_evenly was not called, or a soft contact is no single point.
template <class S> Reason unsupported_reason(const Assembly<S>& assembly) {
  const Scene<S>& scene = assembly.scene();
  for (Index b = 0; b < scene.bodies.size; ++b) {
    if (scene.bodies[b].point_count == 1) continue;
    if (scene.bodies[b].torsion_radius > S(0)) return Reason::unsupported;
    if (scene.pressure == Pressure::even && is_driven(scene, b)) return Reason::unsupported;
  }
  const bool fits = assembly.layout().points >= scene.points.size;
  return fits ? Reason::none : Reason::memory_too_small;
}

namespace detail {

/// Dimension (0 to 2) of the affine hull of a body's points, projected onto its contact plane.
template <class S> Index affine_rank(const Scene<S>& scene, const Body<S>& body) {
  using std::abs;
  Vector3<S> basis[2];
  Index rank = 0;
  S size(0);
  const Vector3<S>& origin = scene.points[body.first_point];
  for (Index i = 1; i < body.point_count; ++i)
    size = Eigen::numext::maxi(size, S((scene.points[body.first_point + i] - origin).norm()));
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

/// [T.7] Pad: round r adds eps_r c_i (lambda_i - lambda_i^(r-1)) to [T.2].
/// With the points' weights w_i, sets c_i: 1 / (m w_i) on a force-controlled patch of several
/// points and on a locked finger; a thousandth of that on another position-controlled body whose
/// normals are linearly dependent; 0 otherwise. And lambda^(0): w_i of each patch's own force or
/// preload, 0 where there is none.
template <class S> void pad_preload(const Assembly<S>& assembly, const PressureMemory<S>& memory) {
  const Scene<S>& scene = assembly.scene();
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    const Index k = body.point_count;
    S force = body.preload;
    bool driven = false;
    for (const Drive<S>& drive : scene.drives) {
      if (drive.body != b) continue;
      const Index driven_bodies = drive_count(scene, drive.actuator);
      const S along = closing_speed(scene, body, drive);
      driven = true;
      if (along > S(0)) force += scene.actuators[drive.actuator].force / (along * S(driven_bodies));
    }
    const bool dependent = k > detail::affine_rank(scene, body) + 1;
    const bool locked = body.preload > S(0);
    const bool soft = locked || (driven && k > 1);
    const S softness = soft ? S(1) : !driven && dependent ? S(1) / S(1000) : S(0);
    for (Index i = body.first_point; i < body.first_point + k; ++i) {
      const S weight = weight_of(scene, body, i);
      memory.preload[i] = weight * force / assembly.layout().scales.force;
      memory.compliance[i] = softness / weight;
    }
  }
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

namespace detail {

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

/// Solves assembly.problem() under the scene's pressure law, by one of the solvers of rounds.hpp:
/// init, step (at most one pivot), solve (a loop over step). A control loop spends as many steps a
/// tick as it has time for.
///
/// Under `pad` the first round is cold, every later one goes on from the last answer. Compliance
/// hides a jam: a squeezed pad just gives way. If the rounds fail, the literal problem is solved
/// without any, so that a ray shows. If there is none, soft pads followed a squeeze that stiff ones
/// resist: the rounds start again stiff, from the literal basis, twice at most.
template <class S, class Rounds> class PressureSolve {
public:
  /// `assembly` and `memory` outlive the solve.
  PressureSolve(Assembly<S>& assembly, const Rounds& rounds, const PressureMemory<S>& memory,
                const PressureOptions<S>& options)
      : assembly_(assembly), rounds_(rounds), memory_(memory), options_(options) {}

  /// Post: running; or bad_input with run().reason.
  [[nodiscard]] Status init() {
    run_ = {};
    run_.reason = unsupported_reason(assembly_);
    if (run_.reason != Reason::none) return Status::bad_input;
    stiffer_ = 0;
    if (is_pad())
      begin_pads(Phase::soft_pads);
    else
      begin_literal();
    return Status::running;
  }

  /// Post: running; solved (memory.z holds the unknowns); or the solver's failure.
  [[nodiscard]] Status step();

  /// Cost: rigid and even one run; pad one cold and a few warm ones.
  [[nodiscard]] Status solve() {
    Status status = init();
    while (status == Status::running) status = step();
    return status;
  }

  const PressureRun& run() const { return run_; }

private:
  enum class Phase { soft_pads, literal, stiff_pads };
  static constexpr int stiffer_starts = 2;

  Assembly<S>& assembly_;
  Rounds rounds_;
  PressureMemory<S> memory_;
  PressureOptions<S> options_;
  PressureRun run_{};
  Phase phase_ = Phase::literal;
  int stiffer_ = 0; // starts that have been made
  S eps_{0}, last_eps_{0}, factor_{0};
  Index round_ = 0;
  bool warm_ = false, restarted_ = false; // of this round

  bool is_pad() const { return assembly_.scene().pressure == Pressure::pad; }

  void begin_literal() {
    phase_ = Phase::literal;
    set_compliance(assembly_, memory_, S(0));
    rounds_.begin(assembly_.problem(), false, memory_);
  }

  /// The rounds, the first of them cold, or stiff from the literal answer.
  void begin_pads(Phase phase) {
    phase_ = phase;
    eps_ = last_eps_ = options_.first_compliance;
    factor_ = options_.factor;
    round_ = 0;
    warm_ = phase == Phase::stiff_pads;
    pad_preload(assembly_, memory_);
    begin_round();
  }

  void begin_round() {
    ++run_.rounds;
    restarted_ = false;
    set_compliance(assembly_, memory_, eps_);
    rounds_.begin(assembly_.problem(), warm_, memory_);
  }

  Status next_round() {
    if (++round_ == options_.max_rounds) return end_pads(Status::numerical_breakdown);
    warm_ = true;
    begin_round();
    return Status::running;
  }

  Status end_round(Status status) {
    using Eigen::numext::maxi;
    if (status != Status::solved && warm_ && !restarted_) {
      if (factor_ < S(0.7)) {
        factor_ = Eigen::numext::sqrt(factor_); // come down more slowly
        eps_ = last_eps_ * factor_;
        return next_round();
      }
      ++run_.cold_restarts;
      restarted_ = true;
      rounds_.begin(assembly_.problem(), false, memory_);
      return Status::running;
    }
    if (status != Status::solved) return end_pads(status);
    S largest(0);
    const S violation = detail::take_pressure(assembly_, memory_, largest);
    if (violation <= options_.tolerance) return Status::solved;
    if (largest > detail::runaway_force(assembly_)) return end_pads(Status::numerical_breakdown);
    last_eps_ = eps_;
    factor_ = maxi(options_.factor, S(factor_ * factor_));
    eps_ *= factor_;
    return next_round();
  }

  /// The pads have failed.
  Status end_pads(Status status) {
    if (phase_ == Phase::soft_pads && status == Status::bad_input) return status;
    if (phase_ == Phase::stiff_pads && stiffer_ == stiffer_starts)
      return Status::numerical_breakdown;
    begin_literal();
    return Status::running;
  }

  Status end_literal(Status status) {
    run_.jammed = status == Status::ray;
    if (!is_pad() || status != Status::solved) return status;
    ++run_.cold_restarts;
    ++stiffer_;
    options_.first_compliance /= S(100);
    rounds_.vary();
    begin_pads(Phase::stiff_pads);
    return Status::running;
  }
};

template <class S, class Rounds> Status PressureSolve<S, Rounds>::step() {
  const Status status = rounds_.step(memory_, run_);
  if (status == Status::running) return status;
  return phase_ == Phase::literal ? end_literal(status) : end_round(status);
}

/// All of it at once.
template <class S, class Rounds>
[[nodiscard]] Status solve_pressure(Assembly<S>& assembly, const Rounds& rounds,
                                    const PressureMemory<S>& memory,
                                    const PressureOptions<S>& options, PressureRun& run) {
  PressureSolve<S, Rounds> solve(assembly, rounds, memory, options);
  const Status status = solve.solve();
  run = solve.run();
  return status;
}

} // namespace lcpush
