#include "spread/mode_motions.hpp"

#include <algorithm>
#include <cmath>

#include "dense/simplex.hpp"
#include "spread/settings.hpp"

namespace lcpush::desktop {
namespace {

using Kind = ContactMode::Kind;

constexpr double nothing = SpreadSettings::nothing;

/// Rows of the same width one after the other: hundreds of thousands of lists are made.
class RowList {
public:
  explicit RowList(Index width) : width_(width) {
    numbers_.reserve(static_cast<std::size_t>(SpreadSettings::usual_rows * width));
  }
  Index count() const { return static_cast<Index>(numbers_.size()) / width_; }
  double* row(Index i) { return numbers_.data() + i * width_; }
  const double* row(Index i) const { return numbers_.data() + i * width_; }
  double* add() {
    numbers_.resize(numbers_.size() + static_cast<std::size_t>(width_));
    return row(count() - 1);
  }
  void drop_last() { numbers_.resize(numbers_.size() - static_cast<std::size_t>(width_)); }

private:
  Index width_;
  std::vector<double> numbers_;
};

double length_of(const double* row, Index width) {
  double sum = 0;
  for (Index k = 0; k < width; ++k) sum += row[k] * row[k];
  return std::sqrt(sum);
}

/// The rows over x that the modes ask for.
class ModeRows {
public:
  explicit ModeRows(const LiteralProblem& problem)
      : equations(problem.motions()), signs(problem.motions()), problem_(problem) {}

  RowList equations, signs;
  std::vector<bool> strict; // of the signs

  void add(Index i, const ContactMode& mode) {
    const ConeGroup<double>& cone = problem_.layout().cones[i];
    const bool may_open =
        mode.kind == Kind::open || (mode.kind == Kind::undecided && cone.normals == 1);
    if (may_open) strict.push_back(mode.kind == Kind::open);
    put(may_open ? signs : equations, 1, cone.variable);
    if (may_open || cone.generators == 0 || mode.kind == Kind::undecided) return;
    if (mode.kind == Kind::stick)
      hold(i, cone.generators);
    else
      slide(i, cone.generators, mode.active);
  }

private:
  const LiteralProblem& problem_;

  /// factor times the row of a force unknown, minus that of `other`.
  void put(RowList& list, double factor, Index unknown, Index other = -1) const {
    double* const row = list.add();
    const Eigen::MatrixXd& rates = problem_.rates();
    for (Index k = 0; k < rates.cols(); ++k)
      row[k] = factor * rates(unknown, k) - (other < 0 ? 0 : factor * rates(other, k));
  }

  void hold(Index i, Index g) {
    const auto against = [&](Index j) {
      put(equations, -1, problem_.layout().friction_index(i, j));
    };
    if (problem_.is_soft(i)) {
      for (Index j = 0; j < g; ++j) against(j);
      return;
    }
    against(0);
    if (g > 2) against(g / 4); // not parallel to the first
  }

