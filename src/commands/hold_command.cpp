// hold: how well the grasp holds before any push.
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "formats/read_number.hpp"
#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/hold.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace lcpush::commands {
namespace {

/// "force 1 0 0".
HoldDirection read_direction(const Values& values, const std::string& text) {
  const std::vector<std::string> kinds(std::begin(disturbance_texts), std::end(disturbance_texts));
  std::vector<std::string> words;
  for (const std::string_view word : split_at(text, ' '))
    if (!word.empty()) words.emplace_back(word);
  if (words.size() != 4)
    values.refuse("direction", values.label("direction") +
                                   " takes what and where to, such as \"force 1 0 0\", not " +
                                   quoted(text));
  const std::string& kind = values.one_of("direction", words[0], kinds);
  HoldDirection direction{
      static_cast<Disturbance>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin()),
      Vector3<double>::Zero()};
  for (Index k = 0; k < 3; ++k) {
    const NumberText number = read_finite_number(words[static_cast<std::size_t>(k) + 1]);
    if (number.error) values.refuse("direction", values.label("direction") + ": " + *number.error);
    direction.direction[k] = number.value;
  }
  const double length = direction.direction.norm();
  if (!(length > 0))
    values.refuse("direction", values.label("direction") + " " + quoted(text) +
                                   " is no direction: all three numbers are 0");
  direction.direction /= length;
  return direction;
}

/// What the corner of a box that falls would take.
std::string corner_answer(const BoxAnswer& box, const PushOptions& options) {
  if (box.verdict != BoxVerdict::may_slip || box.corner_scene.empty()) return "";
  const SceneFile corner = parse_scene(box.corner_scene, "corner");
  HoldQuestion question;
  question.grip_alone = true;
  return "\nAt that corner: " + hold_answer(corner, find_hold(corner, question, options)) + "\n";
}

Result run_hold(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const VariedScene scene = values.scene_with_ranges(Needs::scene);
  SceneFile file = scene.as_given();
  values.refuse_unknowns(file, limits::unknowns_holding, "holding is studied");
  HoldQuestion question;
  if (const auto at = values.numbers("at", {"m", "m", "m"}, "x y z (m, in the scene's frame)"))
    question.at = Vector3<double>((*at)[0], (*at)[1], (*at)[2]);
  for (const std::string& text : values.texts("direction"))
    question.directions.push_back(read_direction(values, text));
  question.with_sections = format == "svg";
  question.presses = values.has("press");
  values.refuse_no_press(file);
  if (question.presses && !scene.ranges().empty())
    values.refuse("press", values.label("press") + " goes with numbers, not with ranges");
  PushOptions options;
  options.watcher = options.searching = &listener;
  if (!scene.ranges().empty() && format != "svg") {
    file.lines.ranges = 0; // they are answered
    const BoxAnswer box = judge_hold(scene);
    return {box.verdict == BoxVerdict::always,
            format == "json"   ? hold_json(file, find_hold(file, question, options), &box)
            : format == "toml" ? values.corner_scene(box)
                               : box_text(file, box, "The grasp", "holds", "may give way") +
                                     corner_answer(box, options)};
  }
  if (format == "toml") (void)values.corner_scene({});
  const HoldStudy study = find_hold(file, question, options);
  return {study.held.value_or(false), format == "json"  ? hold_json(file, study)
                                      : format == "svg" ? hold_svg(file, study)
                                                        : hold_text(file, study)};
}

} // namespace

Command hold_command() {
  return {
      "hold",
      "SCENE.toml [OPTIONS]",
      "how hard to grip, and what makes it slip",
      "The least grip that holds the object's load, and what the grasp bears beyond it: the\n"
      "largest force, moment and acceleration of the hand along each axis and in the direction\n"
      "in which it is weakest, what gives way first there, a mass that may be added, how far\n"
      "gravity may turn. Pushers are left out, or press (--press). Friction and pressure are those "
      "of the scene.\n"
      "With --tolerance, or where its numbers are ranges, it says whether the load is held for\n"
      "every value.\n\n"
      "Examples:\n"
      "  lcpush hold fixtures/scenes/straight_slide.toml --tolerance \"*.friction=10%\"\n"
      "  lcpush hold fixtures/scenes/straight_slide.toml\n"
      "  lcpush hold docs/guide/off_centre.toml --direction \"moment 0 1 0\"\n",
      with_scene_options(
          {{"at", "\"X Y Z\"", "where forces act (m, the scene's frame); else the centre of mass"},
           {"direction", "\"WHAT X Y Z\"",
            "also this one: force, moment or acceleration, and where to; may be repeated", true},
           press_option,
           pressure_option,
           facets_option,
           tolerance_option,
           format_option("text (default), json, svg or toml (a scene: the corner of a box at which "
                         "it falls); --json for short")}),
      run_hold,
      {"text", "json", "svg", "toml"}};
}

} // namespace lcpush::commands
