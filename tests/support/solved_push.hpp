// One push from scene to answer, everything owned: for tests that look at answers.
#pragma once

#include "lcpush/mechanics/solve/breaking.hpp"
#include "support/random_grasp.hpp"

namespace lcpush::test {

template <class S, class Pivots = Lemke<S>> struct SolvedPush {
  OwnedScene<S> owned;
  Scene<S> scene;
  OwnedWorkspace<S> memory;
  Assembly<S> assembly;
  Pivots lemke;
  PressureOptions<S> options{};
  PressureRun run;
  Status status = Status::bad_input;
  Residuals<S> residuals;

  /// `is_round`: friction is, beginning with the scene's facets.
  explicit SolvedPush(const OwnedScene<S>& given, bool is_round = false)
      : owned(given.spread()), scene(owned.view()), memory(workspace_for<Pivots>(scene)),
        assembly(memory.work.assembly),
        lemke(memory.work.lemke_scalars, memory.work.lemke_integers) {
    if (is_round) scene.round_cones = {memory.work.round_cones.data, scene.points.size};
    assembly.assemble(scene);
  }
  SolvedPush(const SolvedPush&) = delete;
  SolvedPush& operator=(const SolvedPush&) = delete;

  /// Solves for the push scaled by sigma and reads the answer.
  Status solve(S sigma = S(1)) {
    assembly.push_by(sigma);
    status = solve_pressure(assembly, LemkeRounds{lemke}, memory.work.pressure, options, run,
                            memory.work.friction_memory(scene));
    if (status != Status::solved) return status;
    read_answer(assembly, memory.work.pressure.z.data, memory.work.answer, sigma);
    residuals = check(scene, scales(), answer(), sigma);
    return status;
  }

  const Answer<S>& answer() const { return memory.work.answer; }
  const Scales<S>& scales() const { return assembly.layout().scales; }
  Vector6<S> wrench(Index body) const { return body_wrench(scene, answer(), scene.bodies[body]); }
  S normal_force(Index body) const {
    S sum(0);
    for (const ContactAnswer<S>& contact : answer().contacts)
      if (contact.body == body) sum += contact.normal_force;
    return sum;
  }
};

} // namespace lcpush::test
