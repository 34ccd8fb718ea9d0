// Hundreds of random grasps through the C interface: how many are answered, how well, in how many
// pivots.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "lcpush/mechanics/solve/breaking.hpp"
#include "support/c_grasp.hpp"
#include "support/seeds.hpp"
#include "support/solved_push.hpp"

namespace lcpush::test {

struct GraspCount {
  int solved = 0, unsolved = 0;
  std::vector<int> pivots; ///< of each that is solved, in order of size
  double worst = 0;
};

/// Of at most twelve points, in float, by a push with nothing known before each.
inline GraspCount solve_a_thousand(Pressure pressure, Index facets) {
  const Family family = pressure == Pressure::even ? Family::even : Family::plain;
  const int bodies = pressure == Pressure::even ? 24 : 12; // as given and point by point
  const lcpush_size most{bodies, 12, 8, bodies, bodies, 0};
  std::vector<double> memory(LCPUSH_BYTES(float, bodies, 12, 8, bodies, bodies) / sizeof(double) +
                             1);
  GraspCount count;
  int tried = 0;
  for (std::uint64_t seed = 1; tried < static_cast<int>(seeds(1000)); ++seed) {
    OwnedScene<float> owned = grasp_of<float>(family, seed);
    if (owned.points.size() > 12) continue;
    ++tried;
    CAPTURE(seed);
    owned.base.facets = facets;
    owned.base.pressure = pressure;
    const CGrasp grasp(owned);
    lcpushf_push* const push = described(memory, most, grasp);
    if (lcpushf_solve(push) != LCPUSH_SOLVED) continue;
    ++count.solved;
    count.pivots.push_back(lcpushf_pivots(push));
    const Violation violated = violation(grasp, push);
    const double worst = std::max(violated.newton, violated.cones_and_grip);
    CHECK(worst <= 2e-4);
    count.worst = std::max(count.worst, worst);
  }
  count.unsolved = tried - count.solved;
  std::sort(count.pivots.begin(), count.pivots.end());
  return count;
}

/// At least 995 of a thousand, and none of them wrong.
inline void check_a_thousand(Pressure pressure, Index facets) {
  CAPTURE(static_cast<int>(pressure));
  CAPTURE(facets);
  const GraspCount count = solve_a_thousand(pressure, facets);
  MESSAGE(facets << " facets, law " << static_cast<int>(pressure) << ": " << count.solved
                 << " solved, " << count.unsolved << " not, pivots median "
                 << count.pivots[count.pivots.size() / 2] << ", 99 % "
                 << count.pivots[count.pivots.size() * 99 / 100] << ", most " << count.pivots.back()
                 << ", worst violation " << count.worst);
  CHECK(count.unsolved <= 5);
}

inline Eigen::Vector3f push_force(const CGrasp& grasp, const lcpushf_push* push) {
  float wrench[6];
  lcpushf_wrench_of(push, grasp.scene.body_count - 1, wrench);
  return Eigen::Map<const Eigen::Vector3f>(wrench);
}
inline float median(std::vector<float> of) {
  std::sort(of.begin(), of.end());
  return of[of.size() / 2];
}

/// Of three hundred each is answered, gripped a tenth tighter, and told before that is solved: by
/// how much of the solved push the old one is off, and the one told, in the median.
inline void check_tighter_grips(Pressure pressure) {
  const Family family = pressure == Pressure::even ? Family::even : Family::plain;
  const lcpush_size most{48, 24, 4, 48, 48, 0};
  std::vector<double> memory(LCPUSH_BYTES(float, 48, 24, 4, 48, 48) / sizeof(double) + 1);
  std::vector<float> old_off, told_off;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    OwnedScene<float> owned = grasp_of<float>(family, seed);
    if (owned.points.size() > 24) continue;
    owned.base.facets = 4;
    owned.base.pressure = pressure;
    const CGrasp grasp(owned);
    lcpushf_push* const push = described(memory, most, grasp);
    if (lcpushf_solve(push) != LCPUSH_SOLVED) continue;
    const Eigen::Vector3f old = push_force(grasp, push);
    std::vector<float> tighter;
    for (const lcpushf_actuator& a : grasp.actuators) tighter.push_back(1.1F * a.force);
    REQUIRE(lcpushf_command(push, tighter.data(), nullptr) == LCPUSH_RUNNING);
    const Eigen::Vector3f told = push_force(grasp, push);
    if (lcpushf_solve(push) != LCPUSH_SOLVED) continue;
    const Eigen::Vector3f solved = push_force(grasp, push);
    if (!(solved.norm() > 0)) continue;
    old_off.push_back((old - solved).norm() / solved.norm());
    told_off.push_back((told - solved).norm() / solved.norm());
  }
  MESSAGE("law " << static_cast<int>(pressure) << ": a tenth more grip, " << old_off.size()
                 << " pushes: off by " << median(old_off) << " as they were, by "
                 << median(told_off) << " as told");
  CHECK(old_off.size() > 200);
  CHECK(median(told_off) < 0.5F * median(old_off));
}

