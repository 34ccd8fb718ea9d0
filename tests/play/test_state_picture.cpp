// The playground's picture: what is drawn stands where the scene has it, from wherever it is seen.
#include <doctest/doctest.h>

#include <regex>

#include "formats/json_reader.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "play/answers.hpp"
#include "support/scenes.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

std::string shipped_text(const char* name) {
  return read_scene_text(std::string(LCPUSH_SOURCE_DIR) + "/fixtures/scenes/" + name);
}

struct Answered {
  std::string svg;
  double meters;
};
Answered looked(Playground& page, const std::string& question, const std::string& text) {
  const JsonValue reply = parse_json(page.answer_to(question, text), "reply");
  return {*reply.find("picture")->as<std::string>(), *reply.find("meters")->as<double>()};
}

const std::string from_front = R"({"right": [1, 0, 0], "up": [0, 1, 0]})";
const std::string from_above = R"({"right": [1, 0, 0], "up": [0, 0, -1]})";

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

/// The corners of the polygons of a class, in order.
std::vector<Eigen::Vector2d> corners_of_kind(const std::string& svg, const std::string& kind) {
  std::vector<Eigen::Vector2d> corners;
  const std::regex polygon("<polygon class=\"" + kind + "\" points=\"([^\"]*)\"");
  const std::regex corner("(-?[0-9.]+),(-?[0-9.]+)");
  for (std::sregex_iterator p(svg.begin(), svg.end(), polygon), end; p != end; ++p) {
    const std::string points = (*p)[1];
    for (std::sregex_iterator c(points.begin(), points.end(), corner); c != end; ++c)
      corners.emplace_back(std::stod((*c)[1]), std::stod((*c)[2]));
  }
  return corners;
}

Eigen::Vector2d extent(const std::vector<Eigen::Vector2d>& corners) {
  REQUIRE(!corners.empty());
  Eigen::Vector2d low = corners[0], high = corners[0];
  for (const auto& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return high - low;
}

} // namespace

TEST_CASE("the object is as large as the scene says, from the front and from above") {
  const std::string text = shipped_text("pivot.toml"); // 100 x 30 x 10 mm
  Playground page;
  for (const auto& [look, height] : {std::pair(from_front, 0.03), std::pair(from_above, 0.01)}) {
    const Answered seen = looked(page, "solve " + look, text);
    const Eigen::Vector2d size = extent(corners_of_kind(seen.svg, "object")) / seen.meters;
    CHECK(size.x() == doctest::Approx(0.1).epsilon(1e-3));
    CHECK(size.y() == doctest::Approx(height).epsilon(1e-3));
  }
}

TEST_CASE("every body can be taken, every contact has its mark, and the ghost is there") {
  Playground page;
  const Answered seen = looked(page, "solve " + from_front, shipped_text("pivot.toml"));
  for (const char* name : {"left", "right", "edge"})
    CHECK(count_of(seen.svg, std::string("data-body=\"") + name + "\"") == 1);
  CHECK(count_of(seen.svg, "class=\"mark ") == 10);
  CHECK(count_of(seen.svg, "class=\"ghost\"") == 1);
  CHECK(count_of(seen.svg, "left  20 N") == 1);
}

TEST_CASE("the margin of the grip is told while a hand drags, of pads as a bound") {
  // Two fingers of 20 N and friction 0.5 bear 20 N: twice the mass, half the margin.
  Playground page;
  const auto margin = [&](const std::string& text) {
    const JsonValue reply = parse_json(page.answer_to("drag", text), "reply");
    return std::pair(*reply.find("grip_margin")->as<double>(), *reply.find("is_bound")->as<bool>());
  };
  const std::string finger = "friction = 0.5\ngrip_force = 20\nshape = \"point\"\non = \"";
  for (const double mass : {0.2, 0.4}) {
    const std::string text = "gravity = [0, 0, -10]\n[object]\nmass = " + std::to_string(mass) +
                             "\nbox = [0.04, 0.04, 0.04]\n[[finger]]\nname = \"a\"\n" + finger +
                             "-y\"\n[[finger]]\nname = \"b\"\n" + finger + "+y\"\n";
    const auto [found, is_bound] = margin(text);
    CHECK(found == doctest::Approx(20 / (10 * mass)).epsilon(1e-6));
    CHECK(!is_bound);
  }
  CHECK(margin(shipped_text("straight_slide.toml")).second);
}

