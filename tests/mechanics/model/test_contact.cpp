// Friction generators: exact where a circle is exact.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

#include "lcpush/mechanics/model/contact.hpp"
#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

template <class S> Body<S> body_with(const Vector3<S>& direction) {
  Body<S> body{};
  body.normal = direction.normalized();
  body.tangent = default_tangent<S>(body.normal);
  body.friction = S(0.5);
  return body;
}

} // namespace

TEST_CASE_TEMPLATE("multiples of 90 degrees are exactly 0 and +-1", S, float, double) {
  for (Index g = 4; g <= 256; g += 4)
    for (Index quarter = 0; quarter < 4; ++quarter) {
      const Index j = quarter * g / 4;
      CHECK(circle_cosine<S>(j, g) == (quarter == 0 ? S(1) : quarter == 2 ? S(-1) : S(0)));
      CHECK(circle_sine<S>(j, g) == (quarter == 1 ? S(1) : quarter == 3 ? S(-1) : S(0)));
    }
}

TEST_CASE_TEMPLATE("opposite generators are exact negatives, for every even g", S, float, double) {
  const Body<S> body = body_with<S>({S(1), S(-2), S(3)});
  for (Index g = 4; g <= 256; g += 2)
    for (Index j = 0; j < g / 2; ++j)
      CHECK(generator(body, j, g).force == -generator(body, (j + g / 2) % g, g).force);
}

TEST_CASE_TEMPLATE("in a plane friction acts along it, forth and back; other bodies keep theirs", S,
                   float, double) {
  const S allowed = S(8) * Eigen::NumTraits<S>::epsilon();
  for (int degrees = 0; degrees < 360; degrees += 15) {
    Body<S> body =
        body_with<S>({circle_cosine<S>(degrees, 360), circle_sine<S>(degrees, 360), S(0)});
    body.torsion_radius = S(0.01);
    lie_in_plane(body);
    CHECK(body.in_plane);
    CHECK(facets_of(body, 8) == 2);
    CHECK(body.torsion_radius == S(0));
    const Vector3<S> forth = generator(body, 0, 8).force;
    CHECK(forth[2] == S(0));
    CHECK(forth == -generator(body, 1, 8).force);
    CHECK(std::abs(forth.norm() - S(1)) <= allowed);
    CHECK(std::abs(forth.dot(body.normal)) <= allowed);
  }
  for (const Vector3<S>& n : {Vector3<S>(S(0), S(0), S(-1)), Vector3<S>(S(1), S(0), S(0.01))}) {
    Body<S> body = body_with<S>(n);
    lie_in_plane(body);
    CHECK_FALSE(body.in_plane);
    CHECK(facets_of(body, 8) == 8);
  }
}

TEST_CASE_TEMPLATE("mirrored directions have the same bits", S, float, double) {
  for (Index g = 4; g <= 64; g += 2)
    for (Index j = 0; j < g; ++j) {
      CHECK(circle_cosine<S>(j, g) == circle_cosine<S>(g - j, g));
      CHECK(circle_sine<S>(j, g) == -circle_sine<S>(g - j, g));
      CHECK(circle_cosine<S>(j + g, g) == circle_cosine<S>(j, g));
    }
}

TEST_CASE_TEMPLATE("generators are unit vectors in the contact plane, the first along t, turning "
                   "towards o = n x t",
                   S, float, double) {
  const S allowed = S(8) * Eigen::NumTraits<S>::epsilon();
  for (const Vector3<S>& n : {Vector3<S>(S(0), S(0), S(1)), Vector3<S>(S(-1), S(0), S(0)),
                              Vector3<S>(S(1), S(-2), S(3))}) {
    const Body<S> body = body_with<S>(n);
    for (const Index g : {4, 6, 8, 14, 256}) {
      for (Index j = 0; j < g; ++j) {
        const Vector3<S> d = generator(body, j, g).force;
        CHECK(std::abs(d.norm() - S(1)) <= allowed);
        CHECK(std::abs(d.dot(body.normal)) <= allowed);
      }
      CHECK(generator(body, 0, g).force == body.tangent);
      CHECK(generator(body, 1, g).force.dot(cross(body.normal, body.tangent)) > S(0));
    }
  }
}

TEST_CASE("a contact without friction has no generators") {
  Scene<double> scene{};
  scene.facets = 8;
  Body<double> body = body_with<double>({0, 0, 1});
  CHECK(generator_count(scene, body) == 8);
  body.friction = 0;
  CHECK(generator_count(scene, body) == 0);
}

TEST_CASE("a wrench column's power is the force along u times the point's acceleration") {
  Random random(2);
  for (int k = 0; k < 50; ++k) {
    const Vector3<double> p = random_vector(random, 3), u = random_vector(random, 3);
    const Vector6<double> twist = random_vector(random, 6);
    CHECK(wrench_column<double>(p, u).dot(twist) ==
          doctest::Approx(u.dot(acceleration_at(p, twist))));
    CHECK((cross<double>(p, u) - p.cross(u)).norm() <= 1e-15);
  }
}

TEST_CASE_TEMPLATE("a normal that is a rounding error off an axis has the axis' tangent", S, float,
                   double) {
  const S eps = Eigen::NumTraits<S>::epsilon();
  for (Index along = 0; along < 3; ++along)
    for (const S sign : {S(1), S(-1)}) {
      const Vector3<S> axis = sign * Vector3<S>::Unit(along);
      const Index chosen = least_aligned_axis<S>(axis);
      CHECK(chosen == (along == 0 ? 1 : 0)); // the first of the two that are as little aligned
      for (const S off : {S(1e-17), eps / 2, eps, S(4) * eps})
        for (Index k = 0; k < 27; ++k) {
          Vector3<S> tilted = axis + off * Vector3<S>(S(k % 3 - 1), S(k / 3 % 3 - 1), S(k / 9 - 1));
          tilted.normalize();
          CHECK(least_aligned_axis<S>(tilted) == chosen);
          const Vector3<S> turned = default_tangent<S>(tilted) - default_tangent<S>(axis);
          CHECK(turned.norm() <= S(16) * eps);
        }
    }
  // What is further off than rounding is another normal.
  CHECK(least_aligned_axis<S>(Vector3<S>(S(1e-3), S(0), S(1)).normalized()) == 1);
}

TEST_CASE("a double's normal may be off by a picometre a metre") {
  CHECK(least_aligned_axis<double>({1e-17, 0, 1}) == 0);
  CHECK(least_aligned_axis<double>({1e-12, 0, 1}) == 0);
  CHECK(least_aligned_axis<double>({0, 1e-12, 1}) == 0);
  CHECK(least_aligned_axis<double>({1, 1e-12, 0}) == 1);
}
