// A number of a scene file in words, for the axes of plots.
#pragma once

#include "lcpush/desktop/varied_scene.hpp"

#include <string>

namespace lcpush::desktop {

/// "grip force", "friction of edge", "shift of edge along x": what a path means.
std::string parameter_words(const Parameter& parameter);
/// "shift of edge along x, m".
std::string parameter_label(const Parameter& parameter);

} // namespace lcpush::desktop
