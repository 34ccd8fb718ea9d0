// lcpush new: a commented scene to start from.
#include <algorithm>

#include "cli/commands.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

int run_new(const Arguments& arguments) {
  const std::vector<std::string> objects = {"box", "cylinder"}, pushes = {"slide", "pivot", "roll"};
  if (arguments.files().empty()) throw UsageError("say what is gripped: box or cylinder");
  const std::string object = arguments.files()[0];
  const std::string push = arguments.value("--push").value_or("slide");
  const auto refuse_unless_one_of = [](const std::vector<std::string>& known,
                                       const std::string& word, const std::string& what) {
    if (std::find(known.begin(), known.end(), word) == known.end())
      refuse_value(what, word, listed(known, "or"), known);
  };
  refuse_unless_one_of(objects, object, "the object");
  refuse_unless_one_of(pushes, push, "--push");
  const std::vector<ShippedScene> scenes = scene_templates();
  const std::string* const text = scene_called(scenes, object + "_" + push);
  if (text == nullptr)
    throw UsageError("a " + object + " does not " + push + "; try: lcpush new cylinder --push " +
                     push);
  write_output(arguments, *text);
  return 0;
}

} // namespace

Command new_command() {
  return {"new",
          "box|cylinder [--push slide|pivot|roll] [-o FILE]",
          "a commented scene to start from",
          "Writes a scene that solves at once: a hand, an object and a push, each key explained.\n"
          "Change the numbers to yours.\n\n"
          "Example:\n  lcpush new box --push pivot -o mine.toml\n  lcpush solve mine.toml\n",
          {{"--push", "MOTION", "slide (default), pivot or roll (a cylinder)"}, output_option},
          1,
          run_new};
}

} // namespace lcpush::cli
