// Pictures of a push, and the page that carries them: projections, the axis of turning, escapes.
#include "support/fixture_push.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "lcpush/desktop/report_page.hpp"
#include "report/grasp_painter.hpp"
#include "report/pictures.hpp"
#include "solve/sentence.hpp"

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
  return describe_motion(file.view(), answer, 0.05, 1e-3, 0.0);
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
    const Motion<double> motion = describe_motion(file.view(), answer, 0.05, 1e-3, 0.0);
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
  CHECK_FALSE(desktop::turns(describe_motion(file.view(), slide, 0.05, 1e-3, 0.0)));
}

TEST_CASE("the ghost lies where the object accelerates to, and there is none at rest") {
  const Page slide(scene_text("straight_slide.toml"));
  const std::string svg = slide.picture("isometric");
  CHECK(count(svg, "class=\"ghost\"") == 1);
  const auto rightmost = [&svg](const std::string& kind) {
    const std::size_t at = svg.find("<polygon class=\"" + kind + "\" points=\"");
    const std::size_t begin = svg.find("points=\"", at) + 8;
    double most = 0;
    std::istringstream corners(svg.substr(begin, svg.find('"', begin) - begin));
    for (std::string corner; corners >> corner;) most = std::max(most, std::stod(corner));
    return most;
  };
  CHECK(rightmost("ghost") > rightmost("object") + 10);
  std::string text = scene_text("straight_slide.toml");
  const Page held(text.substr(0, text.find("[[pusher]]")));
  CHECK(count(held.picture("isometric"), "class=\"ghost\"") == 0);
  const Page rolls(scene_text("rolling.toml")); // looks as it did
  CHECK(count(rolls.picture("isometric"), "class=\"ghost\"") == 0);
}

TEST_CASE("a motion that is negligible beside the contacts' is not drawn") {
  Page page(scene_text("straight_slide.toml"));
  const auto turns = [&page] { return count(page.picture("front"), "class=\"arc\""); };
  const double size = page.report.answer.acceleration.head<3>().norm();
  page.report.answer.acceleration[5] = 0.5e-3 * size / page.report.scales.length;
  CHECK(turns() == 0);
  page.report.answer.acceleration[5] = 0.1 * size / page.report.scales.length;
  CHECK(turns() == 1);
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
  CHECK(desktop::report_pictures(page.content).size() == 3);
  CHECK(count(page.picture("front"), "squeezes") >= 2);
  CHECK(count(page.picture("front"), "class=\"force friction") == 0);
}
