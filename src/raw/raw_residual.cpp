// The referee of raw problems: is z an answer of the problem as it was given? [T.11] on sparse
// rows, with boxes; it shares no code with the solvers.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "raw/raw_parts.hpp"
#include "raw/settings.hpp"

namespace lcpush::desktop {
namespace {

/// 1 / sqrt(x), or 1 where there is nothing to scale.
double balancing(double x) { return x > 0 && std::isfinite(x) ? 1 / std::sqrt(x) : 1.0; }

bool is_balanced(double by) { return std::abs(by - 1) < raw_settings.balanced; }

/// The next power of two, so that scaling rounds nothing.
void round_to_powers(std::vector<double>& scales) {
  for (double& scale : scales) scale = std::exp2(std::round(std::log2(scale)));
}

/// Of three numbers the one in the middle, for low <= high.
double middle(double low, double x, double high) { return std::min(std::max(low, x), high); }

/// How far `distance` is in units of `size`; without a size its sign tells.
double scaled(double distance, double size) {
  if (size > 0) return distance / size;
  return distance > 0 ? 1 : distance < 0 ? -1 : 0;
}

} // namespace

/// Rows and columns of |M| are divided by the roots of their largest entries until these are near
/// 1: then no unit of a row or of an unknown is left in M.
Scales balanced_scales(const SparseRows& M) {
  const auto n = static_cast<std::size_t>(M.rows()), m = static_cast<std::size_t>(M.cols);
  Scales scales{std::vector<double>(n, 1.0), std::vector<double>(m, 1.0)};
  for (int pass = 0; pass < raw_settings.balancing_passes; ++pass) {
    std::vector<double> row_largest(n, 0.0), column_largest(m, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      for (const SparseEntry& entry : M.row(static_cast<Index>(i))) {
        const auto j = static_cast<std::size_t>(entry.column);
        const double size = std::abs(entry.value) * scales.row[i] * scales.column[j];
        row_largest[i] = std::max(row_largest[i], size);
        column_largest[j] = std::max(column_largest[j], size);
      }
    bool changes = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double by = balancing(row_largest[i]);
      scales.row[i] *= by;
      changes = changes || !is_balanced(by);
    }
    for (std::size_t j = 0; j < m; ++j) {
      const double by = balancing(column_largest[j]);
      scales.column[j] *= by;
      changes = changes || !is_balanced(by);
    }
    if (!changes) break;
  }
  round_to_powers(scales.row);
  round_to_powers(scales.column);
  return scales;
}

BoxEnds ends_of(const RawProblem& problem, Index i, const std::vector<double>& z) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto at = static_cast<std::size_t>(i);
  if (!problem.bounds.given()) return {problem.is_free(i) ? -infinite : 0.0, infinite};
  const Index leader = problem.bounds.leader(i);
  if (leader < 0) return {problem.bounds.lo[at], problem.bounds.hi[at]};
  const double end = problem.bounds.hi[at] * z[static_cast<std::size_t>(leader)];
  return {-end, end};
}

Referee::Referee(const RawProblem& problem) : problem_(problem) {
  Scales scales = balanced_scales(problem.M);
  unit_ = std::move(scales.column);
  row_unit_ = std::move(scales.row);
  measure_given();
}

/// Terms that cancel each other, of unknowns however large, answer no question: q is the question,
/// and of an unknown the end that is nearer to 0.
void Referee::measure_given() {
  for (Index i = 0; i < problem_.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    double given = std::abs(problem_.q[at]);
    for (const SparseEntry& entry : problem_.M.row(i))
      given += std::abs(entry.value) * box_size(static_cast<std::size_t>(entry.column));
    given_ = std::max(given_, given * row_unit_[at]);
  }
}

/// Of the end nearer to 0, from which it is counted.
double Referee::box_size(std::size_t j) const {
  if (!problem_.bounds.given() || problem_.bounds.leader(static_cast<Index>(j)) >= 0) return 0;
  const double end = std::min(std::abs(problem_.bounds.lo[j]), std::abs(problem_.bounds.hi[j]));
  return std::isfinite(end) ? end : 0;
}

