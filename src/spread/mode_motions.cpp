#include "spread/mode_motions.hpp"

#include <algorithm>
#include <cmath>

#include "spread/simplex.hpp"

namespace lcpush::desktop {
namespace {

using Kind = ContactMode::Kind;

constexpr double nothing = 1e-10;      // of a row of numbers near 1: what elimination leaves of it
constexpr double contradiction = 1e-9; // of the push
constexpr double parallel = 1e-12;

struct Sign {
  Eigen::RowVectorXd row;
  bool strict;
};

/// The rows over x that the modes ask for.
class ModeRows {
public:
  explicit ModeRows(const LiteralProblem& problem) : problem_(problem) {}

  std::vector<Eigen::RowVectorXd> equations;
  std::vector<Sign> signs;

  void add(Index i, const ContactMode& mode) {
    const ConeGroup<double>& cone = problem_.layout().cones[i];
    const Eigen::RowVectorXd gap = problem_.rates().row(cone.variable);
    if (mode.kind == Kind::open || (mode.kind == Kind::undecided && cone.normals == 1)) {
      signs.push_back({gap, mode.kind == Kind::open});
      return;
    }
    equations.push_back(gap);
    if (cone.generators == 0 || mode.kind == Kind::undecided) return;
    if (mode.kind == Kind::stick)
      hold(i, cone.generators);
    else
      slide(i, cone.generators, mode.active);
  }

private:
  const LiteralProblem& problem_;

  Eigen::RowVectorXd against(Index i, Index j) const {
    return -problem_.rates().row(problem_.layout().friction_index(i, j));
  }

  void hold(Index i, Index g) {
    if (problem_.is_soft(i)) {
      for (Index j = 0; j < g; ++j) equations.push_back(against(i, j));
      return;
    }
    equations.push_back(against(i, 0));
    equations.push_back(against(i, g / 4)); // g >= 4: not parallel to the first
  }

