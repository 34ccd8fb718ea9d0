#include "boxes/box.hpp"

#include "boxes/settings.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "scenes/scene_units.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <array>

namespace lcpush::desktop {
namespace {

/// Places and sizes, of which no share can be off.
constexpr std::array places = {"shift",
                               "center",
                               "ends",
                               "points",
                               "at",
                               "center_of_mass",
                               "box",
                               "sphere_radius",
                               "radius",
                               "size",
                               "length",
                               "cylinder_radius",
                               "cylinder_length"};

std::string key_of(const Parameter& parameter) { return parameter.places.front().key; }

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
  throw InputError("tolerance " + quoted(text) + ": " + what);
}

Rational read(const std::string& text, const SiNumber& number) {
  const std::optional<Rational> value = Rational::parse(number.digits);
  if (!value) refuse(text, number.refusal.empty() ? "too long to be read exactly" : number.refusal);
  return *value;
}

/// The numbers that are given ranges, the last one that is given to each.
struct Given {
  std::vector<Parameter> numbers;
  std::vector<std::pair<Rational, Rational>> ends;
  std::vector<bool> is_fixed; ///< to one value, from which no margin moves it
};

/// "PATH", "PATH=R%" or "PATH=FROM:TO".
void read_tolerance(const VariedScene& scene, const std::string& text, Given& given) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string path(trimmed(std::string_view(text).substr(0, equals)));
  const std::string_view size =
      trimmed(std::string_view(text).substr(std::min(equals + 1, text.size())));
  const std::vector<std::string_view> ends = split_at(size, ':');
  const bool is_share = !size.empty() && size.back() == '%', is_asked = equals == text.size();
  for (const Parameter& number : scene.singles(path)) {
    if (number.kind != Parameter::Kind::number || number.whole)
      refuse(text, quoted(path) + (number.whole ? " counts something" : " is a turn") +
                       ", which has no tolerance");
    if (!is_asked && !is_share && ends.size() != 2)
      refuse(text, "write PATH=10% or PATH=FROM:TO, such as edge.friction=0.3:0.5");
    const std::optional<Rational> typed = Rational::parse(number.typed);
    if (!typed) refuse(text, quoted(number.path) + " is too long to be read exactly");
    Rational low = *typed, high = *typed;
    if (is_share) {
      const Rational off = abs(*typed) *
                           read(text, typed_number(size.substr(0, size.size() - 1), "")) /
                           Rational(100);
      low = *typed - off;
      high = *typed + off;
    } else if (!is_asked) {
      const auto range = typed_ends(ends[0], ends[1], number.unit);
      low = read(text, range.first);
      high = read(text, range.second);
    }
    if (high < low)
      refuse(text, is_share ? "a tolerance is not negative"
                            : "the range goes backwards; the smaller number comes first");
    const auto known = std::find_if(given.numbers.begin(), given.numbers.end(),
                                    [&](const Parameter& one) { return one.path == number.path; });
    if (is_asked && (known != given.numbers.end() || !number.ends.empty())) continue; // it has one
    if (known != given.numbers.end()) {
      const auto at = static_cast<std::size_t>(known - given.numbers.begin());
      given.ends[at] = {low, high};
      given.is_fixed[at] = low == high;
      continue;
    }
    given.numbers.push_back(number);
    given.ends.emplace_back(low, high);
    given.is_fixed.push_back(!is_asked && low == high);
  }
}

} // namespace

VariedScene with_tolerances(VariedScene scene, const std::vector<std::string>& tolerances) {
  Given given;
  for (const std::string& text : tolerances) read_tolerance(scene, text, given);
  if (given.numbers.empty()) return scene;
  scene = scene.with_ranges(given.numbers, given.ends);
  for (std::size_t k = 0; k < given.numbers.size(); ++k)
    if (given.is_fixed[k]) scene = scene.with({given.numbers[k]}, {given.ends[k].first.value()});
  if (scene.ranges().empty()) refuse(tolerances.front(), "one value is no range");
  return scene;
}

Rational BoxSide::low_at(const Rational& margin) const {
  return is_relative ? middle - abs(middle) * margin : low;
}
Rational BoxSide::high_at(const Rational& margin) const {
  return is_relative ? middle + abs(middle) * margin : high;
}

bool is_load(const BoxSide& side) {
  constexpr std::array loads = {"mass", "gravity", "force", "moment"};
  return side.is_one_of(loads);
}

