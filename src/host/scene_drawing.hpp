// What a picture of a scene needs, as JSON: geometry, generators, and where each contact's unknowns
// stand among z.
#pragma once

#include "lcpush/host/json.hpp"
#include "lcpush/host/push.hpp"

namespace lcpush::host {

/// One object, SI units and scene axes.
void write_drawing(JsonWriter& json, const Push& push);

} // namespace lcpush::host
