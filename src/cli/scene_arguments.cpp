#include "cli/scene_arguments.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "cli/time_limit.hpp"
#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {

void refuse_unknowns(const Arguments& arguments, const SceneFile& file, Index most,
                     const std::string& what) {
  const Index unknowns = size_of(file.view()).unknowns();
  if (unknowns > most)
    throw InputError(arguments.files()[0] + ": the scene has " + std::to_string(unknowns) +
                     " unknowns, more than the " + std::to_string(most) + " whose " + what +
                     "; use fewer points or facets");
}

namespace {

void refuse_size(const Arguments& arguments, const SceneFile& file, Needs needs) {
  if (needs == Needs::matrix)
    refuse_unknowns(arguments, file, limits::unknowns_matrix, "matrix fits into 1 GB");
  else
    refuse_unknowns(arguments, file, limits::unknowns_held, "solution fits into 1 GB");
}

} // namespace

void refuse_samples(double samples, const SceneFile& file) {
  const std::string refusal = desktop::too_many_samples(samples, file);
  if (!refusal.empty()) throw UsageError(refusal + "; ask for fewer --steps");
}

SceneFile read_scene_argument(const Arguments& arguments, Needs needs, Strokes strokes) {
  if (arguments.files().empty()) refuse_no_scene();
  SceneFile file = read_scene(arguments.files()[0], strokes);
  if (arguments.has("--strict")) refuse_doubts(file);
  refuse_size(arguments, file, needs);
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

void refuse_no_scene() {
  throw UsageError("a scene file is needed; `lcpush new box -o mine.toml` writes one");
}

VariedScene read_varied_scene(const Arguments& arguments, const std::string& path, Needs needs) {
  VariedScene scene = VariedScene::read(path);
  if (const auto law = arguments.value("--pressure"))
    scene.set_pressure(one_of("--pressure", *law, pressure_names()));
  const SceneFile file = scene.as_given();
  refuse_size(arguments, file, needs);
  if (arguments.has("--strict")) refuse_doubts(file);
  return scene;
}

void refuse_doubts(const SceneFile& file) {
  std::string all;
  for (const SceneDoubt& doubt : check_scene(file))
    all += (all.empty() ? "" : "\n") + doubt_text(doubt);
  if (!all.empty()) throw InputError(all);
}

std::vector<Option> with_scene_options(std::vector<Option> own) {
  own.push_back({"--strict", "", "what looks odd about the scene is an error"});
  const auto has_its_own = [](const Option& option) { return option.name == seconds_option.name; };
  if (std::none_of(own.begin(), own.end(), has_its_own)) own.push_back(seconds_option);
  return with_common_options(std::move(own));
}

Telling telling(const Arguments& arguments) {
  return arguments.has("--verbose") ? Telling::full : Telling::brief;
}

void write_answer(const Arguments& arguments, const std::string& format, const std::string& text,
                  const std::vector<SceneDoubt>& doubts) {
  if (format == "text")
    write_text(arguments, text);
  else
    write_output(arguments, text);
  if (format == "json") return;
  for (const SceneDoubt& doubt : doubts)
    std::cerr << wrapped("Check: " + doubt_text(doubt) + ".", columns_of(Stream::errors)) << "\n";
}

void write_answer(const Arguments& arguments, const std::string& format, const std::string& text,
                  const SceneFile& file) {
  const bool is_checked = format == "json" || arguments.has("--strict");
  write_answer(arguments, format, text, is_checked ? std::vector<SceneDoubt>() : check_scene(file));
}

Variation read_variation(const VariedScene& scene, const std::string& text) {
  const std::vector<std::string_view> sides = split_at(text, '=');
  const std::vector<std::string_view> ends = split_at(sides.back(), ':');
  if (sides.size() != 2 || ends.size() != 2)
    throw UsageError("--vary needs PATH=FROM:TO, such as left.grip_force=5:40, not " +
                     desktop::quoted(text) +
                     (ends.size() > 2 ? "; --steps says how many values" : ""));
  Variation variation;
  variation.parameter = scene.find(std::string(trimmed(sides.front())));
  const auto number = [&](std::string_view word) {
    const NumberText read = read_finite_number(trimmed(word));
    if (read.error) throw UsageError("--vary " + desktop::quoted(text) + ": " + *read.error);
    return read.value;
  };
  variation.from = number(ends.front());
  variation.to = number(ends.back());
  if (variation.from == variation.to)
    throw UsageError("--vary " + desktop::quoted(text) + ": from and to are the same");
  return variation;
}

} // namespace lcpush::cli