TEST_CASE("a jam has no forces, and those who squeeze stand out") {
  Playground page;
  const Answered seen = looked(page, "solve " + from_front, shipped_text("jam.toml"));
  CHECK(count_of(seen.svg, "squeezes\"") == 2);
  CHECK(count_of(seen.svg, "class=\"force") == 0);
  CHECK(count_of(seen.svg, "class=\"ghost") == 0);
}

TEST_CASE("a look shows what was solved, whether that is remembered or not") {
  const std::string text = shipped_text("straight_slide.toml"), other = shipped_text("coin.toml");
  Playground page;
  const Answered first = looked(page, "solve " + from_front, text);
  CHECK(looked(page, "look " + from_front, text).svg == first.svg);
  (void)page.answer_to("solve", other);
  CHECK(looked(page, "look " + from_front, text).svg == first.svg);
  CHECK(looked(page, "look " + from_above, text).svg != first.svg);
}

TEST_CASE("at a moment of the motion things stand where its poses say") {
  const std::string text = shipped_text("pivot.toml");
  const auto moment = [](const std::string& pose) {
    const std::string body = R"({"position": [0, 0.01, 0], "columns": [1, 0, 0, 0, 1, 0, 0, 0, 1],
      "middle": [0, 0, 0], "normal": [0, 0, 1], "force": [0, 3, 4], "normal_force": 4})";
    return R"(look {"right": [1, 0, 0], "up": [0, 1, 0], "meters": 5000, "moment": {"most_force": 4,
      "path": [0, 0, 0, 0.01, 0, 0], "bodies": [)" +
           body + "," + body + "," + body + "], " + pose + "}}";
  };
  Playground page;
  // x looks where z did, y where x did, z where y did: by rows; and 10 mm to the right.
  const Answered turned = looked(
      page, moment(R"("position": [0.01, 0, 0], "rotation": [0, 1, 0, 0, 0, 1, 1, 0, 0])"), text);
  const auto corners = corners_of_kind(turned.svg, "object");
  CHECK(turned.meters == 5000);
  CHECK(extent(corners).x() == doctest::Approx(150));
  CHECK(extent(corners).y() == doctest::Approx(50));
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& corner : corners) sum += corner;
  CHECK((sum / static_cast<double>(corners.size()) - Eigen::Vector2d(410, 240)).norm() < 0.02);
  CHECK(count_of(turned.svg, "class=\"trace\" d=\"M360.00 240.00L410.00 240.00\"") == 1);
  CHECK(count_of(turned.svg, "class=\"force friction\"") == 3);
  CHECK(count_of(turned.svg, "class=\"mark ") == 0); // modes are the first instant's
  CHECK(count_of(turned.svg, "edge  4 N") == 1);
}

TEST_CASE("dots stand where a body could, and names cannot break the picture") {
  std::string text = shipped_text("pivot.toml");
  text.replace(text.find("\"edge\""), 6, R"("<b>\"&")");
  Playground page;
  const Answered seen = looked(page, R"(solve {"right": [1, 0, 0], "up": [0, 1, 0], "meters": 1000,
    "dots": [{"at": [0.02, 0.01, 0], "kind": "jams", "words": "it <jams>"}]})",
                               text);
  CHECK(count_of(seen.svg,
                 "class=\"dot jams\"><circle class=\"where\" cx=\"380.00\" cy=\"230.00\"") == 1);
  CHECK(count_of(seen.svg, "it &lt;jams&gt;") == 1);
  CHECK(count_of(seen.svg, "data-body=\"&lt;b&gt;&quot;&amp;\"") == 1);
}
