#include "certify/exact_cones.hpp"

#include "certify/settings.hpp"
#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/cone_membership.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

Rational dot(const Column& a, const Column& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].sign() != 0 && b[i].sign() != 0) sum += a[i] * b[i];
  return sum;
}

/// The part of b that is orthogonal to the columns. Pre: they are independent.
std::optional<Column> orthogonal_part(const std::vector<const Column*>& columns, const Column& b) {
  std::vector<ExactRow> gram;
  Column right;
  for (const auto* row : columns) {
    ExactRow& products = gram.emplace_back();
    for (std::size_t j = 0; j < columns.size(); ++j)
      products.push_back({static_cast<Index>(j), dot(*row, *columns[j])});
    right.push_back(dot(*row, b));
  }
  Column part = b;
  if (columns.empty()) return part;
  const auto weights = exact_solutions(gram, {right});
  if (!weights) return std::nullopt;
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (std::size_t i = 0; i < b.size(); ++i) part[i] -= weights->front()[j] * (*columns[j])[i];
  return part;
}

} // namespace

std::optional<Column> separation(const std::vector<Column>& columns, const Column& b) {
  const auto m = static_cast<Index>(b.size()), n = static_cast<Index>(columns.size());
  std::vector<double> scalars(static_cast<std::size_t>(cone_membership_scalars(m, n)));
  std::vector<int> integers(static_cast<std::size_t>(least_squares_integers(m, n)));
  ConeMembership<double> question(span_of(scalars), span_of(integers), m, n);
  for (Index i = 0; i < m; ++i) {
    question.b[i] = b[static_cast<std::size_t>(i)].value();
    for (Index j = 0; j < n; ++j)
      question.A(i, j) = columns[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)].value();
  }
  for (Index j = 0; j < n; ++j)
    if (question.A.col(j).norm() > 0) question.A.col(j).normalize();
  question.b.normalize();
  if (question.ask(n) != Status::ray) return std::nullopt;
  std::vector<std::size_t> active;
  for (Index j = 0; j < n; ++j)
    if (std::abs(question.A.col(j).dot(question.residual)) <=
        certify_settings.equality * question.residual.norm())
      active.push_back(static_cast<std::size_t>(j));
  std::vector<ExactRow> rows(b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    for (std::size_t j = 0; j < active.size(); ++j)
      if (columns[active[j]][i].sign() != 0)
        rows[i].push_back({static_cast<Index>(j), columns[active[j]][i]});
  std::vector<const Column*> independent;
  for (const std::size_t j : independent_columns(rows, active.size()))
    independent.push_back(&columns[active[j]]);
  const auto y = orthogonal_part(independent, b);
  if (!y || dot(*y, b).sign() <= 0) return std::nullopt;
  for (const Column& column : columns)
    if (dot(*y, column).sign() > 0) return std::nullopt;
  return y;
}

std::optional<Column> squeeze_near(const MixedProblem& problem, const std::vector<double>& guess) {
  std::vector<std::size_t> forces;
  std::vector<Index> place(problem.size(), -1);
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (guess[i] > certify_settings.equality) {
      place[i] = static_cast<Index>(forces.size());
      forces.push_back(i);
    }
  // What has to vanish: the free rows, and what is left of the cones that are used up.
  std::vector<ExactRow> rows;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    ExactRow row;
    double sum = 0, size = 0;
    for (const ExactEntry& entry : problem.rows[i]) {
      const auto j = static_cast<std::size_t>(entry.column);
      if (place[j] < 0) continue;
      row.push_back({place[j], entry.value});
      sum += entry.value.value() * guess[j];
      size += std::abs(entry.value.value() * guess[j]);
    }
    const bool is_cone = problem.limits_forces(i) && !row.empty();
    if (problem.is_free(i) || (is_cone && std::abs(sum) <= certify_settings.equality * size))
      rows.push_back(std::move(row));
  }
  std::vector<double> near;
  for (const std::size_t j : forces) near.push_back(guess[j]);
  const auto solution = solution_near(rows, Column(rows.size()), near, certify_settings.guess_bits);
  if (!solution) return std::nullopt;
  const Column& f = *solution;
  Column x(problem.size());
  Rational work = 0;
  for (std::size_t j = 0; j < forces.size(); ++j) {
    if (f[j].sign() < 0) return std::nullopt;
    x[forces[j]] = f[j];
    work -= f[j] * problem.q[forces[j]];
  }
  const Column w = times(problem, x);
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (problem.is_free(i) ? w[i].sign() != 0 : problem.limits_forces(i) && w[i].sign() < 0)
      return std::nullopt;
  if (work.sign() <= 0) return std::nullopt;
  return x;
}

void holding_question(const MixedProblem& problem, std::vector<Column>& columns, Column& b) {
  std::vector<std::size_t> rows; // what has to balance
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (problem.is_free(i)) rows.push_back(i);
  std::vector<Column> of(problem.size(), Column(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    b.push_back(-problem.q[rows[k]]);
    for (const ExactEntry& entry : problem.rows[rows[k]])
      of[static_cast<std::size_t>(entry.column)][k] = entry.value;
  }
  std::vector<unsigned char> is_frictionless(problem.size(), 1);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (!problem.limits_forces(i)) continue;
    is_frictionless[i] = 0; // the slip itself
    for (const ExactEntry& normal : problem.rows[i])
      for (const ExactEntry& friction : problem.rows[i]) {
        const auto n = static_cast<std::size_t>(normal.column);
        const auto f = static_cast<std::size_t>(friction.column);
        if (normal.value.sign() < 0 || friction.value.sign() > 0) continue;
        is_frictionless[n] = is_frictionless[f] = 0;
        Column ray = of[n];
        for (std::size_t k = 0; k < ray.size(); ++k) ray[k] += normal.value * of[f][k];
        columns.push_back(std::move(ray));
      }
  }
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (!problem.is_free(i) && is_frictionless[i] != 0) columns.push_back(of[i]);
}

} // namespace lcpush::desktop
