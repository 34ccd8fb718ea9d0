// Pressure laws: how a patch shares its force over its points. The paper fixes only the sum of a
// patch's normal forces [P.6]; docs/theory/theory.md, "Pressure laws", says why that is not enough.
#pragma once

#include "lcpush/mechanics/solve/pad_law.hpp"
#include "lcpush/mechanics/solve/pad_schedule.hpp"
#include "lcpush/mechanics/solve/round_friction.hpp"

namespace lcpush {

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
/// `rigid` and `even` are the literal problem. `pad` is solved by proximal iterations ("rounds"),
/// each around the last one's pressure at the compliance of PadSchedule: the first cold, every
/// later one from the last answer. Compliance hides a jam: a squeezed pad just gives way. If the
/// rounds fail, the literal problem is solved without any, so that a ray shows. If there is none,
/// soft pads followed a squeeze that stiff ones resist: the rounds start again stiff, from the
/// literal basis.
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
    stiff_starts_ = fine_ = retraces_ = 0;
    if (!options_.keeps_cones) friction_.begin();
    return is_pad() ? begin_pads(Phase::soft_pads) : begin_literal();
  }

  /// Post: running; solved (memory.z holds the unknowns); or the solver's failure.
  [[nodiscard]] Status step() {
    const Status status = rounds_.step(memory_, run_);
    if (status == Status::running) return status;
    if (options_.max_pivots > 0 && run_.pivots > options_.max_pivots) return Status::pivot_limit;
    return phase_ == Phase::literal ? end_literal(status) : end_round(status);
  }

  /// Cost: rigid and even one run; pad one cold and a few warm ones.
  [[nodiscard]] Status solve() {
    Status status = init();
    while (status == Status::running) status = step();
    return status;
  }

  const PressureRun& run() const { return run_; }
  const S& compliance() const { return schedule_.compliance(); } ///< `pad`: of the last round

private:
  enum class Phase { soft_pads, literal, stiff_pads };

  Assembly<S>& assembly_;
  Rounds rounds_;
  PressureMemory<S> memory_;
  PressureOptions<S> options_;
  RoundFriction<S> friction_;
  PadSchedule<S> schedule_;
  PressureRun run_{};
  Phase phase_ = Phase::literal;
  Index stiff_starts_ = 0, fine_ = 0, retraces_ = 0; // that have been made
  bool is_first_ = true, has_changed_ = false;       // since the pads' own preload: round, contacts
  S runaway_{PadSettings::runaway};                  // beyond it the forces of rounds are lost
  bool warm_ = false, restarted_ = false;            // this round

  bool is_pad() const { return assembly_.scene().pressure == Pressure::pad; }

  Status begin_solver(bool warm) {
    rounds_.begin(assembly_.problem(), warm, memory_);
    return Status::running;
  }
  /// The same round, cold.
  Status restart() {
    ++run_.cold_restarts;
    restarted_ = true;
    return begin_solver(false);
  }
  // What is not inlined costs a device less flash than its calls cost time.
  [[gnu::noinline]] Status begin_literal() {
    phase_ = Phase::literal;
    set_compliance(assembly_, memory_, S(0));
    return begin_solver(false);
  }
  /// The rounds, the first of them cold, or going on, or stiff from the literal answer.
  Status begin_pads(Phase phase) {
    phase_ = phase;
    schedule_.begin(options_);
    const bool goes_on = phase == Phase::soft_pads && options_.goes_on;
    warm_ = goes_on || phase == Phase::stiff_pads;
    if (!goes_on) begin_pressure();
    return begin_round();
  }
  [[gnu::noinline]] void begin_pressure() {
    pad_preload(assembly_, memory_);
    is_first_ = true;
  }
  /// A pressure that is affine over what touches [T.7] only stays so while the same points touch.
  /// Where some have parted on the way, and pressed again, the rounds begin anew at the compliance
  /// and with the contacts they have come to. What sticks everywhere does not move by how the
  /// pressure is shared: nothing is gained.
  bool retraces() { return has_changed_ && ++retraces_ <= PadSettings::retraces; }
  Status retrace() {
    begin_pressure();
    return next_round();
  }
  Status begin_round() {
    ++run_.rounds;
    restarted_ = false;
    set_compliance(assembly_, memory_, schedule_.compliance());
    return begin_solver(warm_);
  }
  Status next_round() {
    if (!schedule_.has_next()) {
      run_.reason = Reason::unsettled;
      return end_pads(Status::numerical_breakdown);
    }
    warm_ = true;
    return begin_round();
  }

  Status end_round(Status status) {
    if (status != Status::solved && warm_ && !restarted_)
      return schedule_.fall_slower() ? next_round() : restart();
    if (status != Status::solved) return end_pads(status);
    bool changes, slides;
    const S violation = detail::take_pressure(assembly_, memory_, changes, slides);
    has_changed_ = !is_first_ && (has_changed_ || changes);
    is_first_ = false;
    const bool is_pressed = violation <= options_.tolerance;
    bool is_settled = friction_.is_settled(memory_.z.data);
    if (is_pressed) is_settled = is_settled && friction_.passes();
    if (is_pressed && is_settled && !refines(violation))
      return slides && retraces() ? retrace() : Status::solved;
    if (!is_settled && !may_turn()) return unsettled();
    turn(); // settled ones too: corners hold what the next pressure changes
    if (forces_over_load() > runaway_) return end_pads(Status::numerical_breakdown);
    if (is_pressed)
      schedule_.keep();
    else
      schedule_.fall();
    return next_round();
  }
  /// Is a settled answer to be settled more finely? Counts how often.
  bool refines(const S& violation) {
    const bool is_fine = Eigen::numext::maxi(violation, friction_.distance()) <= options_.finest;
    return !is_fine && fine_++ < options_.fine_rounds;
  }
  /// The pads have failed.
  Status end_pads(Status status) {
    if (phase_ == Phase::soft_pads && status == Status::bad_input) return status;
    if (phase_ == Phase::soft_pads || stiff_starts_ < PadSettings::stiff_starts)
      return begin_literal();
    return Status::numerical_breakdown;
  }

  Status end_literal(Status status) {
    if (status != Status::solved && run_.turns > 0) return restarted_ ? unsettled() : restart();
    run_.jammed = status == Status::ray;
    if (status != Status::solved) return status;
    if (is_pad()) return begin_stiff();
    if (friction_.is_settled(memory_.z.data) && friction_.passes()) return status;
    if (!may_turn()) return unsettled();
    turn();
    restarted_ = false;
    return begin_solver(true);
  }
  Status begin_stiff() {
    ++run_.cold_restarts;
    ++stiff_starts_;
    options_.first_compliance *= PadSettings::stiff_start<S>();
    // The literal answer shows what forces there have to be.
    runaway_ *= Eigen::numext::maxi(S(1), forces_over_load());
    rounds_.vary();
    return begin_pads(Phase::stiff_pads);
  }

  /// How large the forces of the last answer are beside what the scene asks for.
  [[gnu::noinline]] S forces_over_load() const {
    return detail::largest_normal(assembly_, memory_) / detail::largest_load(assembly_);
  }
  void turn() { friction_.turn(memory_, run_.turns <= RoundSettings::damped_turns); }
  /// Counts the turns of pyramids that are not settled; false: that was the last.
  bool may_turn() {
    if (run_.turns == options_.max_turns) return false;
    ++run_.turns;
    return true;
  }
  Status unsettled() {
    run_.reason = Reason::turning;
    run_.worst_point = friction_.worst_point();
    return Status::not_settled;
  }
};

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
