// lcpush example: the shipped scenes, also from where only the tool is installed.
#include "cli/commands.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

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
  const std::string name = arguments.files()[0];
  const std::string* const text = scene_called(scenes, name);
  if (text == nullptr) {
    std::vector<std::string> names;
    for (const ShippedScene& scene : scenes) names.push_back(scene.name);
    throw UsageError("no shipped scene is called " + desktop::quoted(name) +
                     suggestion(name, names) + "; `lcpush example` lists them");
  }
  write_output(arguments, *text);
  return 0;
}

} // namespace

Command example_command() {
  return {"example",
          "[NAME] [-o FILE]",
          "lists the shipped scenes, or prints one",
          "Example:\n  lcpush example pivot -o pivot.toml\n  lcpush solve pivot.toml\n",
          {output_option},
          1,
          run_example};
}

} // namespace lcpush::cli
