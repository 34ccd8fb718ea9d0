// Contact problems with pyramids, by Lemke's pivots on their complementarity problem: of each
// contact r_n, the parts of friction along `facets` directions, and the slip's bound; then l.
#include "contacts/settings.hpp"
#include "lcpush/desktop/contacts.hpp"
#include "lcpush/desktop/raw_problem.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;
using Sparse = ContactProblem::Sparse;

/// r = D z and what else z has: a row's own unknowns are `width` a contact.
Sparse directions(Index k, Index facets) {
  constexpr double circle = 2 * 3.14159265358979323846;
  const Index width = facets + 2;
  Triplets entries;
  for (Index c = 0; c < k; ++c) {
    const auto add = [&](Index i, Index j, double x) {
      entries.emplace_back(static_cast<int>(3 * c + i), static_cast<int>(width * c + j), x);
    };
    add(0, 0, 1);
    for (Index j = 0; j < facets; ++j) {
      const double angle = circle * static_cast<double>(j) / static_cast<double>(facets);
      add(1, 1 + j, std::cos(angle));
      add(2, 1 + j, std::sin(angle));
    }
  }
  Sparse D(3 * k, width * k);
  D.setFromTriplets(entries.begin(), entries.end());
  return D;
}

} // namespace

ContactForces solve_contact_pyramids(const ContactProblem& p, Index facets) {
  const Index k = p.contacts(), width = facets + 2, e = p.s.size(), n = width * k;
  const Sparse D = directions(k, facets), Dt = D.transpose(), V = Dt * Sparse(p.V.sparseView());
  Sparse M = Dt * p.W * D;
  const Eigen::VectorXd q = Dt * p.b;
  RawProblem raw;
  raw.M.cols = n + e;
  for (Index i = 0; i < n; ++i) {
    const Index first = i - i % width, slip = first + width - 1;
    for (Sparse::InnerIterator entry(M, i); entry; ++entry) raw.M.add(entry.col(), entry.value());
    if (i == slip) {
      raw.M.add(first, p.mu[i / width]);
      for (Index j = first + 1; j < slip; ++j) raw.M.add(j, -1);
    } else if (i > first) {
      raw.M.add(slip, 1); // may stand after later columns; sorted below
    }
    for (Sparse::InnerIterator entry(V, i); entry; ++entry)
      raw.M.add(n + entry.col(), entry.value());
    std::sort(raw.M.entries.begin() + static_cast<std::ptrdiff_t>(raw.M.begins.back()),
              raw.M.entries.end(),
              [](const SparseEntry& a, const SparseEntry& b) { return a.column < b.column; });
    raw.M.end_row();
    raw.q.push_back(q[i]);
  }
  for (Index a = 0; a < e; ++a) {
    for (Index i = 0; i < n; ++i)
      if (const double x = V.coeff(i, a); x != 0) raw.M.add(i, x);
    if (p.R[a] != 0) raw.M.add(n + a, p.R[a]);
    raw.M.end_row();
    raw.q.push_back(p.s[a]);
  }
  raw.free.assign(static_cast<std::size_t>(n), 0);
  raw.free.resize(static_cast<std::size_t>(n + e), 1);
  const RawAnswer solved = solve_raw(raw, {});
  Eigen::VectorXd z = Eigen::VectorXd::Zero(n + e);
  if (!solved.z.empty()) z = Eigen::Map<const Eigen::VectorXd>(solved.z.data(), n + e);
  const Eigen::VectorXd l = z.tail(e);
  ContactForces answer = judge_contacts(p, D * z.head(n), ContactSettings::solved, &l);
  answer.facets = facets;
  answer.lcp = solved.residual;
  answer.is_good = solved.status == Status::solved;
  return answer;
}

} // namespace lcpush::desktop
