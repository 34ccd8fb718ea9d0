// What of a patch lies beside the object does not press: a long edge over a short box.
#pragma once

#include "formats/toml.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <map>
#include <optional>
#include <string>

namespace lcpush::desktop {

/// The document with the patches that reach beyond the object's faces cut to what touches, and how
/// far each of these reached (m); nothing where none does, where the shape
/// is not known or where the file as a whole looks misplaced. Curved sides are touched along a line
/// or at a point by what reaches beyond them. Throws InputError for a patch that lies on a face's
/// plane, but wholly beside the face. `file`: built from `document`.
struct CutScene {
  TomlDocument document;
  std::map<std::string, double> overhang; ///< by body name
};
std::optional<CutScene> cut_overhang(const TomlDocument& document, const SceneFile& file);

} // namespace lcpush::desktop
