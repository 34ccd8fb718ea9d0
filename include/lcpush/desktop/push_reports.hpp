// What a push is found to do.
#pragma once

#include "lcpush/desktop/final_basis.hpp"
#include "lcpush/desktop/jam.hpp"
#include "lcpush/desktop/sensitivity.hpp"
#include "lcpush/desktop/solver.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"
#include "lcpush/mechanics/study/existence.hpp"
#include "lcpush/mechanics/study/motion.hpp"
#include "lcpush/mechanics/study/uniqueness.hpp"

#include <optional>

namespace lcpush::desktop {

/// An unknown's value, in the solver's units.
struct NamedValue {
  std::string name;
  double value;
  Index unknown = -1; ///< of Push::layout()
};

/// The literal laws' residuals after a number of sweeps.
struct SweepRecord {
  Index sweep; ///< of all rounds together
  Residuals<double> residuals;
};

/// Less than these is told as 0: it is rounding, or nothing beside the scene's loads.
struct Noise {
  double force = 0;        ///< N
  double moment = 0;       ///< N m
  double acceleration = 0; ///< m/s^2
  double length = 0;       ///< m
};

/// Does a theorem promise an answer?
struct ExistenceFound {
  bool studied = false; ///< not for scenes of very many unknowns
  Existence verdict = Existence::not_known;
  std::vector<std::string> bodies; ///< that decide: who closes on nothing, or who squeezes
};

/// What the answers to every question of a push have in common.
/// Which friction an answer obeys.
enum class FrictionLaw {
  pyramids, ///< of the scene's facets
  round,
  pyramids_instead, ///< for round friction that did not settle
};

struct RunReport {
  Status status = Status::bad_input;
  std::string reason; ///< a sentence, empty when solved
  Solver solver = Solver::lemke;
  PressureRun run;
  FrictionLaw friction = FrictionLaw::pyramids;
  Scales<double> scales{};
  Noise noise, brief_noise; ///< in reports of six digits, and of three; of an answer
  Motion<double> motion;    ///< of a break, per unit push
  bool hand_moves =
      false; ///< a body that an actuator drives, by more than a thousandth of the push
  Uniqueness unique_motion = Uniqueness::not_tested;
  bool is_friction_open = false;    ///< the other answer has less friction at what sticks
  std::vector<SweepRecord> history; ///< of a break: of its pushes, one after the other
  std::vector<NamedValue> ray;      ///< entries that are not zero, largest 1
  Jam jam;                          ///< the ray, read
};

struct PushReport : RunReport {
  Answer<double> answer{}; ///< views into the Push: valid until it is asked again
  Residuals<double> residuals;
  Uniqueness unique_wrench = Uniqueness::not_tested;
  Index paths_compared = 0;             ///< other paths of pivots that led to an answer
  std::optional<Outcome<double>> other; ///< of the first other path whose answer differs: the
                                        ///< object's acceleration, all pushers' wrench
  FinalBasis final_basis;               ///< other answers next to this one
  std::string undetermined; ///< a point or body with friction and no known normal force, or empty
  ExistenceFound existence; ///< does a theorem promise an answer?
  std::vector<Sensitivity> sensitivity; ///< if it was asked for
};

/// Does the grasp hold the object's weight with the pushers absent?
struct HoldReport {
  Status status = Status::bad_input;
  bool holds = false;
  Vector6<double> acceleration = Vector6<double>::Zero(); ///< without a push
  double length = 1; ///< m, the size of the grasp, for telling rounding from motion
};

/// Another instant of breaking that obeys the same laws.
struct OtherBreak {
  double break_force = 0;                          ///< N, as Breaking::break_force
  Vector3<double> force = Vector3<double>::Zero(); ///< N, the pusher's on the object
  Vector6<double> twist = Vector6<double>::Zero(); ///< as Breaking::twist
};

/// Its uniqueness compares other paths of pivots.
struct BreakReport : RunReport {
  Index pusher = -1; ///< body that pushes
  Breaking<double> breaking;
  std::vector<NamedValue> closings; ///< of the driven bodies, m/s^2 per m/s^2 of the push
  Uniqueness unique_force = Uniqueness::not_tested;
  std::vector<OtherBreak> others;    ///< that differ from it and from each other
  std::optional<double> other_force; ///< N, of the others' the farthest from it, if any differs
};

/// [T.8] The lemma's conditions on an assembled scene of `file`.
ExistenceFound find_existence(const SceneFile& file, const Assembly<double>& assembly);

/// What a theorem of docs/theory/theory.md says of a scene: an answer exists, or it is the only
/// one.
struct Statement {
  std::string text;                 ///< empty: no theorem covers the scene
  std::vector<std::string> reasons; ///< why, or why not; the first stands for itself
};

Statement existence_statement(const SceneFile& file, const ExistenceFound& found);

/// "2 contacts are between two modes".
std::string tied_words(Index contacts);
/// For a push that is solved.
Statement uniqueness_statement(const PushReport& report);

} // namespace lcpush::desktop
