// A motion of a scene: where the object goes in the grip, step by step [T.13].
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/desktop/stop.hpp"
#include "lcpush/mechanics/model/pose.hpp"
#include "lcpush/mechanics/solve/motion_memory.hpp"
#include "lcpush/mechanics/study/motion.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

struct MoveOptions {
  std::optional<double> time;                                ///< s; else see motion_time
  std::optional<double> step;                                ///< s; else as `tolerance` asks
  std::optional<double> tolerance;                           ///< m; else size_of_object / 1000
  double distance = std::numeric_limits<double>::infinity(); ///< m, that a point of the object goes
  Index frames = 101;                                        ///< kept, the first and last included
  Index most_steps = 100'000;                                ///< solved
  std::function<void(double done, double time)> progress;    ///< done: 0 to 1
  StopCheck stop;                                            ///< ends it with what there is
};

/// What a contact point does.
enum class Touch {
  sticks,
  slips,
  parted,  ///< off its face, or too far to matter
  beside,  ///< where its face has ended
  behind,  ///< it came round an edge
  no_line, ///< a round side stands on its end
  away,    ///< its stroke is over, or has not begun
};
/// As JSON spells it.
const char* touch_text(Touch touch);

/// One body's forces on the object, [N] and [N m] at the object's centre of mass.
struct BodyForce {
  Vector3<double> force = Vector3<double>::Zero(), moment = Vector3<double>::Zero();
  double normal_force = 0;       ///< N, sum over its points
  std::optional<double> closing; ///< m or rad, how far its first actuator has gone; none: undriven
  std::optional<double> closing_speed; ///< m/s or rad/s, at the step's end
};

struct PointState {
  Touch touch = Touch::away;
  std::optional<double> gap; ///< m, at the step's end; none: not over its face then
  double normal_force = 0;   ///< N
  Vector3<double> friction_force = Vector3<double>::Zero();
  double torsion = 0;                                 ///< N m about the normal, soft contacts only
  Vector3<double> velocity = Vector3<double>::Zero(); ///< m/s, object's point relative to its body
  Vector3<double> position = Vector3<double>::Zero(); ///< m, scene's frame
  Vector3<double> normal = Vector3<double>::Zero();
};

/// The end of a step. Forces are the step's mean; twists are at the object's centre of mass.
struct MotionFrame {
  double time = 0, step = 0;
  Pose<double> pose;                              ///< position: how far the centre of mass has gone
  Vector3<double> turn = Vector3<double>::Zero(); ///< rad, axis times angle: as pose has turned,
                                                  ///< beyond half a turn, too
  Vector6<double> twist = Vector6<double>::Zero();
  std::vector<BodyForce> bodies;
  std::vector<PointState> contacts;
  std::vector<Pose<double>> body_poses; ///< where they have gone, about the scene's centre of mass
};

/// A contact point does something else after `time`.
struct MotionEvent {
  double time, within; ///< s; at the end of a step so long
  Index point;
  Touch from, to;
};

/// The pushers' force on the object changes at once, whatever the contacts' modes say.
struct ForceJump {
  double time, within; ///< s; in a step so long
  double from, to;     ///< N
};

/// A part of the motion that one word describes.
struct MotionPhase {
  MotionKind kind = MotionKind::rest;
  double from = 0, until = 0;
  double path = 0;                                 ///< m, of the centre of mass
  double angle = 0;                                ///< rad
  Vector3<double> along = Vector3<double>::Zero(); ///< from its begin to its end, m
  Vector3<double> turn = Vector3<double>::Zero();  ///< rad, sum of the turns
};

enum class MoveEnd {
  time,
  distance,
  lost,    ///< a finger without inertia touches nothing any more
  inside,  ///< a stroke begins inside the object
  steps,   ///< most_steps
  stopped, ///< by MoveOptions::stop
  leaps,   ///< a step that goes too far to be one: a squeeze that gives way, or --step is too long
  failed,  ///< a step without an answer: `status` says why
  free,    ///< nothing touches it any more, nor will
};
const char* move_end_text(MoveEnd end);

struct MotionReport {
  Status status = Status::bad_input; ///< solved unless the end is lost, inside, steps, stopped,
                                     ///< leaps or failed
  MoveEnd end = MoveEnd::failed;
  Stop stop = Stop::none;          ///< stopped: why
  Reason reason = Reason::none;    ///< of a step that failed
  Index body = -1;                 ///< lost or inside: which
  std::vector<MotionFrame> frames; ///< the first at time 0, before anything moves
  std::vector<MotionEvent> events;
  std::vector<ForceJump> jumps;
  std::vector<MotionPhase> phases;
  Index steps = 0, solves = 0;
  Index by_pyramids = 0; ///< solves in which round friction did not settle and pyramids answered
  double shortest = 0, longest = 0; ///< s, steps
  double tried = 0;                 ///< s, of the step that was solved last, if in vain
  double tolerance = 0;             ///< m
  std::optional<double> error;      ///< m, estimated, of controlled steps
  double penetration = 0;           ///< m, the deepest
  double pressed_gap = 0;           ///< m, the largest across which a point presses at a step's end
  /// Once what starts at once has started, in the second step; none: it soon changes.
  std::vector<BodyForce> first;
  double residual = 0; ///< the laws' largest, by check
};

/// How long, if nobody says: to the end of the last stroke, else 1 s.
double motion_time(const SceneFile& file);

/// `file` has all strokes. Throws InputError where the scene does not say how a body touches: edges
/// against edges, points beside every face. Cost: three solves a step where steps are controlled.
MotionReport move(const SceneFile& file, const MoveOptions& options);

/// One sentence, where it ends and how it got there; then frames and events.
std::string move_text(const SceneFile& file, const MotionReport& report, bool verbose = false);
std::string move_json(const SceneFile& file, const MotionReport& report);
/// A line a frame; a column a number, by name.
std::string move_csv(const SceneFile& file, const MotionReport& report);
/// The object's path with ghosts.
std::string move_svg(const SceneFile& file, const MotionReport& report);
/// The same as a picture that moves, over and over; still where the reader wants no motion.
std::string move_animation(const SceneFile& file, const MotionReport& report);
/// A page that plays it; nothing from elsewhere.
std::string move_html(const SceneFile& file, const MotionReport& report);

} // namespace lcpush::desktop
