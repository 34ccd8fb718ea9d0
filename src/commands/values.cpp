#include "commands/values.hpp"

#include "commands/listener.hpp"

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/hold.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/varied_scene.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"
#include "scenes/mirror.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

namespace lcpush::commands {

void Values::refuse_value(const std::string& option, const std::string& word,
                          const std::string& rule, const std::vector<std::string>& known) const {
  refuse(option, label(option) + " is " + rule + ", not " + desktop::quoted(word) +
                     suggestion(word, known));
}

const std::string& Values::one_of(const std::string& option, const std::string& word,
                                  const std::vector<std::string>& known) const {
  if (std::find(known.begin(), known.end(), word) == known.end())
    refuse_value(option, word, listed(known, "or"), known);
  return word;
}

std::optional<Index> Values::whole(const std::string& option, const Range& range) const {
  const std::optional<Written> given = written(option);
  if (!given) return std::nullopt;
  const double number = given->value;
  if (number != std::floor(number) || number < static_cast<double>(range.smallest) ||
      !(number <= static_cast<double>(range.largest)) || (range.even && std::fmod(number, 2) != 0))
    refuse_value(
        option, given->text,
        (range.even ? "an even number from " : "a whole number from ") +
            std::to_string(range.smallest) +
            (range.largest < Range{0}.largest ? " to " + std::to_string(range.largest) : " on"));
  return static_cast<Index>(std::min(number, 1e18)); // what is larger is as good as no limit
}

std::optional<double> Values::number(const std::string& option, double end, const std::string& hint,
                                     const std::string& unit) const {
  const std::optional<Written> given = written(option, unit);
  if (!given) return std::nullopt;
  if (!(given->value > 0) || !(given->value < end))
    refuse_value(option, given->text, "a number between 0 and " + shown(end) + hint);
  return given->value;
}

Solver Values::solver() const {
  const std::string name = text("solver").value_or("lemke");
  if (name == "pgs") return Solver::gauss_seidel; // as many call it
  one_of("solver", name, {"lemke", "gauss-seidel", "hybrid"});
  return name == "lemke" ? Solver::lemke : name == "hybrid" ? Solver::hybrid : Solver::gauss_seidel;
}

std::string Values::format_with_history(Solver solver) const {
  for (const char* option : {"sweeps", "relaxation", "history"})
    if (solver == Solver::lemke && has(option))
      refuse(option, label(option) + " is about sweeps: it goes with " + label("solver") +
                         " gauss-seidel or hybrid");
  return has("history") ? format({"text", "json", "csv"}) : format();
}

void Values::refuse_unknowns(const SceneFile& file, Index most, const std::string& what) const {
  const Index unknowns = size_of(file.view()).unknowns();
  if (unknowns > most)
    throw InputError(scene_name() + ": the scene has " + std::to_string(unknowns) +
                     " unknowns, more than the " + std::to_string(most) + " whose " + what +
                     "; use fewer points or facets");
}

void Values::refuse_size(const SceneFile& file, Needs needs) const {
  if (needs == Needs::matrix)
    refuse_unknowns(file, limits::unknowns_matrix, "matrix fits into 1 GB");
  else
    refuse_unknowns(file, limits::unknowns_held, "solution fits into 1 GB");
}

void Values::refuse_still(const SceneFile& file) const {
  if (push_size(file.view()) > 0) return;
  for (const Drive<double>& drive : file.drives)
    if (file.body(drive.body).role == Role::pusher)
      refuse("scene", file.body_name(drive.body) +
                          " presses with a given force, and no body of the scene is moved: give it "
                          "a velocity instead of its normal_force, and the force that it takes is "
                          "the answer");
  refuse("scene", "no body of the scene moves: give a pusher an acceleration");
}

Document Values::scene_document(std::size_t k) const {
  Document scene = given_scene(k);
  scene.text = with_values(std::move(scene.text), scene.name, label("set"), texts("set"));
  return scene;
}

SceneFile Values::scene(Needs needs, Strokes strokes) const {
  const Document document = scene_document();
  SceneFile file = parse_scene(document.text, document.name, strokes);
  inspect(file);
  refuse_size(file, needs);
  return file;
}

void Values::take_pyramids(SceneFile& file, Listener& listener) const {
  if (file.is_round)
    listener.announce("Pyramids of " + std::to_string(file.facets) +
                      " facets stand for round friction here.");
  file.is_round = false;
}

bool Values::lies_in_plane(const SceneFile& file, Listener& listener) const {
  // Of pyramids the plane takes other ones; a box may leave the image.
  if (!file.is_round || has("tolerance") || file.lines.ranges > 0 || !is_plane(file)) return false;
  listener.announce("The scene is its own image across z: taken as planar = true.");
  return true;
}

VariedScene Values::varied_scene(Needs needs, std::size_t k) const {
  return inspected(read_scene(k), needs);
}

VariedScene Values::scene_with_ranges(Needs needs) const {
  const VariedScene scene = varied_scene(needs);
  refuse_later_in(scene.as_given(), "tolerance");
  return with_tolerances(scene, texts("tolerance"));
}

VariedScene Values::scene_of_middle(Needs needs) const {
  const VariedScene scene = read_scene(0);
  refuse_later_in(scene.as_given(), "tolerance");
  return inspected(with_tolerances(scene, texts("tolerance")), needs);
}

VariedScene Values::read_scene(std::size_t k) const {
  const Document document = scene_document(k);
  VariedScene scene = VariedScene::parse(document.text, document.name);
  if (const auto law = text("pressure"))
    scene.set_pressure(one_of("pressure", *law, pressure_names()));
  if (text("facets") == "round")
    scene.set_facets(std::nullopt);
  else if (const auto facets = whole("facets", {4, 256, true}))
    scene.set_facets(facets);
  return scene;
}

VariedScene Values::inspected(VariedScene scene, Needs needs) const {
  const SceneFile file = scene.as_given();
  refuse_size(file, needs);
  inspect(file);
  return scene;
}

std::string Values::corner_scene(const BoxAnswer& answer) const {
  if (answer.box.empty())
    refuse("format", label("format") + " toml shows a corner of a box: give " + usage("tolerance"));
  if (answer.corner_scene.empty())
    throw InputError(scene_name() + ": no corner of the box is known to fail, so there is none to "
                                    "show");
  return answer.corner_scene;
}

void Values::refuse_later(const SceneFile& file, const std::string& option,
                          const std::string& name) const {
  if (std::find(file.later.begin(), file.later.end(), name) != file.later.end())
    refuse(option, name + " is not there at the start, which this is about: it has a `from`. "
                          "`lcpush move` shows what it does then");
}

void Values::refuse_later_in(const SceneFile& file, const std::string& option) const {
  for (const std::string& path : texts(option))
    refuse_later(file, option, path.substr(0, path.find('.')));
}

void Values::refuse_no_press(const SceneFile& file) const {
  if (has("press") && presses_of(file).empty())
    refuse("press", label("press") + " counts what pushers press with, and no pusher of this scene "
                                     "has a normal_force");
}

Index Values::pusher(const SceneFile& file) const {
  std::vector<std::string> names;
  Index pusher = -1;
  const std::optional<std::string> wanted = text("pusher");
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].role != Role::pusher) continue;
    names.push_back(file.body_names[b]);
    if (!wanted || *wanted == file.body_names[b]) pusher = static_cast<Index>(b);
  }
  if (names.empty())
    refuse("scene", "the scene has no [[pusher]]: nothing can break the grasp; how well it holds "
                    "says `lcpush hold`");
  if (!wanted && names.size() > 1)
    refuse("pusher", "the scene has several pushers: say which with " + label("pusher") + " " +
                         listed(names, "or"));
  if (wanted) refuse_later(file, "pusher", *wanted);
  if (pusher < 0)
    refuse("pusher", "no pusher is named " + desktop::quoted(*wanted) + suggestion(*wanted, names));
  return pusher;
}

VariedScene Values::with_only_pusher(const VariedScene& scene, Listener& listener) const {
  const SceneFile file = scene.as_given();
  const std::string& name = file.body_name(pusher(file));
  std::vector<std::string> others;
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    if (file.bodies[b].role == Role::pusher && file.body_names[b] != name)
      others.push_back(file.body_names[b]);
  if (others.empty()) return scene;
  listener.announce(name + " alone pushes; " + listed(others, "and") +
                    (others.size() > 1 ? " are" : " is") + " left out.");
  return scene.with_only_pusher(name);
}

} // namespace lcpush::commands
