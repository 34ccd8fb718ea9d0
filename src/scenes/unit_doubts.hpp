// Numbers that no hand, object or push has: a slip of the unit, most often.
#pragma once

#include "lcpush/desktop/scene_check.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

/// What is odd about mass, inertia, gravity, friction and accelerations, whatever the places.
std::vector<SceneDoubt> unit_doubts(const SceneFile& file);

/// All forces act at the centre of mass: the places are an idealisation.
bool is_particle(const SceneFile& file);

/// `finger "left": `, as doubts about a body begin.
std::string body_label(const SceneFile& file, std::size_t b);
/// "3 mm" or "1.2 m".
std::string length_text(double length);

} // namespace lcpush::desktop
