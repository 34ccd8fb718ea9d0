// A scene as JSON: geometry, generators, and where each contact's unknowns stand among z. For the
// explorer also what of its pictures no pivot changes, so that its script draws only what does.
#pragma once

#include "formats/json_writer.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// One object, SI units and scene axes.
void write_scene(JsonWriter& json, const Push& push, bool is_drawn);

} // namespace lcpush::desktop
