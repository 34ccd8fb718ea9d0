// [T.17], [T.18]: the motion cone against closed forms, and against pushes that are solved.
#include "support/planar_pushes.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::ConeReport;
using desktop::SceneFile;

namespace {

/// 0.5 kg between soft points of 6 mm at the middle of a line pusher 30 mm below.
std::string soft_grip(const std::string& facets, double gravity, double half_width) {
  const std::string shape = "shape = \"point\"\ntorsion_radius = 0.006\n";
  return "planar = true\nfacets = " + facets + "\ngravity = [0, " + number(gravity) +
         ", 0]\n[object]\nmass = 0.5\nbox = [0.08, 0.06, 0.01]\n" +
         finger("left", shape + "center = [0, 0, 0.005]\n", 1, 0.8, 25) +
         finger("right", shape + "center = [0, 0, -0.005]\n", -1, 0.8, 25) +
         "[[pusher]]\nname = \"wall\"\nshape = \"line\"\nends = [[" + number(-half_width) +
         ", -0.03, 0], [" + number(half_width) +
         ", -0.03, 0]]\nnormal = [0, 1, 0]\nfriction = 0.8\nacceleration = [0, 1e-6, 0]\n";
}

ConeReport cone_of(const std::string& text, const std::optional<Vector6<double>>& twist = {}) {
  const SceneFile file = desktop::parse_scene(text, "test.toml");
  return desktop::find_cone(file, static_cast<Index>(file.bodies.size()) - 1, twist);
}

/// The force of an edge whose wrench per N is w: k from (k w + load) on the ellipsoid, and the
/// twist there.
struct Closed {
  double force;
  Vector3<double> per_radian;
};
Closed ellipsoid_edge(const Vector3<double>& w, const Vector3<double>& load, double limit,
                      double radius) {
  const Vector3<double> stretch(1, 1, 1 / radius);
  const Vector3<double> a = stretch.cwiseProduct(w), b = stretch.cwiseProduct(load);
  const double half = a.dot(b), square = a.squaredNorm();
  const double k =
      (-half + std::sqrt(half * half + square * (limit * limit - b.squaredNorm()))) / square;
  const Vector3<double> v = stretch.cwiseProduct(k * a + b);
  return {k * w.head<2>().norm(), v / v[2]};
}

} // namespace

TEST_CASE("[T.17] [T.18] edges of a line pusher under gravity are those of the ellipsoid") {
  for (const double gravity : {9.81, 0.0, -9.81}) {
    const ConeReport cone = cone_of(soft_grip("\"round\"", gravity, 0.03));
    REQUIRE(cone.status == Status::solved);
    REQUIRE(cone.edges.size() == 4);
    for (const ConeReport::Edge& edge : cone.edges) {
      const double x = edge.point == 2 ? -0.03 : 0.03, side = edge.slips[0] > 0 ? -1 : 1;
      const Vector3<double> w(0.8 * side, 1, x + 0.03 * 0.8 * side);
      const Closed closed = ellipsoid_edge(w, {0, 0.5 * gravity, 0}, 40, 0.006);
      CHECK(edge.wrench.head<3>().norm() == doctest::Approx(closed.force).epsilon(1e-9));
      CHECK(
          (edge.twist / edge.twist[5] - Vector6<double>{edge.twist[0] / edge.twist[5],
                                                        edge.twist[1] / edge.twist[5], 0, 0, 0, 1})
              .norm() < 1e-12);
      CHECK(std::abs(edge.twist[0] / edge.twist[5] - closed.per_radian[0]) < 1e-9);
      CHECK(std::abs(edge.twist[1] / edge.twist[5] - closed.per_radian[1]) < 1e-9);
    }
  }
}

TEST_CASE("the published figures: 29.000 and 5.5169 N, 4.80, 7.30, -0.53 and 1.43 mm a radian") {
  const ConeReport cone = cone_of(soft_grip("\"round\"", 9.81, 0.03));
  std::vector<double> forces;
  for (const ConeReport::Edge& edge : cone.edges) forces.push_back(edge.wrench.head<3>().norm());
  std::sort(forces.begin(), forces.end());
  CHECK(forces[0] == doctest::Approx(5.5169).epsilon(1e-5));
  CHECK(forces[3] == doctest::Approx(29.000).epsilon(1e-5));
}

TEST_CASE("[T.18] the least grip is where the verdict turns") {
  std::mt19937 random(7);
  int found = 0;
  for (int k = 0; k < 400; ++k) {
    CAPTURE(k);
    const RandomPush push = random_push(random);
    const ConeReport cone = desktop::find_cone(push.file, 2, push.twist);
    if (cone.status != Status::solved || !cone.verdict->grip) continue;
    const double least = *cone.verdict->grip;
    if (least < 1.001 * cone.holding_grip || std::abs(least - 1) < 1e-3) continue;
    ++found;
    for (const double by : {1 - 1e-6, 1 + 1e-6}) {
      SceneFile file = push.file;
      for (Actuator<double>& actuator : file.actuators) actuator.force *= least * by;
      CHECK(desktop::find_cone(file, 2, push.twist).verdict->sticks == (by > 1));
    }
  }
  CHECK(found > 10);
}

TEST_CASE("[T.18] without a load a motion sticks with every grip, or with none") {
  std::mt19937 random(8);
  for (int k = 0; k < 200; ++k) {
    RandomPush push = random_push(random);
    push.file.gravity.setZero();
    const ConeReport cone = desktop::find_cone(push.file, 2, push.twist);
    CHECK(cone.verdict->grip.has_value() == cone.verdict->sticks);
    CHECK(cone.verdict->grip.value_or(0) == 0);
  }
}

TEST_CASE("[T.18] without a load the cone of a soft grip is convex, and its edges span it") {
  std::mt19937 random(9);
  std::exponential_distribution<double> share;
  const ConeReport cone = cone_of(soft_grip("\"round\"", 0, 0.03));
  for (int k = 0; k < 40; ++k) {
    Vector6<double> inside = Vector6<double>::Zero(), outside;
    double total = 0;
    for (const ConeReport::Edge& edge : cone.edges) {
      const double part = share(random);
      inside += part * edge.twist / edge.twist.norm();
      total += part;
    }
    outside = cone.edges[0].twist + (cone.edges[0].twist - inside / total);
    CHECK(cone_of(soft_grip("\"round\"", 0, 0.03), inside).verdict->sticks);
    CHECK(!cone_of(soft_grip("\"round\"", 0, 0.03), outside).verdict->sticks);
  }
}
