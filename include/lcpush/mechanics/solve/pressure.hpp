// Pressure laws: how a patch shares its force over its points. The paper fixes only the sum of a
// patch's normal forces [P.6]; docs/theory/theory.md, "Pressure laws", says why that is not enough.
#pragma once

#include "lcpush/mechanics/solve/pad_law.hpp"
#include "lcpush/mechanics/solve/round_friction.hpp"

namespace lcpush {

template <class S> struct PressureOptions {
  S first_compliance{S(1) / S(100)}; ///< eps of round 1
  S factor{S(0.31622776601683794)};  ///< eps falls by this a round
  Index max_rounds = 60;
  Index max_retreats = 0;                ///< to softer pads, by rounds that can: where a cold
                                         ///< start is dear
  S stiffest{0};                         ///< eps below it are numerical_breakdown: the caller
                                         ///< can ask for less stiff pads
  Index max_turns = 32;                  ///< of round friction's pyramids
  S tolerance = Tolerances<S>().settled; ///< scaled violation of the literal [T.2] allowed
  Index fine_rounds = 0; ///< so many more at most, while the violation is above `finest`
  S finest{0};
  bool exact_limit = true; ///< a breaking force by an infinitesimal push, where rounds carry one
  bool goes_on = false;    ///< `pad`: from the memory's last answer, as if this were its next round
};

/// Why there is nothing to solve, if so: the assembly did not fit its memory, the pressure is to be
/// even but spread_evenly was not called, or a soft contact is no single point.
template <class S> Reason unsupported_reason(const Assembly<S>& assembly) {
  const Scene<S>& scene = assembly.scene();
  for (Index b = 0; b < scene.bodies.size; ++b) {
    if (scene.bodies[b].point_count == 1) continue;
    if (scene.bodies[b].torsion_radius > S(0)) return Reason::unsupported;
    if (presses_evenly(scene) && is_driven(scene, b)) return Reason::unsupported;
  }
  const bool fits = assembly.layout().points >= scene.points.size;
  return fits ? Reason::none : Reason::memory_too_small;
}

/// Solves assembly.problem() under the scene's pressure law, by one of the solvers of rounds.hpp:
/// init, step (at most one pivot), solve (a loop over step). A control loop spends as many steps a
/// tick as it has time for.
///
/// Under `pad` the first round is cold, every later one goes on from the last answer. Compliance
/// hides a jam: a squeezed pad just gives way. If the rounds fail, the literal problem is solved
/// without any, so that a ray shows. If there is none, soft pads followed a squeeze that stiff ones
/// resist: the rounds start again stiff, from the literal basis, twice at most.
///
/// Stiff pads may lose their answer in the digits, or where it has no continuation. Rounds that may
/// retreat go back to softer ones then and come down slowly. While the same points press, the
/// object moves as before and every round changes the pressure alike; so that change is repeated at
/// once until a point lets go.
///
/// Under round friction every round turns the pyramids, and the rounds go on until the friction is
/// settled as well.
template <class S, class Rounds> class PressureSolve {
public:
  /// `assembly` and `memory` outlive the solve, and what `round` looks at.
  PressureSolve(Assembly<S>& assembly, const Rounds& rounds, const PressureMemory<S>& memory,
                const PressureOptions<S>& options, const FrictionMemory<S>& round = {})
      : assembly_(assembly), rounds_(rounds), memory_(memory), options_(options),
        friction_(assembly, round) {}

  /// Post: running; or bad_input with run().reason.
  [[nodiscard]] Status init() {
    run_ = {};
    run_.reason = unsupported_reason(assembly_);
    if (run_.reason != Reason::none) return Status::bad_input;
    stiffer_ = 0;
    fine_ = 0;
    friction_.begin();
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
  const S& compliance() const { return eps_; } ///< `pad`: of the last round

private:
  enum class Phase { soft_pads, literal, stiff_pads };
  static constexpr int stiffer_starts = 2;

  Assembly<S>& assembly_;
  Rounds rounds_;
  PressureMemory<S> memory_;
  PressureOptions<S> options_;
  RoundFriction<S> friction_;
  PressureRun run_{};
  Phase phase_ = Phase::literal;
  int stiffer_ = 0; // starts that have been made
  S eps_{0}, last_eps_{0}, factor_{0};
  Index round_ = 0, fine_ = 0;
  bool warm_ = false, restarted_ = false; // of this round
  Index retreats_ = 0;                    // to softer pads
  S last_violation_{0};

  bool is_pad() const { return assembly_.scene().pressure == Pressure::pad; }

  void begin_solver(bool warm) { rounds_.begin(assembly_.problem(), warm, memory_); }
  /// The same round, cold.
  Status restart() {
    ++run_.cold_restarts;
    restarted_ = true;
    begin_solver(false);
    return Status::running;
  }

  void begin_literal() {
    phase_ = Phase::literal;
    set_compliance(assembly_, memory_, S(0));
    begin_solver(false);
  }

  /// The rounds, the first of them cold, or going on, or stiff from the literal answer.
  void begin_pads(Phase phase) {
    phase_ = phase;
    eps_ = last_eps_ = options_.first_compliance;
    factor_ = options_.factor;
    round_ = 0;
    retreats_ = 0;
    const bool goes_on = phase == Phase::soft_pads && options_.goes_on;
    warm_ = goes_on || phase == Phase::stiff_pads;
    if (!goes_on) pad_preload(assembly_, memory_);
    begin_round();
  }

  void begin_round() {
    ++run_.rounds;
    restarted_ = false;
    set_compliance(assembly_, memory_, eps_);
    begin_solver(warm_);
  }

  Status next_round() {
    if (Rounds::retreats && eps_ < options_.stiffest) return Status::numerical_breakdown;
    if (++round_ == options_.max_rounds)
      return end_pads(Status::numerical_breakdown, Reason::unsettled);
    warm_ = true;
    begin_round();
    return Status::running;
  }

  Status end_round(Status status) {
    using Eigen::numext::maxi;
    const bool is_lost = status != Status::solved && warm_;
    if (is_lost && may_retreat()) return retreat();
    if (is_lost && !restarted_) {
      if (factor_ < S(0.7)) {
        factor_ = Eigen::numext::sqrt(factor_); // come down more slowly
        eps_ = last_eps_ * factor_;
        return next_round();
      }
      return restart();
    }
    if (status != Status::solved) return end_pads(status);
    S largest(0);
    const S violation = detail::pad_violation(assembly_, memory_, largest);
    detail::take_pressure(assembly_, memory_, repeats(violation));
    const bool is_pressed = violation <= options_.tolerance;
    bool is_settled = friction_.is_settled(memory_.z.data);
    if (is_pressed) is_settled = is_settled && friction_.passes();
    if (is_pressed && is_settled)
      return violation > options_.finest && fine_++ < options_.fine_rounds ? next_round()
                                                                           : Status::solved;
    if (!is_settled && !turn()) return unsettled();
    if (largest > detail::runaway_force(assembly_)) return end_pads(Status::numerical_breakdown);
    last_eps_ = eps_;
    if (is_pressed) return next_round();
    factor_ = has_retreated() ? slowly() : maxi(options_.factor, S(factor_ * factor_));
    eps_ *= factor_;
    return next_round();
  }

  static S slowly() { return S(7) / S(10); }
  /// Of rounds that never retreat the compiler knows it, and leaves out what would follow.
  bool has_retreated() const { return Rounds::retreats && retreats_ > 0; }
  /// Round friction may turn its pyramids only so often: it has no rounds to spare.
  bool may_retreat() const {
    const bool is_stiff = phase_ == Phase::soft_pads && last_eps_ < S(1) / S(10000);
    return Rounds::retreats && is_stiff && run_.turns == 0 && retreats_ < options_.max_retreats;
  }
  Status retreat() {
    ++retreats_;
    last_violation_ = S(0);
    eps_ *= S(100);
    round_ = 0;
    return next_round();
  }
  /// How often this round's change of pressure is repeated, without further rounds.
  S repeats(const S& violation) {
    const S tolerance = violation / S(1000), change = violation - last_violation_;
    const bool is_steady = has_retreated() && Eigen::numext::abs(change) <= tolerance;
    last_violation_ = violation;
    return is_steady ? detail::pressure_reach(assembly_, memory_) : S(0);
  }

  /// The pads have failed.
  Status end_pads(Status status, Reason reason = Reason::none) {
    if (phase_ == Phase::soft_pads && status == Status::bad_input) return status;
    if (phase_ == Phase::stiff_pads && stiffer_ == stiffer_starts) {
      if (reason != Reason::none) run_.reason = reason;
      return Status::numerical_breakdown;
    }
    begin_literal();
    return Status::running;
  }

  /// Turns the pyramids; false: often enough.
  bool turn() {
    if (run_.turns == options_.max_turns) return false;
    ++run_.turns;
    friction_.turn(memory_);
    return true;
  }
  Status unsettled() {
    run_.reason = Reason::turning;
    run_.worst_point = friction_.worst_point();
    return Status::not_settled;
  }

  Status end_literal(Status status) {
    if (status != Status::solved && run_.turns > 0) {
      if (restarted_) return unsettled();
      return restart();
    }
    run_.jammed = status == Status::ray;
    if (status == Status::solved && !is_pad() &&
        !(friction_.is_settled(memory_.z.data) && friction_.passes())) {
      if (!turn()) return unsettled();
      restarted_ = false;
      begin_solver(true);
      return Status::running;
    }
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
                                    const PressureOptions<S>& options, PressureRun& run,
                                    const FrictionMemory<S>& round = {}) {
  PressureSolve<S, Rounds> solve(assembly, rounds, memory, options, round);
  const Status status = solve.solve();
  run = solve.run();
  return status;
}

} // namespace lcpush