  void slide(Index i, Index g, const std::vector<Index>& active) {
    const auto index = [&](Index j) { return problem_.layout().friction_index(i, j); };
    const auto is_active = [&](Index j) {
      return std::binary_search(active.begin(), active.end(), j);
    };
    // Both against the slip: the active generators oppose it alike, and better than `other`.
    const auto better_than = [&](Index other) {
      put(signs, -1, index(active.front()), other < 0 ? -1 : index(other));
      strict.push_back(true);
    };
    for (std::size_t k = 1; k < active.size(); ++k)
      put(equations, -1, index(active.front()), index(active[k]));
    // Of a regular polygon's directions one that opposes the slip better than both its neighbours,
    // or as well as one of them, opposes it best.
    if (!problem_.is_soft(i) && active.size() == 1) {
      better_than((active[0] + 1) % g);
      better_than((active[0] + g - 1) % g);
      return;
    }
    better_than(-1);
    const bool neighbours = active.size() == 2 &&
                            ((active[0] + 1) % g == active[1] || (active[1] + 1) % g == active[0]);
    if (!problem_.is_soft(i) && neighbours) return;
    for (Index j = 0; j < g; ++j)
      if (!is_active(j)) better_than(j);
  }
};

/// All x with equations x = 0, by their own entries: those that no equation gives.
void solve(RowList& table, Index size, ModeMotions& motions) {
  const Index rows = table.count();
  for (Index r = 0; r < rows; ++r) {
    const double length = length_of(table.row(r), size);
    for (Index k = 0; k < size && length > 0; ++k) table.row(r)[k] /= length;
  }
  std::vector<Index> given; // per eliminated row: the entry that it gives
  Index rank = 0;
  for (; rank < rows && rank < size - 1; ++rank) {
    Index row = -1, column = -1;
    double largest = nothing;
    for (Index k = 0; k < size - 1; ++k)
      for (Index r = rank; r < rows; ++r)
        if (const double x = std::abs(table.row(r)[k]); x > largest) {
          largest = x;
          row = r;
          column = k;
        }
    if (row < 0) break;
    double* const by = table.row(rank);
    std::swap_ranges(by, by + size, table.row(row));
    const double pivot = by[column];
    for (Index k = 0; k < size; ++k) by[k] /= pivot;
    for (Index r = 0; r < rows; ++r) {
      double* const other = table.row(r);
      const double factor = other[column];
      if (r == rank || factor == 0) continue;
      for (Index k = 0; k < size; ++k) other[k] -= factor * by[k];
    }
    given.push_back(column);
  }
  for (Index r = rank; r < rows; ++r)
    if (std::abs(table.row(r)[size - 1]) > SpreadSettings::contradiction) motions.possible = false;
  motions.span = Eigen::MatrixXd::Zero(size, size - rank);
  Index y = 0;
  for (Index k = 0; k < size; ++k) {
    if (std::find(given.begin(), given.end(), k) != given.end()) continue;
    motions.span(k, y) = 1;
    for (Index r = 0; r < rank; ++r)
      motions.span(given[static_cast<std::size_t>(r)], y) = -table.row(r)[k];
    ++y;
  }
}

/// The first of the rows that is the last one, to rounding.
Index find_last(const RowList& kept, Index width) {
  const Index last = kept.count() - 1;
  for (Index k = 0; k < last; ++k) {
    Index same = 0;
    while (same < width &&
           std::abs(kept.row(k)[same] - kept.row(last)[same]) <= SpreadSettings::parallel)
      ++same;
    if (same == width) return k;
  }
  return last;
}

/// The signs over y, without those that always hold or come twice. Stops where nothing more is
/// asked: `own`, and one of the modes has turned out to be another one.
void reduce_signs(const ModeRows& rows, bool own, ModeMotions& motions) {
  const Index size = motions.span.rows(), width = motions.span.cols(), push = width - 1;
  RowList kept(width);
  const auto holds_motion = [&](const double* row) {
    return std::any_of(row, row + push, [](double x) { return std::abs(x) > nothing; });
  };
  for (Index i = 0; i < rows.signs.count(); ++i) {
    const double* const sign = rows.signs.row(i);
    const bool strict = rows.strict[static_cast<std::size_t>(i)];
    double* const row = kept.add();
    for (Index y = 0; y < width; ++y)
      for (Index k = 0; k < size; ++k) row[y] += sign[k] * motions.span(k, y);
    const double length = length_of(row, width);
    const bool is_zero = !(length > nothing * length_of(sign, size));
    if (is_zero && strict) motions.distinct = false;
    for (Index k = 0; k < width && !is_zero; ++k) row[k] /= length;
    if (is_zero || !holds_motion(row)) {
      if (!is_zero && row[push] < 0) motions.possible = false;
      kept.drop_last();
      if (own && !(motions.distinct && motions.possible)) return;
      continue;
    }
    const auto twin = static_cast<std::size_t>(find_last(kept, width));
    if (twin == motions.strict.size()) {
      motions.strict.push_back(strict);
      continue;
    }
    motions.strict[twin] = motions.strict[twin] || strict;
    kept.drop_last();
  }
  motions.signs.resize(kept.count(), width);
  for (Index k = 0; k < kept.count(); ++k)
    motions.signs.row(k) = Eigen::Map<const Eigen::RowVectorXd>(kept.row(k), width);
}

} // namespace

ModeMotions motions_of(const LiteralProblem& problem, const FaceModes& modes, bool own) {
  ModeRows rows(problem);
  for (std::size_t i = 0; i < modes.size(); ++i) rows.add(static_cast<Index>(i), modes[i]);
  ModeMotions motions;
  solve(rows.equations, problem.motions(), motions);
  motions.signs.resize(0, motions.span.cols());
  if (motions.possible || !own) reduce_signs(rows, own, motions);
  return motions;
}

bool has_own_motion(const ModeMotions& motions, double& work) {
  if (!motions.possible || !motions.distinct) return false;
  const Index rows = motions.signs.rows(), free = motions.span.cols() - 1;
  if (rows == 0) return true;
  // The largest t <= 1 that every strict sign keeps, by its dual: a few rows, however many signs.
  // Any of the dual's points bounds t from above.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(free + 1, rows + 1);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(free + 1), c(rows + 1);
  A.topLeftCorner(free, rows) = motions.signs.leftCols(free).transpose();
  for (Index r = 0; r < rows; ++r) A(free, r) = motions.strict[static_cast<std::size_t>(r)] ? 1 : 0;
  A(free, rows) = 1;
  b[free] = 1;
  c << motions.signs.col(free), 1;
  Simplex program(A, b, 0);
  Simplex::Ending ending = program.find_point();
  if (ending == Simplex::Ending::found) ending = program.minimise(c);
  work += program.work() + static_cast<double>(A.size());
  if (ending == Simplex::Ending::unbounded) return false;
  if (ending != Simplex::Ending::found) return true; // not refuted
  return c.dot(program.point()) > SpreadSettings::own_motion;
}

} // namespace lcpush::desktop
