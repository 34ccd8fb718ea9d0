// How an assembly is brought up to date; that its rows are the laws: paper/test_full_form.cpp, and
// check.hpp of every answer.
#include <doctest/doctest.h>

#include <algorithm>

#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// Are they the same numbers, bit by bit?
bool same_assembly(const Assembly<double>& a, const Assembly<double>& b) {
  const FactoredProblem<double>&x = a.factored(), &y = b.factored();
  const Layout<double>&l = a.layout(), &m = b.layout();
  const Problem<double> p = a.problem(), q = b.problem();
  bool same = l.size == m.size && l.points == m.points && x.mobility == y.mobility &&
              a.load() == b.load() && l.scales.force == m.scales.force &&
              l.scales.length == m.scales.length && l.scales.acceleration == m.scales.acceleration;
  for (Index i = 0; same && i < l.forces; ++i) same = x.wrenches[i] == y.wrenches[i];
  for (Index i = 0; same && i < l.points; ++i)
    same = x.cones[i].friction == y.cones[i].friction &&
           x.cones[i].compliance == y.cones[i].compliance;
  for (Index k = 0; same && k < x.sums.size; ++k) {
    const SumGroup<double>&s = x.sums[k], &t = y.sums[k];
    same = s.target == t.target && s.inertia == t.inertia && s.count == t.count;
    for (Index e = s.first; same && e < s.first + s.count; ++e)
      same = x.coupling[e] == y.coupling[e] && x.coupled_variable[e] == y.coupled_variable[e];
  }
  return same && std::equal(p.q, p.q + p.size, q.q);
}

} // namespace

TEST_CASE("a command leaves what a fresh assembly makes of the scene, bit by bit") {
  for (const Family family :
       {Family::plain, Family::planar, Family::even, Family::soft, Family::bilateral,
        Family::parallel, Family::jacobian, Family::weighted, Family::locked})
    for (const bool is_round : {false, true})
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        CAPTURE(static_cast<int>(family));
        CAPTURE(seed);
        SolvedPush<double> push(grasp_of<double>(family, seed), is_round);
        (void)push.solve(); // which changes compliances and right-hand sides
        for (Actuator<double>& actuator : push.owned.actuators) actuator.force *= 1.7;
        for (Body<double>& body : push.owned.bodies) {
          body.acceleration = -0.3 * body.acceleration;
          body.preload *= 2;
        }
        push.scene.gravity += Vector3<double>(0.1, 2, -0.3);
        push.scene.object.wrench[1] += 0.5;
        push.assembly.command();
        OwnedWorkspace<double> fresh(workspace_for<Lemke<double>>(push.scene));
        Assembly<double> assembly(fresh.work.assembly);
        REQUIRE(assembly.assemble(push.scene) == Status::running);
        CHECK(same_assembly(push.assembly, assembly));
        push.assembly.push_by(0.5); // what the motions add, too
        assembly.push_by(0.5);
        CHECK(same_assembly(push.assembly, assembly));
      }
}

TEST_CASE("[T.5] an actuator's couplings ascend, whatever the order and the parts of its drives") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Scene3 scene = grasp_of<double>(Family::parallel, seed);
    SolvedPush<double> given(scene);
    REQUIRE(scene.drives.size() > scene.actuators.size()); // a jaw drives two fingers
    std::reverse(scene.drives.begin(), scene.drives.end());
    scene.drives.front().twist /= 2;
    scene.drives.push_back(scene.drives.front());
    SolvedPush<double> other(scene);
    const FactoredProblem<double>&first = given.assembly.factored(),
          &second = other.assembly.factored();
    for (Index a = 0; a < first.sums.size; ++a) {
      const SumGroup<double>&sum = first.sums[a], &same = second.sums[a];
      REQUIRE(same.count == sum.count);
      for (Index k = 0; k < sum.count; ++k) {
        const Index variable = second.coupled_variable[same.first + k];
        CHECK(variable == first.coupled_variable[sum.first + k]);
        CHECK(second.coupling[same.first + k] ==
              doctest::Approx(first.coupling[sum.first + k]).epsilon(1e-14));
        if (k > 0) CHECK(variable > second.coupled_variable[same.first + k - 1]);
      }
    }
  }
}
