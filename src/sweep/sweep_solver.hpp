// One value of a sweep's parameters: the scene there, and its answers from nothing or from a
// neighbour's basis.
#pragma once

#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "lcpush/lcp/pivots/held_basis.hpp"
#include "sweep/settings.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace lcpush::desktop {

/// How a contact behaves, for telling two segments apart.
struct ContactState {
  Mode mode = Mode::stick;
  bool pressed = false;
  Vector3<double> slip = Vector3<double>::Zero(); ///< direction of sliding, unit
  std::vector<Index> with_friction;               ///< generators that carry friction
};

/// An answer while it is worked with: a breaking force at which the object does not hold keeps its
/// numbers.
struct DetailedAnswer : SweepAnswer {
  Noise zero; ///< less is told as 0
  std::vector<ContactState> contacts;
};

/// The scene at one value, assembled.
struct ScenePoint {
  SceneFile file;
  const Body<double>& pusher;
  AssembledScene assembled{file.view(), file.is_round};
  const Scene<double>& scene = assembled.scene; ///< as solved
  Workspace<double>& work = assembled.work;
  Assembly<double>& assembly = assembled.assembly;

  ScenePoint(SceneFile given, Index pushes) : file(std::move(given)), pusher(file.body(pushes)) {}

  /// Valid until the other question is asked.
  Problem<double> problem(Question question) {
    if (question == Question::breaking) return assembly.breaking_problem();
    assembly.push_by(1.0);
    return assembly.problem();
  }
  /// Proved; asked once.
  bool has_no_answer();

private:
  std::optional<bool> jammed_;
};

/// Thrown out of a solve that is not to go on: all that solves owns its memory.
struct Stopped {
  Stop why;
};

/// Asks every few pivots whether the sweep is to end; once it is, nothing is solved any more.
class StopWatcher : public Watcher {
public:
  explicit StopWatcher(const StopCheck& check) : check_(check) {}
  void stepped(const Lemke<double>&) override { count(); }
  void progressed(Index, Index) override { count(); }
  void look() {
    if (stop_ == Stop::none) stop_ = stop_now(check_);
    if (stop_ != Stop::none) throw Stopped{stop_};
  }
  Stop stop() const { return stop_; }

private:
  const StopCheck& check_;
  Stop stop_ = Stop::none;
  Index pivots_ = 0;

  void count() { // a clock takes as long as a pivot of few points
    if (++pivots_ % SweepSettings::pivots_a_look == 0) look();
  }
};

/// An unknown: is z_i basic?
using Basis = std::vector<unsigned char>;
/// The bases that the rounds of one solve ended in, one after the other; one round of `rigid`.
using RoundBases = std::vector<Basis>;

struct RoundMemory;
class AnyRounds;

class SweepSolver {
public:
  /// `options` outlive it: they are told of its pivots, and say whether samples start from their
  /// neighbours' answers.
  SweepSolver(const VariedScene& scene, const std::vector<Variation>& variations, Index pusher,
              const ParameterSweepOptions& options);

  void go_to(const std::vector<double>& values);
  void go_to(double value) { go_to(std::vector<double>{value}); }
  ScenePoint& point() { return *point_; }
  const std::vector<Variation>& variations() const { return variations_; }
  Index pusher() const { return pusher_; }
  bool is_warm() const { return is_warm_; }
  Stop stop() const { return watcher_.stop(); }

  /// Is there anything to ask? Without a prescribed motion nothing breaks.
  bool has(Question question) const {
    return question == Question::push ||
           (push_size(point_->scene) > 0 && !(leaves_out_ && is_from_nothing(question)));
  }
  /// The answer by the scene's pressure law, from `bases` if there are any, which receive its own.
  DetailedAnswer solve(Question question, RoundBases& bases);
  /// The instant of breaking by finite pushes is found from nothing, as by `break`: a neighbour's
  /// bases save no work, and the way there makes no difference.
  bool is_from_nothing(Question question) const {
    return question == Question::breaking && takes_rounds(point_->file);
  }
  /// Where that has been asked before.
  void leave_out_what_is_from_nothing() { leaves_out_ = true; }
  Index cold() const { return cold_; }
  Index warm() const { return warm_; }

  /// `rigid` and `even`: the one literal problem. Lemke's pivots from nothing; the basis that it
  /// ends in.
  Status solve_cold(Question question, Basis& basis);
  /// Lemke stands at exactly this basis: it is the answer here.
  bool stand_on(Question question, const Basis& basis);
  Lemke<double>& lemke() { return *lemke_; }
  /// The answer of one basis, checked; by the whole dictionary if the basis' factors will not do.
  DetailedAnswer on_basis(Question question, const Basis& basis);

private:
  std::vector<Variation> variations_;
  const VariedScene& scene_;
  Index pusher_;
  bool is_warm_, leaves_out_ = false;
  std::unique_ptr<ScenePoint> point_;
  std::optional<OwnedLemke<double>> lemke_;
  std::optional<Owned<StructuredLemke<double>>> structured_;
  std::optional<Owned<HeldBasis<double>>> held_;
  StopWatcher watcher_;
  Index cold_ = 0, warm_ = 0;

  DetailedAnswer solve_pad(Question question, RoundBases& bases);
  template <class Pivots> AnyRounds rounds_by(Pivots& pivots, RoundMemory& memory);
  DetailedAnswer solve_rounds(Question question, const AnyRounds& rounds);
  void make_lemke();
  void make_structured();
  Status pivot(Question question, const LemkeOptions<double>& options, const unsigned char* from,
               Basis& basis);
};

} // namespace lcpush::desktop
