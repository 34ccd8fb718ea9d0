// lcpush sweep: how the push changes with a number of the scene.
#include <cmath>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "formats/read_number.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

/// --each PATH=V,V,..: a variation a value, from = to.
std::vector<Variation> read_each(const VariedScene& scene, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw UsageError("--each needs PATH=V,V,.. such as facets=4,8,16, not " +
                     desktop::quoted(text));
  const Parameter parameter =
      scene.find(std::string(trimmed(std::string_view(text).substr(0, equals))));
  std::vector<Variation> list;
  for (const std::string_view part : split_at(std::string_view(text).substr(equals + 1), ',')) {
    const NumberText read = read_finite_number(trimmed(part));
    if (read.error) throw UsageError("--each " + desktop::quoted(text) + ": " + *read.error);
    list.push_back({parameter, read.value, read.value});
  }
  return list;
}

/// All that is known before the first solve, so that bad input costs no time.
std::vector<SweepCurve> read_curves(const Arguments& arguments, std::vector<VariedScene>& scenes) {
  std::vector<SweepCurve> curves;
  const auto each = arguments.value("--each");
  for (const std::string& path : arguments.files()) {
    VariedScene scene = read_varied_scene(arguments, path);
    const std::string given = scene.as_given().title, title = given.empty() ? path : given;
    const std::string mine = arguments.files().size() > 1 ? title : "";
    if (!each) {
      curves.push_back({mine, title, std::nullopt, {}});
      scenes.push_back(scene);
      continue;
    }
    for (const Variation& value : read_each(scene, *each)) {
      curves.push_back(curve_at(value, title, mine));
      scenes.push_back(scene.with(value.parameter, value.from));
    }
  }
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (const std::string& text : arguments.values("--vary"))
      curves[k].sweep.variations.push_back(read_variation(scenes[k], text));
  refuse_overwritten(curves);
  return curves;
}

int run_sweep(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "csv", "json", "svg"});
  const std::vector<std::string> varied = arguments.values("--vary");
  if (varied.empty()) throw UsageError("say what to vary: --vary PATH=FROM:TO");
  if (varied.size() > 2)
    throw UsageError("--vary is given once, or twice for a map, not " +
                     std::to_string(varied.size()) + " times");
  std::vector<SweepQuantity> shown;
  if (const auto names = arguments.value("--show")) {
    if (format != "svg")
      throw UsageError("--show goes with --format svg; the other formats have everything");
    for (const std::string_view name : split_at(*names, ','))
      shown.push_back(sweep_quantity(std::string(name)));
  }
  if (arguments.files().empty()) refuse_no_scene();
  std::vector<VariedScene> scenes;
  std::vector<SweepCurve> curves = read_curves(arguments, scenes);
  if (varied.size() > 1 && curves.size() > 1)
    throw UsageError("a map is of one scene: leave out the second --vary, or --each and the other "
                     "scenes");
  ParameterSweepOptions options;
  options.steps =
      arguments.whole("--steps", {2, varied.size() > 1 ? limits::map_steps : limits::sweep_steps})
          .value_or(0);
  const double samples = std::pow(options.steps, static_cast<double>(varied.size()));
  refuse_samples(samples * static_cast<double>(curves.size()), scenes.front().as_given());
  bool complete = true;
  {
    StatusLine line;
    const double count = static_cast<double>(curves.size());
    for (std::size_t k = 0; k < curves.size(); ++k) {
      options.progress = [&line, count, k](double done) {
        line.show_share((static_cast<double>(k) + done) / count);
      };
      options.pusher = chosen_pusher(arguments, scenes[k].as_given());
      curves[k].sweep = sweep_parameter(scenes[k], curves[k].sweep.variations, options);
      complete = complete && curves[k].sweep.complete;
    }
  }
  std::vector<SceneDoubt> doubts;
  for (std::size_t k = 0; k < scenes.size(); k += scenes.size() / arguments.files().size())
    for (SceneDoubt& doubt : check_scene(scenes[k].as_given())) doubts.push_back(std::move(doubt));
  write_answer(arguments, format,
               format == "json"  ? sweep_json(curves, doubts)
               : format == "csv" ? sweep_csv(curves)
               : format == "svg" ? sweep_svg(curves, sweep_title(curves), shown)
                                 : sweep_text(curves, telling(arguments)),
               doubts);
  return complete ? 0 : 1;
}

} // namespace

Command sweep_command() {
  return {
      "sweep",
      "SCENE.toml.. --vary PATH=FROM:TO [OPTIONS]",
      "how the push changes with grip force, friction, place, motion, ..",
      R"(Varies one number of the scene, or two for a map. PATH is a name and a key of the file,
vectors counted from [0]: left.grip_force, wall.ends[0][1], object.mass, gravity[1]; *.KEY
of all bodies that have it; wall.shift[1] moves a body along an axis (m), wall.turn turns
its acceleration in the x-y plane, wall.tangent_turn its friction generators about the normal
(degrees). A path that does not exist lists those that do. Several scenes, or several values
with --each, give a curve each; what counts something (facets, points) varies there alone.

Forces and accelerations give exact segments (under pressure "rigid" or "even"; "pad" by
bisection) with their breakpoints in words; everything else is sampled, more closely where
modes change.

Examples:
  lcpush sweep fixtures/scenes/straight_slide.toml --vary "*.grip_force=2:30" --pressure rigid
)"
      "  lcpush sweep fixtures/scenes/pivot.toml --vary edge.shift[0]=0:0.03 --steps 31 "
      "--each facets=4,8,16 \\\n    --show force,twist[5] --format svg -o pivot.svg\n",
      with_scene_options(
          {{"--vary", "PATH=FROM:TO", "what varies, and how far; twice for a map", true},
           {"--each", "PATH=V,V,..", "one curve for each of these values of another number"},
           {"--steps", "N", "points evenly spread, ends included (51; a map 11 each way)"},
           pressure_option,
           {"--pusher", "NAME", "whose force is meant, among several"},
           {"--show", "NAME,NAME,..",
            "what the picture shows: break_force, force, force[0], twist[5], break_twist[5], .."},
           verbose_option,
           {"--format", "FORMAT", "text (default), csv, json or svg; --json for short"}}),
      limits::curves,
      run_sweep};
}

} // namespace lcpush::cli
