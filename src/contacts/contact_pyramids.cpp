// Contact problems with pyramids, by Lemke's pivots on their complementarity problem: of each
// contact r_n, the parts of friction along `facets` directions, and the slip's bound; then l.
#include "contacts/settings.hpp"
#include "dense/decompositions.hpp"
#include "lcpush/desktop/contacts.hpp"
#include "lcpush/desktop/raw_problem.hpp"

#include <cmath>
#include <vector>

namespace lcpush::desktop {
namespace {

/// What a contact's unknowns do to its three rows: r_c = D z_c; `turn`: rad, of the first
/// direction.
Eigen::MatrixXd directions(Index facets, double turn) {
  constexpr double circle = 2 * 3.14159265358979323846;
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(3, facets + 2);
  D(0, 0) = 1;
  for (Index j = 0; j < facets; ++j) {
    const double angle = turn + circle * static_cast<double>(j) / static_cast<double>(facets);
    D(1, 1 + j) = std::cos(angle);
    D(2, 1 + j) = std::sin(angle);
  }
  return D;
}

} // namespace

ContactForces solve_contact_pyramids(const ContactProblem& p, Index facets,
                                     const Eigen::VectorXd& turns) {
  const Index k = p.contacts(), width = facets + 2, e = p.s.size(), n = width * k;
  std::vector<Eigen::MatrixXd> D; // of each contact
  for (Index c = 0; c < k; ++c) D.push_back(directions(facets, turns.size() > 0 ? turns[c] : 0));
  const auto of = [&](Index c) -> const Eigen::MatrixXd& { return D[static_cast<std::size_t>(c)]; };
  RawProblem raw;
  raw.M.cols = n + e;
  const auto add = [&](const Eigen::RowVectorXd& row, double q) {
    raw.M.add_row(row);
    raw.q.push_back(q);
  };
  const auto spread = [&](const Eigen::VectorXd& rows) { // D' of every contact's three
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(n + e);
    for (Index c = 0; c < k; ++c)
      if (rows.segment<3>(3 * c).any())
        row.segment(width * c, width) =
            product(of(c).transpose(), rows.segment<3>(3 * c)).transpose();
    return row;
  };
  for (Index c = 0; c < k; ++c)
    for (Index j = 0; j < width; ++j) {
      Eigen::VectorXd w = Eigen::VectorXd::Zero(3 * k);
      for (Index i = 0; i < 3; ++i)
        for (const SparseEntry& entry : p.W.row(3 * c + i))
          w[entry.column] += of(c)(i, j) * entry.value;
      Eigen::RowVectorXd row = spread(w);
      row.tail(e) = product(of(c).col(j).transpose(), p.V.middleRows<3>(3 * c));
      if (j == facets + 1) {
        row[width * c] = p.mu[c];
        row.segment(width * c + 1, facets).setConstant(-1);
      } else if (j > 0) {
        row[width * c + facets + 1] = 1;
      }
      add(row, of(c).col(j).dot(p.b.segment<3>(3 * c)));
    }
  for (Index a = 0; a < e; ++a) {
    Eigen::RowVectorXd row = spread(p.V.col(a));
    row[n + a] = p.R[a];
    add(row, p.s[a]);
  }
  raw.free.assign(static_cast<std::size_t>(n), 0);
  raw.free.resize(static_cast<std::size_t>(n + e), 1);
  const RawAnswer solved = solve_raw(raw, {});
  Eigen::VectorXd z = Eigen::VectorXd::Zero(n + e), r(3 * k);
  const auto forces = [&](const Eigen::VectorXd& parts) {
    for (Index c = 0; c < k; ++c)
      r.segment<3>(3 * c) = product(of(c), parts.segment(width * c, width));
    return r;
  };
  if (!solved.z.empty()) z = Eigen::Map<const Eigen::VectorXd>(solved.z.data(), n + e);
  forces(z);
  const Eigen::VectorXd l = z.tail(e);
  ContactForces answer = judge_contacts(p, r, ContactSettings::solved, &l);
  answer.facets = facets;
  answer.is_good = solved.status == Status::solved;
  if (answer.is_good) answer.lcp = solved.residual;
  if (!solved.ray.empty())
    answer.none =
        contradiction(p, forces(Eigen::Map<const Eigen::VectorXd>(solved.ray.data(), n + e)));
  if (!answer.is_good && answer.none.size() == 0) answer.none = find_contradiction(p);
  return answer;
}

} // namespace lcpush::desktop
