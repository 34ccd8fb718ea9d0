// A scene as JSON: geometry, generators, and where each contact's unknowns stand among z. For pages
// also what of its pictures is as in a report, so that their scripts draw only what changes.
#pragma once

#include "formats/json_writer.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// How much of its pictures goes along.
enum class ScenePictures {
  none,
  views, ///< projections, outlines, pads, cones: for a page that shows fixed views
};

/// One object, SI units and scene axes.
void write_scene(JsonWriter& json, const Push& push, ScenePictures pictures);

} // namespace lcpush::desktop
