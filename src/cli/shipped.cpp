// lcpush example and lcpush new: scenes that the tool carries with it, shipped ones and commented
// ones to start from.
#include <filesystem>
#include <iostream>

#include <unistd.h>

#include "cli/shell.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "scenes/new_scene.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {
namespace {

/// What nothing pushes is asked how well it holds.
void tell_next(const std::string& path, const std::string& scene) {
  const bool is_pushed = desktop::parse_scene(scene, path).bodies.back().role == Role::pusher;
  tell("Wrote " + path + "; next: lcpush " + (is_pushed ? "solve " : "hold ") + path);
}

int write_new(const Arguments& arguments, const std::string& text) {
  write_output(arguments, text);
  if (const auto path = arguments.text("output")) tell_next(*path, text);
  return 0;
}

/// Writes the scene called `name`. Throws a UsageError with `refusal` if there is none.
int write_shipped(const Arguments& arguments, const std::vector<ShippedScene>& scenes,
                  const std::string& name, const std::string& refusal) {
  const std::string* const text = scene_called(scenes, name);
  if (text == nullptr) throw UsageError(refusal);
  return write_new(arguments, *text);
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
    write_output(arguments, desktop::wrapped(list_of(scenes)));
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

struct Question {
  const char *option, *words;
  std::string NewScene::*value;
};
constexpr Question questions[] = {
    {"push", "What does the push: slide, pivot, roll (a cylinder) or none?", &NewScene::push},
    {"size", "How large (a box: x, y, z; a cylinder: diameter x length)?", &NewScene::size},
    {"mass", "How heavy?", &NewScene::mass},
    {"pads", "How large is a pad of the fingers (one number: round)?", &NewScene::pads},
    {"friction", "What is the friction of the pads?", &NewScene::friction},
    {"grip", "How hard does each finger grip?", &NewScene::grip},
};

/// On a terminal: the line that answers, `usual` if it is empty.
std::string asked(const std::string& words, const std::string& usual) {
  std::cerr << words << " [" << usual << "] " << std::flush;
  std::string line;
  if (!std::getline(std::cin, line)) throw UsageError("the answers end before the questions");
  line = trimmed(line);
  return line.empty() ? usual : line;
}

/// A line each; a bad one is asked for again.
NewScene asked_scene() {
  NewScene scene;
  const auto ask = [&scene](const std::string& words, std::string NewScene::*value) {
    const std::string usual = usual_scene(scene).*value;
    for (bool is_good = false; !is_good;) {
      scene.*value = asked(words, usual);
      try {
        is_good = !new_scene(scene).empty();
      } catch (const InputError& error) {
        std::string why = error.what();
        for (std::size_t at; (at = why.find("--")) != std::string::npos;) why.erase(at, 2);
        tell(why);
        scene.*value = usual;
      }
    }
  };
  ask("Box or cylinder?", &NewScene::object);
  for (const Question& question : questions) ask(question.words, question.value);
  return scene;
}

/// Where what was asked for is to be written; empty: it was said before.
std::string asked_file(const std::string& object) {
  std::error_code ignored;
  for (;;) {
    const std::string path = asked("Which file?", object + ".toml");
    if (!std::filesystem::exists(path, ignored)) return path;
    tell(desktop::quoted(path) + " exists already; name another");
  }
}

int run_new(const Arguments& arguments) {
  std::error_code ignored;
  const std::string into = arguments.text("output").value_or("");
  if (std::filesystem::is_regular_file(into, ignored))
    throw UsageError(desktop::quoted(into) + " exists already; name another file, or remove it");
  NewScene scene;
  bool is_own = false;
  for (const Question& question : questions) {
    if (!arguments.has(question.option)) continue;
    scene.*question.value = *arguments.text(question.option);
    if ((scene.*question.value).empty())
      throw UsageError(std::string("--") + question.option +
                       " is empty; leave it out for what is usual");
    is_own |= std::string(question.option) != "push";
  }
  if (!arguments.files().empty()) scene.object = arguments.files()[0];
  const bool asks = arguments.files().empty() && !is_own && !arguments.has("push") &&
                    isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
  if (arguments.files().empty() && !asks) throw UsageError("say what is gripped: box or cylinder");
  try {
    if (asks) scene = asked_scene();
    const std::string text = new_scene(scene);
    if (asks && into.empty()) {
      const std::string path = asked_file(scene.object);
      write_file(path, text);
      tell_next(path, text);
      return 0;
    }
    return write_new(arguments, text);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
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
           "box|cylinder [OPTIONS]",
           "a commented scene to start from",
           "Writes a scene that solves at once: a hand, an object and a push, of your own object\n"
           "with the options. On a terminal `lcpush new` alone asks.\n\n"
           "Example:\n  lcpush new box --push pivot -o mine.toml\n  lcpush solve mine.toml\n"
           "  lcpush new box --size \"80 mm x 40 mm x 20 mm\" --mass \"120 g\" \\\n"
           "    --pads \"20 mm x 10 mm\" -o block.toml\n",
           {{"push", "MOTION", "slide (default), pivot, roll (a cylinder) or none"},
            {"size", "SIZE", "\"80 mm x 40 mm x 20 mm\"; of a cylinder diameter x length"},
            {"mass", "MASS", "\"120 g\" (of your size: that of aluminium)"},
            {"pads", "SIZE", "of the fingertips: \"20 mm x 10 mm\", or round \"8 mm\""},
            {"grip", "FORCE",
             "\"20 N\", of each finger (four times what holds the weight or more; to roll, less)"},
            {"friction", "NUMBER", "of the fingertips (0.5)"},
            commands::output_option}},
          run_new};
}

} // namespace lcpush::cli
