// lcpush: a scene file (a strict subset of TOML) becomes a Scene.
#pragma once

#include "lcpush/mechanics/scene.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace lcpush::host {

/// The arrays behind a Scene, and the names that the core does not need.
/// Bodies are the file's fingers, then its pushers, each in the file's order.
struct SceneFile {
  std::string title; ///< empty if the file has none
  Object<double> object{};
  Vector3<double> gravity = Vector3<double>::Zero(); ///< m/s^2
  Index facets = 8;
  Pressure pressure = Pressure::pad;
  bool planar = false;
  bool parallel_jaws = false; ///< [gripper] jaws = "parallel": one actuator of both grip forces
  std::vector<Body<double>> bodies;
  std::vector<Vector3<double>> points;    ///< m, from the centre of mass, body by body
  std::vector<Vector3<double>> positions; ///< m, the same points in the scene's frame
  std::vector<Actuator<double>> actuators;
  std::vector<Drive<double>> drives;
  std::vector<std::string> body_names;     ///< unique
  std::vector<std::string> actuator_names; ///< of the body or the [[actuator]]; "jaws" if parallel

  /// The scene over these arrays: valid while this SceneFile lives unchanged.
  Scene<double> view() const;

  /// The body of a point of `points`. Cost: O(bodies).
  Index body_of(Index point) const {
    std::size_t b = 0;
    while (point >= bodies[b].first_point + bodies[b].point_count) ++b;
    return static_cast<Index>(b);
  }
};

/// Reads the scene file at `path`. Every value of the result is finite and physical: unit normals
/// and tangents, a positive definite inertia, at least one contact point, no coincident points in
/// a patch. Throws InputError, with file and line, on anything else; it guesses nothing.
SceneFile read_scene(const std::string& path);

/// The same for a text in memory; `file_name` only names it in messages.
SceneFile parse_scene(std::string_view text, const std::string& file_name);

} // namespace lcpush::host
