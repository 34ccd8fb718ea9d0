// The one scene file that a command works on.
#pragma once

#include "cli/arguments.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush::cli {

/// What a command does with a scene.
enum class Needs {
  matrix, ///< holds M, or a dictionary of it
  scene,  ///< O(points): sweeps, or pivots on the structured basis
};

inline desktop::SceneFile read_scene_argument(const Arguments& arguments,
                                              Needs needs = Needs::matrix) {
  if (arguments.files().empty())
    throw UsageError("a scene file is needed, such as fixtures/scenes/straight_slide.toml");
  const std::string& path = arguments.files()[0];
  desktop::SceneFile file = desktop::read_scene(path);
  const Index unknowns = size_of(file.view()).unknowns();
  if (unknowns > desktop::largest_dimension && needs == Needs::matrix)
    throw desktop::InputError(path + ": the scene has " + std::to_string(unknowns) +
                              " unknowns, more than the " +
                              std::to_string(desktop::largest_dimension) +
                              " whose matrix this command can hold; use fewer points or facets");
  return file;
}

} // namespace lcpush::cli
