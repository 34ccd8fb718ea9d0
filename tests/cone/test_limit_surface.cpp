// [T.17]: what a grip across the plane resists.
#include "support/fixture_push.hpp"

#include "cone/limit_surface.hpp"
#include "cone/motion_cone.hpp"
#include "cone/pusher_cone.hpp"

#include <random>

using namespace lcpush;
using namespace lcpush::test;
using desktop::Crossing;
using desktop::GripPoints;
using desktop::LimitSurface;

namespace {

constexpr double half_turn = 3.14159265358979323846;

std::string two_discs(const std::string& keys) {
  const std::string finger = "shape = \"disc\"\nradius = 0.01\nfriction = 0.9\ngrip_force = 50\n";
  return "planar = true\n" + keys +
         "[object]\nmass = 0.5\nbox = [0.1, 0.1, 0.01]\n[[finger]]\nname = \"left\"\n" + finger +
         "center = [0.01, 0.02, 0.005]\nnormal = [0, 0, -1]\n[[finger]]\nname = \"right\"\n" +
         finger + "center = [0.01, 0.02, -0.005]\nnormal = [0, 0, 1]\n";
}

LimitSurface surface(const std::string& keys) {
  return LimitSurface(GripPoints(desktop::parse_scene(two_discs(keys), "t.toml")), 0.05);
}

Vector3<double> direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector3<double>(normal(random), normal(random), normal(random)).normalized();
}

} // namespace

TEST_CASE("[T.17] no wrench of the grip has more power than the one that resists") {
  std::mt19937 random(1);
  for (const char* keys : {"facets = 8\n", "facets = \"round\"\n", "pressure = \"even\"\n"}) {
    const LimitSurface grip = surface(keys);
    for (int k = 0; k < 300; ++k) {
      const Vector3<double> v = direction(random), other = direction(random);
      CHECK(grip.resistance(other).dot(v) <= grip.power(v) * (1 + 1e-12));
      CHECK((grip.resistance(v) + grip.resistance(-v)).norm() < 1e-9); // its own mirror image
    }
  }
}

TEST_CASE("[T.17] two discs resist a slide with 2 mu F along a generator, a turn with 4/3 mu F R") {
  const LimitSurface grip = surface("");
  CHECK(grip.power({1, 0, 0}) == doctest::Approx(2 * 0.9 * 50));
  // About the discs' own centre: v = omega z x (p - c).
  const Vector3<double> about(0.02, -0.01, 0.05);
  const LimitSurface round = surface("facets = \"round\"\n");
  CHECK(round.power(about) == doctest::Approx(2 * 0.9 * 50 * 2 / 3.0 * 0.01));
}

TEST_CASE("[T.17] a ray leaves the surface where its normal's power is used up") {
  std::mt19937 random(2);
  for (const char* keys : {"facets = 8\n", "facets = 6\n", "facets = \"round\"\n"}) {
    const LimitSurface grip = surface(keys);
    for (int k = 0; k < 300; ++k) {
      const Vector3<double> load = 0.3 * grip.resistance(direction(random)), d = direction(random);
      const Crossing at = grip.crossing(load, d);
      const Vector3<double> there = load + at.force * d;
      CHECK(at.twist.dot(d) == doctest::Approx(1));
      CHECK(at.twist.dot(there) == doctest::Approx(grip.power(at.twist)));
      for (int j = 0; j < 20; ++j) { // and no other motion gives way earlier
        const Vector3<double> v = direction(random);
        CHECK(v.dot(there) <= grip.power(v) * (1 + 1e-9));
      }
    }
  }
}

TEST_CASE("[T.17] rays through the corners and edges of a symmetric surface are met as well") {
  for (const char* keys :
       {"facets = 8\n", "facets = 4\n", "facets = 32\n", "pressure = \"even\"\n"}) {
    std::string text = two_discs(keys);
    for (std::size_t at; (at = text.find("0.01, 0.02")) != std::string::npos;)
      text.replace(at, 10, "0, 0");
    const LimitSurface grip(GripPoints(desktop::parse_scene(text, "t.toml")), 0.05);
    for (const double load : {0.3, 1.0, 4.905, 49.05})
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int w = -1; w <= 1; ++w) {
            if (x == 0 && y == 0 && w == 0) continue;
            const Vector3<double> d(load * x, load * y, 0.1 * load * w);
            const Crossing at = grip.crossing(Vector3<double>::Zero(), d);
            CHECK(at.force == doctest::Approx(grip.power(at.twist)));
            // The least power of all motions with the product 1, which is a convex function: it is
            // least where it grows on every side.
            const Vector3<double> a = cross<double>(d, {0.3, -0.5, 0.8}), b = cross<double>(d, a);
            for (int k = 0; k < 32; ++k)
              for (const double size : {1e-2, 1e-5}) {
                const double angle = half_turn * k / 16;
                const Vector3<double> to =
                    std::cos(angle) * a.normalized() + std::sin(angle) * b.normalized();
                CHECK(grip.power(at.twist + size * at.twist.norm() * to) >= at.force * (1 - 1e-12));
              }
          }
  }
}

TEST_CASE("[T.17] points beside the object leave their force to the others of their patch") {
  const GripPoints points(desktop::parse_scene(two_discs(""), "t.toml"));
  std::vector<bool> touches(points.size(), true);
  for (std::size_t k = 0; k < 5; ++k) touches[k] = false;
  const LimitSurface grip(points, 0.05, Vector3<double>::Zero(), 0, touches);
  CHECK(grip.touches_everywhere());
  CHECK(grip.power({1, 0, 0}) == doctest::Approx(90));
  for (std::size_t k = 0; k < points.size() / 2; ++k) touches[k] = false;
  CHECK(!LimitSurface(points, 0.05, Vector3<double>::Zero(), 0, touches).touches_everywhere());
}
