#include "design/design_space.hpp"

#include "design/settings.hpp"
#include "lcpush/desktop/design.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "scenes/mirror.hpp"
#include "scenes/scene_units.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Ends = std::vector<std::pair<Rational, Rational>>;

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
  throw InputError("choice " + quoted(text) + ": " + what);
}

Rational typed(double value) { return *Rational::parse(shown(value)); }

/// A friction, a grip or an actuator's force, and no component of one.
bool is_strength(const Parameter& parameter) {
  const auto& place = parameter.places.front();
  return place.key == "friction" || place.key == "grip_force" ||
         (place.key == "force" && place.indices.empty());
}

/// All frictions and grips, and the mass.
std::vector<std::string> usual_tolerances(const VariedScene& scene) {
  std::vector<std::string> paths;
  for (const std::string& path : scene.paths()) {
    const Parameter parameter = scene.find(path);
    if (parameter.owner != "*" && parameter.kind == Parameter::Kind::number &&
        (is_strength(parameter) || parameter.places.front().key == "mass"))
      paths.push_back(path);
  }
  return paths;
}

} // namespace

DesignSpace::DesignSpace(const VariedScene& scene, const std::vector<std::string>& choices,
                         const std::vector<std::string>& tolerances)
    : scene_(scene) {
  for (const std::string& text : choices) {
    choices_.push_back(read_choice(text));
    for (std::size_t k = 0; k + 1 < choices_.size(); ++k)
      for (const Parameter& mine : choices_.back().parameters)
        for (const Parameter& other : choices_[k].parameters)
          if (mine.path == other.path &&
              (choices_[k].slopes.empty() || choices_.back().slopes.empty()))
            refuse(text, quoted(mine.path) + " is chosen twice");
  }
  if (choices.size() > design_settings.most)
    refuse(choices.back(),
           "at most " + std::to_string(design_settings.most) + " numbers are chosen at once");
  const bool has_none = tolerances.empty() && scene.ranges().empty();
  const VariedScene ranges =
      with_tolerances(scene, has_none ? usual_tolerances(scene) : tolerances);
  const Box box(ranges);
  for (const BoxSide& side : box.sides())
    for (const Parameter& parameter : side.parameters) {
      const double off = (side.high - side.middle).value(), middle = std::abs(side.middle.value());
      uncertain_.push_back(
          {parameter.path, side.is_relative, side.is_relative ? off / middle : off});
    }
  for (const Choice& choice : choices_)
    for (const Parameter& parameter : choice.parameters)
      if (!choice.slopes.empty() && uncertain(parameter.path) != nullptr)
        refuse(choice.path, "it moves " + quoted(parameter.path) +
                                ", which has a tolerance; give one to the shift instead");
}

DesignSpace::Choice DesignSpace::read_choice(const std::string& text) const {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::vector<std::string_view> ends =
      split_at(std::string_view(text).substr(std::min(equals + 1, text.size())), ':');
  if (ends.size() != 2) refuse(text, "write PATH=FROM:TO, such as wall.friction=0.2:0.6");
  Choice choice{std::string(trimmed(std::string_view(text).substr(0, equals))), 0, 0, 0, {}, {}};
  const std::size_t dot = choice.path.rfind('.');
  const bool is_width = dot != std::string::npos && choice.path.substr(dot) == ".width";
  const bool is_line = find_line(choice.path, choice);
  if (is_width && !is_line) find_length(text, choice.path);
  const Parameter parameter = is_line ? choice.parameters.front() : scene_.find(choice.path);
  const auto typed = typed_ends(ends[0], ends[1], parameter.unit);
  for (const SiNumber& number : {typed.first, typed.second})
    if (!number.refusal.empty()) refuse(text, number.refusal);
  choice.from = typed.first.value();
  choice.to = typed.second.value();
  if (!(choice.from < choice.to))
    refuse(text, "there is nothing to choose between " + shown(choice.from) + " and " +
                     shown(choice.to) + "; the smaller number comes first");
  if (is_width && !(choice.from > 0)) refuse(text, "a width is larger than 0");
  if (is_line) return choice;
  if (parameter.whole || parameter.kind == Parameter::Kind::tangent_turn)
    refuse(text, "it is no place, size or strength: try each value with --set");
  choice.given = parameter.value;
  choice.parameters = {parameter};
  if (parameter.kind == Parameter::Kind::number) choice.parameters = scene_.singles(choice.path);
  return choice;
}

/// "wall.width" of a body that has a length, or none that can be chosen.
void DesignSpace::find_length(const std::string& text, std::string& path) const {
  const std::string owner = path.substr(0, path.rfind('.'));
  const std::vector<std::string> paths = scene_.paths();
  const auto begins = [&](const std::string& one) { return one.rfind(owner + ".", 0) == 0; };
  if (std::find(paths.begin(), paths.end(), owner + ".length") != paths.end())
    path = owner + ".length";
  else if (std::any_of(paths.begin(), paths.end(), begins))
    refuse(text, owner +
                     " is as wide as its face, or has no width: give it \"length\" in the scene "
                     "to choose that");
}

