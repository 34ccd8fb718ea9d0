// What commands take about scenes: the file, --pusher, --pressure and --vary.
#pragma once

#include "cli/arguments.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/sweep.hpp"

namespace lcpush::cli {

/// What a command does with a scene.
enum class Needs {
  matrix, ///< holds M, or a dictionary of it
  scene,  ///< O(points): sweeps, or pivots on the structured basis
};

/// The scene of the first file. Throws UsageError without one, InputError if it is too large.
SceneFile read_scene_argument(const Arguments& arguments, Needs needs = Needs::matrix);

/// Refuses more unknowns than the `most` "whose `what`", such as "faces can be bounded".
void refuse_unknowns(const Arguments& arguments, const SceneFile& file, Index most,
                     const std::string& what);

/// The body of --pusher, or the only pusher: whose force is meant. Throws UsageError.
Index chosen_pusher(const Arguments& arguments, const SceneFile& file);

inline const Option pressure_option{"--pressure", "LAW",
                                    "pad, even or rigid instead of the scene's own"};
/// The law of --pressure, if it is given.
void set_pressure(const Arguments& arguments, VariedScene& scene);

/// PATH=FROM:TO, the value of --vary.
Variation read_variation(const VariedScene& scene, const std::string& text);

} // namespace lcpush::cli
