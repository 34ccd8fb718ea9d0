// Lemke's basis of a factored problem without its dictionary: a local form whose pivots cost
// nothing, and on top of it the exchanges that it does not hold,
//
//     K = M(rows that have left, slots that have entered),   K^-1 stored and updated.
//
// The entering column follows from K^-1 and one product with the local form. Cost of a pivot:
// O(n + t^2) for t exchanges; when t has grown, the basis is factored afresh, and the cones that
// slide go to the local form.
#pragma once

#include <limits>

#include "lcpush/lcp/complete_pivoting.hpp"
#include "lcpush/lcp/pivots/dictionary.hpp"
#include "lcpush/lcp/pivots/ratio_test.hpp"
#include "lcpush/lcp/pivots/structured/local_form.hpp"
#include "lcpush/lcp/residual.hpp"

namespace lcpush {
namespace detail {
/// The most exchanges that the memory holds: `asked`, or as many as pay.
constexpr Index most_exchanges(Index n, Index asked) {
  const Index most = asked > 0 ? asked : StructuredSettings::exchanges;
  return n + 1 < most ? n + 1 : most;
}
} // namespace detail

/// `M`: what it keeps (basis.hpp).
template <class S, class M = DesktopMemory> class StructuredBasis {
public:
  using Memory = M;
  using Integer = typename M::Integer;
  using Int = Integer;
  StructuredBasis() {}
  static constexpr bool takes_matrix = false; ///< of factored problems alone
  Dictionary<S, Int> dictionary;              ///< its table: the entering column alone

  static constexpr Index scalars(Index n, Index cones, Index shared, Index right_hand_sides,
                                 Index exchanges) {
    const Index t = detail::most_exchanges(n, exchanges);
    return detail::LocalForm<S, M>::scalars(n, cones, shared) + n * (1 + right_hand_sides) +
           t * (t + 3);
  }
  static constexpr Index integers(Index n, Index cones, Index shared, Index exchanges) {
    const Index t = detail::most_exchanges(n, exchanges);
    return detail::LocalForm<S, M>::integers(n, cones, shared) + 3 * n + 2 + 2 * t;
  }

  static bool supports(const Problem<S>& problem, TieRule rule) {
    return problem.factored != nullptr && rule != TieRule::lexicographic &&
           numbers(problem.size, problem.factored->cones.size, problem.factored->sums.size);
  }
  /// Is Int wide enough for as many?
  static constexpr bool numbers(Index n, Index cones, Index sums) {
    constexpr Index most = detail::LocalForm<S, M>::most_groups();
    return artificial(n) <= std::numeric_limits<Int>::max() && cones <= most && sums <= most;
  }

  /// `exchanges`: LemkeOptions::exchanges.
  void carve(const Problem<S>& problem, Index right_hand_sides, Index exchanges, Block<S>& scalars,
             Block<Int>& integers);
  /// Rows and columns have one scale; the memory of the entering column is scratch, which neither a
  /// response nor a pivot keeps; the target has been read before anything is a candidate.
  void seat(const MethodMemory<S, Int>& method, Block<S>& scalars, Block<Int>& integers) {
    scalars.seat(method.row_scale, n_);
    new (&method.column_scale) VectorMap<S>(method.row_scale.data(), n_);
    for (VectorMap<S>* map : {&method.row_sum, &method.scratch})
      new (map) VectorMap<S>(dictionary.table.data(), n_);
    method.candidates = method.target = integers.take(n_);
  }
  S scale(bool equilibrates, const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
          const VectorMap<S>& /*row_sum*/, const VectorMap<S>& /*scratch*/) const {
    return form_.scale(equilibrates, row_scale, column_scale);
  }
  void product(const S* z, S* out) const { form_.product(z, out); }
  /// A bound on them.
  void row_sums(const VectorMap<S>& column_scale, VectorMap<S>& row_sum) const {
    form_.row_sums(column_scale.data(), row_sum.data());
  }
  void load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
            const VectorMap<S>& covering_vector);
  template <class Reader> void set_covering_vector(const VectorMap<S>& as_given, Reader /*here*/) {
    form_.set_covering_vector(as_given);
  }

