// Pivots on the structured basis that first turn the slides of the basis they start from.
#pragma once

#include <vector>

#include "lcpush/lcp/pivots/structured_lemke.hpp"

namespace lcpush::desktop {

/// Where pyramids have many facets, a motion that differs by a percent from the one that a basis was
/// made for opposes another generator at every point, and each is a pivot or more. So before any
/// pivot every point that slides takes the generator that is most opposed to its slip in the motion
/// of the basis, all at once, until they stay: as Newton's method would for a cone.
class TurningPivots {
public:
  explicit TurningPivots(StructuredLemke<double>& lemke) : lemke_(lemke) {}

  Status init(const Problem<double>& problem, const LemkeOptions<double>& options) {
    return lemke_.init(problem, options);
  }
  Status init(const Problem<double>& problem, const LemkeOptions<double>& options,
              const unsigned char* active, Guess guess) {
    constexpr int most_turns = 8;
    const Status status = lemke_.init(problem, options, active, guess);
    if (!is_fine(problem)) return status;
    active_.assign(active, active + problem.size);
    Status turned = status;
    for (int k = 0; k < most_turns && turned == Status::running && turn_slides(problem); ++k)
      turned = lemke_.init(problem, options, active_.data(), guess);
    return turned == status ? turned : lemke_.init(problem, options, active, guess);
  }

  template <class Watcher> Status step(Watcher& watcher) { return lemke_.step(watcher); }
  template <class Watcher> Status solve(Watcher& watcher) { return lemke_.solve(watcher); }
  Status status() const { return lemke_.status(); }
  Reason reason() const { return lemke_.reason(); }
  Index pivots() const { return lemke_.pivots(); }
  bool is_basic(Index i) const { return lemke_.is_basic(i); }
  const double* z() const { return lemke_.z(); }
  const double* z_push() const { return lemke_.z_push(); }
  double valid_to() const { return lemke_.valid_to(); }

private:
  StructuredLemke<double>& lemke_;
  std::vector<unsigned char> active_;
  std::vector<double> slack_; // w of the basis

  /// With fewer generators a pivot or two cost less.
  static bool is_fine(const Problem<double>& problem) {
    constexpr Index few = 16;
    for (const ConeGroup<double>& cone : problem.factored->cones)
      if (cone.generators > few) return true;
    return false;
  }

  /// False: every point that slides does so against its generator.
  bool turn_slides(const Problem<double>& problem) {
    read_slacks(problem);
    bool turns = false;
    for (const ConeGroup<double>& cone : problem.factored->cones)
      turns = turn(cone) || turns;
    return turns;
  }

  void read_slacks(const Problem<double>& problem) {
    const Dictionary<double>& basis = lemke_.dictionary();
    const Index finite = problem.free_begin < problem.size ? 1 : 0;
    slack_.assign(active_.size(), 0.0);
    for (Index row = 0; row < problem.size; ++row)
      if (const Index i = basis.basic[row]; i < problem.size)
        slack_[static_cast<std::size_t>(i)] = basis.values(row, finite) * lemke_.slack_unit(i);
  }

  bool turn(const ConeGroup<double>& cone) {
    if (cone.generators == 0 || active_[static_cast<std::size_t>(cone.slip())] == 0) return false;
    constexpr double clearly = 1e-12;
    const auto first = static_cast<std::size_t>(cone.variable + cone.normals);
    const auto count = static_cast<std::size_t>(cone.generators);
    std::size_t against = 0, most_opposed = 0, slides = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (active_[first + k] != 0) {
        against = k;
        ++slides;
      }
      if (slack_[first + k] < slack_[first + most_opposed]) most_opposed = k;
    }
    if (slides != 1 || !(slack_[first + most_opposed] < -clearly)) return false;
    active_[first + against] = 0;
    active_[first + most_opposed] = 1;
    return true;
  }
};

} // namespace lcpush::desktop
