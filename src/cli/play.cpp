// lcpush play: the grasp to take in your hand.
#include "lcpush/desktop/play.hpp"

#include <unistd.h>

#include <filesystem>

#include "cli/commands.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/assemble.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/limits.hpp"

namespace lcpush::cli {
namespace {

int write_gallery(const Arguments& arguments) {
  const std::optional<std::string> directory = arguments.value("--output");
  if (!directory) throw UsageError("say where to: --gallery -o DIRECTORY");
  if (!arguments.files().empty())
    throw UsageError("--gallery shows the shipped scenes; leave the scene out");
  const std::filesystem::path into(*directory);
  std::error_code failure;
  std::filesystem::create_directories(into, failure);
  if (failure) throw desktop::InputError(*directory + ": cannot be made: " + failure.message());
  for (const desktop::PlayFile& file : desktop::play_gallery())
    write_file((into / file.name).string(), file.text);
  return 0;
}

int run_play(const Arguments& arguments) {
  if (arguments.has("--gallery")) return write_gallery(arguments);
  if (!arguments.has("--output") && isatty(STDOUT_FILENO) != 0)
    throw UsageError("a page is for a browser: say where to with -o play.html");
  std::string text;
  if (arguments.files().empty()) {
    text = *desktop::scene_called(desktop::example_scenes(), "straight_slide");
  } else {
    const std::string& path = arguments.files()[0];
    text = desktop::read_scene_text(path);
    // What is wrong is said here as well.
    const desktop::SceneFile file = desktop::parse_scene(text, desktop::scene_label(path));
    if (size_of(file.view()).unknowns() > desktop::limits::unknowns_searched)
      throw desktop::InputError(desktop::scene_label(path) + ": more than the " +
                                std::to_string(desktop::limits::unknowns_searched) +
                                " unknowns that the page solves while you look; use fewer points "
                                "or facets");
  }
  write_output(arguments, desktop::play_html(text));
  return 0;
}

} // namespace

Command play_command() {
  return {
      "play",
      "[SCENE.toml] [OPTIONS]",
      "a page to try things: drag the grasp, and it is solved at once",
      "Writes one page for a browser with the solver inside: drag the pusher and the fingers,\n"
      "change friction, grip, mass and gravity, play the push, watch its pivots. It needs no\n"
      "network and nothing installed, so it can be mailed; its links carry a scene. Without\n"
      "SCENE it begins with the straight slide of the examples.\n\n"
      "Example:\n  lcpush play fixtures/scenes/pivot.toml -o play.html\n"
      "  lcpush play --gallery -o scenes\n",
      {{"--gallery", "", "every shipped scene, as a folder of pages: -o DIRECTORY"}, output_option},
      1,
      run_play};
}

} // namespace lcpush::cli
