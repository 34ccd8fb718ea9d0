// One basis of a factored problem, looked at without a pivot: does it still hold?
#pragma once

#include "lcpush/lcp/pivots/structured/structured_basis.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// Scalars and ints that HeldBasis needs for n unknowns in `cones` groups; `shared` as for
/// StructuredLemke. O(n).
constexpr Index held_basis_scalars(Index n, Index cones, Index shared) {
  return 4 * n + StructuredBasis<double>::scalars(n, cones, shared, 1, 0);
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
  /// rounding where z is basic, and no sign is wrong by more than a tie; numerical_breakdown: it is
  /// not, or not solved so well; bad_input: the problem is dense or has a push, or the memory is
  /// too small. Cost: O(n), and the square of what the cones do not hold by themselves.
  [[nodiscard]] Status look(const Problem<S>& problem, const unsigned char* active);
  const S* z() const { return z_.data(); }

private:
  Span<S> scalars_;
  Span<int> integers_;
  StructuredBasis<S> basis_;
  VectorMap<S> z_{nullptr, 0}, w_{nullptr, 0}, ones_{nullptr, 0}, scratch_{nullptr, 0};
  Span<int> target_, candidates_;
  S size_{1}; // of z, at least 1

  bool carve(const Problem<S>& problem);
  bool factor(const Problem<S>& problem, const unsigned char* active);
  bool find_values(const Problem<S>& problem, const unsigned char* active);
  bool has_right_signs(const Problem<S>& problem, const unsigned char* active);
};

template <class S> bool HeldBasis<S>::carve(const Problem<S>& problem) {
  if (problem.push != nullptr || !StructuredBasis<S>::supports(problem, TieRule::generic))
    return false;
  Block<S> scalars(scalars_);
  Block<int> integers(integers_);
  for (VectorMap<S>* map : {&z_, &w_, &ones_, &scratch_}) scalars.seat(*map, problem.size);
  for (Span<int>* span : {&target_, &candidates_}) *span = integers.take(problem.size);
  basis_.carve(problem, 1, 0, scalars, integers);
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
    basis_.dictionary.values(i, 0) = problem.q[i];
    target_[i] = static_cast<int>(active[i] != 0 ? unknown(i, n) : slack(i));
  }
  const Tolerances<S> tolerances;
  const S smallest = tolerances.pivot * tolerances.tie;
  return basis_.factor(target_, candidates_, smallest, scratch_, {0, 1, 1}) == 0;
}

/// z, and w = q + M z as given; corrected once if w is not zero where it has to be. False if it is
/// not then either.
template <class S>
bool HeldBasis<S>::find_values(const Problem<S>& problem, const unsigned char* active) {
  const Index n = problem.size;
  const Span<int>& basic = basis_.dictionary.basic;
  z_.setZero();
  size_ = S(1);
  for (Index i = 0; i < n; ++i) {
    if (basic[i] < n) continue;
    const S value = basis_.dictionary.values(i, 0);
    z_[basic[i] - n] = value;
    size_ = Eigen::numext::maxi(size_, S(Eigen::numext::abs(value)));
  }
  const S rounding = HeldSettings::rounding<S>() * size_;
  for (int pass = 0;; ++pass) {
    multiply(problem, z_.data(), w_.data());
    bool is_zero = true, is_near = true;
    for (Index i = 0; i < n; ++i) {
      w_[i] += problem.q[i];
      if (active[i] == 0) continue;
      const S left = Eigen::numext::abs(w_[i]); // NaN: neither
      is_zero = is_zero && left <= rounding;
      is_near = is_near && left <= Tolerances<S>().residual;
    }
    if (is_zero) return true;
    if (pass > 0 || !is_near) return false;
    for (Index i = 0; i < n; ++i)
      if (active[i] == 0) w_[i] = S(0);
    basis_.respond(w_, scratch_);
    for (Index i = 0; i < n; ++i)
      if (basic[i] >= n) z_[basic[i] - n] -= scratch_[i];
  }
}

template <class S>
bool HeldBasis<S>::has_right_signs(const Problem<S>& problem, const unsigned char* active) {
  const S tie = Tolerances<S>().tie * size_;
  for (Index i = 0; i < problem.free_begin; ++i) {
    if (!((active[i] != 0 ? z_[i] : w_[i]) >= -tie)) return false;
    z_[i] = Eigen::numext::maxi(z_[i], S(0));
  }
  return true;
}

template <class S>
Status HeldBasis<S>::look(const Problem<S>& problem, const unsigned char* active) {
  if (!carve(problem)) return Status::bad_input;
  const bool is_answer =
      factor(problem, active) && find_values(problem, active) && has_right_signs(problem, active);
  return is_answer ? Status::solved : Status::numerical_breakdown;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class HeldBasis<double>;
#endif

} // namespace lcpush
