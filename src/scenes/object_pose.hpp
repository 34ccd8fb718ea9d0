// An object that is turned in its scene: rotation and tilt.
#pragma once

#include "formats/toml.hpp"

#include <optional>
#include <string>

namespace lcpush::desktop {

/// "20 deg about z" as a rotation, [axis.., angle], its angle as a text with its unit; nothing if
/// it says something else.
std::optional<TomlValue> rotation_of_tilt(const TomlValue& tilt);

bool has_turned_object(const TomlDocument& document);

/// The same scene in the object's own frame: gravity, loads and speeds, and the contacts with
/// frame = "scene", are turned back into it by a rotation in fractions. Throws InputError.
/// Pre: check_sections().
TomlDocument in_object_frame(TomlDocument document);

} // namespace lcpush::desktop
