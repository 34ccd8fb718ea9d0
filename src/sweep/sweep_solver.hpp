// One value of a sweep's parameters: the scene there, and its answers from nothing or from a
// neighbour's basis.
#pragma once

#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "scenes/scene_series.hpp"
#include "sweep/basis_solution.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace lcpush::desktop {

/// The two questions of a sweep.
enum class Quantity { push, breaking };

/// How a contact behaves, for telling two segments apart.
struct ContactState {
  Mode mode = Mode::stick;
  bool pressed = false;
  Vector3<double> slip = Vector3<double>::Zero(); ///< direction of sliding, unit
  std::vector<Index> rubs;                        ///< generators that carry friction
};

/// The answer to one of the questions.
struct Outputs {
  Status status = Status::bad_input;
  double normal = 0;                               ///< N, the pusher's
  Vector3<double> force = Vector3<double>::Zero(); ///< N, the pusher's
  Vector6<double> twist = Vector6<double>::Zero(); ///< as prescribed, or of a unit push
  double residual = 0;
  double force_noise = 0, motion_noise = 0; ///< N, m/s^2: less is rounding's
  double turning_noise = 0;                 ///< rad/s^2, the same
  std::vector<ContactState> contacts;

  bool is_solved() const { return status == Status::solved; }
};

/// The scene at one value, assembled.
struct ScenePoint {
  SceneFile file;
  AssembledScene assembled{file.view()};
  const Scene<double>& scene = assembled.scene; ///< as solved
  Workspace<double>& work = assembled.work;
  Assembly<double>& assembly = assembled.assembly;

  explicit ScenePoint(SceneFile given) : file(std::move(given)) {}

  Problem<double> problem(Quantity quantity) const {
    return quantity == Quantity::push ? assembly.problem() : assembly.breaking_problem();
  }
};

/// The bases that the rounds of one solve ended in, one after the other; one round of `rigid`.
using RoundBases = std::vector<Basis>;

class SweepSolver {
public:
  SweepSolver(const VariedScene& scene, const std::vector<Variation>& variations, Index pusher);

  void go_to(const std::vector<double>& values);
  void go_to(double value) { go_to(std::vector<double>{value}); }
  ScenePoint& point() { return *point_; }
  const std::vector<Variation>& variations() const { return variations_; }
  Index pusher() const { return pusher_; }

  /// Is there anything to ask? Without a prescribed motion nothing breaks.
  bool has(Quantity quantity) const {
    return quantity == Quantity::push || push_size(point_->scene) > 0;
  }
  /// The answer by the scene's pressure law, from `bases` if there are any, which receive its own.
  /// `others` are tried next, before any pivot: those of a neighbour on the other side.
  Outputs solve(Quantity quantity, RoundBases& bases, const RoundBases* others = nullptr);
  Index cold() const { return cold_; }
  Index warm() const { return warm_; }

  /// `rigid` and `even`: the one literal problem. Lemke's pivots from nothing; the basis that it
  /// ends in.
  Status solve_cold(Quantity quantity, Basis& basis);
  /// Lemke stands at exactly this basis: it is the answer here.
  bool stand_on(Quantity quantity, const Basis& basis);
  Lemke<double>& lemke() { return *lemke_; }
  /// The answer of one basis, checked; `thorough`: by the whole dictionary if the small system will
  /// not do.
  Outputs on_basis(Quantity quantity, const Basis& basis, bool thorough = true);

private:
  std::vector<Variation> variations_;
  SceneSeries series_;
  Index pusher_;
  std::unique_ptr<ScenePoint> point_;
  std::optional<OwnedLemke<double>> lemke_;
  Index cold_ = 0, warm_ = 0;

  const Body<double>& pusher_body() const {
    return point_->file.bodies[static_cast<std::size_t>(pusher_)];
  }
  Outputs read_push(const double* z);
  Outputs read_breaking(const BasisSolution& solution);
  Outputs read_contacts(Outputs outputs) const;
  Outputs judge_breaking(Status status, const Breaking<double>& breaking);
  Outputs solve_pad(Quantity quantity, RoundBases& bases);
  void make_lemke();
};

} // namespace lcpush::desktop
