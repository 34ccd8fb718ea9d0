// From a mixed problem (some unknowns free, their rows equalities) to one that Lemke starts from:
// free unknowns are pivoted into the basis, where they never block, and their rows drop out.
#pragma once

#include "lcpush/lcp/complete_pivoting.hpp"
#include "lcpush/lcp/pivots/dictionary.hpp"
#include "lcpush/lcp/pivots/equilibrate.hpp"
#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// What becomes of free unknowns whose part of the free block is singular.
enum class SingularBlock {
  bound,    ///< they stay free in the reduced problem; Lemke bounds them symbolically
  exchange, ///< 2 x 2 exchanges with a complementary pair, as long as one exists
};

constexpr Index reduction_scalars(Index n) { return 2 * n * n + 5 * n; }
constexpr Index reduction_integers(Index n) { return 6 * n; }

/// What reduced unknown k stands for: z_index, or w_index where an exchange has swapped the pair.
struct ReducedUnknown {
  Index index;
  bool swapped;
};

template <class S> class Reduction {
public:
  /// Memory of at least reduction_scalars(n) and reduction_integers(n) elements.
  Reduction(Span<S> scalars, Span<int> integers) : scalars_(scalars), integers_(integers) {}

  /// `M` n x n column-major and `q` n; is_free[i] != 0 makes z_i free and row i the equality w_i =
  /// 0. Post: solved, and problem() is the reduced problem; bad_input with inconsistent_row() >= 0
  /// if the equalities contradict each other, with -1 if the memory is too small. Cost: n^2
  /// multiply-adds a free unknown.
  [[nodiscard]] Status init(Index n, const S* M, const S* q, const unsigned char* is_free,
                            SingularBlock singular) {
    n_ = n;
    is_free_ = is_free;
    inconsistent_row_ = -1;
    if (!carve()) return Status::bad_input;
    load(M, q);
    while (pivot_free_block() || (singular == SingularBlock::exchange && exchange_pair())) {
    }
    if (!drop_redundant_rows(q)) return Status::bad_input;
    write_reduced();
    return Status::solved;
  }

  /// The reduced problem, equilibrated by powers of two.
  const Problem<S>& problem() const { return problem_; }

  /// All n unknowns from a solution of problem().
  void recover(const S* reduced, S* z) const { expand(reduced, true, z); }
  /// The same for a direction of the reduced problem, such as a ray.
  void recover_direction(const S* reduced, S* z) const { expand(reduced, false, z); }

  Index inconsistent_row() const { return inconsistent_row_; }
  /// Equalities that hold once the others do; as many free unknowns are fixed at 0.
  Span<const int> redundant_rows() const { return {redundant_.data, redundant_count_}; }
  Span<const int> fixed_unknowns() const { return {fixed_.data, redundant_count_}; }

  ReducedUnknown unknown_of(Index k) const {
    const Index variable = dictionary_.nonbasic[kept_column_[k]];
    return {variable % n_, variable < n_};
  }

private:
  Span<S> scalars_;
  Span<int> integers_;
  Index n_ = 0, redundant_count_ = 0, inconsistent_row_ = -1;
  const unsigned char* is_free_ = nullptr;
  Dictionary<S> dictionary_; // without an artificial column
  VectorMap<S> row_scale_{nullptr, 0}, column_scale_{nullptr, 0}, scratch_{nullptr, 0};
  Span<S> matrix_, q_;
  Span<int> kept_row_, kept_column_, redundant_, fixed_;
  Problem<S> problem_;

  // An equality whose w is still basic; a free unknown that is still nonbasic.
  bool open_row(Index i) const {
    return dictionary_.basic[i] < n_ && is_free_[dictionary_.basic[i]] != 0;
  }
  bool open_column(Index c) const {
    return dictionary_.nonbasic[c] >= n_ && is_free_[dictionary_.nonbasic[c] - n_] != 0;
  }
  S smallest_pivot() const { return Tolerances<S>().pivot; }

  bool carve() {
    Block<S> scalars(scalars_);
    Block<int> integers(integers_);
    const Index n = n_;
    dictionary_.carve(n, n, 1, scalars, integers);
    for (VectorMap<S>* map : {&row_scale_, &column_scale_, &scratch_}) scalars.seat(*map, n);
    matrix_ = scalars.take(n * n);
    q_ = scalars.take(n);
    for (Span<int>* span : {&kept_row_, &kept_column_, &redundant_, &fixed_})
      *span = integers.take(n);
    return !scalars.exhausted() && !integers.exhausted();
  }

  void load(const S* M, const S* q) {
    Problem<S> given;
    given.size = given.free_begin = n_;
    given.matrix = M;
    fill_matrix(given, dictionary_.table);
    row_scale_.setOnes();
    column_scale_.setOnes();
    equilibrate(dictionary_.table, row_scale_, column_scale_, scratch_);
    for (Index i = 0; i < n_; ++i) {
      dictionary_.values(i, 0) = q[i] * row_scale_[i];
      dictionary_.basic[i] = static_cast<int>(slack(i));
      dictionary_.nonbasic[i] = static_cast<int>(unknown(i, n_));
    }
  }

  /// One pivot on the largest entry of the block (equalities) x (free unknowns).
  bool pivot_free_block() {
    const LargestEntry<S> pivot = largest_entry(n_, n_, smallest_pivot(), [&](Index i, Index c) {
      return open_row(i) && open_column(c) ? S(dictionary_.table(i, c)) : S(0);
    });
    if (pivot.row >= 0) dictionary_.exchange(pivot.row, pivot.column, scratch_);
    return pivot.row >= 0;
  }

  /// The free block is exhausted: an equality i and a free unknown c leave together through a
  /// complementary pair (row k, column l) with entries (i, l) and (k, c) that are not zero.
  bool exchange_pair() {
    S largest = smallest_pivot();
    Index best[4] = {-1, -1, -1, -1};
    for (Index c = 0; c < n_; ++c)
      for (Index k = 0; open_column(c) && k < n_; ++k) {
        if (is_free_[dictionary_.basic[k] % n_] != 0) continue;
        const Index l = dictionary_.column_of(complement(dictionary_.basic[k], n_));
        for (Index i = 0; i < n_; ++i) {
          if (!open_row(i)) continue;
          const S a = Eigen::numext::abs(dictionary_.table(i, l)),
                  b = Eigen::numext::abs(dictionary_.table(k, c));
          const S smaller = a < b ? a : b;
          if (!(smaller > largest)) continue;
          largest = smaller;
          best[0] = i, best[1] = c, best[2] = k, best[3] = l;
        }
      }
    if (best[0] < 0) return false;
    dictionary_.exchange(best[2], best[1], scratch_);
    dictionary_.exchange(best[0], best[3], scratch_);
    return true;
  }

  /// False, with inconsistent_row_ set, if an equality without unknowns says 0 = something.
  bool drop_redundant_rows(const S* q) {
    using Eigen::numext::abs, Eigen::numext::maxi;
    S q_size(0);
    for (Index i = 0; i < n_; ++i) q_size = maxi(q_size, abs(S(q[i] * row_scale_[i])));
    redundant_count_ = 0;
    for (Index i = 0; i < n_; ++i) {
      if (!open_row(i)) continue;
      S largest(0);
      for (Index c = 0; c < n_; ++c) {
        const bool is_zero = dictionary_.nonbasic[c] < n_ && is_free_[dictionary_.nonbasic[c]] != 0;
        if (!is_zero) largest = maxi(largest, abs(S(dictionary_.table(i, c))));
      }
      if (largest > smallest_pivot()) continue;
      if (abs(S(dictionary_.values(i, 0))) > smallest_pivot() * q_size) {
        inconsistent_row_ = dictionary_.basic[i];
        return false;
      }
      redundant_[redundant_count_++] = dictionary_.basic[i];
    }
    return true;
  }

  /// Keeps complementary pairs first, then the equalities and free unknowns that are still open.
  void write_reduced() {
    Index m = 0;
    for (Index i = 0; i < n_; ++i) {
      if (is_free_[dictionary_.basic[i] % n_] != 0) continue;
      kept_row_[m] = static_cast<int>(i);
      kept_column_[m++] =
          static_cast<int>(dictionary_.column_of(complement(dictionary_.basic[i], n_)));
    }
    problem_ = {};
    problem_.free_begin = m;
    Index rows = m, columns = m;
    for (Index i = 0; i < n_; ++i) {
      bool is_redundant = false;
      for (const int row : redundant_rows())
        is_redundant = is_redundant || row == dictionary_.basic[i];
      if (open_row(i) && !is_redundant) kept_row_[rows++] = static_cast<int>(i);
    }
    Index fixed = 0;
    for (Index c = 0; c < n_; ++c) {
      if (!open_column(c)) continue;
      if (columns < rows)
        kept_column_[columns++] = static_cast<int>(c);
      else
        fixed_[fixed++] = dictionary_.nonbasic[c] - static_cast<int>(n_);
    }
    problem_.size = rows;
    problem_.matrix = matrix_.data;
    problem_.q = q_.data;
    for (Index j = 0; j < rows; ++j)
      for (Index i = 0; i < rows; ++i)
        matrix_[j * rows + i] = dictionary_.table(kept_row_[i], kept_column_[j]);
    for (Index i = 0; i < rows; ++i) q_[i] = dictionary_.values(kept_row_[i], 0);
  }

  void expand(const S* reduced, bool with_constants, S* z) const {
    for (Index j = 0; j < n_; ++j) z[j] = S(0);
    for (Index k = 0; k < problem_.size; ++k) {
      const ReducedUnknown unknown = unknown_of(k);
      if (!unknown.swapped) z[unknown.index] = reduced[k] * column_scale_[unknown.index];
    }
    for (Index i = 0; i < n_; ++i) {
      if (dictionary_.basic[i] < n_) continue;
      S x = with_constants ? dictionary_.values(i, 0) : S(0);
      for (Index k = 0; k < problem_.size; ++k)
        x += dictionary_.table(i, kept_column_[k]) * reduced[k];
      const Index j = dictionary_.basic[i] - n_;
      z[j] = x * column_scale_[j];
    }
  }
};

} // namespace lcpush
