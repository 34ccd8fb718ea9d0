// A motion: one time step after the other, each a push of its own [T.13], in the caller's memory.
//
// A step places the points that may touch, solves the push that takes the velocities to the step's
// end, and moves every pose by them. What a straight step misses of a turning face is of second
// order; where it would let a point into its face, the step is solved again with the gaps that the
// turned faces have at its end. If that leads nowhere, the step is too long and nothing moves.
#pragma once

#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/model/validate.hpp"
#include "lcpush/mechanics/solve/motion_memory.hpp"
#include "lcpush/mechanics/solve/step_rounds.hpp"

namespace lcpush {

/// What a step took, and how well its answer obeys the laws.
template <class S> struct StepRun {
  Index rounds = 0, pivots = 0;
  Index cold_restarts = 0;
  Index corrections = 0; ///< times it was solved again for its gaps
  Reason reason = Reason::none;
  Mistake mistake = Mistake::none;
  TouchMistake touch = TouchMistake::none;
  bool lost = false; ///< does_not_hold: a finger without inertia touches nothing
  S residual{0};     ///< the laws' largest scaled violation, by check
  S penetration{0};  ///< m, the deepest point at the step's end; 0: none
};

/// The motion of `scene`'s object. Positions, poses and twists are in the hand's axes, from the
/// place of the object's centre of mass at the start: there the hand has its origin.
template <class S, class Pivots> class TimeStepper {
public:
  /// Memory of make_structured_motion_memory; `scene` and `surroundings` outlive the
  /// motion.
  TimeStepper(const Scene<S>& scene, const Surroundings<S>& surroundings,
              const MotionMemory<S>& memory)
      : scene_(&scene), around_(&surroundings), m_(memory), assembly_(memory.work.assembly),
        lemke_(memory.work.lemke_scalars, memory.work.lemke_integers) {}

  /// At rest in the pose of the scene; prescribed velocities 0. Post: running; or bad_input with
  /// run()'s mistake or touch.
  [[nodiscard]] Status start();

  /// The object's twist at its centre of mass; may be set between two steps.
  Vector6<S>& velocity() { return velocity_; }
  const Vector6<S>& velocity() const { return velocity_; }
  /// What a body moves with beside its actuators, a twist at the hand's origin; the caller's to set
  /// before each step.
  Vector6<S>& prescribed(Index body) { return m_.velocities[body]; }

  /// From now on, what presses at a step's end touches there, too: along a turning face a straight
  /// step leaves a gap of second order, which else the next one closes. Ends without it depend
  /// smoothly on h: their error of first order can be extrapolated away. Cost: a warm solve or two.
  void end_on_faces() { ends_on_faces_ = true; }

  /// One step of h seconds. Post: solved; or why not, and nothing has moved: does_not_hold with
  /// run().lost, ray (a jam), bad_input (h is not > 0), numerical_breakdown with Reason::leap
  /// (shorter steps may do), or a solver's failure. Cost: a warm solve,
  /// more where a turning face asks for corrections.
  [[nodiscard]] Status advance(const S& h);

  const Pose<S>& pose() const { return pose_; } ///< position: of the centre of mass
  const Pose<S>& pose_of(Index body) const { return m_.poses[body]; }
  const S& closing(Index actuator) const { return m_.closings[actuator]; }
  const S& closing_speed(Index actuator) const { return m_.speeds[actuator]; }
  const StepContact<S>& contact(Index point) const { return m_.contacts[point]; }
  const StepRun<S>& run() const { return run_; }
  S time() const { return time_; }

  /// What a step changes beside the arrays of take_motion_arrays: who keeps a copy of those and
  /// this can go back. step_scene() and step_answer() stay those of the last step.
  struct Moment {
    Pose<S> pose;
    Vector6<S> velocity;
    S time;
    bool knows_last;
  };
  Moment moment() const { return {pose_, velocity_, time_, knows_last_}; }
  void return_to(const Moment& moment) {
    pose_ = moment.pose;
    velocity_ = moment.velocity;
    time_ = moment.time;
    knows_last_ = moment.knows_last;
  }

  /// The step just made as a push: its scene [T.13], answer and scales, for whoever checks it.
  const Scene<S>& step_scene() const { return solved_; }
  /// Its contacts are those of the present points; behind them stand some of earlier steps.
  const Answer<S>& step_answer() const { return m_.work.answer; }
  const Assembly<S>& assembly() const { return assembly_; }
  /// The point of the motion's scene that is point `present` of step_scene().
  Index point_of(Index present) const { return m_.from[present]; }

private:
  const Scene<S>* scene_;
  const Surroundings<S>* around_;
  MotionMemory<S> m_;
  Assembly<S> assembly_;
  Pivots lemke_;
  Pose<S> pose_{};
  Vector6<S> velocity_ = Vector6<S>::Zero();
  Scene<S> present_{}, push_{}, solved_{};
  StepRun<S> run_{};
  bool knows_last_ = false, ends_on_faces_ = false;
  S time_{0}, length_{0};
  // The end that the last solve leads to.
  Vector6<S> next_velocity_ = Vector6<S>::Zero();
  S depth_{0}; // m, of the deepest point at the step's begin

  static constexpr Index most_corrections = 12;
  /// Of a gap of second order the first leaves one of third, and so on.
  static constexpr Index most_closings = 3;

  /// What thousands of steps may leave of a length, as a part of it, or of a direction.
  static S rounding() {
    return Eigen::numext::maxi(S(1e-9), S(4 * Eigen::NumTraits<S>::epsilon()));
  }
  S penetration_tolerance() const { return length_ * rounding(); }
  /// Where steps have turned the object, what had no part along an axis has one of rounding. Taken
  /// for one, points that stick beside each other are nearly independent, and pivots go astray
  /// among them.
  static Vector3<S> without_rounding(Vector3<S> v, const S& size) {
    for (S& part : v)
      if (Eigen::numext::abs(part) <= size * ModelSettings<S>::equal_distance()) part = S(0);
    return v;
  }
  /// What rounding leaves of a closed gap is none: over h^2 it would be a force. Under a point that
  /// presses, one step's.
  S settled(const S& gap, bool pressed = false) const {
    const S one = S(4) * length_ * ModelSettings<S>::equal_distance();
    return Eigen::numext::abs(gap) <= (pressed ? one : penetration_tolerance()) ? S(0) : gap;
  }
  /// A residue of the pads is a speed, and in thousands of steps a way. Six rounds leave none, or
  /// what rounding leaves: asked for less of that, pads become so stiff that pivots go astray.
  static PressureOptions<S> pressure_options() {
    PressureOptions<S> options;
    options.fine_rounds = 6;
    options.finest = S(4 * Eigen::NumTraits<S>::epsilon());
    return options;
  }
  /// So is a slip of the wrong sign that a tie lets pass: what rests would creep by it. From the
  /// last basis it takes a few pivots to have none; where it does not, a tie is a tie.
  static void take_finely(LemkeOptions<S>& pivots) {
    const S next_to_nothing = S(32 * Eigen::NumTraits<S>::epsilon());
    pivots.tolerances.tie = Eigen::numext::mini(pivots.tolerances.tie, next_to_nothing);
    pivots.covers = 1;
    pivots.max_pivots = 24;
  }
  Touching touching(Index body) const {
    return around_->touching.size > 0 ? around_->touching[body] : Touching{};
  }
  PlacedPoint<S> placed(Index b, Index i, const Pose<S>& object, const Pose<S>& hand) const;
  bool is_massless(Index body) const {
    for (const Drive<S>& drive : scene_->drives)
      if (drive.body == body && !(scene_->actuators[drive.actuator].inertia > S(0))) return true;
    return false;
  }
  /// Under even pressure each point of a driven body is a pad of its own, which follows its face
  /// wherever that goes: it has no gap.
  bool follows_face(Index body) const { return presses_evenly(*scene_) && is_massless(body); }

  // step_geometry.hpp: which points touch now, and where the solved push takes them.
  S reach(const S& h) const;
  bool comes_from_beside(Index i) const;
  void place_points(const S& reach);
  void gather_points(Index b, Index first, Index count, Index& points);
  bool gather();
  void carry_basis(bool to_present);
  void read_speeds(const S& h);
  bool is_at_rest(const S& h) const;
  Vector6<S> end_twist(Index body) const;
  S deepest(const S& h, bool& missed) const;
  S loosest(const S& h) const;
  void straight_gaps();
  void level_gaps();
  void bend_gaps(const S& h, Index times);
  bool leaps(const S& h) const;
  void commit(const S& h);
  void read_contact(Index i, Index present, const PlacedPoint<S>& then, const S& h);
  /// Of a present point: its body among the present ones.
  Index body_at(Index present) const {
    Index b = 0;
    while (present >= m_.bodies[b].first_point + m_.bodies[b].point_count) ++b;
    return b;
  }

  Status solve_push(const S& h);
  Status solve_rounds(int attempt, bool finely);
  Status correct(const S& h);
};

template <class S, class Pivots> Status TimeStepper<S, Pivots>::start() {
  run_ = {};
  run_.mistake = find_mistake(*scene_);
  if (run_.mistake == Mistake::none) run_.touch = find_touch_mistake(*scene_, *around_);
  if (!m_.work.complete) run_.mistake = Mistake::memory_too_small;
  if (run_.mistake != Mistake::none || run_.touch != TouchMistake::none) return Status::bad_input;
  pose_ = {};
  velocity_.setZero();
  next_velocity_.setZero();
  for (Index b = 0; b < scene_->bodies.size; ++b) {
    m_.poses[b] = {};
    m_.velocities[b].setZero();
  }
  for (Index a = 0; a < scene_->actuators.size; ++a) m_.closings[a] = m_.speeds[a] = S(0);
  for (Index i = 0; i < m_.active.size; ++i) m_.active[i] = 0;
  for (StepContact<S>& contact : m_.contacts) contact = {};
  length_ = S(0);
  for (const Vector3<S>& p : scene_->points) length_ = Eigen::numext::maxi(length_, S(p.norm()));
  if (!(length_ > S(0))) length_ = S(1);
  time_ = S(0);
  knows_last_ = false;
  return Status::running;
}

/// The push over m_.gaps. Post: solved, and the answer passed the check of the laws.
template <class S, class Pivots> Status TimeStepper<S, Pivots>::solve_push(const S& h) {
  const StepStart<S> from{h,
                          velocity_,
                          {m_.body_twists.data, present_.bodies.size},
                          {m_.speeds.data, m_.speeds.size},
                          {m_.gaps.data, present_.points.size}};
  push_ = laws::time_step(present_, from, m_.push);
  if (spread_evenly(push_, m_.even, solved_) != Status::solved) return Status::bad_input;
  if (has_round_friction(*scene_))
    solved_.round_cones = {m_.work.round_cones.data, solved_.points.size};
  if (assembly_.assemble(solved_) != Status::running) return Status::bad_input;
  // The last step's basis may lead astray; and pads of nearly the same normal force may end under
  // one covering vector or schedule and not under another.
  Status status = knows_last_ ? solve_rounds(0, true) : Status::running;
  if (status != Status::solved) status = solve_rounds(0, false);
  const int most = has_round_friction(*scene_) ? RoundSettings::step_attempts : 4;
  for (int attempt = knows_last_ ? 0 : 1; status != Status::solved && attempt < most; ++attempt) {
    knows_last_ = false;
    ++run_.cold_restarts;
    status = solve_rounds(attempt, false);
  }
  if (status != Status::solved) return status;
  next_velocity_ = velocity_ + h * m_.work.answer.acceleration;
  read_speeds(h);
  if (is_at_rest(h)) {
    next_velocity_.setZero();
    for (S& speed : m_.next_speeds) speed = S(0);
  }
  return Status::solved;
}

/// From the last step's basis, if it is known. Later attempts take other covering vectors and
/// slower pads. Post: as solve_push says.
template <class S, class Pivots>
Status TimeStepper<S, Pivots>::solve_rounds(int attempt, bool finely) {
  const Index unknowns = assembly_.layout().size;
  if (unknowns > 0) {
    carry_basis(true);
    LastStep last{{m_.kept.data, unknowns}, knows_last_};
    PressureRun run;
    assembly_.push_by(S(1)); // without the compliance of rounds before
    LemkeOptions<S> pivots;
    pivots.exchanges = m_.work.exchanges;
    pivots.first_cover = attempt * pivots.covers;
    if (attempt < 3) pivots.max_pivots = 200 + 3 * unknowns; // what takes more has gone astray
    if (finely) take_finely(pivots);
    PressureOptions<S> pads = pressure_options();
    if (has_round_friction(*scene_)) pads.max_pivots = RoundSettings::step_pivots * unknowns;
    for (int k = 0; k < attempt; ++k) pads.factor = Eigen::numext::sqrt(pads.factor);
    const Status status =
        solve_pressure(assembly_, StepRounds<S, Pivots>(lemke_, last, pivots), m_.work.pressure,
                       pads, run, m_.work.friction_memory(solved_));
    run_.rounds += run.rounds;
    run_.pivots += run.pivots;
    run_.cold_restarts += run.cold_restarts;
    const bool is_unsettled = status == Status::numerical_breakdown && run.reason == Reason::none;
    run_.reason = is_unsettled ? Reason::unsettled : run.reason;
    if (status != Status::solved) return status;
  }
  Answer<S>& answer = m_.work.answer;
  read_answer(assembly_, m_.work.pressure.z.data, answer, S(1));
  run_.residual = check(solved_, assembly_.layout().scales, answer, S(1)).max();
  if (!(run_.residual <= Tolerances<S>().residual)) {
    run_.reason = Reason::residual;
    return Status::numerical_breakdown;
  }
  knows_last_ = unknowns > 0;
  carry_basis(false);
  return Status::solved;
}

/// Solves again with the gaps of the step's end while a point ends in its face, or off it though it
/// presses, where steps end on faces. An answer without that stays where there is none with it: the
/// gaps >= 0 that it has always have one.
template <class S, class Pivots> Status TimeStepper<S, Pivots>::correct(const S& h) {
  bool missed = false;
  for (Index k = 0; k < most_corrections; ++k) {
    const S depth = deepest(h, missed);
    const bool is_loose =
        ends_on_faces_ && k < most_closings && loosest(h) > penetration_tolerance();
    if (missed || !(depth > penetration_tolerance() || is_loose)) return Status::solved;
    bend_gaps(h, k);
    ++run_.corrections;
    if (solve_push(h) == Status::solved) continue;
    straight_gaps();
    return solve_push(h);
  }
  return Status::solved;
}

template <class S, class Pivots> Status TimeStepper<S, Pivots>::advance(const S& h) {
  run_ = {};
  if (!(h > S(0)) || !detail::all_finite(velocity_)) {
    run_.mistake = Mistake::not_finite;
    return Status::bad_input;
  }
  // Nothing is left out for being far, and then touched.
  S within = reach(h);
  for (int tries = 0;; ++tries) {
    place_points(within);
    run_.lost = !gather();
    if (run_.lost) return Status::does_not_hold;
    Status status = solve_push(h);
    if (status == Status::solved) status = correct(h);
    if (status != Status::solved) return status;
    bool missed = false;
    run_.penetration = deepest(h, missed);
    if (!missed || tries == 1) break;
    within = Eigen::NumTraits<S>::highest();
  }
  if (leaps(h)) {
    run_.reason = Reason::leap;
    return Status::numerical_breakdown;
  }
  commit(h);
  return Status::solved;
}

} // namespace lcpush

#include "lcpush/mechanics/solve/step_geometry.hpp"

#ifdef LCPUSH_EXTERN_TEMPLATES
namespace lcpush {
extern template class TimeStepper<double, StructuredLemke<double>>;
} // namespace lcpush
#endif