/// "wall.width", or "wall.center[1]", of a line that is given by its ends.
bool DesignSpace::find_line(const std::string& path, Choice& choice) const {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return false;
  const std::string owner = path.substr(0, dot), key = path.substr(dot + 1);
  const std::vector<std::string> paths = scene_.paths();
  const auto is_known = [&](const std::string& one) {
    return std::find(paths.begin(), paths.end(), one) != paths.end();
  };
  const bool is_center = key == "center[0]" || key == "center[1]" || key == "center[2]";
  if (is_known(path) || !is_known(owner + ".ends[1][2]") || !(is_center || key == "width"))
    return false;
  std::vector<Parameter> ends;
  for (const char* end : {"[0]", "[1]"})
    for (const char* axis : {"[0]", "[1]", "[2]"})
      ends.push_back(scene_.singles(owner + ".ends" + end + axis).front());
  Vector3<double> along;
  for (std::size_t i = 0; i < 3; ++i)
    along[static_cast<Index>(i)] = ends[i + 3].value - ends[i].value;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = along[static_cast<Index>(i)] / along.norm() / 2;
    const bool is_it = is_center && key[7] == "012"[i];
    if (is_it) choice.given = (ends[i].value + ends[i + 3].value) / 2;
    if (is_center ? !is_it : share == 0) continue;
    choice.parameters.insert(choice.parameters.end(), {ends[i], ends[i + 3]});
    choice.slopes.insert(choice.slopes.end(), {is_it ? 1 : -share, is_it ? 1 : share});
  }
  if (!is_center) choice.given = along.norm();
  return true;
}

Values DesignSpace::given() const {
  Values values;
  for (const Choice& choice : choices_) values.push_back(choice.given);
  return values;
}

bool DesignSpace::asks_ranges() const {
  return std::any_of(uncertain_.begin(), uncertain_.end(),
                     [](const Uncertain& one) { return one.is_relative && one.off > 0; });
}

const DesignSpace::Uncertain* DesignSpace::uncertain(const std::string& path) const {
  const auto found = std::find_if(uncertain_.begin(), uncertain_.end(),
                                  [&](const Uncertain& one) { return one.path == path; });
  return found == uncertain_.end() ? nullptr : &*found;
}

VariedScene DesignSpace::scene_at(const Values& values) const {
  VariedScene scene = scene_;
  for (std::size_t j = 0; j < choices_.size(); ++j) {
    const Choice& choice = choices_[j];
    if (values[j] == choice.given) continue;
    // A pattern at once: jaws have one grip force.
    if (choice.slopes.empty()) {
      scene = scene.with({scene.find(choice.path)}, {values[j]});
      continue;
    }
    // Both ends of a line at once: one alone may come to lie on the other.
    std::vector<Parameter> ends;
    Values places;
    for (std::size_t i = 0; i < choice.slopes.size(); ++i) {
      ends.push_back(scene.find(choice.parameters[i].path));
      places.push_back(ends.back().value + choice.slopes[i] * (values[j] - choice.given));
    }
    scene = scene.with(ends, places);
  }
  return scene;
}

VariedScene DesignSpace::box_at(const Values& values, const std::optional<double>& margin) const {
  const VariedScene scene = scene_at(values);
  std::vector<Parameter> numbers;
  Ends ends;
  for (const Uncertain& one : uncertain_) {
    numbers.push_back(scene.find(one.path));
    const Rational middle = *Rational::parse(numbers.back().typed);
    const Rational off =
        one.is_relative ? typed(margin.value_or(one.off)) * abs(middle) : typed(one.off);
    ends.emplace_back(middle - off, middle + off);
  }
  return scene.with_ranges(numbers, ends);
}

VariedScene DesignSpace::scene_over(const std::vector<bool>& choices, const Values& at) const {
  const VariedScene scene = box_at(at);
  std::vector<Parameter> numbers;
  Ends ends;
  for (std::size_t j = 0; j < choices_.size(); ++j) {
    const Choice& choice = choices_[j];
    if (!choices[j] || !choice.slopes.empty()) continue;
    for (const Parameter& parameter : choice.parameters) {
      const Uncertain* const off = uncertain(parameter.path);
      const Rational more = off != nullptr && !off->is_relative ? typed(off->off) : Rational(0);
      numbers.push_back(parameter);
      ends.emplace_back(typed(choice.from) - more, typed(choice.to) + more);
    }
  }
  return scene.with_ranges(numbers, ends);
}

std::vector<BoxSide> DesignSpace::sides_over(const std::vector<bool>& choices,
                                             const Values& at) const {
  std::vector<BoxSide> sides;
  for (std::size_t j = 0; j < choices_.size(); ++j) {
    const Choice& choice = choices_[j];
    if (!choices[j] || choice.slopes.empty()) continue;
    BoxSide side{{}, typed(choice.from), {}, typed(choice.to), "ends", false, Role::pusher, {}, {}};
    side.middle = (side.low + side.high) / Rational(2);
    side.typed = typed(at[j]);
    for (std::size_t i = 0; i < choice.slopes.size(); ++i) {
      side.parameters.push_back(scene_at(at).find(choice.parameters[i].path));
      side.slopes.push_back(typed(choice.slopes[i]));
    }
    sides.push_back(std::move(side));
  }
  return sides;
}

std::optional<std::pair<std::string, double>>
leaves_plane(const VariedScene& scene, const std::vector<std::string>& choices,
             const std::vector<std::string>& tolerances) {
  const DesignSpace space(scene, choices, tolerances);
  for (std::size_t j = 0; j < space.choices().size(); ++j) {
    const DesignSpace::Choice& choice = space.choices()[j];
    if (is_strength(choice.parameters.front())) continue;
    for (const double end : {choice.from, choice.to}) {
      Values at = space.given();
      at[j] = end;
      if (!is_plane(space.scene_at(at).as_given())) return std::pair(choice.path, end);
    }
  }
  return std::nullopt;
}

} // namespace lcpush::desktop