Box::Box(const VariedScene& scene, const std::vector<BoxSide>& more)
    : scene_(scene), parameters_(scene.ranges()) {
  const SceneFile file = scene.as_given();
  const auto shares_jaws = [&](const Parameter& parameter) {
    return key_of(parameter) == "grip_force" &&
           (file.hand == Hand::parallel || file.hand == Hand::locked);
  };
  for (const Parameter& parameter : parameters_) {
    const auto low = Rational::parse(parameter.ends[0]), high = Rational::parse(parameter.ends[1]);
    if (!low || !high) refuse(parameter.path, "too long to be read exactly");
    const std::string key = key_of(parameter);
    const auto jaws = std::find_if(sides_.begin(), sides_.end(), [&](const BoxSide& side) {
      return shares_jaws(side.parameters[0]);
    });
    if (shares_jaws(parameter) && jaws != sides_.end()) {
      if (jaws->low != *low || jaws->high != *high)
        refuse(parameter.path, "both jaws share one grip_force; give them the same range");
      jaws->parameters.push_back(parameter);
      continue;
    }
    const Rational middle = (*low + *high) / Rational(2);
    const bool is_place = std::find(places.begin(), places.end(), key) != places.end();
    const auto body = std::find(file.body_names.begin(), file.body_names.end(), parameter.owner);
    std::optional<Role> role;
    if (body != file.body_names.end()) role = file.body(body - file.body_names.begin()).role;
    sides_.push_back(
        {{parameter}, *low, middle, *high, key, !is_place && middle.sign() != 0, role});
  }
  for (const BoxSide& side : more) {
    for (const Parameter& parameter : side.parameters)
      if (std::none_of(parameters_.begin(), parameters_.end(),
                       [&](const Parameter& one) { return one.path == parameter.path; }))
        parameters_.push_back(parameter);
    sides_.push_back(side);
  }
  if (sides_.size() > box_settings.most_sides)
    refuse(parameters_.back().path, "a box of " + std::to_string(sides_.size()) +
                                        " numbers has too many corners; at most " +
                                        std::to_string(box_settings.most_sides) + " may vary");
}

std::vector<Rational> Box::values(const std::vector<Rational>& of_sides) const {
  std::vector<Rational> values;
  for (const Parameter& parameter : parameters_) {
    Rational value = *Rational::parse(parameter.typed);
    for (std::size_t k = 0; k < sides_.size(); ++k)
      for (std::size_t i = 0; i < sides_[k].parameters.size(); ++i) {
        const BoxSide& side = sides_[k];
        if (side.parameters[i].path != parameter.path) continue;
        value =
            side.slopes.empty() ? of_sides[k] : value + side.slopes[i] * (of_sides[k] - side.typed);
      }
    values.push_back(std::move(value));
  }
  return values;
}

std::vector<Rational> Box::corner(Corner corner, const std::optional<Rational>& margin) const {
  std::vector<Rational> values;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const BoxSide& side = sides_[k];
    const bool is_high = (corner >> k & 1U) != 0;
    values.push_back(margin    ? (is_high ? side.high_at(*margin) : side.low_at(*margin))
                     : is_high ? side.high
                               : side.low);
  }
  return values;
}

std::vector<Rational> Box::middle() const {
  std::vector<Rational> values;
  for (const BoxSide& side : sides_) values.push_back(side.middle);
  return values;
}

bool Box::is_scaled(const std::vector<bool>& counts) const {
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (counts[k] && sides_[k].is_relative) return true;
  return false;
}

SceneFile Box::scene_at(const std::vector<Rational>& of_sides) const {
  std::vector<double> rounded;
  for (const Rational& value : values(of_sides)) rounded.push_back(value.value());
  return scene_.at(parameters_, rounded);
}

BoxAnswer Box::answer() const {
  BoxAnswer answer;
  for (const Parameter& parameter : parameters_)
    answer.box.push_back({parameter.path, Rational::parse(parameter.ends[0])->value(),
                          Rational::parse(parameter.ends[1])->value(), true});
  return answer;
}

std::vector<std::pair<std::string, double>>
Box::named_values(const std::vector<Rational>& of_sides) const {
  const std::vector<Rational> exact = values(of_sides);
  std::vector<std::pair<std::string, double>> named;
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    named.emplace_back(parameters_[k].path, exact[k].value());
  return named;
}

void Box::put_corner(const std::vector<Rational>& of_sides, BoxAnswer& answer) const {
  answer.corner = named_values(of_sides);
  answer.corner_scene = scene_.text_at(parameters_, values(of_sides));
}

BoxAnswer unknown_box(const VariedScene& scene) { return Box(scene).answer(); }

std::vector<SceneFile> corner_scenes(const VariedScene& scene,
                                     const std::optional<double>& margin) {
  constexpr std::array keys = {"friction", "grip_force", "mass", "gravity", "force", "moment"};
  const Box box(scene);
  for (const BoxSide& side : box.sides())
    if (!side.is_one_of(keys))
      refuse(side.parameters[0].path,
             "a plan is made for every value of friction, grip, mass and load alone");
  std::vector<SceneFile> scenes;
  const std::optional<Rational> wide = margin ? std::optional(Rational(*margin)) : std::nullopt;
  for (Box::Corner c = 0; c < box.corners(); ++c) {
    bool is_wanted = true;
    for (std::size_t k = 0; k < box.sides().size(); ++k) {
      const BoxSide& side = box.sides()[k];
      is_wanted =
          is_wanted && ((c >> k & 1U) == 0 || side.key != "friction" || side.role == Role::finger);
    }
    if (!is_wanted) continue;
    scenes.push_back(box.scene_at(box.corner(c, wide)));
    if (scenes.size() > box_settings.plan_corners)
      refuse(box.parameters()[0].path,
             "a plan's box has at most " + std::to_string(box_settings.plan_corners) +
                 " corners beside the frictions of pushers; give fewer numbers a tolerance");
  }
  return scenes;
}

double widest_margin(const std::function<bool(double margin)>& holds, bool is_quick) {
  const int halvings = is_quick ? box_settings.quick_halvings : box_settings.halvings;
  double low = 0, high = 1 - box_settings.inside; // at 1 nothing is left
  if (holds(high)) return high;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return std::max(low - box_settings.inside, 0.0);
}

} // namespace lcpush::desktop
