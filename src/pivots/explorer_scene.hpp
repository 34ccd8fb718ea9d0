// What a picture of a scene needs, as JSON: geometry, generators, and where each contact's unknowns
// stand among z.
#pragma once

#include "formats/json_writer.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// One object, SI units and scene axes.
void write_drawing(JsonWriter& json, const Push& push);

} // namespace lcpush::desktop