  /// Computes the column of a nonbasic variable. Cost: O(n + t^2).
  Index enter(Index variable);
  /// The variable of the column last computed enters, the one of `row` leaves.
  void exchange(Index row, Index column, Index entering, const VectorMap<S>& scratch);
  bool is_basic(Index variable) const {
    const Index i = slot_of(variable);
    return at_base(variable) ? out_at_[i] < 0 : in_at_[i] >= 0;
  }
  /// Has the basis outgrown the memory, however it is factored?
  bool is_too_long() const { return t_ > capacity_; }
  /// What pivots have taken so far, counted alike on every machine, modulo 2^32.
  std::uint32_t work() const { return form_.work(); }
  bool must_refactor() const { return t_ + 1 >= capacity_ || t_ >= long_; }
  void respond(const VectorMap<S>& r, VectorMap<S> out);
  void set_bound_rhs(Index free_begin, const VectorMap<S>& column_scale, const S& rhs_scale);

  Index factor(Span<Int> target, Span<Int> candidates, const S& smallest_pivot,
               const VectorMap<S>& scratch, const Wanted& wanted);
  bool drop_pairs(Index left, Span<Int> target, Span<Int> candidates, const S& smallest_pivot,
                  const VectorMap<S>& scratch);

private:
  detail::LocalForm<S, M> form_;
  Index n_ = 0, capacity_ = 0, t_ = 0, long_ = 0;
  LCPUSH_SEATED(MatrixMap<S>, inverse_);   // t x t: rows as in_, columns as out_
  LCPUSH_SEATED(VectorMap<S>, rates_);     // of slots in_, as one enters
  LCPUSH_SEATED(VectorMap<S>, along_row_); // of M at out_, in_: scratch
  LCPUSH_SEATED(VectorMap<S>, along_column_);
  // k: a row whose base variable has left, and the slot now there; row, slot: their k, -1 for none.
  LCPUSH_SEATED(Span<Int>, out_);
  LCPUSH_SEATED(Span<Int>, in_);
  LCPUSH_SEATED(Span<Int>, out_at_);
  LCPUSH_SEATED(Span<Int>, in_at_);

  /// Column k of K^-1: what row out_[k] brings about.
  S* of_row(Index k) { return inverse_.data() + k * capacity_; }

  // The base is the basis of the local form: one variable of every complementary pair.
  Index slot_of(Index variable) const {
    return variable == artificial(n_) ? n_ : variable < n_ ? variable : variable - n_;
  }
  bool at_base(Index variable) const {
    return variable != artificial(n_) && (variable >= n_) == form_.is_flipped(slot_of(variable));
  }
  Index base_variable(Index row) const {
    return form_.is_flipped(row) ? unknown(row, n_) : slack(row);
  }
  Index other_variable(Index slot) const {
    return slot == n_ ? artificial(n_) : form_.is_flipped(slot) ? slack(slot) : unknown(slot, n_);
  }
  void place(Index k, Index row, Index slot) {
    out_[k] = static_cast<Int>(row);
    in_[k] = static_cast<Int>(slot);
    out_at_[row] = in_at_[slot] = static_cast<Int>(k);
    dictionary.basic[row] = static_cast<Int>(other_variable(slot));
  }
  void swap_rows(Index i, Index j) {
    for (Index k = 0; k < dictionary.values.cols(); ++k)
      Eigen::numext::swap(dictionary.values(i, k), dictionary.values(j, k));
    Eigen::numext::swap(dictionary.basic[i], dictionary.basic[j]);
  }
  void list_exchanges(Span<Int> target);
  Index invert(const S& smallest_pivot);
  void find_values(const Wanted& wanted);
  /// What nonbasic variables are held at.
  struct Held {
    const S* slacks;  ///< of w; null: all at 0
    Index free_begin; ///< z_i from here on are at 1 over (scale_i unit), the others at 0
    const S* scale;
    S unit;
    S at(Index variable, Index n) const {
      if (variable < n) return slacks == nullptr ? S(0) : slacks[variable];
      const bool is_free = variable >= unknown(free_begin, n) && variable < artificial(n);
      return is_free ? S(S(1) / (scale[variable - n] * unit)) : S(0);
    }
  };
  void respond_to(const Held& held, VectorMap<S>& out);
  /// The slots that are not at 0, for LocalForm::multiply.
  struct Inputs {
    const Int* slots; ///< null: 0, 1, 2, ..
    const S* values;
    Index count;
    Index more = -1; ///< one more slot, at x
    S x{0};
    template <class Visit> void operator()(const Visit& visit) const {
      if (more >= 0) visit(more, x);
      for (Index k = 0; k < count; ++k)
        if (values[k] != S(0)) visit(slots == nullptr ? k : Index(slots[k]), values[k]);
    }
  };
  VectorMap<S> entering_column() { return column(dictionary.table, 0); }

