// Points and directions by name.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush::desktop {

/// "left.3": point 3 (counted from 1) of body "left".
std::string point_name(const SceneFile& file, Index point);
/// A unit vector in three digits: "(0.707, 0.707, 0)".
std::string components_text(const Vector3<double>& direction);
/// "+x" or "-z" along an axis, else "(0.707, 0.707, 0)".
std::string direction_text(const Vector3<double>& direction);
/// "round friction", "8 facets", "friction along the plane" or "no friction".
std::string friction_law_text(const SceneFile& file);
/// " along +x"; of a soft point " along +x times 0.866 and twisting by 0.5", positive about its
/// normal; " twisting by 1" for a pure torque.
std::string generator_text(const Generator<double>& generator, double torsion_radius);

} // namespace lcpush::desktop