  void slide(Index i, Index g, const std::vector<Index>& active) {
    const Eigen::RowVectorXd slip = against(i, active.front());
    const auto is_active = [&](Index j) {
      return std::binary_search(active.begin(), active.end(), j);
    };
    for (std::size_t k = 1; k < active.size(); ++k)
      equations.push_back(slip - against(i, active[k]));
    // Of a regular polygon's directions one that opposes the slip better than both its neighbours,
    // or as well as one of them, opposes it best.
    if (!problem_.is_soft(i) && active.size() == 1) {
      signs.push_back({slip - against(i, (active[0] + 1) % g), true});
      signs.push_back({slip - against(i, (active[0] + g - 1) % g), true});
      return;
    }
    signs.push_back({slip, true});
    const bool neighbours = active.size() == 2 &&
                            ((active[0] + 1) % g == active[1] || (active[1] + 1) % g == active[0]);
    if (!problem_.is_soft(i) && neighbours) return;
    for (Index j = 0; j < g; ++j)
      if (!is_active(j)) signs.push_back({slip - against(i, j), true});
  }
};

/// All x with equations x = 0, by their own entries: those that no equation gives.
void solve(const std::vector<Eigen::RowVectorXd>& equations, Index size, ModeMotions& motions) {
  Eigen::MatrixXd table(static_cast<Index>(equations.size()), size);
  for (Index r = 0; r < table.rows(); ++r) {
    table.row(r) = equations[static_cast<std::size_t>(r)];
    const double length = table.row(r).norm();
    if (length > 0) table.row(r) /= length;
  }
  std::vector<Index> given; // per eliminated row: the entry that it gives
  Index rank = 0;
  for (; rank < table.rows() && rank < size - 1; ++rank) {
    Index row = 0, column = 0;
    const auto left = table.block(rank, 0, table.rows() - rank, size - 1);
    if (!(left.cwiseAbs().maxCoeff(&row, &column) > nothing)) break;
    table.row(rank).swap(table.row(rank + row));
    table.row(rank) /= table(rank, column);
    for (Index r = 0; r < table.rows(); ++r)
      if (r != rank && table(r, column) != 0) table.row(r) -= table(r, column) * table.row(rank);
    given.push_back(column);
  }
  for (Index r = rank; r < table.rows(); ++r)
    if (std::abs(table(r, size - 1)) > contradiction) motions.possible = false;
  motions.span = Eigen::MatrixXd::Zero(size, size - rank);
  Index y = 0;
  for (Index k = 0; k < size; ++k) {
    if (std::find(given.begin(), given.end(), k) != given.end()) continue;
    motions.span(k, y) = 1;
    for (Index r = 0; r < rank; ++r)
      motions.span(given[static_cast<std::size_t>(r)], y) = -table(r, k);
    ++y;
  }
}

} // namespace

ModeMotions motions_of(const LiteralProblem& problem, const FaceModes& modes) {
  ModeRows rows(problem);
  for (std::size_t i = 0; i < modes.size(); ++i) rows.add(static_cast<Index>(i), modes[i]);
  ModeMotions motions;
  solve(rows.equations, problem.motions(), motions);
  motions.signs.resize(0, motions.span.cols());
  std::vector<Eigen::RowVectorXd> kept;
  for (const Sign& sign : rows.signs) {
    Eigen::RowVectorXd row = sign.row * motions.span;
    const double length = row.norm();
    if (!(length > nothing * sign.row.norm())) {
      if (sign.strict) motions.distinct = false;
      continue;
    }
    row /= length;
    const Index push = row.size() - 1;
    if (push == 0 || !(row.head(push).cwiseAbs().maxCoeff() > nothing)) {
      if (row[push] < 0) motions.possible = false;
      continue;
    }
    bool is_new = true;
    for (std::size_t k = 0; k < kept.size() && is_new; ++k)
      if ((kept[k] - row).cwiseAbs().maxCoeff() <= parallel) {
        is_new = false;
        motions.strict[k] = motions.strict[k] || sign.strict;
      }
    if (!is_new) continue;
    kept.push_back(row);
    motions.strict.push_back(sign.strict);
  }
  motions.signs.resize(static_cast<Index>(kept.size()), motions.span.cols());
  for (std::size_t k = 0; k < kept.size(); ++k) motions.signs.row(static_cast<Index>(k)) = kept[k];
  return motions;
}

bool has_own_motion(const ModeMotions& motions, double& work) {
  constexpr double least = 1e-9; // of the push
  if (!motions.possible || !motions.distinct) return false;
  const Index rows = motions.signs.rows(), free = motions.span.cols() - 1;
  if (rows == 0) return true;
  // The largest t <= 1 that every strict sign keeps: columns y, t, what the signs have left.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows + 1, free + 1 + rows + 1);
  Eigen::VectorXd b(rows + 1), c = Eigen::VectorXd::Zero(A.cols());
  A.topLeftCorner(rows, free) = motions.signs.leftCols(free);
  A.bottomRightCorner(rows + 1, rows + 1).setIdentity();
  A.block(0, free + 1, rows, rows) *= -1;
  A(rows, free) = 1;
  for (Index r = 0; r < rows; ++r)
    A(r, free) = motions.strict[static_cast<std::size_t>(r)] ? -1 : 0;
  b.head(rows) = -motions.signs.col(free);
  b[rows] = 1;
  c[free] = -1;
  Simplex program(A, b, free);
  const Simplex::Ending ending = program.find_point();
  const bool failed =
      ending == Simplex::Ending::failed ||
      (ending == Simplex::Ending::found && program.minimise(c) != Simplex::Ending::found);
  work += program.work() + static_cast<double>(A.size());
  if (failed) return true; // not refuted
  return ending == Simplex::Ending::found && program.point()[free] > least;
}

} // namespace lcpush::desktop
