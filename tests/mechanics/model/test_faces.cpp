// Contact geometry: which points touch which faces, and what is refused.
#include <doctest/doctest.h>

#include "support/owned_motion.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

struct Placing {
  std::vector<Vec3> corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  std::vector<Face<double>> faces{1};
  std::vector<RoundSide<double>> sides{1};
  Body<double> body{};
  Pose<double> object, hand;
  Placing() {
    faces[0].corners = {corners.data(), 4};
    sides[0].radius = 0.5;
    body.normal = {0, 0, -1};
    body.tangent = {1, 0, 0};
  }
  PlacedPoint<double> operator()(Riding riding, const Vec3& start) const {
    const Surroundings<double> around{{}, {faces.data(), 1}, {sides.data(), 1}};
    const Index face = riding == Riding::on_side ? -1 : 0;
    return place(around, Touching{riding, face, 0}, body, start, object, hand, 1e-3);
  }
};

} // namespace

TEST_CASE("a body's point on a face of the object: gaps, rims, and the far side") {
  Placing at;
  CHECK(at(Riding::on_body, {0, 0, 0}).gap == 0);
  CHECK(at(Riding::on_body, {0.5, 0, 0.25}).gap == 0.25);
  CHECK(at(Riding::on_body, {1, 0, 0}).absence == Absence::none); // the rim is of the face
  CHECK(at(Riding::on_body, {1.01, 0, 0}).absence == Absence::outside);
  CHECK(at(Riding::on_body, {0, -1.01, 0}).absence == Absence::outside);
  CHECK(at(Riding::on_body, {0, 0, -0.01}).absence == Absence::behind);
  CHECK(at(Riding::on_body, {0, 0, -0.0005}).absence == Absence::none);
  SUBCASE("corners the other way round are the same face") {
    std::reverse(at.corners.begin(), at.corners.end());
    CHECK(at(Riding::on_body, {0.9, 0.9, 0}).absence == Absence::none);
    CHECK(at(Riding::on_body, {1.01, 0, 0}).absence == Absence::outside);
  }
  SUBCASE("the face turns with the object, and the normal with it") {
    Vector6<double> twist = Vector6<double>::Zero();
    twist[4] = 0.1; // about y
    at.object = moved(at.object, twist, 1.0);
    const PlacedPoint<double> placed = at(Riding::on_body, {0.5, 0, 0});
    CHECK(placed.gap == doctest::Approx(0.5 * std::sin(0.1)).epsilon(1e-12));
    CHECK(placed.normal[0] == doctest::Approx(-std::sin(0.1)).epsilon(1e-12));
    CHECK(placed.position[2] == 0);
  }
  SUBCASE("a round face") {
    at.faces[0].radius = 0.5;
    CHECK(at(Riding::on_body, {0.5, 0, 0}).absence == Absence::none);
    CHECK(at(Riding::on_body, {0.51, 0, 0}).absence == Absence::outside);
  }
}

TEST_CASE("a corner of the object on a body's plane rides on the object") {
  Placing at;
  at.body.normal = {0, 0, 1};
  at.object.position = {0.2, 0, 0.3};
  const PlacedPoint<double> placed = at(Riding::on_object, {0.5, 0, 0});
  CHECK(placed.gap == doctest::Approx(0.3));
  CHECK((placed.position - Vec3(0.7, 0, 0.3)).norm() == 0);
  at.object.position = {0.6, 0, 0};
  CHECK(at(Riding::on_object, {0.5, 0, 0}).absence == Absence::outside);
}

TEST_CASE("a round side touches a plane along a line that is found anew") {
  Placing at;
  at.body.normal = {0, 1, 0};
  Vector6<double> twist = Vector6<double>::Zero();
  twist[5] = 0.7; // rolled about its own axis, z
  at.object = moved(at.object, twist, 1.0);
  const PlacedPoint<double> placed = at(Riding::on_side, {0, -0.5, 0.2});
  CHECK((placed.position - Vec3(0, -0.5, 0.2)).norm() < 1e-15);
  CHECK(std::abs(placed.gap) < 1e-15);
  at.body.normal = {0, 0, 1};
  CHECK(at(Riding::on_side, {0, 0, 0}).absence == Absence::no_line);
}

TEST_CASE("edges against edges are refused by name, and so is what is not there") {
  Scene3 scene = straight_slide();
  const Scene<double> view = scene.view();
  std::vector<Touching> touching(3);
  std::vector<Face<double>> faces(1);
  std::vector<RoundSide<double>> sides(1);
  const auto mistake = [&] {
    return find_touch_mistake<double>(view,
                                      {{touching.data(), 3}, {faces.data(), 1}, {sides.data(), 1}});
  };
  CHECK(mistake() == TouchMistake::none);
  touching[2].face = 1;
  CHECK(mistake() == TouchMistake::index);
  touching[2].face = 0; // a wall along x against a face along z: only edges can meet
  CHECK(mistake() == TouchMistake::plane);
  faces[0].normal = {-1, 0, 0};
  CHECK(mistake() == TouchMistake::apart);
  faces[0].point = {-0.05, 0, 0};
  CHECK(mistake() == TouchMistake::none);
  touching[2] = {Riding::on_side, -1, 0};
  CHECK(mistake() == TouchMistake::side); // no radius
  sides[0].radius = 0.05;
  CHECK(mistake() == TouchMistake::none);
  sides[0].axis = {1, 0, 0};
  CHECK(mistake() == TouchMistake::side);
  touching[2].side = 1;
  CHECK(mistake() == TouchMistake::index);
  CHECK(find_touch_mistake<double>(view, {{touching.data(), 2}, {}, {}}) == TouchMistake::index);
}
