// Every engine that answers a push, behind one name: for tests that hold all of them to the laws.
#pragma once

#include <type_traits>

#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "support/random_grasp.hpp"

namespace lcpush::test {

enum class Engine {
  dense,        ///< Lemke on the whole dictionary
  structured,   ///< Lemke, O(points) a pivot
  small,        ///< the same as devices have it: short integers, arrays that share their memory
  predicted,    ///< structured, from the modes that one expects
  gauss_seidel, ///< block by block, accelerated
  hybrid,       ///< sweeps, finished by pivots on the dictionary
};
constexpr const char* engine_names[] = {"dense",     "structured",   "small",
                                        "predicted", "gauss_seidel", "hybrid"};
constexpr std::size_t engine_count = std::size(engine_names);

template <Engine engine> using Choice = std::integral_constant<Engine, engine>;
/// act(Choice<engine>()) for each of them.
template <class Act> void for_every_engine(const Act& act) {
  act(Choice<Engine::dense>());
  act(Choice<Engine::structured>());
  act(Choice<Engine::small>());
  act(Choice<Engine::predicted>());
  act(Choice<Engine::gauss_seidel>());
  act(Choice<Engine::hybrid>());
}

/// What an engine makes of a push, with the laws' residuals of its answer.
template <class S, Engine engine> struct EnginePush {
  OwnedScene<S> owned;
  Scene<S> scene;
  std::vector<unsigned char> bytes;
  Workspace<S> work;
  PressureRun run;
  Status status;
  Scales<S> scales;
  Residuals<S> residuals;

  explicit EnginePush(const OwnedScene<S>& given, bool is_round = false)
      : owned(given.spread()), scene(owned.view()), work(room()) {
    if (is_round) scene.round_cones = {work.round_cones.data, scene.points.size};
    Assembly<S> assembly(work.assembly);
    status = assembly.assemble(scene);
    if (status != Status::running) return;
    scales = assembly.layout().scales;
    status = solve(assembly);
    if (status != Status::solved) return;
    read_answer(assembly, work.pressure.z.data, work.answer, S(1));
    residuals = check(scene, scales, work.answer, S(1));
  }
  EnginePush(const EnginePush&) = delete;
  EnginePush& operator=(const EnginePush&) = delete;

  const Answer<S>& answer() const { return work.answer; }
  /// The object's acceleration, turns times the scene's length.
  Vector6<S> motion() const {
    Vector6<S> a = work.answer.acceleration;
    a.template tail<3>() *= scales.length;
    return a;
  }

private:
  Workspace<S> room() {
    const AssemblySize size = size_of(scene);
    const Index shared = scene.pressure == Pressure::even ? Index(0) : scene.actuators.size;
    const auto block = [&](Index count) {
      bytes.resize(static_cast<std::size_t>(count));
      return Arena(bytes.data(), count);
    };
    if constexpr (engine == Engine::structured || engine == Engine::predicted) {
      return make_structured_workspace<S>(block(structured_bytes<S>(size, shared)), size, shared);
    } else if constexpr (engine == Engine::small) {
      const Index exchanges = size.unknowns() + 1;
      return make_small_workspace<S>(block(small_bytes<S>(size, shared, exchanges)), size, shared,
                                     exchanges);
    } else if constexpr (engine == Engine::gauss_seidel) {
      return make_sweep_workspace<S>(block(sweep_bytes<S>(size)), size);
    } else {
      return make_workspace<S>(block(push_bytes<S>(size)), size);
    }
  }

  Status solve(Assembly<S>& assembly) {
    using Watcher = const Unwatched;
    using Pivots =
        std::conditional_t<engine == Engine::small, SmallLemke<S>,
                           std::conditional_t<engine == Engine::dense || engine == Engine::hybrid,
                                              Lemke<S>, StructuredLemke<S>>>;
    const auto by = [&](const auto& rounds) {
      return solve_pressure(assembly, rounds, work.pressure, {}, run, work.friction_memory(scene));
    };
    if constexpr (engine == Engine::gauss_seidel) {
      BlockGaussSeidel<S> sweeps(work.sweep_scalars, work.sweep_integers);
      SweepRounds<S> rounds{sweeps};
      rounds.options.tolerance = Tolerances<S>().residual / 32;
      rounds.options.max_sweeps = 5000;
      return by(rounds);
    } else {
      Pivots lemke(work.lemke_scalars, work.lemke_integers);
      LemkeOptions<S> options;
      options.exchanges = work.exchanges;
      const LemkeRounds<S, Watcher, Pivots> cold{lemke, options};
      if constexpr (engine == Engine::predicted) {
        return by(PredictedRounds<S, Watcher, Pivots>{assembly, cold});
      } else if constexpr (engine == Engine::hybrid) {
        std::vector<unsigned char> more(static_cast<std::size_t>(sweep_bytes<S>(size_of(scene))));
        const Workspace<S> extra = make_sweep_workspace<S>(
            Arena(more.data(), static_cast<Index>(more.size())), size_of(scene));
        BlockGaussSeidel<S> sweeps(extra.sweep_scalars, extra.sweep_integers);
        SweepRounds<S> rounds{sweeps};
        rounds.options.tolerance = S(1e-6);
        rounds.options.max_sweeps = 200;
        return by(HybridRounds<S>{rounds, cold});
      } else {
        return by(cold);
      }
    }
  }
};

} // namespace lcpush::test