/// Three hundred answered, then each with another grip and motion, cut off in the first tick:
/// forces are in their cones and press with the new grip, and where they do not balance it is told.
inline void check_commands_cut_off(Pressure pressure) {
  CAPTURE(static_cast<int>(pressure));
  const Family family = pressure == Pressure::even ? Family::even : Family::plain;
  const lcpush_size most{48, 24, 4, 48, 48, 0};
  std::vector<double> memory(LCPUSH_BYTES(float, 48, 24, 4, 48, 48) / sizeof(double) + 1);
  int cut = 0, balanced = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    OwnedScene<float> owned = grasp_of<float>(family, seed);
    if (owned.points.size() > 24) continue;
    owned.base.facets = 4;
    owned.base.pressure = pressure;
    CGrasp grasp(owned);
    for (lcpushf_actuator& a : grasp.actuators) // of an even finger's shares the mean is told
      a.inertia = pressure == Pressure::even ? 0 : a.force * static_cast<float>(seed % 3) * 2;
    std::vector<float> forces, motions;
    lcpushf_push* const push = described(memory, most, grasp);
    if (lcpushf_solve(push) != LCPUSH_SOLVED) continue;
    for (const lcpushf_body& body : grasp.bodies)
      for (const float x : body.acceleration) motions.push_back(2 * x);
    for (int tick = 0; tick < 3; ++tick) { // a tighter grip, or none; a looser one
      CAPTURE(seed);
      CAPTURE(tick);
      forces.clear();
      for (lcpushf_actuator& a : grasp.actuators) {
        const auto k = static_cast<float>(forces.size() + seed % 3);
        a.force = tick == 1 && seed % 5 == 0 ? 0 : a.force * (tick == 2 ? 0.3F : 1 + k) + k;
        forces.push_back(a.force);
      }
      REQUIRE(lcpushf_command(push, forces.data(), motions.data()) == LCPUSH_RUNNING);
      if (lcpushf_step_within(push, 1) != LCPUSH_RUNNING) continue;
      const Violation violated = violation(grasp, push);
      CHECK(violated.cones_and_grip <= 1e-5);
      if (violated.newton > 1e-2) CHECK(lcpushf_residual(push) > 1e-4F);
      balanced += violated.newton < 0.1 ? 1 : 0;
      ++cut;
    }
  }
  MESSAGE("law " << static_cast<int>(pressure) << ": " << cut << " commands cut off, in "
                 << balanced << " of them the forces balance to a tenth");
  CHECK(cut > 100);
}

