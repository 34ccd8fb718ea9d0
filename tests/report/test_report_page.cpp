// Pictures of a push, and the page that carries them: projections, the axis of turning, escapes.
#include "support/fixture_push.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "draw/label_places.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "report/pictures.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

using Vector = Vector3<double>;

const Vector z_axis(0, 0, 1);

desktop::SceneFile bar() {
  return desktop::parse_scene(scene_text("straight_slide.toml"), "test.toml");
}

/// The motion of a screw with this axis through `at` (scene's frame), rate and pitch.
Motion<double> screw(const desktop::SceneFile& file, const Vector& at, const Vector& along,
                     double rate, double pitch) {
  Answer<double> answer;
  const Vector alpha = rate * along;
  answer.acceleration.head<3>() =
      pitch * alpha + cross<double>(alpha, file.object.center_of_mass - at);
  answer.acceleration.tail<3>() = alpha;
  return describe_motion(file.view(), answer, 0.05, 1e-3);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++times;
  return times;
}

/// A page about the scene as `lcpush report` makes it, without the breaking force.
struct Page {
  desktop::SceneFile file;
  desktop::Push push;
  desktop::HoldReport hold;
  desktop::PushReport report;
  desktop::PageContent content;

  explicit Page(const std::string& text)
      : file(desktop::parse_scene(text, "test.toml")), push(file),
        hold(push.holds_without_push({})),
        report(push.solve({})), content{file, hold, report, nullptr, nullptr, {}} {}
  std::string html() const { return desktop::report_html(content); }
  std::string picture(const std::string& name) const {
    for (const desktop::Picture& picture : desktop::report_pictures(content))
      if (picture.name == name) return picture.svg;
    return "";
  }
};

} // namespace

TEST_CASE("a view keeps right hands right: right times up points at the viewer") {
  for (const char* name : {"straight_slide.toml", "screw_driving.toml", "ground.toml"}) {
    CAPTURE(name);
    const desktop::SceneFile file = desktop::parse_scene(scene_text(name), name);
    const std::vector<desktop::View> views = desktop::chosen_views(file);
    REQUIRE(views.size() == 2);
    CHECK(views[0].name == "front");
    for (const desktop::View& view : views) {
      CHECK(view.flat(view.right).isApprox(desktop::Pixel(1, 0)));
      CHECK(view.flat(view.up).isApprox(desktop::Pixel(0, -1))); // y down on a drawing
      CHECK(view.toward.dot(cross<double>(view.right, view.up)) == 1);
      CHECK(view.flat(view.toward).norm() == 0);
      CHECK(view.toward.norm() == 1);
    }
    CHECK(views[0].flat(Vector(1, 0, 0)).isApprox(desktop::Pixel(1, 0)));
    // The other view is from above, or from the right.
    const Vector from = views[1].name == "top" ? views[0].up : Vector(1, 0, 0);
    CHECK(views[1].toward.dot(from) == 1);
  }
}

TEST_CASE("gravity points down the front view") {
  for (const char* name : {"straight_slide.toml", "screw_driving.toml", "rolling.toml"}) {
    const desktop::SceneFile file = desktop::parse_scene(scene_text(name), name);
    REQUIRE(file.gravity.norm() > 0);
    CHECK(desktop::chosen_views(file)[0].flat(file.gravity).y() > 0);
  }
}

TEST_CASE("the hull of a square with points inside and on its edges is its four corners") {
  const std::vector<desktop::Pixel> corners = desktop::hull(
      {{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 1}, {2, 2}, {0.5, 1.5}, {0, 0}});
  REQUIRE(corners.size() == 4);
  double area = 0;
  for (std::size_t k = 0; k < 4; ++k)
    area += corners[k].x() * corners[(k + 1) % 4].y() - corners[k].y() * corners[(k + 1) % 4].x();
  CHECK(std::abs(area / 2) == 4);
}

