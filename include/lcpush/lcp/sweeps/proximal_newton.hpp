// All groups of a factored problem answer at once, and the few numbers that they share - the
// object's six accelerations and one a sum group - are solved for by Newton's method.
//
// With its forces held near their last values f^c by a proximal term, every group has a closed form
// for them at given rates r = W' u + q - coupling s:
//
//     lambda = max(0, (eps lambda^c - r) / (eps + c)),
//     beta   = the point of { beta >= 0, sum beta <= mu lambda } nearest to beta^c - r / eps.
//
// What is left is a system of 6 + (sum groups) equations, piecewise linear in x = [u; s]:
//
//     u = B G f(x),      sum coupling f(x) + inertia s = target.
//
// Its solution becomes the next f^c, and eps falls. The proximal term vanishes where f = f^c, so a
// limit solves the problem as given: nothing of a penalty is left in it. [Rockafellar 1976]
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/sweeps/coupling_table.hpp"
#include "lcpush/lcp/sweeps/settings.hpp"
#include "lcpush/lcp/sweeps/simplex.hpp"
#include "lcpush/lcp/sweeps/small_solve.hpp"

namespace lcpush {

constexpr Index proximal_scalars(Index n, Index couplings, Index sums) {
  return 4 * n + couplings + (6 + sums) * (6 + sums + 8);
}
constexpr Index proximal_integers(Index n, Index couplings, Index sums) {
  return 2 * n + 1 + couplings + sums;
}

template <class S> class ProximalNewton {
public:
  /// Memory of at least proximal_scalars and proximal_integers elements.
  ProximalNewton(Span<S> scalars, Span<int> integers) : scalars_(scalars), integers_(integers) {}

  /// Takes the forces of `start` (n numbers) as the first f^c. False if the memory is too small.
  /// `problem` (factored) must outlive the run.
  [[nodiscard]] bool init(const Problem<S>& problem, const S* start);

  /// Newton's iterations at this eps, from the last x. True if they converged: z() and the next
  /// f^c are the solution. False: all is as it was before. Cost of a pass: O(forces) and a dense
  /// solve of 6 + (sum groups) unknowns.
  [[nodiscard]] bool settle(S eps, Index most_passes);

  /// All n unknowns: the forces f^c, xi and s as the groups' multipliers.
  void recover(S* z) const;

  Index passes() const { return passes_; } ///< over all groups, since init

private:
  Span<S> scalars_;
  Span<int> integers_;
  Problem<S> problem_;
  Index n_ = 0, dimension_ = 0, passes_ = 0;
  S eps_{1};
  Span<S> force_, center_, rate_, wanted_; // n each; a slip's place in force_ holds theta
  Span<S> x_, trial_, phi_, step_, settled_x_, normal_, tangent_, column_, jacobian_;
  CouplingTable<S> sums_; // its slots are places in x

  const FactoredProblem<S>& factored() const { return *problem_.factored; }

  bool carve(Index couplings, Index sums) {
    Block<S> scalars(scalars_);
    Block<int> integers(integers_);
    for (Span<S>* span : {&force_, &center_, &rate_, &wanted_}) *span = scalars.take(n_);
    sums_.take(scalars, integers, n_, couplings, sums);
    jacobian_ = scalars.take((6 + sums) * (6 + sums));
    for (Span<S>* span : {&x_, &trial_, &phi_, &step_, &settled_x_, &normal_, &tangent_, &column_})
      *span = scalars.take(6 + sums);
    return !scalars.exhausted() && !integers.exhausted();
  }

  S rate_at(Index variable, Index force, const S* x) const {
    const Eigen::Map<const Vector6<S>> u(x);
    S rate = factored().wrenches[force].dot(u) + problem_.q[variable];
    for (Index e = sums_.first[variable]; e < sums_.first[variable + 1]; ++e)
      rate -= sums_.coupling[e] * x[sums_.sum[e]];
    return rate;
  }

  void solve_normal(const ConeGroup<S>& cone) {
    const Index i = cone.variable;
    if (sums_.is_fixed[i] != 0) {
      force_[i] = center_[i];
      return;
    }
    const S before = cone.normal_force(center_.data);
    const S lambda = (eps_ * before - rate_[i]) / (eps_ + cone.compliance);
    cone.set_normal_force(force_.data, lambda);
  }

  void solve_friction(const ConeGroup<S>& cone) {
    const Index first = cone.variable + cone.normals, g = cone.generators;
    const S most = cone.friction_limit(force_.data);
    S theta(0);
    for (Index i = first; i < first + g; ++i) wanted_[i] = center_[i] - rate_[i] / eps_;
    if (most > S(0)) theta = simplex_threshold(wanted_.data + first, g, most);
    for (Index i = first; i < first + g; ++i)
      force_[i] = most > S(0) && wanted_[i] > theta ? S(wanted_[i] - theta) : S(0);
    force_[cone.slip()] = theta;
  }

  /// The forces of all groups at x.
  void respond(const S* x) {
    ++passes_;
    for (const ConeGroup<S>& cone : factored().cones) {
      for (Index k = 0; k < cone.forces(); ++k)
        rate_[cone.variable + k] = rate_at(cone.variable + k, cone.force + k, x);
      solve_normal(cone);
      if (cone.generators > 0) solve_friction(cone);
    }
  }

  /// phi_ = what the shared equations lack at x with the present forces; returns its size.
  S residual(const S* x) {
    Vector6<S> wrench = Vector6<S>::Zero();
    for (Index a = 0; a < factored().sums.size; ++a)
      if (sums_.slot[a] >= 0)
        phi_[sums_.slot[a]] =
            factored().sums[a].inertia * x[sums_.slot[a]] - factored().sums[a].target;
    for (const ConeGroup<S>& cone : factored().cones)
      for (Index k = 0; k < cone.forces(); ++k) {
        const Index i = cone.variable + k;
        if (force_[i] == S(0)) continue;
        wrench += factored().wrenches[cone.force + k] * force_[i];
        for (Index e = sums_.first[i]; e < sums_.first[i + 1]; ++e)
          phi_[sums_.sum[e]] += sums_.coupling[e] * force_[i];
      }
    const Vector6<S> u = factored().mobility.lazyProduct(wrench);
    for (Index k = 0; k < 6; ++k) phi_[k] = x[k] - u[k];
    S squares(0);
    for (Index k = 0; k < dimension_; ++k) squares += phi_[k] * phi_[k];
    return Eigen::numext::sqrt(squares);
  }

  /// [W ; - coupling] of a force: what it does to u and to the sums, and what they do to its rate.
  void extend(Index force, Index variable, Span<S> column) const {
    for (Index k = 0; k < dimension_; ++k) column[k] = k < 6 ? factored().wrenches[force][k] : S(0);
    for (Index e = sums_.first[variable]; e < sums_.first[variable + 1]; ++e)
      column[sums_.sum[e]] -= sums_.coupling[e];
  }

  /// Adds - d(sum of a group's force columns) / dx.
  void add_group(const ConeGroup<S>& cone, MatrixMap<S>& J) {
    const auto add = [&](Span<S> a, Span<S> b, const S& factor) {
      for (Index j = 0; j < dimension_; ++j)
        for (Index i = 0; i < dimension_; ++i) J(i, j) += a[i] * (factor * b[j]);
    };
    const Index i = cone.variable, first = i + cone.normals;
    const S lambda = cone.normal_force(force_.data);
    if (lambda == S(0) && cone.normals == 1) return;
    const S yields = sums_.is_fixed[i] != 0 ? S(0) : S(1) / (eps_ + cone.compliance);
    extend(cone.force, i, normal_);
    if (sums_.is_fixed[i] == 0) add(normal_, normal_, yields);
    if (cone.generators == 0) return;
    S support(0);
    for (Index k = 0; k < dimension_; ++k) tangent_[k] = S(0);
    for (Index k = 0; k < cone.generators; ++k) {
      if (!(force_[first + k] > S(0))) continue;
      extend(cone.force + cone.normals + k, first + k, column_);
      add(column_, column_, S(1) / eps_);
      for (Index d = 0; d < dimension_; ++d) tangent_[d] += column_[d];
      support += S(1);
    }
    if (!(force_[cone.slip()] > S(0)) || !(support > S(0))) return;
    add(tangent_, tangent_, S(-1) / (eps_ * support)); // on the cone's limit the sum is fixed ..
    const S sign = lambda < S(0) ? S(-1) : S(1);
    add(tangent_, normal_, sign * cone.friction * yields / support); // .. but moves with lambda
  }

  void fill_jacobian() {
    MatrixMap<S> J(jacobian_.data, dimension_, dimension_);
    J.setZero();
    for (const ConeGroup<S>& cone : factored().cones) add_group(cone, J);
    for (Index j = 0; j < dimension_; ++j) {
      const Vector6<S> wrench = J.col(j).template head<6>();
      J.col(j).template head<6>() = factored().mobility.lazyProduct(wrench);
    }
    for (Index k = 0; k < 6; ++k) J(k, k) += S(1);
    for (Index a = 0; a < factored().sums.size; ++a)
      if (sums_.slot[a] >= 0) J(sums_.slot[a], sums_.slot[a]) += factored().sums[a].inertia;
  }

  /// One step of Newton's method, halved until phi_ falls. False if it does not.
  bool newton_step() {
    const S before = residual(x_.data);
    fill_jacobian();
    for (Index k = 0; k < dimension_; ++k) step_[k] = -phi_[k];
    if (!solve_small(MatrixMap<S>(jacobian_.data, dimension_, dimension_), step_.data))
      return false;
    S t(1);
    bool falls = false;
    for (int k = 0; k < ProximalSettings::halvings && !falls; ++k, t /= S(2)) {
      for (Index d = 0; d < dimension_; ++d) trial_[d] = x_[d] + t * step_[d];
      respond(trial_.data);
      falls = residual(trial_.data) < (S(1) - t / S(ProximalSettings::decrease)) * before;
    }
    for (Index d = 0; d < dimension_; ++d) x_[d] = trial_[d];
    return falls;
  }
};

template <class S> bool ProximalNewton<S>::init(const Problem<S>& problem, const S* start) {
  problem_ = problem;
  n_ = problem.size;
  passes_ = 0;
  Index couplings = 0;
  for (const SumGroup<S>& sum : factored().sums) couplings += sum.count;
  if (!carve(couplings, factored().sums.size)) return false;
  for (Index i = 0; i < n_; ++i) center_[i] = start[i];
  dimension_ = sums_.sort_sums(factored(), 6, center_);
  sums_.sort_couplings(factored());
  for (Index k = 0; k < dimension_; ++k) x_[k] = settled_x_[k] = S(0);
  return true;
}

template <class S> bool ProximalNewton<S>::settle(S eps, Index most_passes) {
  eps_ = eps;
  const Index end = passes_ + most_passes;
  int stuck = 0;
  S size(1);
  respond(x_.data);
  for (Index k = 0; k < n_; ++k) size = Eigen::numext::maxi(size, Eigen::numext::abs(force_[k]));
  const S small = ProximalSettings::rounding<S>() * size;
  bool settled = residual(x_.data) <= small;
  while (!settled && passes_ < end && stuck <= ProximalSettings::most_stuck) {
    if (!newton_step()) ++stuck;
    settled = residual(x_.data) <= small;
  }
  Span<S> from = settled ? x_ : settled_x_, to = settled ? settled_x_ : x_;
  for (Index d = 0; d < dimension_; ++d) to[d] = from[d];
  if (!settled) return false;
  for (const ConeGroup<S>& cone : factored().cones)
    for (Index k = 0; k < cone.forces(); ++k)
      center_[cone.variable + k] = force_[cone.variable + k];
  return true;
}

template <class S> void ProximalNewton<S>::recover(S* z) const {
  for (const ConeGroup<S>& cone : factored().cones) {
    for (Index k = 0; k < cone.forces(); ++k) z[cone.variable + k] = center_[cone.variable + k];
    if (cone.generators == 0) continue;
    S xi(0);
    for (Index k = cone.normals; k < cone.forces(); ++k)
      xi = Eigen::numext::maxi(xi, S(-rate_at(cone.variable + k, cone.force + k, settled_x_.data)));
    z[cone.slip()] = xi;
  }
  for (Index a = 0; a < factored().sums.size; ++a) {
    const Index s = problem_.free_begin + a;
    if (sums_.slot[a] >= 0) {
      z[s] = settled_x_[sums_.slot[a]];
      continue;
    }
    const Index entry = factored().sums[a].first, i = factored().coupled_variable[entry];
    for (const ConeGroup<S>& cone : factored().cones)
      if (cone.variable == i)
        z[s] = (rate_at(i, cone.force, settled_x_.data) + cone.compliance * z[i]) /
               factored().coupling[entry];
  }
}

} // namespace lcpush