  /// out = M (rates_ on the slots that have entered, x on one more); then the rows that have left
  /// show the rates of what is there now.
  void add_entered(VectorMap<S>& out, Index more = -1, const S& x = S(0)) {
    form_.multiply(Inputs{in_.data, rates_.data(), t_, more, x}, out);
    for (Index k = 0; k < t_; ++k) out[out_[k]] = rates_[k];
  }

  /// rates_ = -K^-1 times what the rows that have left are at.
  void solve_for(const VectorMap<S>& left) {
    for (Index k = 0; k < t_; ++k) rates_[k] = S(0);
    for (Index k = 0; k < t_; ++k)
      if (left[k] != S(0)) detail::add_scaled(rates_.data(), of_row(k), S(-left[k]), t_);
  }

  /// along_row_ = K^-1's response: (row of M on the slots that have entered) K^-1.
  void read_row(Index row) {
    form_.begin_row(row);
    for (Index k = 0; k < t_; ++k) along_column_[k] = form_.entry_of_row(row, in_[k]);
    for (Index k = 0; k < t_; ++k)
      along_row_[k] = detail::dot_along(of_row(k), 1, along_column_.data(), t_);
  }

  /// K grows by a row and a slot; rates_ is -K^-1 times its new column.
  void append(Index row, Index slot, const S& pivot) {
    read_row(row);
    for (Index k = 0; k < t_; ++k) {
      const S factor = along_row_[k] / pivot;
      if (factor != S(0)) detail::add_scaled(of_row(k), rates_.data(), S(-factor), t_);
      inverse_(t_, k) = -factor;
    }
    for (Index i = 0; i < t_; ++i) inverse_(i, t_) = rates_[i] / pivot;
    inverse_(t_, t_) = S(1) / pivot;
    place(t_, row, slot);
    ++t_;
  }

  /// Another slot takes the place of in_[k].
  void replace_slot(Index k, Index slot, const S& pivot) {
    for (Index j = 0; j < t_; ++j) {
      const S solved = -inverse_(k, j) / pivot;
      if (solved == S(0)) continue;
      detail::add_scaled(of_row(j), rates_.data(), solved, t_);
      inverse_(k, j) = solved;
    }
    in_at_[in_[k]] = -1;
    place(k, out_[k], slot);
  }

  /// Another row leaves in the place of out_[k], whose base variable has come back.
  void replace_row(Index k, Index row, const S& pivot) {
    read_row(row);
    for (Index j = 0; j < t_; ++j)
      if (j != k && along_row_[j] != S(0))
        detail::add_scaled(of_row(j), rates_.data(), S(-(along_row_[j] / pivot)), t_);
    for (Index i = 0; i < t_; ++i) inverse_(i, k) = rates_[i] / pivot;
    out_at_[out_[k]] = -1;
    place(k, row, in_[k]);
  }

