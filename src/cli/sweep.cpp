// lcpush sweep: how the push changes with a number of the scene.
#include "lcpush/host/sweep.hpp"
#include "chosen_pusher.hpp"
#include "commands.hpp"
#include "lcpush/host/input_error.hpp"
#include "scene_argument.hpp"
#include "varied_argument.hpp"

namespace lcpush::cli {
namespace {

constexpr Index most_steps = 1000000, most_map_steps = 1000;

std::string title_of(const host::Sweep& sweep, const std::string& scene) {
  std::string title = scene.empty() ? "" : scene + ": ";
  title += "push by " + sweep.pusher + " over " + sweep.variations[0].parameter.path;
  if (sweep.is_map()) title += " and " + sweep.variations[1].parameter.path;
  return title;
}

int run(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "csv", "json", "svg"});
  const std::vector<std::string> varied = arguments.values("--vary");
  if (varied.empty()) throw UsageError("say what to vary: --vary PATH=FROM:TO");
  if (varied.size() > 2)
    throw UsageError("--vary is given once, or twice for a map, not " +
                     std::to_string(varied.size()) + " times");
  const host::SceneFile file = read_scene_argument(arguments);
  host::VariedScene scene = host::VariedScene::read(arguments.files()[0]);
  set_pressure(arguments, scene);
  std::vector<host::Variation> variations;
  for (const std::string& text : varied) variations.push_back(read_variation(scene, text));
  host::ParameterSweepOptions options;
  options.pusher = chosen_pusher(arguments, file);
  options.steps = read_steps(arguments, varied.size() > 1 ? most_map_steps : most_steps);
  host::Sweep sweep;
  {
    SweepMeter meter;
    options.progress = [&meter](double done) { meter.show(done); };
    sweep = host::sweep_parameter(scene, variations, options);
  }
  write_output(arguments, format == "json"  ? host::sweep_json(sweep)
                          : format == "csv" ? host::sweep_csv(sweep)
                          : format == "svg" ? host::sweep_svg(sweep, title_of(sweep, file.title))
                                            : host::sweep_text(sweep));
  return sweep.complete ? 0 : 1;
}

} // namespace

Command sweep_command() {
  return {
      "sweep",
      "SCENE.toml --vary PATH=FROM:TO [OPTIONS]",
      "how the push changes with grip force, friction, place, motion, ..",
      "Varies one number of the scene, or two for a map. PATH is a name and a key of the file,\n"
      "vectors counted from [0]: left.grip_force, wall.ends[0][1], object.mass, gravity[1]; *.KEY\n"
      "of all bodies that have it; wall.shift[1] moves a body along an axis (m), wall.turn turns\n"
      "its acceleration in the x-y plane (degrees). A path that does not exist lists those that "
      "do.\n\n"
      "Forces and accelerations give exact segments (under pressure \"rigid\" or \"even\"; \"pad\" "
      "by\n"
      "bisection) with their breakpoints in words; everything else is sampled, more closely where\n"
      "modes change.\n\n"
      "Examples:\n"
      "  lcpush sweep fixtures/scenes/straight_slide.toml --vary \"*.grip_force=2:30\" "
      "--pressure rigid\n"
      "  lcpush sweep fixtures/scenes/pivot.toml --vary edge.shift[0]=0:0.03 --steps 31 "
      "--format svg -o pivot.svg\n",
      with_common_options(
          {{"--vary", "PATH=FROM:TO", "what varies, and how far; twice for a map", true},
           {"--steps", "N", "points evenly spread, ends included (51; a map 11 each way)"},
           pressure_option(),
           {"--pusher", "NAME", "whose force is meant, among several"},
           {"--format", "FORMAT", "text (default), csv, json or svg; --json for short"}}),
      1,
      run};
}

} // namespace lcpush::cli
