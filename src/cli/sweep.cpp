// lcpush sweep: how the push changes with a number of the scene.
#include <algorithm>
#include <chrono>

#include <unistd.h>

#include "../host/message.hpp"
#include "../host/number_text.hpp"
#include "chosen_pusher.hpp"
#include "commands.hpp"
#include "lcpush/host/input_error.hpp"
#include "lcpush/host/sweep.hpp"
#include "scene_argument.hpp"

namespace lcpush::cli {
namespace {

constexpr Index most_steps = 1000000, most_map_steps = 1000;

/// PATH=FROM:TO.
host::Variation read_variation(const host::VariedScene& scene, const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.rfind(':');
  if (equals == std::string::npos || colon == std::string::npos || colon < equals)
    throw UsageError("--vary needs PATH=FROM:TO, such as left.grip_force=5:40, not " +
                     host::quoted(text));
  host::Variation variation;
  variation.parameter = scene.find(text.substr(0, equals));
  const auto number = [&](std::size_t begin, std::size_t end) {
    const host::NumberText read = host::read_finite_number(text.substr(begin, end - begin));
    if (read.error) throw UsageError("--vary " + host::quoted(text) + ": " + *read.error);
    return read.value;
  };
  variation.from = number(equals + 1, colon);
  variation.to = number(colon + 1, text.size());
  if (variation.from == variation.to)
    throw UsageError("--vary " + host::quoted(text) + ": from and to are the same");
  return variation;
}

Index read_steps(const Arguments& arguments, Index most) {
  const std::optional<std::string> text = arguments.value("--steps");
  if (!text) return 0;
  const auto steps = host::whole_number(*text);
  if (!steps || *steps < 2 || *steps > static_cast<std::uint64_t>(most))
    throw UsageError("--steps is a whole number from 2 to " + std::to_string(most) + ", not " +
                     host::quoted(*text));
  return static_cast<Index>(*steps);
}

/// How much of the sweep is done, once a second.
class Meter {
public:
  ~Meter() {
    if (shown_ && terminal_) std::fprintf(stderr, "\r\033[K");
  }
  void show(double done) {
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::seconds(1);
    shown_ = true;
    std::fprintf(stderr, "%slcpush: %.0f %% of the sweep%s", terminal_ ? "\r\033[K" : "",
                 100 * done, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
  bool shown_ = false, terminal_ = isatty(STDERR_FILENO) != 0;
};

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
  if (const auto law = arguments.value("--pressure")) {
    const std::vector<std::string> laws = {"pad", "even", "rigid"};
    if (std::find(laws.begin(), laws.end(), *law) == laws.end())
      throw UsageError("--pressure is " + host::listed(laws, "or") + ", not " + host::quoted(*law) +
                       host::suggestion(*law, laws));
    scene.set_pressure(*law);
  }
  std::vector<host::Variation> variations;
  for (const std::string& text : varied) variations.push_back(read_variation(scene, text));
  host::ParameterSweepOptions options;
  options.pusher = chosen_pusher(arguments, file);
  options.steps = read_steps(arguments, varied.size() > 1 ? most_map_steps : most_steps);
  host::Sweep sweep;
  {
    Meter meter;
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
           {"--pressure", "LAW", "pad, even or rigid instead of the scene's own"},
           {"--pusher", "NAME", "whose force is meant, among several"},
           {"--format", "FORMAT", "text (default), csv, json or svg; --json for short"}}),
      1,
      run};
}

} // namespace lcpush::cli
