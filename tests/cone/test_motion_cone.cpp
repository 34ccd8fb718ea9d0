// [T.17], [T.18]: the motion cone against closed forms, and against pushes that are solved.
#include "support/fixture_push.hpp"

#include "lcpush/desktop/cone.hpp"

#include <random>

using namespace lcpush;
using namespace lcpush::test;
using desktop::ConeReport;
using desktop::SceneFile;

namespace {

constexpr double pi = 3.14159265358979323846;

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

std::string finger(const std::string& name, const std::string& shape, double z, double friction,
                   double grip) {
  return "[[finger]]\nname = \"" + name + "\"\n" + shape + "normal = [0, 0, " +
         (z > 0 ? "-1" : "1") + "]\nfriction = " + number(friction) +
         "\ngrip_force = " + number(grip) + "\n";
}

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

struct RandomPush {
  SceneFile file;
  Vector6<double> twist = Vector6<double>::Zero();
};

RandomPush random_push(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const int sides[] = {4, 6, 8, 12, 16, 32};
  const double angle = uniform(0, 2 * pi);
  std::string text = "planar = true\nfacets = " + std::to_string(sides[random() % 6]) +
                     "\npressure = \"" + (random() % 2 ? "pad" : "even") + "\"\ngravity = [" +
                     number(9.81 * std::cos(angle)) + ", " + number(9.81 * std::sin(angle)) +
                     ", 0]\n[object]\nmass = " + number(uniform(0.05, 0.5)) +
                     "\nbox = [0.1, 0.06, 0.02]\n[gripper]\njaws = \"independent\"\n";
  const double x = uniform(-0.02, 0.02), y = uniform(-0.015, 0.015);
  for (const double side : {1.0, -1.0}) {
    const std::string at =
        "center = [" + number(x) + ", " + number(y) + ", " + number(0.01 * side) + "]\n";
    const bool is_soft = random() % 4 == 0;
    const std::string shape =
        is_soft ? "shape = \"point\"\ntorsion_radius = " + number(uniform(0.002, 0.008)) + "\n"
                : "shape = \"disc\"\nradius = " + number(uniform(0.003, 0.012)) +
                      "\npoints = " + std::to_string(3 + random() % 8) + "\n";
    text += finger(side > 0 ? "left" : "right", shape + at, side, uniform(0.3, 1.0),
                   uniform(15, 40));
  }
  const double middle = uniform(-0.03, 0.03), half = uniform(0.004, 0.02);
  const bool is_point = random() % 3 == 0;
  text += "[[pusher]]\nname = \"wall\"\n" +
          (is_point ? "shape = \"point\"\ncenter = [" + number(middle) + ", -0.03, 0]\n"
                    : "shape = \"line\"\nends = [[" + number(middle - half) + ", -0.03, 0], [" +
                          number(middle + half) + ", -0.03, 0]]\n") +
          "normal = [0, 1, 0]\nfriction = " + number(uniform(0.1, 1.2)) +
          "\nacceleration = [0, 1, 0]\n";
  RandomPush push{desktop::parse_scene(text, "random.toml")};
  push.twist << uniform(-1, 1), uniform(-0.2, 1), 0, 0, 0, uniform(-60, 60);
  return push;
}

/// How far the object slips over the pusher in a push as slow as that, beside the push's own speed.
std::optional<double> slip_when_pushed(const RandomPush& push, double speed) {
  SceneFile file = push.file;
  Body<double>& wall = file.bodies.back();
  wall.acceleration = speed * push.twist;
  desktop::Push solver(file);
  desktop::PushOptions options;
  options.other_covers = 0;
  options.study_existence = false;
  const desktop::PushReport report = solver.solve(options);
  if (report.status != Status::solved) return std::nullopt;
  double most = 0, fastest = 0;
  for (Index i = wall.first_point; i < wall.first_point + wall.point_count; ++i) {
    const Vector3<double>& p = file.points[static_cast<std::size_t>(i)];
    most = std::max(
        most,
        acceleration_at(p, Vector6<double>(report.answer.acceleration - wall.acceleration)).norm());
    fastest = std::max(fastest, acceleration_at(p, wall.acceleration).norm());
  }
  return most / fastest;
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
      CHECK((edge.twist / edge.twist[5] - Vector6<double>{edge.twist[0] / edge.twist[5],
                                                           edge.twist[1] / edge.twist[5], 0, 0, 0,
                                                           1})
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

TEST_CASE("[T.18] a pusher sticks in solved pushes where the motion cone says so") {
  std::mt19937 random(20180618);
  int judged = 0, sticking = 0, unsolved = 0;
  for (int k = 0; k < 2000; ++k) {
    CAPTURE(k);
    const RandomPush push = random_push(random);
    const ConeReport cone = desktop::find_cone(push.file, 2, push.twist);
    if (cone.status != Status::solved || std::abs(cone.verdict->margin) < 1e-6) continue;
    const std::optional<double> slip = slip_when_pushed(push, 1e-6);
    if (!slip) {
      ++unsolved;
      continue;
    }
    ++judged;
    sticking += cone.verdict->sticks ? 1 : 0;
    CHECK((*slip < 1e-4) == cone.verdict->sticks);
  }
  MESSAGE(judged << " judged, " << sticking << " stick, " << unsolved << " not solved");
  CHECK(judged > 1500);
  CHECK(sticking > 150);
}