/// Of grasps under round friction, those that do not settle: they are told over eight facets, and
/// by how much that misses the round cone's law.
inline void check_unsettled(Pressure pressure) {
  const lcpush_size most{12, 12, 8, 12, 12, 0};
  std::vector<double> memory(LCPUSH_BYTES(float, 12, 12, 8, 12, 12) / sizeof(double) + 1);
  int unsettled = 0, tried = 0, compared = 0, same = 0;
  for (std::uint64_t seed = 1; seed <= seeds(3000); ++seed) {
    OwnedScene<float> owned = grasp_of<float>(Family::plain, seed);
    if (owned.points.size() > 12) continue;
    owned.base.pressure = pressure;
    CGrasp grasp(owned);
    grasp.scene.facets = LCPUSH_ROUND;
    CAPTURE(seed);
    lcpushf_push* const push = described(memory, most, grasp);
    ++tried;
    if (lcpushf_solve(push) != LCPUSH_NOT_SETTLED) continue;
    ++unsettled;
    CHECK(lcpushf_age(push) == 0);
    CHECK(lcpushf_residual(push) > 9e-5F);
    const Violation violated = violation(grasp, push);
    CHECK(std::max(violated.newton, violated.cones_and_grip) <= 2e-4);
    // A command that ends it on the way is about round friction again.
    const int pivots = lcpushf_pivots(push);
    REQUIRE(lcpushf_describe(push, &grasp.scene) == LCPUSH_RUNNING);
    while (lcpushf_pivots(push) + 2 < pivots && lcpushf_step(push, 1) == LCPUSH_RUNNING) continue;
    std::vector<float> forces;
    for (lcpushf_actuator& a : grasp.actuators) forces.push_back(a.force *= 2);
    REQUIRE(lcpushf_command(push, forces.data(), nullptr) == LCPUSH_RUNNING);
    if (lcpushf_solve(push) != LCPUSH_SOLVED) continue;
    const Eigen::Vector3f commanded = push_force(grasp, push);
    REQUIRE(lcpushf_describe(push, &grasp.scene) == LCPUSH_RUNNING);
    if (lcpushf_solve(push) != LCPUSH_SOLVED) continue;
    const auto size = static_cast<float>(grasp.size());
    same += (commanded - push_force(grasp, push)).norm() <= 1e-2F * size ? 1 : 0;
    ++compared;
  }
  MESSAGE("law " << static_cast<int>(pressure) << ": " << unsettled << " of " << tried
                 << " do not settle; of " << compared << " commands " << same << " as described");
  CHECK(unsettled > 0);
  CHECK(same * 10 >= compared * 9);
}

/// Of grasps under `pad` whose fastest body has `ratio` of grip force over mass: in how many of a
/// hundred float's push is within a per cent of double's.
inline double within_a_per_cent(double ratio) {
  const lcpush_size most{12, 12, 8, 12, 12, 0};
  std::vector<double> memory(LCPUSH_BYTES(float, 12, 12, 8, 12, 12) / sizeof(double) + 1);
  int compared = 0, within = 0;
  for (std::uint64_t seed = 1; compared < 300; ++seed) {
    OwnedScene<double> in_double = grasp_of<double>(Family::plain, seed);
    if (in_double.points.size() > 12) continue;
    double fastest = 0, grip = 0;
    for (const Body<double>& body : in_double.bodies)
      fastest = std::max(fastest, body.acceleration.head<3>().norm());
    for (const Actuator<double>& a : in_double.actuators) grip = std::max(grip, a.force);
    const double factor = ratio * grip / in_double.base.object.mass / fastest;
    OwnedScene<float> owned = grasp_of<float>(Family::plain, seed);
    for (Body<double>& body : in_double.bodies) body.acceleration *= factor;
    for (Body<float>& body : owned.bodies) body.acceleration *= static_cast<float>(factor);
    owned.base.facets = in_double.base.facets = 4;
    owned.base.pressure = in_double.base.pressure = Pressure::pad;
    SolvedPush<double> expected(in_double);
    const CGrasp grasp(owned);
    lcpushf_push* const push = described(memory, most, grasp);
    REQUIRE(expected.solve() == Status::solved);
    ++compared;
    if (lcpushf_solve(push) != LCPUSH_SOLVED) continue;
    float found[6];
    const int pusher = grasp.scene.body_count - 1;
    lcpushf_wrench_of(push, pusher, found);
    const Vector3<double> force = expected.wrench(pusher).head<3>();
    const Vector3<double> off = Eigen::Map<const Eigen::Vector3f>(found).cast<double>() - force;
    within += off.norm() <= 0.01 * force.norm() ? 1 : 0;
  }
  return 100.0 * within / compared;
}

