// A scene as it is solved, with all its memory: even pressure spread, the problem assembled.
#pragma once

#include "lcpush/desktop/owned.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush::desktop {

/// The scene as it is solved: a file's scene, spread evenly if it says so.
template <class S> struct EvenSceneOf {
  std::vector<Body<S>> bodies;
  std::vector<Actuator<S>> actuators;
  std::vector<Drive<S>> drives;
  Scene<S> scene; ///< over these arrays, and over the given scene's

  explicit EvenSceneOf(const Scene<S>& given) {
    const EvenSize size = even_size(given);
    bodies.resize(static_cast<std::size_t>(size.bodies));
    actuators.resize(static_cast<std::size_t>(size.drives));
    drives.resize(static_cast<std::size_t>(size.drives));
    const EvenMemory<S> memory{span_of(bodies), span_of(actuators), span_of(drives)};
    // A file whose actuators drive several bodies is refused when it is read.
    if (spread_evenly(given, memory, scene) != Status::solved) scene = given;
  }
};
extern template struct EvenSceneOf<double>;
using EvenScene = EvenSceneOf<double>;

/// The arrays behind `given` outlive this. Memory: sweep_bytes. `is_round`: friction is round, and
/// the scene has round cones.
struct AssembledScene {
  EvenScene even;
  const Scene<double>& scene; ///< as solved
  std::vector<unsigned char> bytes;
  Workspace<double> work;
  Assembly<double> assembly;

  explicit AssembledScene(const Scene<double>& given, bool is_round = false)
      : even(given), scene(even.scene),
        bytes(static_cast<std::size_t>(sweep_bytes<double>(size_of(scene)))),
        work(make_sweep_workspace<double>(span_of(bytes), size_of(scene))),
        assembly(work.assembly) {
    assemble(is_round);
  }
  /// With round cones, or with the pyramids that `facets` says.
  void assemble(bool is_round) {
    even.scene.round_cones = {};
    if (is_round) even.scene.round_cones = {work.round_cones.data, scene.points.size};
    assembly.assemble(scene);
  }
  AssembledScene(const AssembledScene&) = delete; // the views inside would point into the other one
  AssembledScene& operator=(const AssembledScene&) = delete;
};

} // namespace lcpush::desktop
