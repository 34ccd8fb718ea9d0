// lcpush: is somebody else's motion one that these laws allow?
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/pose.hpp"
#include "lcpush/status.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// What a frame says of a contact point's force on the object.
struct FrameContact {
  std::optional<double> normal_force;            ///< N
  std::optional<Vector3<double>> friction_force; ///< N
  std::optional<double> torsion;                 ///< N m about the normal
  std::optional<double> gap;                     ///< m, at the frame's time
};

/// The same of a body's points together.
struct FrameBody {
  std::optional<Vector3<double>> force, moment; ///< N; N m about the centre of mass
  std::optional<double> closing;                ///< m or rad, how far its first actuator has gone
  std::optional<double> closing_speed;          ///< m/s or rad/s, at the step's end
};

/// Where the object is, as `lcpush move` says it: from position 0 and rotation 1 at the start.
struct TrajectoryFrame {
  double time = 0;
  Pose<double> pose;                    ///< position: how far the centre of mass has gone
  std::optional<Vector6<double>> twist; ///< at the centre of mass
  std::optional<double> step; ///< s, of the step that ends here, whose means the forces are; else
                              ///< since the frame before
  std::vector<FrameContact> contacts; ///< of the scene's points; empty: nothing is said
  std::vector<FrameBody> bodies;      ///< of the scene's bodies; empty: nothing is said
  bool has_rotation = true;           ///< false: nothing is said, and it is taken not to turn
};

struct Trajectory {
  std::vector<TrajectoryFrame> frames;
  std::vector<std::string> unread; ///< columns, or keys of frames, that say nothing here
  /// The last digit of all places, m, and of the numbers of all rotations, a power of ten; 0: they
  /// have many.
  double place_digit = 0, turn_digit = 0;
};

/// Of a JSON object as `lcpush move --json` writes it, or of a CSV file with a head and the
/// columns time (or t), x, y, z, then r11 .. r33 or qw, qx, qy, qz unless it does not turn, and if
/// they are known vx .. wz and forces. Throws InputError: not of this shape, times that do not
/// grow, no rotation, bodies or contacts that the scene has not. `file_name` only names the text in
/// messages.
Trajectory parse_trajectory(const std::string& text, const std::string& file_name,
                            const SceneFile& scene);

enum class TrajectoryVerdict {
  follows,      ///< every step is the laws' own, within the tolerance
  creeps,       ///< the laws hold the object, and it moves
  differs,      ///< a step that the laws make differently
  stopped,      ///< from one of its frames the laws have no next step
  wrong_forces, ///< every step is the laws' own, and a force breaks one
};
const char* verdict_text(TrajectoryVerdict verdict); ///< "follows", ..

/// What a frame's forces may break, those first that say most of what is wrong.
enum class ForceLaw {
  gap,         ///< nothing presses across a gap, or where nothing touches
  normal,      ///< nothing pulls
  cone,        ///< friction is in the contact plane, and at most mu times the normal force
  dissipation, ///< friction opposes the slip, with all that the cone has
  sum,         ///< a body's force is the sum of its contacts'
  grip,        ///< an actuator's bodies press with its force
  newton,      ///< all forces together make the change of velocity
};
constexpr ForceLaw force_laws[] = {ForceLaw::gap,         ForceLaw::normal, ForceLaw::cone,
                                   ForceLaw::dissipation, ForceLaw::sum,    ForceLaw::grip,
                                   ForceLaw::newton};
const char* force_law_text(ForceLaw law); ///< "gap", ..

/// Where the forces break a law most, or least obey it.
struct WorstForce {
  ForceLaw law = ForceLaw::newton;
  double off = 0;          ///< as a part of the largest force involved
  double time = 0;         ///< s
  Index of = -1;           ///< gap, normal, cone, dissipation: the point; sum: the body; grip: the
                           ///< actuator
  double found = 0;        ///< N; newton, sum: of the force that is missing
  double lawful = 0;       ///< N: the force that it should be, at most or at least
  bool is_moment = false;  ///< both are N m
  bool is_of_body = false; ///< gap .. dissipation: it is the body's of this point, not its own
  bool is_out_of_plane = false; ///< cone: found is across the contact plane
  std::optional<double> gap;    ///< m; none: nothing touches there
};

/// Of the frames' forces alone, by the laws; nothing is solved.
struct ForceReport {
  Index frames = 0;   ///< with forces
  Index balanced = 0; ///< of these: a step each, so that newton can be judged
  std::vector<WorstForce>
      worst; ///< one of each law that could be judged, in the order of force_laws

  /// The first law that is broken, or nullptr.
  const WorstForce* broken(double tolerance) const;
};

/// What each step's end does not show, since it is small beside the tolerance, adds up: the
/// velocity is followed over many steps.
struct MissedChange {
  double speed = 0;           ///< m/s, by which the laws lead to another velocity, at most
  double from = 0, until = 0; ///< s
  /// m/s, of the contact point that this is: by how much its velocity changes, and by the laws.
  Vector3<double> found = Vector3<double>::Zero(), lawful = Vector3<double>::Zero();
};

/// A point that goes into its face, which no law of contact allows. Geometry alone, of bodies whose
/// place is known.
struct Overlap {
  Index point = -1; ///< none: nothing does
  double speed = 0; ///< m/s, at which it goes deeper in the worst step
  double time = 0;  ///< s, at that step's end
  double depth = 0; ///< m, most that it goes deeper than it was at the first frame
  double until = 0; ///< s, when it does
};

/// Steps are compared one by one, each begun where the other motion is.
struct TrajectoryReport {
  TrajectoryVerdict verdict = TrajectoryVerdict::differs;
  double tolerance = 0;  ///< of the fastest speed
  Index steps = 0;       ///< compared
  double fastest = 0;    ///< m/s, of pushers, and of the motion's contact points
  double worst = 0;      ///< m/s, between the ends of a step, at the contact point where most
  double worst_time = 0; ///< s, at that step's end
  double mean = 0;       ///< m/s
  /// Over several steps; none: they were not followed, one step breaks a law and goes far.
  std::optional<MissedChange> missed;
  double missed_speed() const { return missed ? missed->speed : 0; } ///< m/s
  Overlap overlap; ///< of the point that goes deeper fastest
  /// m: the positions are relative to another origin, and so are judged from their first on.
  std::optional<Vector3<double>> offset;
  bool has_rotation = true;          ///< as its frames
  std::vector<std::string> unread;   ///< as its file
  std::string hint;                  ///< other units or order with which it would fit, or why its
                                     ///< digits are too few; or empty
  Status status = Status::solved;    ///< of the step that stopped
  bool is_coarse = false;            ///< it did as frames so far apart, or places of so few
                                     ///< digits, leave its speed open
  double creep = 0;                  ///< m/s, mean speed of the contact point that goes farthest
  std::optional<double> held;        ///< so many times the grip that holds: the scene's own
  std::optional<ForceReport> forces; ///< none: the motion says nothing of them
};

/// `tolerance`: as a part of the fastest speed, and of the largest force.
TrajectoryReport verify_trajectory(const SceneFile& file, const Trajectory& trajectory,
                                   double tolerance);

std::string trajectory_text(const SceneFile& file, const TrajectoryReport& report);
std::string trajectory_json(const SceneFile& file, const TrajectoryReport& report);

} // namespace lcpush::desktop