TEST_CASE("round numbers lie below and above, within a factor") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> power(-9, 9);
  for (int k = 0; k < 500; ++k) {
    const double x = std::pow(10, power(random));
    CHECK(desktop::round_below(x) <= x * (1 + 1e-9));
    CHECK(desktop::round_below(x) >= 0.39 * x);
    CHECK(desktop::round_above(x) >= x * (1 - 1e-9));
    CHECK(desktop::round_above(x) <= 1.7 * x);
  }
  CHECK(desktop::round_below(0.05) == doctest::Approx(0.05));
  CHECK(desktop::round_above(20) == doctest::Approx(20));
}

TEST_CASE("the instantaneous centre of a planar motion is com + z x a / alpha") {
  desktop::SceneFile file = bar();
  file.object.center_of_mass = {0.01, -0.02, 0.003};
  const desktop::View front = desktop::chosen_views(file)[0];
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 100; ++k) {
    Answer<double> answer;
    answer.acceleration << number(random), number(random), 0, 0, 0, number(random);
    const double ax = answer.acceleration[0], ay = answer.acceleration[1];
    const double alpha = answer.acceleration[5];
    if (std::abs(alpha) < 0.01) continue;
    const Motion<double> motion = describe_motion(file.view(), answer, 0.05, 1e-3);
    REQUIRE(desktop::turns(motion));
    CHECK(desktop::is_along_sight(front, motion.axis));
    CHECK_FALSE(desktop::has_pitch(motion, 0.05));
    const desktop::Pixel seen = front.flat(file.object.center_of_mass + motion.axis_point);
    CHECK(seen.x() == doctest::Approx(0.01 - ay / alpha));
    CHECK(-seen.y() == doctest::Approx(-0.02 + ax / alpha));
  }
}

TEST_CASE("a screw's axis and pitch come out as they went in, in every view") {
  const desktop::SceneFile file = bar();
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  for (int k = 0; k < 100; ++k) {
    const Vector at = 0.05 * Vector(number(random), number(random), number(random));
    const Vector along = Vector(number(random), number(random), number(random)).normalized();
    const double pitch = 0.02 * number(random);
    const Motion<double> motion = screw(file, at, along, 3, pitch);
    for (const desktop::View& view : desktop::chosen_views(file)) {
      REQUIRE(desktop::turns(motion));
      CHECK(desktop::has_pitch(motion, 0.05));
      CHECK_FALSE(desktop::is_along_sight(view, motion.axis));
      CHECK(motion.pitch == doctest::Approx(pitch));
      CHECK((motion.axis - along).norm() < 1e-9);
      // Both points lie on the line that is drawn.
      const desktop::Pixel line = view.flat(motion.axis),
                           offset =
                               view.flat(at) -
                               view.flat(Vector(file.object.center_of_mass + motion.axis_point));
      CHECK(std::abs(line.x() * offset.y() - line.y() * offset.x()) < 1e-9);
    }
  }
}

TEST_CASE("an axis along the line of sight is a point, with a pitch or without") {
  const desktop::SceneFile file = bar();
  const std::vector<desktop::View> views = desktop::chosen_views(file); // along z, along y
  const Vector at(0.02, 0.01, 0);
  const Motion<double> end_on = screw(file, at, z_axis, 2, 0.004);
  CHECK(desktop::turns(end_on));
  CHECK(desktop::is_along_sight(views[0], end_on.axis));
  CHECK(desktop::has_pitch(end_on, 0.05));
  const Vector point = file.object.center_of_mass + end_on.axis_point;
  CHECK((views[0].flat(point) - views[0].flat(at)).norm() < 1e-12);
  const Motion<double> across = screw(file, at, z_axis, 2, 0);
  CHECK(desktop::turns(across));
  CHECK_FALSE(desktop::is_along_sight(views[1], across.axis));
  CHECK_FALSE(desktop::has_pitch(across, 0.05));
  Answer<double> slide;
  slide.acceleration << 1, 0, 0, 0, 0, 0;
  CHECK_FALSE(desktop::turns(describe_motion(file.view(), slide, 0.05, 1e-3)));
}

