// The existence lemma's conditions as linear programs: on scenes where theory knows, and against
// what the pivots end in.
#include <doctest/doctest.h>

#include <algorithm>

#include "lcpush/mechanics/study/existence.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

struct Studied {
  Existence verdict;
  std::vector<double> witness;
};

Studied study(const SolvedPush<double>& push) {
  const ExistenceSize size = existence_size(push.assembly);
  std::vector<double> scalars(static_cast<std::size_t>(size.scalars()));
  std::vector<int> integers(static_cast<std::size_t>(size.integers()));
  Studied studied;
  studied.witness.resize(
      static_cast<std::size_t>(size_of(push.scene).forces() + size_of(push.scene).actuators));
  studied.verdict =
      study_existence<double>(push.assembly, size,
                              {{scalars.data(), static_cast<Index>(scalars.size())},
                               {integers.data(), static_cast<Index>(integers.size())}},
                              studied.witness.data());
  return studied;
}

Existence verdict(const Scene3& scene) { return study(SolvedPush<double>(scene)).verdict; }

/// A stop on the right and a pusher on the left of a part.
Scene3 stop_and_pusher(const Vec3& motion) {
  Scene3 scene = bare_scene(0.2, Vec3(2e-4, 2e-4, 2e-4), Vec3::Zero());
  scene.base.pressure = Pressure::rigid;
  scene.add_body(Role::finger, {-1, 0, 0}, 0.5, {{0.02, 0, 0}});
  scene.add_body(Role::pusher, {1, 0, 0}, 0.5, {{-0.02, 0, 0}});
  scene.bodies.back().acceleration.head<3>() = motion;
  return scene;
}

} // namespace

TEST_CASE("[T.8] fingers along their normals and one pusher: covered, whatever the push") {
  CHECK(verdict(straight_slide()) == Existence::proved);
  CHECK(verdict(rolling({})) == Existence::proved);
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    CHECK(verdict(random_grasp<double>(seed)) == Existence::proved);
  }
}

TEST_CASE("[T.8] a pusher towards a stop fails (H2), with a balanced squeeze that it tightens") {
  SolvedPush<double> push(stop_and_pusher({0.1, 0, 0}));
  const Studied studied = study(push);
  REQUIRE(studied.verdict == Existence::can_be_squeezed);
  Vector6<double> sum = Vector6<double>::Zero();
  double power = 0;
  for (Index j = 0; j < push.assembly.layout().forces; ++j) {
    const double f = studied.witness[static_cast<std::size_t>(j)];
    CHECK(f >= 0);
    const Vector6<double> wrench = f * push.assembly.factored().wrenches[j];
    sum += wrench;
    if (j >= push.assembly.layout().cones[1].force) power += wrench[0];
  }
  CHECK(sum.norm() <= 1e-9);
  CHECK(power > 0.5);
}

TEST_CASE("[T.8] a massless drive across its normal fails (H1); inertia mends it") {
  const auto dragged = [](double inertia) {
    Scene3 scene = bare_scene(0.2, Vec3(2e-4, 2e-4, 2e-4), Vec3::Zero());
    scene.add_body(Role::finger, {0, 0, -1}, 0.6, {{0, 0, 0.01}});
    scene.add_body(Role::finger, {0, 0, 1}, 0.6, {{0, 0, -0.01}});
    scene.drive_last_body(5);
    Vector6<double> J = Vector6<double>::Zero();
    J[0] = 1;
    scene.drives.push_back({0, 1, J});
    scene.actuators.push_back({1, inertia});
    return scene;
  };
  CHECK(verdict(dragged(0)) == Existence::closes_on_nothing);
  CHECK(verdict(dragged(0.1)) == Existence::proved);
}

TEST_CASE("[T.8] a stop opposite the push: every ray is one where the lemma promises nothing") {
  Index rays = 0, promised = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    OwnedScene<double> scene = random_grasp<double>(seed);
    const Vec3 at = scene.points.back();
    scene.add_body(Role::finger, {-1, 0, 0}, 0.3, {{-at[0], at[1], at[2]}});
    std::swap(scene.bodies[2], scene.bodies[3]); // points have to follow their bodies
    std::rotate(scene.points.begin() + scene.bodies[3].first_point, scene.points.end() - 1,
                scene.points.end());
    scene.bodies[2].first_point = scene.bodies[3].first_point;
    scene.bodies[3].first_point += 1;
    scene.base.pressure = Pressure::rigid;
    SolvedPush<double> push(scene);
    const Existence known = study(push).verdict;
    CHECK(known != Existence::not_known);
    const Status status = push.solve();
    if (status == Status::ray) ++rays;
    if (known == Existence::proved) ++promised;
    if (status == Status::ray) CHECK(known == Existence::can_be_squeezed);
  }
  MESSAGE(rays << " rays, " << promised << " promised");
  CHECK(rays > 5);
}
