// The one scene file that a command works on.
#pragma once

#include "arguments.hpp"
#include "lcpush/host/scene_io.hpp"

namespace lcpush::cli {

inline host::SceneFile read_scene_argument(const Arguments& arguments) {
  if (arguments.files().empty())
    throw UsageError("a scene file is needed, such as fixtures/scenes/straight_slide.toml");
  return host::read_scene(arguments.files()[0]);
}

} // namespace lcpush::cli
