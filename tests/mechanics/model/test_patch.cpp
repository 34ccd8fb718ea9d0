#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/mechanics/model/patch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace lcpush;

namespace {

template <class S> using Points = std::vector<Vector3<S>>;

/// A tilted contact plane away from the origin, so that no component vanishes by luck.
template <class S> struct Plane {
  Vector3<S> center{S(0.3), S(-0.2), S(0.1)};
  Vector3<S> n = Vector3<S>(S(1), S(-2), S(3)).normalized();
  Vector3<S> t = default_tangent<S>(n);
  Vector3<S> o = cross(n, t);
};

template <class S> Span<Vector3<S>> span_of(Points<S>& points) {
  return {points.data(), static_cast<Index>(points.size())};
}

template <class S> Points<S> disc(const Plane<S>& plane, S radius, std::size_t count) {
  Points<S> points(count);
  sample_disc<S>(plane.center, plane.t, plane.o, radius, span_of(points));
  return points;
}

template <class S> Vector3<S> centroid(const Points<S>& points) {
  Vector3<S> sum = Vector3<S>::Zero();
  for (const Vector3<S>& p : points) sum += p;
  return sum / S(points.size());
}

template <class S> S smallest_distance(const Points<S>& points) {
  S smallest = S(1e9);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      smallest = std::min(smallest, (points[i] - points[j]).norm());
  return smallest;
}

} // namespace

TEST_CASE_TEMPLATE("a disc's points lie within it and in its plane, its centroid is its centre", S,
                   float, double) {
  const Plane<S> plane;
  const S radius = S(0.05);
  const S allowed = S(50) * std::numeric_limits<S>::epsilon();
  for (std::size_t k = 2; k <= 400; ++k) {
    CAPTURE(k);
    const Points<S> points = disc(plane, radius, k);
    for (const Vector3<S>& p : points) {
      CHECK((p - plane.center).norm() <= radius + allowed);
      CHECK(std::abs(plane.n.dot(p - plane.center)) <= allowed);
    }
    CHECK((centroid(points) - plane.center).norm() <= allowed);
  }
}

TEST_CASE("a disc's points are spread evenly: none closer than 40 % of the even spacing") {
  const Plane<double> plane;
  for (std::size_t k = 3; k <= 400; ++k) {
    CAPTURE(k);
    const double even_spacing = std::sqrt(3.14159265 / static_cast<double>(k));
    CHECK(smallest_distance(disc(plane, 1.0, k)) >= 0.4 * even_spacing);
  }
}

TEST_CASE("a disc resists rotation about every axis of its plane alike") {
  const Plane<double> plane;
  for (std::size_t k = 3; k <= 60; ++k) {
    CAPTURE(k);
    double along_t = 0, along_o = 0, mixed = 0;
    for (const Vector3<double>& p : disc(plane, 1.0, k)) {
      const double x = plane.t.dot(p - plane.center), y = plane.o.dot(p - plane.center);
      along_t += x * x, along_o += y * y, mixed += x * y;
    }
    CHECK(along_t == doctest::Approx(along_o).epsilon(1e-12));
    CHECK(std::abs(mixed) <= 1e-12 * along_t);
  }
}

TEST_CASE("a ring lies on its circle, starts along t and is centred, odd numbers included") {
  const Plane<double> plane;
  for (std::size_t k = 2; k <= 33; ++k) {
    CAPTURE(k);
    Points<double> points(k);
    sample_ring<double>(plane.center, plane.t, plane.o, 0.2, span_of(points));
    CHECK((points[0] - plane.center - 0.2 * plane.t).norm() <= 1e-15);
    CHECK((centroid(points) - plane.center).norm() <= 1e-15);
    const double side = 2 * 0.2 * std::sin(3.141592653589793 / static_cast<double>(k));
    CHECK(smallest_distance(points) == doctest::Approx(side).epsilon(1e-9));
    for (const Vector3<double>& p : points)
      CHECK((p - plane.center).norm() == doctest::Approx(0.2).epsilon(1e-13));
  }
}

TEST_CASE("a ring of four in the x-y plane has exact coordinates") {
  Points<double> points(4);
  sample_ring<double>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.005, span_of(points));
  CHECK(points[1] == Vector3<double>(0, 0.005, 0));
  CHECK(points[2] == Vector3<double>(-0.005, 0, 0));
}

TEST_CASE("a line runs from end to end in even steps; one point lies midway") {
  const Vector3<double> first(-1, 2, 0), last(3, 2, 8);
  for (std::size_t k = 2; k <= 9; ++k) {
    Points<double> points(k);
    sample_line<double>(first, last, span_of(points));
    CHECK(points.front() == first);
    CHECK(points.back() == last);
    CHECK((centroid(points) - (first + last) / 2).norm() <= 1e-14);
    const double step = (last - first).norm() / static_cast<double>(k - 1);
    CHECK(smallest_distance(points) == doctest::Approx(step));
  }
  Points<double> one(1);
  sample_line<double>(first, last, span_of(one));
  CHECK(one[0] == Vector3<double>(1, 2, 4));
}

TEST_CASE("a rectangle's grid includes its corners, t fastest") {
  const Vector3<double> center(1, 1, 0), t(1, 0, 0), o(0, 1, 0);
  Points<double> points(6);
  sample_rectangle<double>(center, t, o, 2.0, 4.0, 3, 2, span_of(points));
  CHECK(points[0] == Vector3<double>(0, -1, 0));
  CHECK(points[1] == Vector3<double>(1, -1, 0));
  CHECK(points[2] == Vector3<double>(2, -1, 0));
  CHECK(points[5] == Vector3<double>(2, 3, 0));
  CHECK(centroid(points) == center);
}

TEST_CASE(
    "the default tangent follows the axis least aligned with the normal, the first on a tie") {
  CHECK(default_tangent<double>({0, 0, -1}) == Vector3<double>(1, 0, 0));
  CHECK(default_tangent<double>({1, 0, 0}) == Vector3<double>(0, 1, 0));
  CHECK(default_tangent<double>({0, -1, 0}) == Vector3<double>(1, 0, 0));
  const Vector3<double> diagonal = Vector3<double>(1, 1, 1).normalized();
  CHECK((default_tangent<double>(diagonal) - Vector3<double>(2, -1, -1).normalized()).norm() <=
        1e-15);
  CHECK(default_tangent<double>({0.6, 0.8, 0}) == Vector3<double>(0, 0, 1));
}
