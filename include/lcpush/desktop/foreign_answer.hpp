// lcpush: somebody else's answer to a scene: the shape of `lcpush solve --json`, or any part of it.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lcpush::desktop {

/// What the file says about one contact point; SI units, scene axes, forces on the object.
struct ForeignContact {
  std::string name, body; ///< empty if not given
  std::optional<double> normal_force, torsion, spin;
  std::optional<Vector3<double>> friction_force, acceleration, position;
};

struct ForeignBody {
  std::optional<Vector3<double>> force, moment;
  std::optional<double> normal_force;
  std::vector<double> closing; ///< empty; one; or under even pressure one a point
};

struct ForeignAnswer {
  std::string file;                            ///< for messages
  std::string status;                          ///< as claimed; empty if not given
  std::optional<Vector6<double>> acceleration; ///< of the object
  std::vector<ForeignContact> contacts;        ///< none, or the scene's
  std::vector<ForeignBody> bodies;             ///< none, or one a body of the scene's
  std::vector<double> closing;                 ///< none, or one an actuator
  std::optional<Index> facets;                 ///< of the pyramids that its friction obeys
  std::optional<double> break_force;           ///< N: then nothing else is given
  std::string pusher;                          ///< whose; empty: the only one
  /// Why this cannot be an answer to the scene: other bodies, other points. Empty if it can.
  std::string not_this_scene;
};

/// Reads an answer to the scene `file`. Contacts and bodies are matched by name where all are named
/// as the scene names them, and then some may be left out, else by order; null stands for what is
/// not known; keys that are not known are ignored. Throws InputError, with file and line, on what
/// is no JSON or has the wrong type, and if nothing is in it that could be checked. `tolerance`:
/// what places may be off by, of the scene's size; six digits always do.
ForeignAnswer parse_foreign_answer(std::string_view text, const std::string& file_name,
                                   const SceneFile& file, double tolerance);

} // namespace lcpush::desktop
