// What pictures are made of: hulls, round numbers, prisms, labels that keep clear, markup.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "draw/arrow_places.hpp"
#include "draw/label_places.hpp"
#include "draw/plot_svg.hpp"
#include "draw/prism.hpp"

using namespace lcpush;

namespace {

using Vector = Vector3<double>;

} // namespace

TEST_CASE(
    "a rectangle whose corners and sides are doubled, but for rounding or a hair of tilt, keeps "
    "its corners, however it is turned") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 4000; ++trial) {
    const double off = std::pow(10, -12.0 + trial % 8),
                 angle = trial % 3 == 0 ? 0 : 4 * unit(random);
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<desktop::Pixel> points;
    for (int twice = 0; twice < 2; ++twice)
      for (const double x : {116.02, 479.1})
        for (const double y : {155.54, 200.0, 264.46})
          points.emplace_back(c * x - s * y + off * unit(random),
                              s * x + c * y + off * unit(random));
    std::shuffle(points.begin(), points.end(), random);
    double area = 0;
    const std::vector<desktop::Pixel> corners = desktop::hull(points);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const desktop::Pixel &a = corners[i], &b = corners[(i + 1) % corners.size()];
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    CHECK((off > 1e-7 || corners.size() == 4));
    CHECK(std::abs(std::abs(area) - (479.1 - 116.02) * (264.46 - 155.54)) < 1e-6 + 1500 * off);
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

TEST_CASE("a line is clipped to the picture, and one that misses it is not drawn") {
  const desktop::Frame picture{0, 0, 100, 40};
  const auto across = desktop::clipped_line(picture, {50, 20}, {1, 0});
  REQUIRE(across.has_value());
  CHECK(across->first.isApprox(desktop::Pixel(0, 20)));
  CHECK(across->second.isApprox(desktop::Pixel(100, 20)));
  const auto diagonal = desktop::clipped_line(picture, {0, 0}, {2, 1});
  REQUIRE(diagonal.has_value());
  CHECK(diagonal->second.isApprox(desktop::Pixel(80, 40)));
  CHECK_FALSE(desktop::clipped_line(picture, {0, -1}, {1, 0}).has_value());
  CHECK_FALSE(desktop::clipped_line(picture, {-50, 0}, {1, 1.5}).has_value());
}

TEST_CASE("labels with room around them do not cover each other or leave the picture") {
  desktop::LabelPlaces places(400, 300);
  std::vector<desktop::Frame> frames;
  for (int k = 0; k < 5; ++k)
    frames.push_back(
        places.place({{"a name", "normal 20 N"}, {200, 150}, desktop::Pixel::Zero(), {200, 150}}));
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

TEST_CASE("labels touch no edge while there is room, and no leader runs through another's words") {
  const std::vector<desktop::Pixel> square{{150, 100}, {250, 100}, {250, 200}, {150, 200}};
  desktop::LabelPlaces places(400, 300);
  places.bar_edges(square);
  std::vector<desktop::Label> labels;
  for (const desktop::Pixel& corner : square)
    labels.push_back({{"a name", "normal 20 N"}, corner, desktop::Pixel::Zero(), corner});
  const std::vector<desktop::Frame> frames = desktop::placed_labels(places, labels);
  REQUIRE(frames.size() == 4);
  for (std::size_t a = 0; a < 4; ++a)
    for (double t = 0; t <= 1; t += 0.01) {
      const auto is_in = [&frames](std::size_t label, const desktop::Pixel& at) {
        const desktop::Frame& f = frames[label];
        return at.x() > f.left && at.x() < f.right && at.y() > f.top && at.y() < f.bottom;
      };
      const desktop::Pixel end = desktop::leader_end(frames[a], labels[a].target);
      for (std::size_t b = 0; b < 4; ++b) {
        CHECK_FALSE(is_in(b, square[a] + t * (square[(a + 1) % 4] - square[a])));
        CHECK_FALSE(is_in(b, labels[a].target + t * (end - labels[a].target)));
      }
    }
}

TEST_CASE("a picture is as high as what it shows, and keeps its corner free") {
  desktop::LabelPlaces places(400, 300);
  places.bar({0, 0, 60, 50});
  places.block_endless_line({200, 0}, {200, 300}, 60);
  places.block({150, 120, 250, 180}, 1);
  const desktop::Frame used = places.used({{100, 190, 160, 210}}, {60, 50}, 20);
  CHECK(used.top < 120);
  CHECK(used.top > 100);
  CHECK(used.bottom == 230);
  CHECK(used.width() == 400);
  places.block({20, 120, 50, 130}, 1); // below the corner, which moves down with the edge
  CHECK(places.used({}, {60, 50}, 20).top == 70);
}

TEST_CASE("an arrow that would lie on another stands beside it") {
  desktop::ArrowPlaces places;
  const desktop::Pixel from(100, 100), to(100, 150);
  CHECK(places.clear_start(from, to) == from);
  places.add({60, 120}, {140, 120}); // crosses it
  CHECK(places.clear_start(from, to) == from);
  places.add({100, 200}, {100, 160}); // on its line, farther off
  CHECK(places.clear_start(from, to) == from);
  places.add({101, 190}, {101, 140});
  const desktop::Pixel beside = places.clear_start(from, to);
  CHECK(beside.y() == doctest::Approx(100));
  CHECK(std::abs(beside.x() - 101) >= 11);
  CHECK(std::abs(beside.x() - 100) <= 21);
}

TEST_CASE("a prism shows the faces that are turned to the viewer") {
  const desktop::Prism box = desktop::box_prism({1, 2, 3}, {2, 4, 6});
  CHECK(desktop::corners_of(box).size() == 8);
  CHECK(desktop::faces_toward(box, {1, 1, 1}).size() == 3);
  CHECK(desktop::faces_toward(box, {0, 0, 1}).size() == 1);
  const auto lid = desktop::faces_toward(box, {0, 1, 0});
  REQUIRE(lid.size() == 1);
  for (const Vector& corner : lid[0]) CHECK(corner.y() == 4);
  const desktop::Prism coin = desktop::cylinder_prism({0, 0, 0}, {0.1, 0.016, 0.1}, 1);
  CHECK(desktop::faces_toward(coin, {1, 1, 1}).size() == 1); // its sides are round
}

TEST_CASE("markup escapes what ends elements and attributes, and what XML cannot hold") {
  CHECK(desktop::escaped("<a href=\"x\">&'") == "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  CHECK(desktop::escaped("\u00e4 \u6f22 \U0001F600") == "\u00e4 \u6f22 \U0001F600");
  CHECK(desktop::escaped(std::string("a\0b\x01\x1f\x7f", 6)) == "a\uFFFDb\uFFFD\uFFFD\uFFFD");
  CHECK(desktop::escaped("\xEF\xBF\xBE!") == "\uFFFD!"); // no character at all
  CHECK(desktop::escaped("a\nb\tc") == "a&#10;b\tc");
}

TEST_CASE("a map's colour bar goes from its least value to its largest; equal values have none") {
  desktop::MapPlot plot;
  plot.columns = 2;
  plot.cells = {1, 2, 3, std::nan("")};
  plot.texts = {"a", "b", "c", "d"};
  const std::string svg = desktop::map_svg(plot);
  const std::size_t bar = svg.find("class=\"colours\""), end = svg.find("</g>", bar);
  REQUIRE(bar != std::string::npos);
  const std::string colours = svg.substr(bar, end - bar);
  for (const char* value : {">1<", ">2<", ">3<"}) CHECK(colours.find(value) != std::string::npos);
  const auto opacity = [&colours](std::size_t at) {
    const std::size_t begin = colours.find("fill-opacity=\"", at) + 14;
    return std::stod(colours.substr(begin, colours.find('"', begin) - begin));
  };
  CHECK(opacity(0) < 0.1);
  CHECK(opacity(colours.rfind("<rect class=\"cell\"")) > 0.95);
  plot.cells = {1, 1, 1, 1};
  CHECK(desktop::map_svg(plot).find("class=\"colours\"") == std::string::npos);
}
