// lcpush play: the grasp to take in your hand.
#include "lcpush/desktop/play.hpp"

#include <filesystem>

#include "cli/shell.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/assemble.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/limits.hpp"

namespace lcpush::cli {
namespace {

int write_gallery(const Arguments& arguments) {
  const std::optional<std::string> directory = arguments.text("output");
  if (!directory) throw UsageError("say where to: --gallery -o DIRECTORY");
  if (!arguments.files().empty() || arguments.has("set"))
    throw UsageError("--gallery shows the shipped scenes; leave the scene out");
  const std::filesystem::path into(*directory);
  make_directory(*directory);
  for (const PlayFile& file : play_gallery()) write_file((into / file.name).string(), file.text);
  tell("Wrote " + (into / "index.html").string() + " and what it shows; open it in a browser.");
  return 0;
}

int run_play(const Arguments& arguments) {
  if (arguments.has("gallery")) return write_gallery(arguments);
  refuse_page_on_terminal(arguments, "play");
  if (arguments.has("lcp")) {
    if (!arguments.files().empty() || arguments.has("set"))
      throw UsageError(
          "--lcp is the page of an M and a q that are typed there; leave the scene out");
    write_output(arguments, lcp_html());
    return 0;
  }
  std::string text;
  if (arguments.files().empty() && !arguments.has("set")) {
    text = *scene_called(example_scenes(), "straight_slide");
  } else {
    const Document scene = arguments.scene_document();
    text = scene.text;
    // What is wrong is said here as well.
    const SceneFile file = parse_scene(text, scene.name);
    arguments.inspect(file);
    if (size_of(file.view()).unknowns() > limits::unknowns_searched)
      throw InputError(scene.name + ": more than the " + std::to_string(limits::unknowns_searched) +
                       " unknowns that the page solves while you look; use fewer points or facets");
  }
  write_output(arguments, play_html(text));
  return 0;
}

} // namespace

ShellCommand play_command() {
  return {
      {"play",
       "[SCENE.toml] [OPTIONS]",
       "a page to try things: drag the grasp, it is solved at once",
       "Writes one page for a browser with the solver inside: drag the pusher and the fingers,\n"
       "change friction, grip, mass and gravity, play the push, watch its pivots. It needs no\n"
       "network and nothing installed, so it can be mailed; its links carry a scene. Without\n"
       "SCENE it begins with the straight slide of the examples.\n\n"
       "Example:\n  lcpush play fixtures/scenes/pivot.toml -o play.html\n"
       "  lcpush play --lcp -o lcp.html\n"
       "  lcpush play --gallery -o scenes\n",
       {{"lcp", "", "instead, Lemke's method on an M and a q that are typed there"},
        {"gallery", "", "every shipped scene, as a folder of pages: -o DIRECTORY"},
        commands::set_option,
        commands::output_option}},
      run_play};
}

} // namespace lcpush::cli
