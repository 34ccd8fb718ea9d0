#include "raw/box_form.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace lcpush::desktop {

BoxForm::Row BoxForm::row_of(const RawProblem& boxed, Index i) {
  const auto at = static_cast<std::size_t>(i);
  const double lo = boxed.bounds.lo[at], hi = boxed.bounds.hi[at];
  if (boxed.bounds.leader(i) >= 0) return {hi > 0 ? Kind::follows : Kind::fixed};
  if (lo == hi) return {Kind::fixed, lo};
  if (std::isfinite(lo) && std::isfinite(hi)) // what is 0 there stays so to the last bit
    return std::abs(hi) < std::abs(lo) ? Row{Kind::both, hi, -1} : Row{Kind::both, lo};
  if (std::isfinite(lo)) return {Kind::lower, lo};
  if (std::isfinite(hi)) return {Kind::upper, hi, -1};
  return {Kind::free};
}

Index BoxForm::unknowns_of(Kind kind) {
  switch (kind) {
  case Kind::fixed: return 0;
  case Kind::both: return 2;
  case Kind::follows: return 3;
  default: return 1;
  }
}

/// sign * w_i of the box, with z written in the unknowns here, and beside it the multiplier of its
/// limit, in the row's own unit.
void BoxForm::add_row(Index i, double sign, Index multiplier) {
  std::map<Index, double> entries;
  double constant = boxed_.q[static_cast<std::size_t>(i)];
  for (const SparseEntry& entry : boxed_.M.row(i)) {
    const Row& column = rows_[static_cast<std::size_t>(entry.column)];
    constant += entry.value * column.at;
    if (column.first >= 0) entries[column.first] += entry.value * column.sign;
    if (column.kind == Kind::follows) entries[column.first + 1] -= entry.value;
  }
  double largest = 0;
  for (auto& [column, value] : entries) {
    value *= sign;
    largest = std::max(largest, std::abs(value));
  }
  if (multiplier >= 0) entries[multiplier] += largest > 0 ? std::exp2(std::ilogb(largest)) : 1;
  for (const auto& [column, value] : entries)
    if (value != 0) problem_.M.add(column, value);
  problem_.M.end_row();
  problem_.q.push_back(sign * constant);
  origin_.push_back(i);
}

/// What the last unknown of a row is the multiplier of: its other end is not passed, or
/// hi z_j - |z| >= 0.
void BoxForm::add_limit(Index i) {
  const auto at = static_cast<std::size_t>(i);
  const Row& row = rows_[at];
  std::map<Index, double> entries{{row.first, -1.0}};
  double constant = boxed_.bounds.hi[at] - boxed_.bounds.lo[at];
  if (row.kind == Kind::follows) {
    const double friction = boxed_.bounds.hi[at];
    const Row& leader = rows_[static_cast<std::size_t>(boxed_.bounds.leader(i))];
    constant = friction * leader.at;
    entries[row.first + 1] = -1.0;
    if (leader.first >= 0) entries[leader.first] += friction * leader.sign;
  }
  for (const auto& [column, value] : entries) problem_.M.add(column, value);
  problem_.M.end_row();
  problem_.q.push_back(constant);
  origin_.push_back(i);
}

BoxForm::BoxForm(const RawProblem& boxed) : boxed_(boxed) {
  Index count = 0;
  for (Index i = 0; i < boxed.size(); ++i) {
    rows_.push_back(row_of(boxed, i));
    if (rows_.back().kind != Kind::fixed) rows_.back().first = count;
    count += unknowns_of(rows_.back().kind);
  }
  problem_.M.cols = count;
  for (Index i = 0; i < boxed.size(); ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    if (row.kind == Kind::fixed) continue;
    if (row.kind == Kind::follows) {
      add_row(i, 1, row.first + 2);
      add_row(i, -1, row.first + 2);
      add_limit(i);
    } else if (row.kind == Kind::both) {
      add_row(i, row.sign, row.first + 1);
      add_limit(i);
    } else {
      add_row(i, row.sign, -1);
    }
  }
  for (const Index i : origin_)
    problem_.free.push_back(rows_[static_cast<std::size_t>(i)].kind == Kind::free ? 1 : 0);
}

std::vector<double> BoxForm::inside(const std::vector<double>& z) const {
  std::vector<double> p(problem_.q.size(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    if (row.kind == Kind::fixed) continue;
    const auto first = static_cast<std::size_t>(row.first);
    p[first] = row.sign * (z[i] - row.at);
    const bool is_beyond = row.sign > 0 ? z[i] >= boxed_.bounds.hi[i] : z[i] <= boxed_.bounds.lo[i];
    if (row.kind == Kind::both && is_beyond) p[first + 1] = 1;
    if (row.kind != Kind::follows) continue;
    const BoxEnds ends = ends_of(boxed_, static_cast<Index>(i), z);
    p[first] = std::max(z[i], 0.0);
    p[first + 1] = std::max(-z[i], 0.0);
    if (!(ends.lo < z[i] && z[i] < ends.hi)) p[first + 2] = 1;
  }
  return p;
}

double BoxForm::place(Index i, const std::vector<double>& p) const {
  const auto at = static_cast<std::size_t>(i);
  const Row& row = rows_[at];
  if (row.kind == Kind::fixed) return row.at;
  const auto first = static_cast<std::size_t>(row.first);
  if (row.kind == Kind::follows) return p[first] - p[first + 1];
  // At its other end by the multiplier: there to the last bit.
  if (row.kind == Kind::both && p[first + 1] > 0)
    return row.sign > 0 ? boxed_.bounds.hi[at] : boxed_.bounds.lo[at];
  return row.at + row.sign * p[first];
}

void BoxForm::take_back(RawAnswer& answer) const {
  const auto box_row = [&](Index row) { return origin_[static_cast<std::size_t>(row)]; };
  for (Index& row : answer.redundant_rows) row = box_row(row);
  if (answer.inconsistent_row >= 0) answer.inconsistent_row = box_row(answer.inconsistent_row);
  const std::vector<double> p = answer.z, v = answer.ray;
  answer.z.clear();
  answer.ray.clear();
  answer.basic.clear();
  for (Index i = 0; i < boxed_.size(); ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    if (answer.status == Status::solved) answer.z.push_back(place(i, p));
    if (v.empty()) continue;
    const auto first = static_cast<std::size_t>(row.first);
    const double along = row.kind == Kind::fixed     ? 0
                         : row.kind == Kind::follows ? v[first] - v[first + 1]
                                                     : row.sign * v[first];
    answer.ray.push_back(along);
  }
  // What rounding has left outside of the box comes back; rows that follow another after it.
  for (const bool follows : {false, true})
    for (Index i = 0; i < static_cast<Index>(answer.z.size()); ++i) {
      if ((boxed_.bounds.leader(i) >= 0) != follows) continue;
      const BoxEnds ends = ends_of(boxed_, i, answer.z);
      double& z = answer.z[static_cast<std::size_t>(i)];
      z = std::min(std::max(z, ends.lo), ends.hi);
    }
}

} // namespace lcpush::desktop
