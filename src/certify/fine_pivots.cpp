#include "certify/fine_pivots.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

constexpr double negligible = 0x1p-80; // of a diagonal: an actuator without inertia

/// A dense matrix with the constants as its last column.
template <class S> class Table {
public:
  explicit Table(const MixedProblem& problem)
      : n_(problem.size()), entries_(n_ * (n_ + 1)), free_(problem.free) {
    for (std::size_t i = 0; i < n_; ++i) {
      for (const ExactEntry& entry : problem.rows[i])
        at(i, static_cast<std::size_t>(entry.column)) += S(entry.value);
      at(i, n_) = S(problem.q[0][i]);
    }
    for (std::size_t i = 0; i < n_; ++i) {
      rows_.push_back(i);
      columns_.push_back(i);
    }
  }

  /// Free unknowns leave with a free row each, as far as those determine them.
  void eliminate_free() {
    S first(0);
    for (;;) {
      std::size_t row = n_, column = n_;
      S largest = first * S(negligible);
      for (const std::size_t i : rows_)
        for (const std::size_t j : columns_)
          if (free_[i] != 0 && free_[j] != 0 && abs(at(i, j)) > largest) {
            largest = abs(at(i, j));
            row = i;
            column = j;
          }
      if (row == n_) return;
      if (first == S(0)) first = largest;
      rows_.erase(std::find(rows_.begin(), rows_.end(), row));
      columns_.erase(std::find(columns_.begin(), columns_.end(), column));
      for (const std::size_t i : rows_) substitute(i, row, column);
    }
  }

  const std::vector<std::size_t>& rows() const { return rows_; }
  const std::vector<std::size_t>& columns() const { return columns_; }
  const S& constant(std::size_t i) const { return entries_[i * (n_ + 1) + n_]; }
  S& at(std::size_t i, std::size_t j) { return entries_[i * (n_ + 1) + j]; }

private:
  std::size_t n_;
  std::vector<S> entries_;
  std::vector<unsigned char> free_;
  std::vector<std::size_t> rows_, columns_; // that are left

  void substitute(std::size_t i, std::size_t row, std::size_t column) {
    const S by = at(i, column) / at(row, column);
    if (by == S(0)) return;
    for (const std::size_t j : columns_)
      if (at(row, j) != S(0)) at(i, j) -= by * at(row, j);
    at(i, n_) -= by * constant(row);
  }
};

} // namespace

template <class S>
FinePivots<S>::FinePivots(const MixedProblem& problem)
    : size_(problem.size()), lemke_(static_cast<Index>(problem.size())) {
  Table<S> table(problem);
  table.eliminate_free();
  // Pairs first, as the core has them; what is left of the free ones comes in any order.
  std::vector<std::size_t> rows, columns;
  for (const bool is_free : {false, true}) {
    for (const std::size_t i : table.rows())
      if (problem.is_free(i) == is_free) rows.push_back(i);
    for (const std::size_t j : table.columns())
      if (problem.is_free(j) == is_free) columns.push_back(j);
    if (!is_free) pairs_ = rows;
  }
  for (const std::size_t j : columns)
    for (const std::size_t i : rows) matrix_.push_back(table.at(i, j));
  for (const std::size_t i : rows) q_.push_back(table.constant(i));
  problem_.size = static_cast<Index>(rows.size());
  problem_.free_begin = static_cast<Index>(pairs_.size());
  problem_.matrix = matrix_.data();
  problem_.q = q_.data();
}

template <class S> Basis FinePivots<S>::basis(Index cover, Index most_pivots) {
  LemkeOptions<S> options;
  options.first_cover = cover;
  options.covers = 1;
  options.max_pivots = most_pivots;
  (void)lemke_.init(problem_, options);
  return pivoted();
}

template <class S> Basis FinePivots<S>::basis_from(const Basis& near, Index most_pivots) {
  std::vector<unsigned char> active;
  for (const std::size_t i : pairs_) active.push_back(near[i]);
  active.resize(static_cast<std::size_t>(problem_.size), 1);
  LemkeOptions<S> options;
  options.covers = 1;
  options.max_pivots = most_pivots;
  (void)lemke_.init(problem_, options, active.data());
  return pivoted();
}

template <class S> Basis FinePivots<S>::pivoted() {
  const Status status = lemke_.status() == Status::running ? lemke_.solve() : lemke_.status();
  pivots_ += lemke_.pivots() + 1; // a start that fails is not for nothing
  if (status != Status::solved) return {};
  Basis basic(size_, 0);
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    basic[pairs_[k]] = lemke_.is_basic(static_cast<Index>(k)) ? 1 : 0;
  return basic;
}

template class FinePivots<DoubleDouble>;
template class FinePivots<WideFloat>;

} // namespace lcpush::desktop
