// How many corners a drawn friction cone has.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// Of round friction enough for the eye.
inline Index drawn_facets(const SceneFile& file) { return file.is_round ? 64 : file.facets; }

} // namespace lcpush::desktop
