// Builds a scene from the tables of a parsed document.
#pragma once

#include "formats/toml.hpp"
#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// Throws InputError if the document is no scene. S is double or Rational.
template <class S> SceneOf<S> build_scene(const TomlDocument& document);

} // namespace lcpush::desktop
