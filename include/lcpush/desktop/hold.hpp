// How well the grasp holds the object before any push: the least grip, what it bears beyond its
// load, and what gives way first (docs/theory/theory.md, [T.19]).
#pragma once

#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/push_reports.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "lcpush/desktop/sweep.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// What is added to the load.
enum class Disturbance {
  force,        ///< at a point, N
  moment,       ///< N m
  acceleration, ///< of the hand, m/s^2: the load -m a at the centre of mass
};

constexpr const char* disturbance_texts[] = {"force", "moment", "acceleration"};

struct HoldDirection {
  Disturbance kind;
  Vector3<double> direction; ///< unit
};

struct HoldQuestion {
  std::optional<Vector3<double>> at; ///< m, scene's frame, where forces act; none: centre of mass
  std::vector<HoldDirection> directions; ///< beside the axes
  bool with_sections = false;            ///< for a picture
  bool grip_alone = false;               ///< nothing beyond the load
  bool presses = false; ///< pushers with a normal force press with it, without friction: a load
};

/// How a grasp gives way: by the dual of a limit, a motion that the load drives.
struct GiveWay {
  std::vector<Index> slips, opens, yields; ///< bodies, in order; yields: pushed back, as the grip's
                                           ///< force is all it has
  std::vector<Index> leaves;               ///< of those that open, all of whose points do
  bool turns = false;                      ///< in the contacts that slip, or about what stays
  bool slides_too = false;                 ///< it turns, and the contacts slip one way all the same
  Vector3<double> along = Vector3<double>::Zero(); ///< unit: the turn's axis, or where it slides
};

constexpr double unknown_number = std::numeric_limits<double>::quiet_NaN();
constexpr double no_limit = std::numeric_limits<double>::infinity();

/// A plane through the set of held loads: how far it reaches in equal steps of the angle from
/// `along` towards `across`, in N or N m.
struct HoldSection {
  Disturbance kind;
  Index along, across; ///< axes
  std::vector<double> reach;
};

/// The largest t >= 0 for which the load and t times a direction are held.
struct HoldLimit {
  HoldDirection what{};
  double limit = unknown_number;   ///< of the scene's law
  double statics = unknown_number; ///< of any pressure; no_limit: contacts bear whatever it takes
  double lower = unknown_number, upper = unknown_number; ///< of statics, the bracket; of a weakest
                                                         ///< direction also against all others
  GiveWay gives{};
};

struct HoldStudy {
  std::optional<bool> held;        ///< by the scene's law
  std::string reason;              ///< of what is not known, a sentence
  std::optional<HoldReport> other; ///< held, but an answer of the laws, which leave forces open,
                                   ///< does not hold it
  GripReport grip;                 ///< whose force factors are of
  bool presses = false;            ///< what presses is part of the load
  double factor = unknown_number;  ///< least, on all grip forces; no_limit: no grip holds
  double most = no_limit;          ///< no larger one holds; nan: not known
  double statics_factor = unknown_number, statics_most = no_limit; ///< the same of statics
  GiveWay falls;              ///< if it does, or at its least grip
  bool is_statics = true;     ///< the scene's law holds whatever statics can
  bool may_bear_more = false; ///< the work was used up before the law was asked beyond all limits
  Vector3<double> at = Vector3<double>::Zero(); ///< m, scene's frame
  std::vector<HoldLimit> limits;      ///< along +x, -x, +y, .. of each kind, then as asked
  std::array<HoldLimit, 3> weakest{}; ///< by kind
  std::vector<HoldSection> sections;  ///< if they are asked for
  double added_mass = unknown_number; ///< kg, at the same point
  double tilt = unknown_number;       ///< rad, of gravity in any direction; pi: it may turn over

  /// Grip over least grip.
  double margin() const { return factor > 0 && factor < no_limit ? 1 / factor : unknown_number; }
};

/// A pusher that presses with a force of its own, N.
struct Press {
  Index body;
  double force;
};
std::vector<Press> presses_of(const SceneFile& file);

HoldStudy find_hold(const SceneFile& file, const HoldQuestion& question,
                    const PushOptions& options = {});

/// The least grip along a number of a scene.
struct HoldSweep {
  Variation variation;
  std::vector<double> values;     ///< evenly spread
  std::vector<HoldStudy> studies; ///< there, of the grip alone
  Stop stop = Stop::none;         ///< what ended it early: then there are fewer
  bool of_margin = true;          ///< what the picture shows; else the least grip force
};
/// `presses`: as of a HoldQuestion.
HoldSweep sweep_hold(const VariedScene& scene, const Variation& variation, bool presses,
                     Index steps, const StopCheck& stop = {});
std::string hold_sweep_text(const HoldSweep& sweep);
std::string hold_sweep_csv(const HoldSweep& sweep);
std::string hold_sweep_json(const HoldSweep& sweep);
std::string hold_sweep_svg(const HoldSweep& sweep);

std::string hold_text(const SceneFile& file, const HoldStudy& study);
/// The sections as a picture.
std::string hold_svg(const SceneFile& file, const HoldStudy& study);
/// `box`: with what holds for every value; then the grip's margin is `grip_margin`.
std::string hold_json(const SceneFile& file, const HoldStudy& study,
                      const BoxAnswer* box = nullptr);
/// The first line of the text.
std::string hold_answer(const SceneFile& file, const HoldStudy& study);

} // namespace lcpush::desktop
