// A plan: which pushes against the scene's pushers take the object from where it is to another
// place in the grip (docs/theory/theory.md, [T.18]).
#pragma once

#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/move.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lcpush::desktop {

/// Where the object is in the plane, from where the scene has it: how far its centre of mass has
/// gone, m, and how far it has turned about z, rad.
struct PlanarPose {
  double x = 0, y = 0, angle = 0;
};

struct PlanOptions {
  Index tries = 600;   ///< places that are tried on the way
  double speed = 0.01; ///< m/s, of the fastest point of a pusher
  double position_error = 1e-3, angle_error = 3.14159265358979323846 / 180; ///< of the replay
  std::function<void(double done)> progress;                                ///< 0 to 1
  StopCheck stop;                                                           ///< ends the search
  /// The scene with ranges: every push is to stick for every value. Else it is the middle's plan.
  std::optional<VariedScene> box = std::nullopt;
};

enum class PushKind {
  stick, ///< inside the pusher's motion cone all the way: the object moves as the pusher does
  slip,  ///< the object slips over the pusher; where it goes is what `move` says
};

/// One push of a plan: a pusher that touches the object and moves with one twist.
struct PlannedPush {
  Index pusher = -1; ///< body of the scene
  PushKind kind = PushKind::stick;
  PlanarPose from, to;                             ///< of the object
  Vector6<double> twist = Vector6<double>::Zero(); ///< of the pusher, at the object's centre of
                                                   ///< mass as it begins, [m/s; rad/s]
  double begin = 0, end = 0;                       ///< s
  // What a sticking push takes, the most along it: less than there is keeps it sticking.
  double friction = 0; ///< of the pusher's coefficient
  double reach = 0;    ///< m, from the pusher's middle to where its force acts, along it
  double grip = 0;     ///< factor on all grip forces
};

struct PlanReport {
  bool found = false;                         ///< and its replay ends within the errors allowed
  bool holds_start = true, holds_goal = true; ///< by the grip alone; else nothing is tried
  Stop stop = Stop::none;                     ///< what ended the search, or its replay, early
  PlanarPose goal;
  std::vector<PlannedPush> pushes;
  double cost = 0;        ///< m: the way of the centre of mass, turns at the object's size, and
                          ///< `change_of_pusher` a change
  Index tried = 0;        ///< places
  PlanarPose nearest;     ///< where the search, or the replay, came nearest to the goal
  std::string scene_text; ///< the scene with the plan's strokes for pushers
  SceneFile scene;        ///< the same, read
  MotionReport replay;    ///< of it, by `move`
  std::optional<double> replay_step; ///< s: in equal steps so long; none: in those of `move`
  double position_error = 0, angle_error = 0; ///< m and rad, of the replay's end
  std::optional<BoxAnswer> box;               ///< if one is asked for: do all pushes stick?
};

/// m: what another pusher is worth of way.
constexpr double change_of_pusher = 0.02;

/// `text` is a scene file's, called `file_name`. Throws InputError as find_cone does.
PlanReport find_plan(std::string_view text, const std::string& file_name, const PlanarPose& goal,
                     const PlanOptions& options = {});

std::string plan_text(const SceneFile& file, const PlanReport& report, bool verbose = false);
std::string plan_json(const SceneFile& file, const PlanReport& report);

} // namespace lcpush::desktop
