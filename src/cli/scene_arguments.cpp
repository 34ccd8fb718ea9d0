#include "cli/scene_arguments.hpp"

#include <algorithm>

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {

void refuse_unknowns(const Arguments& arguments, const SceneFile& file, Index most,
                     const std::string& what) {
  const Index unknowns = size_of(file.view()).unknowns();
  if (unknowns > most)
    throw InputError(arguments.files()[0] + ": the scene has " + std::to_string(unknowns) +
                     " unknowns, more than the " + std::to_string(most) + " whose " + what +
                     "; use fewer points or facets");
}

SceneFile read_scene_argument(const Arguments& arguments, Needs needs) {
  if (arguments.files().empty())
    throw UsageError("a scene file is needed, such as fixtures/scenes/straight_slide.toml");
  SceneFile file = read_scene(arguments.files()[0]);
  if (needs == Needs::matrix)
    refuse_unknowns(arguments, file, largest_dimension, "matrix this command can hold");
  return file;
}

Index chosen_pusher(const Arguments& arguments, const SceneFile& file) {
  std::vector<std::string> names;
  Index pusher = -1;
  const std::optional<std::string> wanted = arguments.value("--pusher");
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].role != Role::pusher) continue;
    names.push_back(file.body_names[b]);
    if (!wanted || *wanted == file.body_names[b]) pusher = static_cast<Index>(b);
  }
  if (names.empty()) throw UsageError("the scene has no [[pusher]]: nothing can break the grasp");
  if (!wanted && names.size() > 1)
    throw UsageError("the scene has several pushers: say which with --pusher " +
                     listed(names, "or"));
  if (pusher < 0)
    throw UsageError("no pusher is named " + desktop::quoted(*wanted) + suggestion(*wanted, names));
  return pusher;
}

void set_pressure(const Arguments& arguments, VariedScene& scene) {
  const auto law = arguments.value("--pressure");
  if (!law) return;
  const std::vector<std::string> laws = pressure_names();
  if (std::find(laws.begin(), laws.end(), *law) == laws.end())
    refuse_value("--pressure", *law, listed(laws, "or"), laws);
  scene.set_pressure(*law);
}

Variation read_variation(const VariedScene& scene, const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.rfind(':');
  if (equals == std::string::npos || colon == std::string::npos || colon < equals)
    throw UsageError("--vary needs PATH=FROM:TO, such as left.grip_force=5:40, not " +
                     desktop::quoted(text));
  Variation variation;
  variation.parameter = scene.find(text.substr(0, equals));
  const auto number = [&](std::size_t begin, std::size_t end) {
    const NumberText read = read_finite_number(text.substr(begin, end - begin));
    if (read.error) throw UsageError("--vary " + desktop::quoted(text) + ": " + *read.error);
    return read.value;
  };
  variation.from = number(equals + 1, colon);
  variation.to = number(colon + 1, text.size());
  if (variation.from == variation.to)
    throw UsageError("--vary " + desktop::quoted(text) + ": from and to are the same");
  return variation;
}

} // namespace lcpush::cli
