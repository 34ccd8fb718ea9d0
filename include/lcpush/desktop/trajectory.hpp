// lcpush: is somebody else's motion one that these laws allow?
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/pose.hpp"
#include "lcpush/status.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// Where the object is, as `lcpush move` says it: from position 0 and rotation 1 at the start.
struct TrajectoryFrame {
  double time = 0;
  Pose<double> pose;                    ///< position: how far the centre of mass has gone
  std::optional<Vector6<double>> twist; ///< at the centre of mass
};

/// Frames of a JSON object as `lcpush move --json` writes it, or of a CSV file with a head and the
/// columns time, x, y, z, then r11 .. r33 or qw, qx, qy, qz, and if they are known vx .. wz. Throws
/// InputError: not of this shape, times that do not grow, no rotation.
std::vector<TrajectoryFrame> read_trajectory(const std::string& path);
/// The same for a text; `file_name` only names it in messages.
std::vector<TrajectoryFrame> parse_trajectory(const std::string& text,
                                              const std::string& file_name);

enum class TrajectoryVerdict {
  follows, ///< every step is the laws' own, within the tolerance
  creeps,  ///< the laws hold the object, and it moves
  differs, ///< a step that the laws make differently
  stopped, ///< from one of its frames the laws have no next step
};
const char* verdict_text(TrajectoryVerdict verdict); ///< "follows", ..

/// Steps are compared one by one, each begun where the other motion is.
struct TrajectoryReport {
  TrajectoryVerdict verdict = TrajectoryVerdict::differs;
  double tolerance = 0;  ///< of the fastest speed
  Index steps = 0;       ///< compared
  double fastest = 0;    ///< m/s, of pushers, and of the motion's contact points
  double worst = 0;      ///< m/s, between the ends of a step, at the contact point where most
  double worst_time = 0; ///< s, at that step's end
  double mean = 0;       ///< m/s
  Status status = Status::solved; ///< of the step that stopped
  double creep = 0;               ///< m/s, mean speed of the contact point that goes farthest
  std::optional<double> held;     ///< so many times the grip that holds: the scene's own
};

/// `tolerance`: as a part of the fastest speed.
TrajectoryReport verify_trajectory(const SceneFile& file,
                                   const std::vector<TrajectoryFrame>& trajectory,
                                   double tolerance);

std::string trajectory_text(const SceneFile& file, const TrajectoryReport& report);
std::string trajectory_json(const TrajectoryReport& report);

} // namespace lcpush::desktop
