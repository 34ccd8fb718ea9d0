// [T.20] The proof that a push sticks for every value in a box, for docs/check/lcpush_check_box.py.
#include "boxes/push_model.hpp"
#include "boxes/settings.hpp"
#include "certify/sha256.hpp"
#include "formats/json_writer.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr const char* statement =
    "For every value in this box the pusher's force lies within its friction cone and between its "
    "outer points: the object moves as the pusher does.";

/// The least value of a condition, and where.
struct Least {
  Box::Corner corner = 0;
  Rational value;
};

/// What the checker does not know.
std::string beyond_checker(const std::string& text, const Box& box, const SceneFile& file) {
  constexpr std::array keys = {"friction", "grip_force", "mass", "gravity", "force", "moment"};
  for (const BoxSide& side : box.sides())
    if (!side.is_one_of(keys))
      return quoted(side.parameters[0].path) + " is none of " +
             listed({keys.begin(), keys.end()}, "and");
  if (!parse_scene(text, "").planar) return "the scene does not say planar = true";
  if (!file.is_round) return "friction is that of pyramids";
  if (file.hand == Hand::actuators) return "the hand is one of [[actuator]]s";
  if (std::any_of(file.overhang.begin(), file.overhang.end(), [](double m) { return m > 0; }))
    return "a contact is cut to the object";
  return "";
}

/// A little less than the value, in few digits.
Rational rounded_down(const Rational& value) {
  const Rational near(value.value() * (1 - box_settings.inside));
  return near > value ? Rational(0) : near;
}

} // namespace

BoxCertificate certify_box(const std::string& text, const VariedScene& scene,
                           const std::optional<Vector6<double>>& twist) {
  const SceneFile file = scene.as_given();
  const Box box(scene);
  const std::string obstacle = beyond_checker(text, box, file);
  if (!obstacle.empty()) return {"", obstacle};
  const PushModel model(box, twist);
  std::array<std::optional<Least>, 4> least;
  for (Box::Corner c = 0; c < box.corners(); ++c) {
    const PushConditions<Interval> there = model.exact_conditions(box.corner(c));
    for (std::size_t i = 0; i < least.size(); ++i)
      if (!least[i] || there.values[i].low < least[i]->value - Rational(box_settings.tie))
        least[i] = Least{c, there.values[i].low};
  }
  std::vector<std::string> claim{file.body_name(model.pusher())};
  const auto claimed = [&](const Rational& x) {
    claim.push_back(x.text());
    return x.text();
  };
  JsonWriter json;
  json.begin_object().member("certificate", 1).member("proof", "box");
  json.member("pusher", claim[0]).key("twist").begin_array();
  for (const Rational& x : model.direction()) json.value(claimed(x));
  json.end_array();
  json.list("box", box.sides(), [&](const BoxSide& side) {
    json.begin_object().key("paths").begin_array();
    for (const Parameter& parameter : side.parameters) {
      claim.push_back(parameter.path);
      json.value(parameter.path);
    }
    json.end_array().member("low", claimed(side.low)).member("high", claimed(side.high));
    json.end_object();
  });
  json.list("conditions", least, [&](const std::optional<Least>& one) {
    json.begin_object().key("corner").begin_array();
    for (const Rational& x : box.corner(one->corner)) json.value(claimed(x));
    json.end_array().member("least", claimed(rounded_down(one->value))).end_object();
  });
  std::string joined;
  for (const std::string& word : claim) joined += (joined.empty() ? "" : ",") + word;
  json.member("sha256", std::vector<std::string>{sha256(text), sha256(joined)});
  json.member("statement", statement);
  return {json.end_object().text(), ""};
}

} // namespace lcpush::desktop