/// The limit of a vanishing push on the whole table in double.
inline Status break_in_double(const OwnedScene<double>& given, Breaking<double>& breaking,
                              double& size) {
  OwnedScene<double> owned = given.spread();
  const Scene<double> scene = owned.view();
  OwnedWorkspace<double> memory = workspace_for<Lemke<double>>(scene);
  Assembly<double> assembly(memory.work.assembly);
  REQUIRE(assembly.assemble(scene) == Status::running);
  size = assembly.layout().scales.force;
  Lemke<double> lemke(memory.work.lemke_scalars, memory.work.lemke_integers);
  PressureRun run;
  return find_breaking(assembly, LemkeRounds{lemke}, memory.work,
                       scene.bodies[scene.bodies.size - 1], PressureOptions<double>(), breaking,
                       run);
}

/// Of some hundred grasps every one breaks in float or does not hold; nearly always as in double,
/// and mostly with the same force: the laws may leave several.
inline void check_breaks(Pressure pressure) {
  const Family family = pressure == Pressure::even ? Family::even : Family::plain;
  const lcpush_size most{24, 12, 8, 24, 24, 0};
  std::vector<double> memory(LCPUSH_BYTES(float, 24, 12, 8, 24, 24) / sizeof(double) + 1);
  lcpushf_push* const push = lcpushf_make(memory.data(), memory.size() * sizeof(double), &most);
  REQUIRE(push != nullptr);
  int tried = 0, ended = 0, agreed = 0, broken = 0, same = 0;
  for (std::uint64_t seed = 1; seed <= seeds(180); ++seed) {
    OwnedScene<float> owned = grasp_of<float>(family, seed);
    OwnedScene<double> in_double = grasp_of<double>(family, seed);
    if (owned.points.size() > 12) continue;
    CAPTURE(seed);
    owned.base.facets = in_double.base.facets = 4;
    owned.base.pressure = in_double.base.pressure = pressure;
    const CGrasp grasp(owned);
    lcpushf_breaking breaking;
    REQUIRE(lcpushf_describe(push, &grasp.scene) == LCPUSH_RUNNING);
    const lcpush_status status = lcpushf_break_grasp(push, grasp.scene.body_count - 1, &breaking);
    Breaking<double> exact;
    double size = 0;
    const Status expected = break_in_double(in_double, exact, size);
    const bool holds = status == LCPUSH_SOLVED;
    ++tried;
    ended += holds || status == LCPUSH_DOES_NOT_HOLD ? 1 : 0;
    agreed += holds == (expected == Status::solved) ? 1 : 0;
    if (!holds || expected != Status::solved) continue;
    ++broken;
    const double off = std::abs(static_cast<double>(breaking.break_force) - exact.break_force);
    same += off <= 5e-3 * size ? 1 : 0;
  }
  CAPTURE(static_cast<int>(pressure));
  MESSAGE("law " << static_cast<int>(pressure) << ": " << tried << " grasps, " << ended
                 << " break or do not hold, " << agreed << " as in double; " << broken << " break, "
                 << same << " at the same force");
  CHECK(ended >= tried - 1);
  CHECK(agreed >= tried - 4);
  // A tenth of the grasps, under sanitizers, is too few for shares of them.
  if (is_sanitized) return;
  CHECK(tried > 100);
  CHECK(broken > 40);
  CHECK(same * 10 >= broken * 7);
}

} // namespace lcpush::test
