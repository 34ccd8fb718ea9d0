// lcpush example and lcpush new: scenes that the tool carries with it, shipped ones and commented
// ones to start from.
#include <algorithm>
#include <filesystem>

#include "cli/shell.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

/// Writes the scene called `name`. Throws a UsageError with `refusal` if there is none.
int write_shipped(const Arguments& arguments, const std::vector<ShippedScene>& scenes,
                  const std::string& name, const std::string& refusal) {
  const std::string* const text = scene_called(scenes, name);
  if (text == nullptr) throw UsageError(refusal);
  write_output(arguments, *text);
  if (const auto path = arguments.text("output"))
    tell("Wrote " + *path + "; next: lcpush solve " + *path);
  return 0;
}

/// What the scene calls itself.
std::string title_of(const std::string& scene) {
  const std::string key = "title = \"";
  const std::size_t begin = scene.find(key) + key.size();
  return scene.substr(begin, scene.find('"', begin) - begin);
}

std::string list_of(const std::vector<ShippedScene>& scenes) {
  std::string text = "Shipped scenes; `lcpush example NAME` prints one.\n\n";
  for (const ShippedScene& scene : scenes) {
    std::string name = "  " + scene.name;
    name.resize(28, ' ');
    text += name + title_of(scene.text) + "\n";
  }
  return text;
}

int run_example(const Arguments& arguments) {
  const std::vector<ShippedScene> scenes = example_scenes();
  if (arguments.files().empty()) {
    write_output(arguments, list_of(scenes));
    return 0;
  }
  // as a file's name too, from wherever its sources are
  const std::string name = std::filesystem::path(arguments.files()[0]).stem().string();
  std::vector<std::string> names;
  for (const ShippedScene& scene : scenes) names.push_back(scene.name);
  return write_shipped(arguments, scenes, name,
                       "no shipped scene is called " + desktop::quoted(name) +
                           suggestion(name, names) + "; `lcpush example` lists them");
}

int run_new(const Arguments& arguments) {
  if (arguments.files().empty()) throw UsageError("say what is gripped: box or cylinder");
  const std::string object = arguments.files()[0];
  const std::vector<std::string> objects = {"box", "cylinder"};
  if (std::find(objects.begin(), objects.end(), object) == objects.end())
    throw UsageError("the object is " + listed(objects, "or") + ", not " + desktop::quoted(object) +
                     suggestion(object, objects));
  const std::string push = arguments.one_of("push", arguments.text("push").value_or("slide"),
                                            {"slide", "pivot", "roll"});
  return write_shipped(arguments, scene_templates(), object + "_" + push,
                       "a " + object + " does not " + push + "; try: lcpush new cylinder --push " +
                           push);
}

} // namespace

ShellCommand example_command() {
  return {{"example",
           "[NAME] [-o FILE]",
           "lists the shipped scenes, or prints one",
           "Example:\n  lcpush example pivot -o pivot.toml\n  lcpush solve pivot.toml\n",
           {commands::output_option}},
          run_example};
}

ShellCommand new_command() {
  return {{"new",
           "box|cylinder [--push slide|pivot|roll] [-o FILE]",
           "a commented scene to start from",
           "Writes a scene that solves at once: a hand, an object and a push, each key explained.\n"
           "Change the numbers to yours.\n\n"
           "Example:\n  lcpush new box --push pivot -o mine.toml\n  lcpush solve mine.toml\n",
           {{"push", "MOTION", "slide (default), pivot or roll (a cylinder)"},
            commands::output_option}},
          run_new};
}

} // namespace lcpush::cli
