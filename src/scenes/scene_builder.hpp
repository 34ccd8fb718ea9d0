// Builds a scene from the tables of a parsed document.
#pragma once

#include "formats/toml.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <optional>

namespace lcpush::desktop {

/// Throws InputError if the document, one of `parse_scene_tables`, is no scene, whatever `strokes`
/// are meant. S is double or Rational. `unsaid_hand`: of a file that names none, if it is known;
/// else the one that its fingers belong to.
template <class S>
SceneOf<S> build_scene(const TomlDocument& document, std::optional<Hand> unsaid_hand = {},
                       Strokes strokes = Strokes::first);

} // namespace lcpush::desktop
