// The one scene file that a command works on.
#pragma once

#include "arguments.hpp"
#include "lcpush/host/input_error.hpp"
#include "lcpush/host/matrix_market.hpp"
#include "lcpush/host/scene_io.hpp"
#include "lcpush/mechanics/workspace.hpp"

namespace lcpush::cli {

/// What a command does with a scene.
enum class Needs {
  matrix, ///< holds M, or a dictionary of it
  scene,  ///< O(points): sweeps, or pivots on the structured basis
};

inline host::SceneFile read_scene_argument(const Arguments& arguments,
                                           Needs needs = Needs::matrix) {
  if (arguments.files().empty())
    throw UsageError("a scene file is needed, such as fixtures/scenes/straight_slide.toml");
  const std::string& path = arguments.files()[0];
  host::SceneFile file = host::read_scene(path);
  const Index unknowns = size_of(file.view()).unknowns();
  if (unknowns > host::largest_dimension && needs == Needs::matrix)
    throw host::InputError(path + ": the scene has " + std::to_string(unknowns) +
                           " unknowns, more than the " + std::to_string(host::largest_dimension) +
                           " whose matrix this command can hold; use fewer points or facets");
  return file;
}

} // namespace lcpush::cli
