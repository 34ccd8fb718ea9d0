// [T.8] What a ray proves and what it does not, from rays written by hand.
#include <doctest/doctest.h>

#include "lcpush/mechanics/study/jam.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A stop on the right, a pusher on the left that moves by `motion`, a driven finger above.
template <class S> OwnedScene<S> jam_scene(S motion) {
  OwnedScene<S> scene;
  scene.base.object.mass = S(0.2);
  scene.base.object.inertia = S(2e-4) * Matrix3<S>::Identity();
  scene.base.object.center_of_mass.setZero();
  scene.base.gravity.setZero();
  scene.base.facets = 4;
  scene.base.pressure = Pressure::rigid;
  scene.add_body(Role::finger, {-1, 0, 0}, S(0.5), {{S(0.02), 0, 0}});
  scene.add_body(Role::pusher, {1, 0, 0}, S(0.5), {{S(-0.02), 0, 0}});
  scene.bodies.back().acceleration[0] = motion;
  scene.add_body(Role::finger, {0, 0, -1}, S(0.5), {{0, 0, S(0.01)}});
  scene.drive_last_body(S(5));
  return scene;
}

enum Part : Index { stop, wall, finger };

/// A ray by hand.
template <class S> struct Ray {
  SolvedPush<S> push;
  std::vector<S> v;
  std::vector<Squeeze<S>> bodies;

  explicit Ray(const OwnedScene<S>& scene)
      : push(scene), v(static_cast<std::size_t>(layout().size)), bodies(scene.bodies.size()) {}
  const Layout<S>& layout() const { return push.assembly.layout(); }
  S& entry(Index i) { return v[static_cast<std::size_t>(i)]; }
  const Squeeze<S>& body(Index b) const { return bodies[static_cast<std::size_t>(b)]; }
  RaySum<S> read() {
    return read_ray<S>(push.assembly, v.data(), {bodies.data(), static_cast<Index>(bodies.size())});
  }
};

/// The stop and the wall press with a unit force each.
template <class S> struct Pressed : Ray<S> {
  explicit Pressed(const OwnedScene<S>& scene) : Ray<S>(scene) {
    for (const Index b : {stop, wall}) this->entry(this->layout().normal_index(b)) = S(1);
  }
};

} // namespace

TEST_CASE_TEMPLATE("[T.8] a balanced squeeze that a motion tightens proves that there is no answer",
                   S, float, double) {
  Pressed<S> ray(jam_scene(S(0.1)));
  const RaySum<S> sum = ray.read();
  CHECK(sum.proves_no_answer());
  CHECK(sum.power == doctest::Approx(static_cast<double>(sum.motion)));
  CHECK(ray.body(wall).power > S(0));
  CHECK(ray.body(stop).normal == S(1));
  CHECK(ray.body(finger).normal == S(0));
}

TEST_CASE("[T.8] a ray proves nothing if the motion rests or loosens it") {
  for (const double motion : {0.0, -0.1}) {
    CAPTURE(motion);
    CHECK_FALSE(Pressed<double>(jam_scene(motion)).read().proves_no_answer());
  }
}

TEST_CASE("[T.8] a ray proves nothing if friction takes part or an actuator feels it") {
  Pressed<double> rubs(jam_scene(0.1));
  for (const Index b : {stop, wall})
    for (const Index j : {0, 2})
      rubs.entry(rubs.layout().friction_index(b, j)) = 0.1; // each balanced
  const RaySum<double> with_friction = rubs.read();
  CHECK(with_friction.imbalance <= with_friction.noise);
  CHECK(with_friction.friction == doctest::Approx(0.4));
  CHECK_FALSE(with_friction.proves_no_answer());

  Scene3 driven = jam_scene(0.1);
  Vector6<double> closing = Vector6<double>::Zero();
  closing[0] = -1;
  driven.drives.push_back({stop, 1, closing});
  driven.actuators.push_back({1, 0});
  const RaySum<double> with_load = Pressed<double>(driven).read();
  CHECK(with_load.load == doctest::Approx(1));
  CHECK_FALSE(with_load.proves_no_answer());
}

TEST_CASE("[T.8] forces that do not balance prove nothing, but the plane takes what leans out") {
  Scene3 scene = jam_scene(0.1);
  Ray<double> one(scene);
  one.entry(one.layout().normal_index(wall)) = 1;
  CHECK(one.read().imbalance == doctest::Approx(1));
  CHECK_FALSE(one.read().proves_no_answer());

  scene.base.planar = true;
  scene.add_body(Role::pusher, {0, 0, -1}, 0.5, {{0, 0, 0.01}});
  scene.bodies.back().acceleration[2] = -0.1;
  Ray<double> planar(scene);
  planar.entry(planar.layout().normal_index(finger + 1)) = 1;
  CHECK(planar.read().proves_no_answer());
}
