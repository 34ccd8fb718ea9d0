// [T.19] on devices: least and most grip and margins in bounded steps, against closed forms and the
// desktop's cone programs, which share no solver with them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lcpush/mechanics/study/holding.hpp"
#include "solve/grip_statics.hpp"
#include "support/grasp_families.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr Index many = 1000;

/// A scene with the program's memory.
template <class S> struct HeldScene {
  OwnedScene<S> owned;
  Scene<S> scene;
  OwnedWorkspace<S> memory;
  Assembly<S> assembly;
  std::vector<unsigned char> bytes;

  explicit HeldScene(const OwnedScene<S>& given)
      : owned(given.spread()), scene(owned.view()), memory(workspace_for<Lemke<S>>(scene)),
        assembly(memory.work.assembly) {
    REQUIRE(assembly.assemble(scene) == Status::running);
    bytes.resize(static_cast<std::size_t>(holding_bytes<S>(scene.actuators.size)));
  }
  Arena arena() { return {bytes.data(), static_cast<Index>(bytes.size())}; }
};

/// Its fingers as a file of the desktop.
desktop::SceneFile hand_of(const OwnedScene<double>& owned) {
  desktop::SceneFile file;
  file.object = owned.base.object;
  file.gravity = owned.base.gravity;
  file.facets = owned.base.facets;
  file.pressure = owned.base.pressure;
  file.planar = owned.base.planar;
  file.actuators = owned.actuators;
  for (std::size_t b = 0; b < owned.bodies.size(); ++b) {
    Body<double> body = owned.bodies[b];
    if (body.role == Role::pusher) continue;
    for (Drive<double> drive : owned.drives) {
      if (drive.body != static_cast<Index>(b)) continue;
      drive.body = static_cast<Index>(file.bodies.size());
      file.drives.push_back(drive);
    }
    body.first_point = static_cast<Index>(file.points.size());
    for (const Index i : points_of(owned.bodies[b])) {
      file.points.push_back(owned.points[static_cast<std::size_t>(i)]);
      if (!owned.weights.empty())
        file.weights.push_back(owned.weights[static_cast<std::size_t>(i)]);
    }
    file.bodies.push_back(body);
  }
  return file;
}

/// The program's c x at its best; nan: it failed.
double optimum(desktop::StaticsProgram& program, double c) {
  using Ending = desktop::StaticsProgram::Ending;
  const auto best = program.minimise(Eigen::VectorXd::Constant(1, c));
  if (best.ending == Ending::unlimited) return std::numeric_limits<double>::infinity();
  return best.ending == Ending::found ? c * best.value : std::nan("");
}

/// The desktop's least and most factor and margin; empty: none holds.
struct Expected {
  std::vector<double> grips, margin;

  Expected(const OwnedScene<double>& owned, const Vector6<double>& wrench) {
    using Ending = desktop::StaticsProgram::Ending;
    const desktop::SceneFile file = hand_of(owned);
    const desktop::GripStatics statics(file);
    desktop::StaticsProgram grip(statics, statics.grip_column(), 0, statics.load(0));
    if (grip.find_point() != Ending::none) {
      grips.push_back(optimum(grip, 1));
      grips.push_back(optimum(grip, -1));
    }
    const Eigen::MatrixXd column = statics.wrench_column(wrench) / statics.scales().force;
    desktop::StaticsProgram load(statics, 0 * column, 1, statics.load(1)),
        beside(statics, column, 1, statics.load(1));
    if (load.find_point() != Ending::none && beside.find_point() == Ending::found)
      margin.push_back(optimum(beside, -1));
  }
};

struct Count {
  int asked = 0, known = 0;
  double worst = 0; ///< of values' relative errors
  Index exchanges = 0;

  template <class S>
  void judge(const std::vector<double>& expected, std::size_t k, const Held<S>& held) {
    ++asked;
    exchanges = std::max(exchanges, held.exchanges);
    if (held.status == Status::numerical_breakdown) return;
    ++known;
    REQUIRE(held.status == (expected.empty() ? Status::does_not_hold : Status::solved));
    if (expected.empty()) return;
    const auto value = static_cast<double>(held.value);
    REQUIRE(std::isfinite(value) == std::isfinite(expected[k]));
    if (std::isfinite(value))
      worst = std::max(worst, std::abs(value - expected[k]) / std::max(1e-3, expected[k]));
  }

