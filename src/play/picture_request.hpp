// How the playground's page wants its picture.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/pose.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lcpush::desktop {

/// What would happen with a body in another place.
struct OtherPlace {
  Vector3<double> at;
  std::string kind, words;
};

/// A moment of the motion: poses about the centre of mass, and what the bodies do then.
struct Moment {
  struct Pressing {
    Pose<double> pose;
    Vector3<double> middle, normal, force; ///< of the points that touch; on the object [N]
    std::optional<double> normal_force;    ///< [N]; not known at the start
  };
  Pose<double> object;
  std::vector<Pressing> bodies;      ///< in the order of the file
  double most_force = 0;             ///< [N] that the longest arrow stands for
  std::vector<Vector3<double>> path; ///< of the centre of mass, from where it was
};

struct PictureRequest {
  bool in_full = true;       ///< as "solve" or as "drag"
  std::string view;          ///< "front", "top", "side" or "isometric"; empty: as follows
  Vector3<double> right, up; ///< of the scene, on the picture; unit vectors
  double meters = 0;         ///< pixels a metre; 0: as large as all fits, however it is turned
  double letter = 7.5;       ///< pixels a letter is wide
  std::vector<OtherPlace> dots;
  std::optional<Moment> moment;
};

/// {"full": true, "view": "front" or "right": [3 numbers] with "up": [3], "meters", "letter",
/// "dots": [{"at", "kind", "words"}], "moment": {"position", "rotation": [9, row by row],
/// "most_force", "path": [3 a place], "bodies": [{"position", "columns": [9, column by column],
/// "middle", "normal", "force", "normal_force"}]}}; all but the view can be left out. Throws
/// InputError.
PictureRequest read_picture_request(std::string_view text);

} // namespace lcpush::desktop
