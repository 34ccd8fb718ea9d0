// Planar scenes in text, drawn at random or typed, for the tests of cones and plans.
#pragma once

#include "support/fixture_push.hpp"

#include "lcpush/desktop/cone.hpp"

#include <random>

namespace lcpush::test {

inline constexpr double pi = 3.14159265358979323846;

inline std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

inline std::string finger(const std::string& name, const std::string& shape, double z,
                          double friction, double grip) {
  return "[[finger]]\nname = \"" + name + "\"\n" + shape + "normal = [0, 0, " +
         (z > 0 ? "-1" : "1") + "]\nfriction = " + number(friction) +
         "\ngrip_force = " + number(grip) + "\n";
}

struct RandomPush {
  desktop::SceneFile file;
  Vector6<double> twist = Vector6<double>::Zero();
};

inline RandomPush random_push(std::mt19937& random) {
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
    text +=
        finger(side > 0 ? "left" : "right", shape + at, side, uniform(0.3, 1.0), uniform(15, 40));
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

} // namespace lcpush::test
