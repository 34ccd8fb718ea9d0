// What the readers of a motion's two formats share.
#pragma once

#include "lcpush/desktop/trajectory.hpp"

#include <map>

namespace lcpush::desktop {

/// Frames, and the lines where they stand in the file.
struct ReadFrames {
  std::vector<TrajectoryFrame> frames;
  std::vector<int> lines;
  std::vector<std::string> unread;
  std::vector<double> places, turns; ///< the numbers of places and of rotations as they stand
};

/// Where a scene's bodies and contacts stand, by name.
struct PlacesByName {
  std::map<std::string, std::size_t, std::less<>> bodies, contacts;

  explicit PlacesByName(const SceneFile& scene);
  /// All names, for suggestions.
  std::vector<std::string> known() const;
};

Matrix3<double> rotation_of_rows(const std::vector<double>& rows);
/// w first; of any length but zero.
Matrix3<double> rotation_of_quaternion(const std::vector<double>& q);

ReadFrames frames_of_json(const std::string& text, const std::string& file, const SceneFile& scene);
ReadFrames frames_of_csv(const std::string& text, const std::string& file, const SceneFile& scene);

} // namespace lcpush::desktop
