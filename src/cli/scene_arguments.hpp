// What commands take about scenes: the file, --pusher, --pressure and --vary.
#pragma once

#include "cli/arguments.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/report.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/desktop/sweep.hpp"

namespace lcpush::cli {

/// What a command does with a scene.
enum class Needs {
  matrix, ///< holds M, or a dictionary of it
  scene,  ///< O(points): sweeps, or pivots on the structured basis
};

/// The scene of the first file. Throws UsageError without one, InputError if it is too large, or
/// odd in any way with --strict.
SceneFile read_scene_argument(const Arguments& arguments, Needs needs = Needs::matrix,
                              Strokes strokes = Strokes::first);
/// The same, to be varied; the law of --pressure, if it is given.
VariedScene read_varied_scene(const Arguments& arguments, const std::string& path,
                              Needs needs = Needs::matrix);
/// Throws UsageError: no file was named.
[[noreturn]] void refuse_no_scene();
/// Throws InputError if the scene looks odd.
void refuse_doubts(const SceneFile& file);

/// The options of a command that answers about a scene, also --strict.
std::vector<Option> with_scene_options(std::vector<Option> own);
inline const Option verbose_option{"--verbose", "",
                                   "also all digits, the theory, how it was found; -v for short"};
Telling telling(const Arguments& arguments);

/// Writes the answer; on stderr, what looks odd about its scene. JSON has that in `warnings`.
void write_answer(const Arguments& arguments, const std::string& format, const std::string& text,
                  const std::vector<SceneDoubt>& doubts);
/// The same, of a scene that nobody has checked yet but the writer of JSON.
void write_answer(const Arguments& arguments, const std::string& format, const std::string& text,
                  const SceneFile& file);

/// More samples of a sweep than the memory's ceiling holds.
void refuse_samples(double samples, const SceneFile& file);

/// Refuses more unknowns than the `most` "whose `what`", such as "faces can be bounded".
void refuse_unknowns(const Arguments& arguments, const SceneFile& file, Index most,
                     const std::string& what);

/// The body of --pusher, or the only pusher: whose force is meant. Throws UsageError.
Index chosen_pusher(const Arguments& arguments, const SceneFile& file);

inline const Option pressure_option{"--pressure", "LAW",
                                    "pad, even or rigid instead of the scene's own"};

/// PATH=FROM:TO, the value of --vary.
Variation read_variation(const VariedScene& scene, const std::string& text);

} // namespace lcpush::cli