  template <class S>
  void ask(Family family, std::uint64_t seed, const Expected& expected,
           const Vector6<double>& wrench) {
    OwnedScene<S> owned = grasp_of<S>(family, seed);
    if (owned.base.pressure == Pressure::pad) owned.base.pressure = Pressure::rigid;
    HeldScene<S> held(owned);
    Holding<S> holding(held.assembly, held.arena());
    judge(expected.grips, 0, holding.least_grip(many));
    judge(expected.grips, 1, holding.most_grip(many));
    judge(expected.margin, 0, holding.margin(wrench.cast<S>(), many));
  }
};

/// A block of 1 N between two points on z, of friction 1/2, in fingers of 20 N.
template <class S> OwnedScene<S> pinch() {
  OwnedScene<S> scene;
  scene.base.object.mass = S(1);
  scene.base.object.inertia = Matrix3<S>::Identity();
  scene.base.gravity = {S(0), S(-1), S(0)};
  scene.base.facets = 4;
  scene.base.pressure = Pressure::pad;
  for (const S side : {S(1), S(-1)}) {
    scene.add_body(Role::finger, {S(0), S(0), -side}, S(0.5), {{S(0), S(0), side / S(64)}});
    scene.drive_last_body(S(20));
  }
  return scene;
}

template <class S> Vector6<S> force(S x, S y, S z) {
  Vector6<S> wrench = Vector6<S>::Zero();
  wrench.template head<3>() << x, y, z;
  return wrench;
}

} // namespace

TEST_CASE_TEMPLATE("a pinch holds with mu F at each finger", S, double, float) {
  HeldScene<S> held(pinch<S>());
  Holding<S> holding(held.assembly, held.arena());
  const S digits = S(100) * std::numeric_limits<S>::epsilon();
  const Held<S> least = holding.least_grip(many);
  CHECK(least.status == Status::solved);
  CHECK(std::abs(least.value - S(1) / S(20)) < digits);
  CHECK(least.twist[1] < S(0)); // it slips down, and may roll about a finger
  const Held<S> most = holding.most_grip(many);
  CHECK(most.status == Status::solved);
  CHECK(std::isinf(most.value));
  CHECK(most.twist.isZero(0));
  CHECK(std::abs(holding.margin(force<S>(0, -1, 0), many).value - S(19)) < S(20) * digits);
  CHECK(std::abs(holding.margin(force<S>(0, 2, 0), many).value - S(10.5)) < S(20) * digits);
  CHECK(std::abs(holding.margin(force<S>(1, 0, 0), many).value - S(19)) <
        S(20) * digits); // |x| + |y|
  Vector6<S> about_the_fingers = Vector6<S>::Zero();
  about_the_fingers[5] = S(1);
  const Held<S> turn = holding.margin(about_the_fingers, many);
  CHECK(turn.status == Status::solved);
  CHECK(turn.value < digits);
  CHECK(std::isinf(holding.margin(force<S>(0, 0, 0), many).value));
}

TEST_CASE("nothing holds what no contact resists, and its motion shows that") {
  OwnedScene<double> smooth = pinch<double>();
  for (Body<double>& body : smooth.bodies) body.friction = 0;
  HeldScene<double> held(smooth);
  Holding<double> holding(held.assembly, held.arena());
  for (const Held<double>& falls : {holding.least_grip(many), holding.most_grip(many),
                                    holding.margin(force<double>(0, 1, 0), many)}) {
    CHECK(falls.status == Status::does_not_hold);
    CHECK(falls.twist[1] < 0);
    Vector6<double> scaled = falls.twist;
    scaled.tail<3>() *= held.assembly.layout().scales.length;
    CHECK(scaled.cwiseAbs().maxCoeff() == doctest::Approx(1));
  }
}

TEST_CASE("a harder grip may hold less: a finger pushes a block on a table") {
  OwnedScene<double> block = pinch<double>();
  block.bodies.clear();
  block.points.clear();
  block.drives.clear();
  block.actuators.clear();
  block.base.pressure = Pressure::rigid;
  block.add_body(Role::finger, {0, 1, 0}, 0.25,
                 {{-1, -1, -1}, {1, -1, -1}, {-1, -1, 1}, {1, -1, 1}});
  block.add_body(Role::finger, {1, 0, 0}, 0, {{-1, -1, 0}});
  block.drive_last_body(2);
  HeldScene<double> held(block);
  Holding<double> holding(held.assembly, held.arena());
  CHECK(holding.least_grip(many).value == 0);
  CHECK(holding.most_grip(many).value == doctest::Approx(0.125)); // mu W / F
  CHECK(holding.margin(force<double>(-1, 0, 0), many).status == Status::does_not_hold);
}

