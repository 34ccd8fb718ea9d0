// Gravity pulls down every picture, whatever axis it points along: the report's, the motion's and
// the playground's show one fall alike.
#include <doctest/doctest.h>

#include <regex>

#include "formats/json_reader.hpp"
#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "play/answers.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

std::string listed(const Vector3<double>& v) {
  return "[" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
         "]";
}

/// A box between two fingers without friction, across gravity: it falls.
std::string falling_box(Index axis, double gravity) {
  const Vector3<double> size(0.1, 0.03, 0.01);
  const Index across = (axis + 1) % 3;
  std::string text = "gravity = " + listed(gravity * Vector3<double>::Unit(axis)) +
                     "\n[object]\nmass = 0.2\nbox = " + listed(size) + "\n";
  for (const double side : {1.0, -1.0})
    text += std::string("[[finger]]\nname = \"") + (side > 0 ? "one" : "other") +
            "\"\nshape = \"point\"\ncenter = " +
            listed(side * size[across] / 2 * Vector3<double>::Unit(across)) +
            "\nnormal = " + listed(-side * Vector3<double>::Unit(across)) +
            "\nfriction = 0\ngrip_force = 10\n";
  return text;
}

/// How far down the picture something goes, and how far across: numbers 1 to 4 of `pattern`.
Eigen::Vector2d stretch(const std::string& svg, const std::string& pattern) {
  std::smatch found;
  REQUIRE(std::regex_search(svg, found, std::regex(pattern)));
  return {std::stod(found[3]) - std::stod(found[1]), std::stod(found[4]) - std::stod(found[2])};
}

const std::string number = "(-?[0-9.]+)";

} // namespace

TEST_CASE("a box falls down every picture, whichever way gravity points") {
  for (const Index axis : {0, 1, 2})
    for (const double gravity : {9.81, -9.81}) {
      CAPTURE(axis);
      CAPTURE(gravity);
      const std::string text = falling_box(axis, gravity);
      const SceneFile file = parse_scene(text, "falls.toml", Strokes::all);
      Push push(file);
      const HoldReport hold = push.holds_without_push({});
      const PushReport report = push.solve({});
      for (const Picture& picture : report_pictures({file, hold, report, nullptr, nullptr, {}})) {
        CAPTURE(picture.name);
        if (picture.name != "front" && picture.name != "isometric") continue;
        const Eigen::Vector2d weight = stretch(
            picture.svg, "class=\"force weight\"><line class=\"shaft\" x1=\"" + number +
                             "\" y1=\"" + number + "\" x2=\"" + number + "\" y2=\"" + number);
        CHECK(weight.y() > 5);
        CHECK(std::abs(weight.x()) < 0.1);
      }
      MoveOptions options;
      options.time = 0.1;
      options.frames = 2;
      const Eigen::Vector2d fall =
          stretch(move_svg(file, desktop::move(file, options)),
                  "class=\"turning\" d=\"M" + number + " " + number + "L" + number + " " + number);
      CHECK(fall.y() > 5);
      CHECK(std::abs(fall.x()) < 0.1);
      for (const char* view : {"front", "side", "isometric"}) {
        Playground page;
        const JsonValue seen = parse_json(
            page.answer_to(std::string("solve {\"view\": \"") + view + "\"}", text), "reply");
        const JsonArray& up = *seen.find("up")->as<JsonArray>();
        CHECK(gravity * *up[static_cast<std::size_t>(axis)].as<double>() < -7);
      }
    }
}