  /// K shrinks: the base variable of row out_[k_row] has come back, slot in_[k_slot] has left.
  void remove(Index k_row, Index k_slot) {
    const S pivot = inverse_(k_slot, k_row);
    for (Index i = 0; i < t_; ++i) along_column_[i] = inverse_(i, k_row);
    for (Index j = 0; j < t_; ++j) {
      const S factor = inverse_(k_slot, j) / pivot;
      if (j != k_row && factor != S(0))
        detail::add_scaled(of_row(j), along_column_.data(), S(-factor), t_);
    }
    const Index last = t_ - 1, row_left = out_[k_slot], slot_left = in_[k_row];
    out_at_[out_[k_row]] = -1;
    in_at_[in_[k_slot]] = -1;
    // Slot in_[k_row] moves to row out_[k_slot]; then the last pair fills the gap at k_row.
    if (k_slot != k_row) {
      for (Index j = 0; j < t_; ++j) inverse_(k_slot, j) = inverse_(k_row, j);
      place(k_slot, row_left, slot_left);
    }
    if (k_row != last) {
      for (Index j = 0; j < t_; ++j) inverse_(k_row, j) = inverse_(last, j);
      for (Index i = 0; i < t_; ++i) inverse_(i, k_row) = inverse_(i, last);
      place(k_row, out_[last], in_[last]);
    }
    --t_;
  }
};

template <class S, class M>
void StructuredBasis<S, M>::carve(const Problem<S>& problem, Index right_hand_sides,
                                  Index exchanges, Block<S>& scalars, Block<Int>& integers) {
  n_ = problem.size;
  capacity_ = detail::most_exchanges(n_, exchanges);
  form_.carve(problem, scalars, integers);
  dictionary.carve(n_, 1, right_hand_sides, scalars, integers);
  scalars.seat(inverse_, capacity_, capacity_);
  for (VectorMap<S>* map : {&rates_, &along_row_, &along_column_}) scalars.seat(*map, capacity_);
  out_at_ = integers.take(n_);
  in_at_ = integers.take(n_ + 1);
  out_ = integers.take(capacity_);
  in_ = integers.take(capacity_);
}

template <class S, class M>
void StructuredBasis<S, M>::load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
                                 const VectorMap<S>& covering_vector) {
  form_.load(row_scale, column_scale, covering_vector);
  t_ = 0;
  long_ = StructuredSettings::exchanges_at_first;
  for (Index i = 0; i < n_; ++i) {
    out_at_[i] = in_at_[i] = -1;
    dictionary.basic[i] = static_cast<Int>(slack(i));
  }
  in_at_[n_] = -1;
}

template <class S, class M> Index StructuredBasis<S, M>::enter(Index variable) {
  const Index slot = slot_of(variable);
  dictionary.nonbasic[0] = static_cast<Int>(variable);
  VectorMap<S> at = entering_column();
  if (at_base(variable)) { // it left before: row out_at_ of M x is to grow by 1
    for (Index i = 0; i < t_; ++i) rates_[i] = inverse_(i, out_at_[slot]);
    add_entered(at);
    return 0;
  }
  form_.begin_column(slot);
  for (Index k = 0; k < t_; ++k) along_column_[k] = form_.entry_of_column(out_[k], slot);
  solve_for(along_column_);
  add_entered(at, slot, S(1));
  return 0;
}

template <class S, class M>
void StructuredBasis<S, M>::exchange(Index row, Index /*column*/, Index entering,
                                     const VectorMap<S>& /*scratch*/) {
  const S* const rates = entering_column().data();
  const S pivot = rates[row];
  for (Index k = 0; k < dictionary.values.cols(); ++k) {
    S* const values = dictionary.values.data() + k * n_;
    if (values[row] == S(0)) continue;
    const S step = -values[row] / pivot;
    detail::add_scaled(values, rates, step, n_);
    values[row] = step;
  }
  const Index slot = slot_of(entering), leaves_at = out_at_[row];
  const bool returns = at_base(entering), leaves_base = leaves_at < 0;
  dictionary.basic[row] = static_cast<Int>(entering);
  if (!returns) {
    if (leaves_base)
      append(row, slot, pivot);
    else
      replace_slot(leaves_at, slot, pivot);
    return;
  }
  const Index home = slot, k = out_at_[home];
  if (home != row) swap_rows(home, row);
  if (leaves_base)
    replace_row(k, row, pivot);
  else
    remove(k, leaves_at);
}

} // namespace lcpush

#include "lcpush/lcp/pivots/structured/structured_factor.hpp"