TEST_CASE("locked jaws bear any squeeze, and a load across by what that gives") {
  OwnedScene<double> vise = pinch<double>();
  vise.drives.clear();
  vise.actuators.clear();
  vise.base.pressure = Pressure::rigid;
  HeldScene<double> held(vise);
  Holding<double> holding(held.assembly, held.arena());
  for (const Held<double>& any : {holding.margin(force<double>(0, -1, 0), many),
                                  holding.margin(force<double>(0, 0, 3), many)}) {
    CHECK(any.status == Status::solved);
    CHECK(std::isinf(any.value));
  }
}

TEST_CASE("grips and margins of 540 random grasps are the desktop's cone programs'") {
  Count in_double, in_float;
  for (const Family family :
       {Family::plain, Family::planar, Family::even, Family::soft, Family::parallel, Family::stop,
        Family::jacobian, Family::weighted, Family::locked})
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      CAPTURE(static_cast<int>(family));
      CAPTURE(seed);
      OwnedScene<double> owned = grasp_of<double>(family, seed);
      if (owned.base.pressure == Pressure::pad) owned.base.pressure = Pressure::rigid;
      Random random(seed);
      Vector6<double> wrench;
      for (Index k = 0; k < 6; ++k) wrench[k] = random.uniform(-1, 1) * (k < 3 ? 1 : 0.02);
      const Expected expected(owned, wrench);
      in_double.ask<double>(family, seed, expected, wrench);
      in_float.ask<float>(family, seed, expected, wrench);
    }
  MESSAGE("double off by " << in_double.worst << ", float " << in_float.worst << ", "
                           << in_float.asked - in_float.known << " not known, at most "
                           << in_double.exchanges << " exchanges");
  CHECK(in_double.known == in_double.asked);
  CHECK(in_double.worst < 1e-9);
  CHECK(in_float.known >= in_float.asked - 3);
  CHECK(in_float.worst < 1e-3);
  CHECK(std::max(in_double.exchanges, in_float.exchanges) < 80);
}

TEST_CASE("a question takes no more exchanges than it may") {
  OwnedScene<double> owned = grasp_of<double>(Family::stop, 98);
  owned.base.pressure = Pressure::rigid;
  HeldScene<double> held(owned);
  Holding<double> holding(held.assembly, held.arena());
  const Held<double> least = holding.least_grip(many);
  REQUIRE(least.status == Status::solved);
  REQUIRE(least.exchanges > 8);
  for (Index most = 0; most < least.exchanges; ++most) {
    const Held<double> cut = holding.least_grip(most);
    CHECK(cut.status == Status::pivot_limit);
    CHECK(cut.exchanges == most);
  }
  CHECK(holding.least_grip(least.exchanges).value == least.value);
}

TEST_CASE("what a linear program does not answer is refused") {
  OwnedScene<double> owned = pinch<double>();
  const auto refusal = [&](Index bytes) {
    HeldScene<double> held(owned);
    Holding<double> holding(held.assembly, {held.bytes.data(), bytes});
    const Held<double> least = holding.least_grip(many),
                       margin = holding.margin(force<double>(1, 0, 0), many);
    CHECK(least.status == margin.status);
    CHECK(least.reason == margin.reason);
    return least.reason;
  };
  const Index enough = holding_bytes<double>(2);
  CHECK(refusal(enough) == Reason::none);
  CHECK(refusal(enough / 2) == Reason::memory_too_small);
  CHECK(refusal(0) == Reason::memory_too_small);
  owned.drives.clear(); // locked: under `pad` they press as their preload and the load make them
  owned.actuators.clear();
  CHECK(refusal(enough) == Reason::unsupported);
  owned = grasp_of<double>(Family::plain, 3);
  CHECK(refusal(enough) == Reason::unsupported); // patches of pads
  owned.base.pressure = Pressure::rigid;
  CHECK(refusal(enough) == Reason::none);
}
