// Factoring a structured basis from the problem as given. Included by structured_basis.hpp.
#pragma once

#include "lcpush/lcp/pivots/structured/structured_basis.hpp"

namespace lcpush {

/// What the local form does not hold of the basis: rows that leave, slots that enter.
template <class S, class M> void StructuredBasis<S, M>::list_exchanges(Span<Int> target) {
  constexpr int has_slack = 1, has_unknown = 2;
  bool has_artificial = false;
  const Span<Int> flags = out_at_; // free until rows have left
  for (Index i = 0; i < n_; ++i) flags[i] = 0;
  for (const Int variable : target) {
    if (variable == artificial(n_))
      has_artificial = true;
    else
      flags[slot_of(variable)] =
          static_cast<Int>(flags[slot_of(variable)] | (variable < n_ ? has_slack : has_unknown));
  }
  if (!form_.pivot_locally([&](Index slot) { return (flags[slot] & has_unknown) != 0; })) {
    t_ = capacity_ + 1;
    return;
  }
  Index leaves = 0, enters = 0;
  const auto list = [&](Span<Int> which, Index& count, Index i) {
    if (count < capacity_) which[count] = static_cast<Int>(i);
    ++count;
  };
  for (Index i = 0; i < n_; ++i) {
    const bool flipped = form_.is_flipped(i);
    if ((flags[i] & (flipped ? has_unknown : has_slack)) == 0) list(out_, leaves, i);
    if ((flags[i] & (flipped ? has_slack : has_unknown)) != 0) list(in_, enters, i);
  }
  if (has_artificial) list(in_, enters, n_);
  for (Index i = 0; i < n_; ++i) out_at_[i] = -1;
  t_ = leaves;
}

/// K^-1 in place of K by complete pivoting. Returns how many rows are left without a pivot above
/// `smallest_pivot`; they and as many slots come last.
template <class S, class M> Index StructuredBasis<S, M>::invert(const S& smallest_pivot) {
  MatrixMap<S> K = inverse_;
  for (Index k = 0; k < t_; ++k) {
    const LargestEntry<S> largest = largest_entry(
        t_ - k, t_ - k, smallest_pivot, [&](Index i, Index j) { return S(K(k + i, k + j)); });
    if (largest.row < 0) return t_ - k;
    const Index row = k + largest.row, column = k + largest.column;
    for (Index j = 0; j < t_; ++j) Eigen::numext::swap(K(row, j), K(k, j));
    for (Index i = 0; i < t_; ++i) Eigen::numext::swap(K(i, column), K(i, k));
    // Row i < k now belongs to slot in_[i], column j < k to row out_[j].
    Eigen::numext::swap(out_[row], out_[k]);
    Eigen::numext::swap(in_[column], in_[k]);
    const S pivot = K(k, k);
    for (Index i = 0; i < t_; ++i) along_column_[i] = K(i, k);
    for (Index j = 0; j < t_; ++j) {
      if (j == k || K(k, j) == S(0)) continue;
      const S solved = -K(k, j) / pivot;
      detail::add_scaled(of_row(j), along_column_.data(), solved, t_);
      K(k, j) = solved;
    }
    for (Index i = 0; i < t_; ++i) K(i, k) = along_column_[i] / pivot;
    K(k, k) = S(1) / pivot;
  }
  return 0;
}

template <class S, class M>
Index StructuredBasis<S, M>::factor(Span<Int> target, Span<Int> /*candidates*/,
                                    const S& smallest_pivot, const VectorMap<S>& /*scratch*/,
                                    const Wanted& wanted) {
  list_exchanges(target);
  if (t_ >= capacity_) { // the next pivot would have no room
    const Index asked = t_;
    t_ = capacity_ + 1;
    return asked;
  }
  for (Index k = 0; k < t_; ++k) {
    form_.begin_column(in_[k]);
    for (Index i = 0; i < t_; ++i) inverse_(i, k) = form_.entry_of_column(out_[i], in_[k]);
  }
  form_.add_work(StructuredSettings::work_a_factored_row * n_ + t_ * t_ * t_);
  const Index left = invert(smallest_pivot);
  t_ -= left;
  for (Index i = 0; i < n_; ++i) dictionary.basic[i] = static_cast<Int>(base_variable(i));
  for (Index k = 0; k < t_; ++k) place(k, out_[k], in_[k]);
  find_values(wanted);
  long_ = t_ + StructuredSettings::exchanges_between;
  return left;
}

/// The right-hand sides of the problem as given become the values of this basis: the unknowns that
/// make the rows that have left 0. The exact ones are corrected for rounding in K^-1.
template <class S, class M> void StructuredBasis<S, M>::find_values(const Wanted& wanted) {
  constexpr int corrections = StructuredSettings::corrections;
  VectorMap<S> at = entering_column();
  VectorMap<S> entered(along_row_.data(), t_), left(along_column_.data(), t_);
  for (Index rhs = wanted.first; rhs < wanted.end; ++rhs) {
    VectorMap<S> values = column(dictionary.values, rhs);
    form_.evaluate(values);
    if (t_ == 0) continue;
    const int passes = rhs < wanted.exact ? 1 + corrections : 1;
    const S noise = StructuredSettings::rounding<S>() * values.cwiseAbs().maxCoeff();
    entered.setZero();
    for (int pass = 0; pass < passes; ++pass) {
      for (Index k = 0; k < t_; ++k)
        left[k] = pass > 0 ? S(values[out_[k]] + at[out_[k]]) : S(values[out_[k]]);
      if (pass > 0 && !(left.cwiseAbs().maxCoeff() > noise)) break;
      solve_for(left);
      for (Index k = 0; k < t_; ++k) entered[k] += rates_[k];
      form_.multiply(Inputs{in_.data, entered.data(), t_}, at);
    }
    values += at;
    for (Index k = 0; k < t_; ++k) values[out_[k]] = entered[k];
  }
}

/// out = the basic variables where every nonbasic one is as it is held and q = 0.
template <class S, class M>
void StructuredBasis<S, M>::respond_to(const Held& held, VectorMap<S>& out) {
  VectorMap<S> at = entering_column();
  for (Index i = 0; i < n_; ++i) at[i] = in_at_[i] < 0 ? held.at(other_variable(i), n_) : S(0);
  form_.multiply(Inputs{nullptr, at.data(), n_}, out);
  for (Index k = 0; k < t_; ++k) rates_[k] = S(0);
  for (Index k = 0; k < t_; ++k) {
    const S wanted = held.at(base_variable(out_[k]), n_);
    detail::add_scaled(rates_.data(), of_row(k), S(wanted - out[out_[k]]), t_);
  }
  add_entered(at);
  out += at;
  for (Index k = 0; k < t_; ++k) out[out_[k]] = rates_[k];
}

template <class S, class M>
void StructuredBasis<S, M>::respond(const VectorMap<S>& r, VectorMap<S> out) {
  respond_to({r.data(), n_, nullptr, S(1)}, out);
}

/// Free unknowns that are basic are at S exactly and nothing else is: rounding in a solve would
/// leave noise where the ratio test looks first.
template <class S, class M>
void StructuredBasis<S, M>::set_bound_rhs(Index free_begin, const VectorMap<S>& column_scale,
                                          const S& rhs_scale) {
  VectorMap<S> values = column(dictionary.values, 0);
  const Held bound{nullptr, free_begin, column_scale.data(), -rhs_scale};
  respond_to(bound, values);
  for (Index i = 0; i < n_; ++i) values[i] -= bound.at(dictionary.basic[i], n_);
}

/// After factor has left some: see DenseBasis. The lists stand where those that were left do.
template <class S, class M>
bool StructuredBasis<S, M>::drop_pairs(Index left, Span<Int> /*target*/, Span<Int> /*candidates*/,
                                       const S& smallest_pivot, const VectorMap<S>& scratch) {
  if (t_ > capacity_) return false;
  const Span<Int> in_base{out_.data + t_, left}, in_neither{in_.data + t_, left};
  // In the base and still there, while its complement has entered; and neither of both.
  Index both = 0, neither = 0;
  for (Index k = 0; k < left; ++k) {
    if (in_at_[in_base[k]] >= 0) in_base[both++] = in_base[k];
    if (out_at_[in_neither[k]] >= 0) in_neither[neither++] = in_neither[k];
  }
  const auto exchange_pairs = [&](Index j, Index i) {
    const Index returns = base_variable(j);
    exchange(out_[in_at_[i]], enter(returns), returns, scratch);
  };
  return exchange_largest(
             in_neither, in_base, both, smallest_pivot,
             [&](Index j, Index i) -> const S& { return inverse_(in_at_[i], out_at_[j]); },
             exchange_pairs) == 0;
}

} // namespace lcpush