TEST_CASE("a line is clipped to the picture, and one that misses it is not drawn") {
  const auto across = desktop::clipped_line({50, 20}, {1, 0}, 100, 40);
  REQUIRE(across.has_value());
  CHECK(across->first.isApprox(desktop::Pixel(0, 20)));
  CHECK(across->second.isApprox(desktop::Pixel(100, 20)));
  const auto diagonal = desktop::clipped_line({0, 0}, {2, 1}, 100, 40);
  REQUIRE(diagonal.has_value());
  CHECK(diagonal->second.isApprox(desktop::Pixel(80, 40)));
  CHECK_FALSE(desktop::clipped_line({0, -1}, {1, 0}, 100, 40).has_value());
  CHECK_FALSE(desktop::clipped_line({-50, 0}, {1, 1.5}, 100, 40).has_value());
}

TEST_CASE("labels with room around them do not cover each other or leave the picture") {
  desktop::LabelPlaces places(400, 300);
  std::vector<desktop::Frame> frames;
  for (int k = 0; k < 5; ++k)
    frames.push_back(places.place({"a name", "normal 20 N"}, {200, 150}, desktop::Pixel::Zero()));
  for (std::size_t a = 0; a < frames.size(); ++a) {
    CHECK(frames[a].left >= 0);
    CHECK(frames[a].top >= 0);
    CHECK(frames[a].right <= 400);
    CHECK(frames[a].bottom <= 300);
    for (std::size_t b = 0; b < a; ++b)
      CHECK((frames[a].right <= frames[b].left || frames[b].right <= frames[a].left ||
             frames[a].bottom <= frames[b].top || frames[b].bottom <= frames[a].top));
  }
}

