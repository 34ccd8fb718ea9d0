// Pieces of a raw problem that no entry of M connects, and a piece as pivots store it.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "raw/raw_parts.hpp"

namespace lcpush::desktop {
namespace {

/// Union by linking to the smaller index.
class Groups {
public:
  explicit Groups(Index n) : parent_(static_cast<std::size_t>(n)) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace

double largest_of(const std::vector<double>& list) {
  double largest = 0;
  for (const double x : list) largest = std::max(largest, std::abs(x));
  return largest;
}

std::vector<std::vector<Index>> pieces_of(const SparseRows& M) {
  Groups groups(M.rows());
  for (Index i = 0; i < M.rows(); ++i)
    for (const SparseEntry& entry : M.row(i))
      groups.join(static_cast<std::size_t>(i), static_cast<std::size_t>(entry.column));
  std::vector<std::vector<Index>> by_root(static_cast<std::size_t>(M.rows())), pieces;
  for (Index i = 0; i < M.rows(); ++i)
    by_root[groups.find(static_cast<std::size_t>(i))].push_back(i);
  for (std::vector<Index>& piece : by_root)
    if (!piece.empty()) pieces.push_back(std::move(piece));
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return pieces;
}

Index largest_piece(const RawProblem& problem) {
  const auto pieces = pieces_of(problem.M);
  return pieces.empty() ? 0 : static_cast<Index>(pieces.back().size());
}

double pivot_bytes(const RawProblem& problem) {
  double unknowns = 0;
  bool has_free = false;
  for (Index i = 0; i < problem.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool is_boxed = problem.bounds.given();
    const bool has_lo = !is_boxed || std::isfinite(problem.bounds.lo[at]);
    const bool has_hi = is_boxed && std::isfinite(problem.bounds.hi[at]);
    has_free = has_free || problem.is_free(i) || (!has_lo && !has_hi);
    unknowns += is_boxed && problem.bounds.leader(i) >= 0 ? 3 : has_lo && has_hi ? 2 : 1;
  }
  const double n = static_cast<double>(largest_piece(problem)) * unknowns /
                   static_cast<double>(std::max<Index>(problem.size(), 1));
  return sizeof(double) * n * n * (has_free ? 5 : 2);
}

RawProblem cut_out(const RawProblem& problem, const std::vector<Index>& rows) {
  RawProblem part;
  part.M.cols = static_cast<Index>(rows.size());
  for (const Index i : rows) {
    // The rows ascend: a column's place among them is its new number.
    for (const SparseEntry& entry : problem.M.row(i)) {
      const auto place = std::lower_bound(rows.begin(), rows.end(), Index{entry.column});
      if (place != rows.end() && *place == entry.column)
        part.M.add(place - rows.begin(), entry.value);
    }
    part.M.end_row();
    part.q.push_back(problem.q[static_cast<std::size_t>(i)]);
    part.free.push_back(problem.free[static_cast<std::size_t>(i)]);
  }
  return part;
}

DensePiece::DensePiece(const RawProblem& from, Scaled scaled) {
  const Index n = from.size();
  for (const bool wanted : {false, true})
    for (Index i = 0; i < n; ++i)
      if (from.is_free(i) == wanted) {
        order.push_back(i);
        free.push_back(wanted ? 1 : 0);
      }
  pairs = static_cast<Index>(std::count(free.begin(), free.end(), 0));
  const auto count = static_cast<std::size_t>(n);
  Scales scales{std::vector<double>(count, 1.0), std::vector<double>(count, 1.0)};
  if (scaled == Scaled::yes) scales = balanced_scales(from.M);
  std::vector<std::size_t> place(count);
  for (std::size_t k = 0; k < count; ++k) place[static_cast<std::size_t>(order[k])] = k;
  M.assign(count * count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(order[k]);
    for (const SparseEntry& entry : from.M.row(order[k])) {
      const auto j = static_cast<std::size_t>(entry.column);
      M[place[j] * count + k] = entry.value * scales.row[i] * scales.column[j];
    }
    q.push_back(from.q[i] * scales.row[i]);
    column_scale.push_back(scales.column[i]);
  }
  const double largest = largest_of(q);
  if (scaled == Scaled::yes && largest > 0) q_scale = std::exp2(std::round(std::log2(largest)));
  for (double& entry : q) entry /= q_scale;
}

Problem<double> DensePiece::problem() const {
  Problem<double> view;
  view.size = size();
  view.free_begin = pairs;
  view.matrix = M.data();
  view.q = q.data();
  return view;
}

std::vector<double> DensePiece::original(const double* z) const {
  std::vector<double> all(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    all[static_cast<std::size_t>(order[k])] = z[k] * column_scale[k] * q_scale;
  return all;
}

} // namespace lcpush::desktop
