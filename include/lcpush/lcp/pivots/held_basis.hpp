// One basis of a factored problem, looked at without a pivot: does it still hold?
#pragma once

#include "lcpush/lcp/pivots/structured/structured_basis.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// Scalars and ints that HeldBasis needs for n unknowns in `cones` groups; `shared` as for
/// StructuredLemke. O(n).
constexpr Index held_basis_scalars(Index n, Index cones, Index shared) {
  return 6 * n + StructuredBasis<double>::scalars(n, cones, shared, 2, 0);
}
constexpr Index held_basis_integers(Index n, Index cones) {
  return 2 * n + StructuredBasis<double>::integers(n, cones, 0, 0);
}

/// Between neighbouring problems, as a sweep or a control loop has them, most answers stand in the
/// basis of the last one. Lemke's method started from there would say so, but scales, covers,
/// refines and referees for it, which is most of its time where nothing has to be pivoted. Here the
/// basis is factored as it is, and its values are looked at on the problem as given, by the
/// solvers' own product: who reports the answer asks natural_residual, or the laws' check, as
/// sweeps do.
template <class S> class HeldBasis {
public:
  /// Memory of at least held_basis_scalars and held_basis_integers elements; it is the caller's.
  HeldBasis(Span<S> scalars, Span<int> integers) : scalars_(scalars), integers_(integers) {}

  /// The basis in which z_i is basic where active[i] is not 0. Pre: `problem` is about 1 in size,
  /// as mechanics assembles it. Post: solved, and z() is the answer: w = q + M z is zero to
  /// rounding where z is basic, and no sign is wrong by more than a tie; with a push, z() + sigma
  /// z_push() is, as long as sigma <= valid_to(). Or numerical_breakdown: it is not, or not solved
  /// so well; bad_input: the problem is dense, or the memory is too small. Cost: O(n), and the
  /// square of what the cones do not hold by themselves.
  [[nodiscard]] Status look(const Problem<S>& problem, const unsigned char* active);
  const S* z() const { return level_[0].z.data(); }
  const S* z_push() const { return level_[1].z.data(); }
  const S& valid_to() const { return valid_to_; } ///< as Lemke::valid_to

private:
  /// A right-hand side, and what the basis makes of it.
  struct Level {
    const S* q = nullptr;
    VectorMap<S> z{nullptr, 0}, w{nullptr, 0};
    S size{1}; // of z, at least 1
  };
  Span<S> scalars_;
  Span<int> integers_;
  StructuredBasis<S> basis_;
  Level level_[2];
  Index levels_ = 1; // 2: with a push
  VectorMap<S> ones_{nullptr, 0}, scratch_{nullptr, 0};
  Span<int> target_, candidates_;
  S valid_to_{-1};

  bool carve(const Problem<S>& problem);
  bool factor(const Problem<S>& problem, const unsigned char* active);
  bool find_values(const Problem<S>& problem, const unsigned char* active, Index k);
  bool has_right_signs(const Problem<S>& problem, const unsigned char* active);
};

template <class S> bool HeldBasis<S>::carve(const Problem<S>& problem) {
  if (!StructuredBasis<S>::supports(problem, TieRule::generic)) return false;
  Block<S> scalars(scalars_);
  Block<int> integers(integers_);
  levels_ = problem.push != nullptr ? 2 : 1;
  for (Level& level : level_)
    for (VectorMap<S>* map : {&level.z, &level.w}) scalars.seat(*map, problem.size);
  for (VectorMap<S>* map : {&ones_, &scratch_}) scalars.seat(*map, problem.size);
  for (Span<int>* span : {&target_, &candidates_}) *span = integers.take(problem.size);
  basis_.carve(problem, 2, 0, scalars, integers);
  level_[0].q = problem.q;
  level_[1].q = problem.push;
  return !scalars.exhausted() && !integers.exhausted();
}

/// False if the basis leaves a free unknown at its bound, or is singular.
template <class S>
bool HeldBasis<S>::factor(const Problem<S>& problem, const unsigned char* active) {
  const Index n = problem.size;
  for (Index i = problem.free_begin; i < n; ++i)
    if (active[i] == 0) return false;
  ones_.setOnes();
  basis_.load(ones_, ones_, ones_);
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < levels_; ++k) basis_.dictionary.values(i, k) = level_[k].q[i];
    target_[i] = static_cast<int>(active[i] != 0 ? unknown(i, n) : slack(i));
  }
  const Tolerances<S> tolerances;
  const S smallest = tolerances.pivot * tolerances.tie;
  return basis_.factor(target_, candidates_, smallest, scratch_, {0, levels_, levels_}) == 0;
}

/// z, and w = q + M z as given; corrected once if w is not zero where it has to be. False if it is
/// not then either.
template <class S>
bool HeldBasis<S>::find_values(const Problem<S>& problem, const unsigned char* active, Index k) {
  const Index n = problem.size;
  const Span<int>& basic = basis_.dictionary.basic;
  Level& level = level_[k];
  level.z.setZero();
  level.size = S(1);
  for (Index i = 0; i < n; ++i) {
    if (basic[i] < n) continue;
    const S value = basis_.dictionary.values(i, k);
    level.z[basic[i] - n] = value;
    level.size = Eigen::numext::maxi(level.size, S(Eigen::numext::abs(value)));
  }
  const S rounding = HeldSettings::rounding<S>() * level.size;
  for (int pass = 0;; ++pass) {
    multiply(problem, level.z.data(), level.w.data());
    bool is_zero = true, is_near = true;
    for (Index i = 0; i < n; ++i) {
      level.w[i] += level.q[i];
      if (active[i] == 0) continue;
      const S left = Eigen::numext::abs(level.w[i]); // NaN: neither
      is_zero = is_zero && left <= rounding;
      is_near = is_near && left <= Tolerances<S>().residual;
    }
    if (is_zero) return true;
    if (pass > 0 || !is_near) return false;
    for (Index i = 0; i < n; ++i)
      if (active[i] == 0) level.w[i] = S(0);
    basis_.respond(level.w, scratch_);
    for (Index i = 0; i < n; ++i)
      if (basic[i] >= n) level.z[basic[i] - n] -= scratch_[i];
  }
}

/// With a push: does what is zero not fall below, and how far does the rest carry?
template <class S>
bool HeldBasis<S>::has_right_signs(const Problem<S>& problem, const unsigned char* active) {
  const S tie = Tolerances<S>().tie * level_[0].size;
  const S push_tie = Tolerances<S>().tie * level_[1].size;
  valid_to_ = S(-1);
  for (Index i = 0; i < problem.free_begin; ++i) {
    VectorMap<S>& values = active[i] != 0 ? level_[0].z : level_[0].w;
    if (!(values[i] >= -tie)) return false;
    values[i] = Eigen::numext::maxi(values[i], S(0));
    if (levels_ == 1) continue;
    const S rate = active[i] != 0 ? level_[1].z[i] : level_[1].w[i];
    if (!(rate < -push_tie)) continue;
    if (!(values[i] > tie)) return false;
    const S reach = values[i] / -rate;
    if (valid_to_ < S(0) || reach < valid_to_) valid_to_ = reach;
  }
  return true;
}

template <class S>
Status HeldBasis<S>::look(const Problem<S>& problem, const unsigned char* active) {
  if (!carve(problem)) return Status::bad_input;
  const bool is_answer = factor(problem, active) && find_values(problem, active, 0) &&
                         (levels_ == 1 || find_values(problem, active, 1)) &&
                         has_right_signs(problem, active);
  return is_answer ? Status::solved : Status::numerical_breakdown;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class HeldBasis<double>;
#endif

} // namespace lcpush