TEST_CASE("markup escapes what ends elements and attributes, and what XML cannot hold") {
  CHECK(desktop::escaped("<a href=\"x\">&'") == "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  CHECK(desktop::escaped("\u00e4 \u6f22 \U0001F600") == "\u00e4 \u6f22 \U0001F600");
  CHECK(desktop::escaped(std::string("a\0b\x01\x1f\x7f", 6)) == "a\uFFFDb\uFFFD\uFFFD\uFFFD");
  CHECK(desktop::escaped("\xEF\xBF\xBE!") == "\uFFFD!"); // no character at all
  CHECK(desktop::escaped("a\nb\tc") == "a&#10;b\tc");
}

TEST_CASE("a long name is cut between letters") {
  CHECK(desktop::shortened("wall", 4) == "wall");
  CHECK(desktop::shortened("a longer name", 6) == "a lo..");
  CHECK(desktop::shortened("\u00e4\u00f6\u00fc\u00df\u00e9", 4) == "\u00e4\u00f6..");
  CHECK(desktop::shortened("\u00e4\u00f6\u00fc\u00df", 4) == "\u00e4\u00f6\u00fc\u00df");
}

TEST_CASE("names and titles stand on the page as text, whatever they hold") {
  const std::string name = "w<b>&\\\"'";
  std::string text = with(scene_text("straight_slide.toml"), "\"wall\"", "\"" + name + "\"");
  text = with(text, "title = \"", "title = \"</title><script>&\\uFFFE");
  const Page page(text);
  const std::string html = page.html(), front = page.picture("front");
  CHECK(count(html, "<script") == 0);
  CHECK(count(html, "<b>") == 0);
  CHECK(count(front, "<b>") == 0);
  CHECK(count(html, "w&lt;b&gt;&amp;&quot;&#39;") > 3);
  CHECK(count(html, "&lt;/title&gt;&lt;script&gt;&amp;\uFFFD") >= 2);
  CHECK(count(html, "\x07") == 0);
}

TEST_CASE("the arc turns as the object does") {
  // A sweep flag of 1 is clockwise on a drawing, a turn about -z as z points at the viewer.
  const Page pivot(scene_text("pivot.toml")), rolling(scene_text("rolling.toml"));
  REQUIRE(pivot.report.answer.acceleration[5] < 0);
  REQUIRE(rolling.report.answer.acceleration[5] > 0);
  const auto arc = [](const std::string& svg) {
    const std::size_t at = svg.find("<path class=\"arc\"");
    return svg.substr(at, svg.find("/>", at) - at);
  };
  CHECK(count(arc(pivot.picture("front")), " 0 1 1 ") == 1);
  CHECK(count(arc(rolling.picture("front")), " 0 1 0 ") == 1);
}

TEST_CASE("each contact has its mark: square, triangle or ring") {
  const Page page(scene_text("tipping.toml"));
  REQUIRE(page.report.status == Status::solved);
  std::size_t modes[3] = {0, 0, 0};
  for (const ContactAnswer<double>& contact : page.report.answer.contacts)
    ++modes[static_cast<int>(contact.mode)];
  REQUIRE(modes[static_cast<int>(Mode::separate)] > 0);
  for (const char* view : {"front", "top"}) {
    const std::string svg = page.picture(view);
    CHECK(count(svg, "<polygon class=\"mark stick\"") == modes[static_cast<int>(Mode::stick)]);
    CHECK(count(svg, "<polygon class=\"mark slide\"") == modes[static_cast<int>(Mode::slide)]);
    CHECK(count(svg, "<circle class=\"mark separate\"") == modes[static_cast<int>(Mode::separate)]);
    for (Index i = 0; i < page.report.answer.contacts.size; ++i)
      CHECK(count(svg, "<title>" + desktop::point_name(page.file, i) + " ") == 1);
  }
}

TEST_CASE("of large patches the first points are drawn, and every other one is accounted for") {
  const Page page(with(scene_text("ground.toml"), "points = 6", "points = 30"));
  REQUIRE(page.report.status == Status::solved);
  const std::string svg = page.picture("friction");
  CHECK(count(svg, "<polygon class=\"cone\"") == 16 + 16 + 4); // a third of 48, and all of four
  CHECK(count(svg, ">left.16</text>") == 1);
  CHECK(count(svg, ">left.17</text>") == 0);
  CHECK(desktop::without_friction(page.file, page.report) ==
        std::vector<std::string>{"left.17 to left.30 (no room)", "right.17 to right.30 (no room)"});
  const Page soft(scene_text("soft_fingers.toml"));
  CHECK(desktop::without_friction(soft.file, soft.report) ==
        std::vector<std::string>{"rod.1 (frictionless)"});
}

TEST_CASE("a jam's page says who squeezes and draws no force") {
  const Page page(scene_text("jam.toml"));
  REQUIRE(page.report.status == Status::ray);
  CHECK_FALSE(desktop::is_solved(page.content));
  const std::string html = page.html();
  for (const std::string& sentence : desktop::jam_sentences(page.file, page.report.jam))
    CHECK(html.find(desktop::escaped(sentence.substr(sentence.rfind("- ", 0) == 0 ? 2 : 0))) !=
          std::string::npos);
  CHECK(count(html, "NOT SOLVED (ray)") == 1);
  CHECK(count(html, "id=\"contacts\"") == 0);
  CHECK(desktop::report_pictures(page.content).size() == 2);
  CHECK(count(page.picture("front"), "squeezes") >= 2);
  CHECK(count(page.picture("front"), "class=\"force friction") == 0);
}

TEST_CASE("the residual picture marks what breaks its tolerance") {
  Residuals<double> good, bad;
  bad.cone = 1e-3;
  Residuals<double> unknown;
  unknown.grip = std::nan("");
  CHECK(count(desktop::residual_picture(good).elements, "broken") == 0);
  CHECK(count(desktop::residual_picture(bad).elements, "broken") == 1);
  CHECK(count(desktop::residual_picture(unknown).elements, "broken") == 1);
}

TEST_CASE("every picture has a title and a description, and no two on a page share an id") {
  for (const char* name : {"pivot.toml", "three_finger_hand.toml", "jam.toml"}) {
    CAPTURE(name);
    const Page page(scene_text(name));
    for (const desktop::Picture& picture : desktop::report_pictures(page.content)) {
      CHECK(count(picture.svg, "role=\"img\"") == 1);
      CHECK(picture.svg.find("<title>" + picture.title) != std::string::npos);
      CHECK(count(picture.svg, "<desc>") == 1);
      CHECK(count(picture.svg, " id=\"") == 0);
      CHECK(count(picture.svg, "http") == 1); // the namespace
    }
  }
}
