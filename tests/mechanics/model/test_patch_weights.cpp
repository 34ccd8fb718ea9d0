// Weighted points against the surfaces that they stand for, under uniform pressure.
#include "lcpush/mechanics/model/patch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace lcpush;

namespace {

struct Moments {
  double span_x, span_y;     ///< largest |x|, |y|: where it tips
  double square_x, square_y; ///< mean x^2, y^2
  double torsion;            ///< mean distance from the centre: torque about it over mu F
};

struct Patch {
  std::vector<Vector3<double>> points;
  std::vector<double> weights;

  explicit Patch(Index count)
      : points(static_cast<std::size_t>(count)), weights(static_cast<std::size_t>(count)) {}
  Span<Vector3<double>> places() { return {points.data(), static_cast<Index>(points.size())}; }
  Span<double> shares() { return {weights.data(), static_cast<Index>(weights.size())}; }

  Moments moments() const {
    Moments m{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = points[i].x(), y = points[i].y(), w = weights[i];
      m.span_x = std::max(m.span_x, std::abs(x));
      m.span_y = std::max(m.span_y, std::abs(y));
      m.square_x += w * x * x;
      m.square_y += w * y * y;
      m.torsion += w * std::hypot(x, y);
    }
    return m;
  }
};

const Vector3<double> origin = Vector3<double>::Zero(), x = Vector3<double>::UnitX(),
                      y = Vector3<double>::UnitY();

Patch line(Index count) {
  Patch patch(count);
  sample_line<double>(-x, x, patch.places());
  line_weights(patch.shares());
  return patch;
}
Patch disc(Index count) {
  Patch patch(count);
  sample_disc<double>(origin, x, y, 1, patch.places());
  disc_weights(patch.shares());
  return patch;
}
Patch rectangle(Index count_x, Index count_y, double half_y = 1) {
  Patch patch(count_x * count_y);
  sample_rectangle<double>(origin, x, y, 2, 2 * half_y, count_x, count_y, patch.places());
  rectangle_weights(count_x, count_y, patch.shares());
  return patch;
}

/// Mean distance from the centre of a rectangle with half edges 1 and b, by its closed form.
double rectangle_torsion(double b) {
  const double d = std::hypot(1, b);
  return d / 3 + (std::asinh(b) / b + b * b * std::asinh(1 / b)) / 6;
}

constexpr Moments line_surface{1, 0, 1.0 / 3, 0, 0.5}, disc_surface{1, 1, 0.25, 0.25, 2.0 / 3};
Moments rectangle_surface(double b) { return {1, b, 1.0 / 3, b * b / 3, rectangle_torsion(b)}; }

/// A row of the table in docs/theory/theory.md: each quantity over the surface's.
std::string row(const std::string& name, const Moments& points, const Moments& surface) {
  const auto ratio = [](double a, double b) { return b > 0 ? a / b : 1.0; };
  char text[160];
  std::snprintf(
      text, sizeof text, "| %s | %.3f | %.3f | %.3f |", name.c_str(),
      std::min(ratio(points.span_x, surface.span_x), ratio(points.span_y, surface.span_y)),
      ratio(points.square_x, surface.square_x), ratio(points.torsion, surface.torsion));
  return text;
}

std::vector<std::string> table() {
  std::vector<std::string> rows;
  for (const Index k : {2, 3, 4, 5, 6, 9})
    rows.push_back(row("line, " + std::to_string(k), line(k).moments(), line_surface));
  for (const Index k : {3, 5, 6, 8, 12, 16, 40, 64})
    rows.push_back(row("disc, " + std::to_string(k), disc(k).moments(), disc_surface));
  for (const Index k : {2, 3, 4, 6, 8})
    rows.push_back(row("square, " + std::to_string(k) + " x " + std::to_string(k),
                       rectangle(k, k).moments(), rectangle_surface(1)));
  for (const double b : {0.5, 0.25, 0.1}) {
    char name[32];
    std::snprintf(name, sizeof name, "1 : %g, 4 x 4", b);
    rows.push_back(row(name, rectangle(4, 4, b).moments(), rectangle_surface(b)));
  }
  return rows;
}

} // namespace

TEST_CASE("weights are positive and sum to one, whatever the shape and number of points") {
  const auto check = [](const Patch& patch) {
    double sum = 0;
    for (const double w : patch.weights) {
      CHECK(w > 0);
      sum += w;
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
  };
  for (Index k = 1; k <= 200; ++k) {
    CAPTURE(k);
    check(line(k));
    check(disc(k));
    check(rectangle(k, 1 + k % 7));
  }
}

TEST_CASE("a line of four points or more has the segment's span, second moment and torsion") {
  for (Index k = 4; k <= 200; ++k) {
    CAPTURE(k);
    const Moments m = line(k).moments();
    CHECK(m.span_x == 1);
    CHECK(m.square_x == doctest::Approx(1.0 / 3).epsilon(1e-12));
    CHECK(m.torsion == doctest::Approx(0.5).epsilon(1e-12));
  }
}

TEST_CASE("a disc of six points or more has the surface's span, second moments and torsion") {
  for (Index k = 6; k <= 300; ++k) {
    CAPTURE(k);
    const Moments m = disc(k).moments();
    CHECK(m.span_x == 1); // a point lies on the rim along t; others come within a step of it
    CHECK(m.square_x == doctest::Approx(0.25).epsilon(1e-12));
    CHECK(m.square_y == doctest::Approx(0.25).epsilon(1e-12));
    CHECK(m.torsion == doctest::Approx(2.0 / 3).epsilon(1e-12));
  }
}

TEST_CASE("a rectangle has the surface's span and second moments, and its torsion within 2.2 %") {
  for (const double b : {1.0, 0.5, 0.25, 0.1, 0.02})
    for (Index k = 4; k <= 12; ++k) {
      CAPTURE(b);
      CAPTURE(k);
      const Moments m = rectangle(k, k, b).moments(), surface = rectangle_surface(b);
      CHECK(m.span_x == 1);
      CHECK(m.span_y == b);
      CHECK(m.square_x == doctest::Approx(surface.square_x).epsilon(1e-12));
      CHECK(m.square_y == doctest::Approx(surface.square_y).epsilon(1e-12));
      CHECK(std::abs(m.torsion / surface.torsion - 1) <= 0.022);
    }
}

TEST_CASE("the closed form of a rectangle's torsion is the integral") {
  for (const double b : {1.0, 0.3}) {
    constexpr int n = 400;
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) sum += std::hypot((i + 0.5) / n, b * (j + 0.5) / n);
    CHECK(rectangle_torsion(b) == doctest::Approx(sum / n / n).epsilon(1e-5));
  }
}

TEST_CASE("the table of docs/theory/theory.md is this one") {
  std::ifstream file(std::string(LCPUSH_SOURCE_DIR) + "/docs/theory/theory.md");
  std::stringstream text;
  text << file.rdbuf();
  std::string rows;
  for (const std::string& line : table()) rows += line + "\n";
  CAPTURE(rows); // what to put there
  CHECK(text.str().find(rows) != std::string::npos);
}