/// How large z_j may be for rounding in it to be excused: its own size, its box's, and what it may
/// have caught of the unknowns that share a row with it. What of these a row brings, it brings
/// through its terms: a huge unknown with a tiny coefficient hides nothing. The row is its own;
/// where that has no diagonal, any.
void Referee::measure_unknowns(const std::vector<double>& z) {
  const Index n = problem_.size();
  size_.assign(z.size(), 0.0);
  caught_.assign(z.size(), 0.0);
  std::vector<bool> has_diagonal(z.size());
  for (Index i = 0; i < n; ++i) has_diagonal[static_cast<std::size_t>(i)] = problem_.M(i, i) != 0;
  for (Index i = 0; i < n; ++i) {
    double largest = 0, terms = std::abs(problem_.q[static_cast<std::size_t>(i)]);
    for (const SparseEntry& entry : problem_.M.row(i)) {
      const auto j = static_cast<std::size_t>(entry.column);
      largest = std::max(largest, std::abs(z[j]) / unit_[j]);
      terms = std::max(terms, std::abs(entry.value * z[j]));
    }
    for (const SparseEntry& entry : problem_.M.row(i)) {
      const auto j = static_cast<std::size_t>(entry.column);
      size_[j] = std::max(size_[j], largest);
      if (entry.value != 0 && (entry.column == i || !has_diagonal[j]))
        caught_[j] = std::max(caught_[j], terms / std::abs(entry.value));
    }
  }
  const double noise = Tolerances<double>().noise;
  for (std::size_t j = 0; j < z.size(); ++j) {
    const double caught = z[j] != 0 ? std::min(size_[j] * unit_[j], caught_[j]) : 0;
    size_[j] = std::abs(z[j]) + std::max(caught, box_size(j)) * noise;
  }
}

/// w, the sum of each row's |terms|, and what a unit of z_j is of its own row, or without a
/// diagonal of the row where it is most.
void Referee::measure_rows(const std::vector<double>& z, std::vector<double>& w) {
  const Index n = problem_.size();
  w.resize(z.size());
  scale_.assign(z.size(), 0.0);
  share_.assign(z.size(), 0.0);
  for (Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    double sum = 0, scale = std::abs(problem_.q[at]), diagonal = 0;
    for (const SparseEntry& entry : problem_.M.row(i)) {
      const auto j = static_cast<std::size_t>(entry.column);
      sum += entry.value * z[j];
      scale += std::abs(entry.value) * size_[j];
      if (entry.column == i) diagonal += std::abs(entry.value);
    }
    w[at] = sum + problem_.q[at];
    const double most = raw_settings.terms_over_given * given_ / row_unit_[at];
    scale_[at] = most > 0 ? std::min(scale, most) : scale;
    caught_[at] = diagonal;
  }
  for (Index i = 0; i < n; ++i) {
    const double scale = scale_[static_cast<std::size_t>(i)];
    for (const SparseEntry& entry : problem_.M.row(i)) {
      const auto j = static_cast<std::size_t>(entry.column);
      const bool counts = entry.column == i || caught_[j] == 0;
      if (counts && scale > 0) share_[j] = std::max(share_[j], std::abs(entry.value) / scale);
    }
  }
}

WorstRow<double> Referee::judge(const std::vector<double>& z, std::vector<double>& w) {
  double z_max = 0;
  for (std::size_t j = 0; j < z.size(); ++j) z_max = std::max(z_max, std::abs(z[j]) / unit_[j]);
  measure_unknowns(z);
  measure_rows(z, w);
  WorstRow<double> worst;
  for (Index i = 0; i < problem_.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double scale = scale_[at];
    const double scaled_w = scale > 0 ? w[at] / scale : w[at];
    const BoxEnds ends = ends_of(problem_, i, z);
    const double unit = unit_[at] * z_max, share = share_[at];
    // Beside the largest unknown, and as a term of its row: the larger of the two.
    const auto side = [&](double distance) {
      const double beside = scaled(distance, unit);
      const double as_term = share > 0 ? distance * share : 0.0;
      return std::abs(as_term) > std::abs(beside) ? as_term : beside;
    };
    const double below = side(z[at] - ends.lo), above = side(z[at] - ends.hi);
    // x - x is 0 unless x is NaN or infinite, and then no other row can make up for it.
    const double not_finite = (z[at] - z[at]) + (scaled_w - scaled_w) + (scale - scale);
    if (!(not_finite == 0)) return {not_finite, i};
    // Crossed ends hold nothing: then both of them are broken, or one by the other's distance.
    const double residual = above <= below ? std::abs(middle(above, scaled_w, below))
                                           : std::max(std::abs(above), std::abs(below));
    if (!(residual <= worst.residual)) worst = {residual, i};
  }
  return worst;
}

WorstRow<double> raw_residual(const RawProblem& problem, const std::vector<double>& z,
                              std::vector<double>& w) {
  return Referee(problem).judge(z, w);
}

} // namespace lcpush::desktop
