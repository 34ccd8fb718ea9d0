// The mixed linear complementarity problem
//
//     w = M z + q,   0 <= z_i _|_ w_i >= 0   for i <  free_begin
//                    z_i free, w_i = 0       for i >= free_begin
//
// in the two forms that the solvers read: a dense matrix, or the factored form that mechanics
// assembles. Both only look at memory that the caller owns.
#pragma once

#include "lcpush/lcp/loops.hpp"

namespace lcpush {

/// One normal unknown lambda, its generators' unknowns beta_1..beta_g and its slip unknown xi:
/// variables [lambda, beta_1, .., beta_g, xi], just [lambda] when there is no friction.
/// A group that can pull as well has normals = 2 and the variables [lambda+, lambda-, beta_1, ..]:
/// its normal force is lambda+ - lambda-, the second wrench column the first one's negative.
template <class S> struct ConeGroup {
  Index force;       ///< column of lambda among the wrenches; the other forces follow
  Index generators;  ///< g, 0 for a frictionless group
  Index variable;    ///< index of lambda in z; the other forces follow, in the wrenches' order
  S friction;        ///< mu
  S compliance;      ///< c >= 0, between the normal force and the normal acceleration
  Index normals = 1; ///< 1: pushes only; 2: pulls as well

  Index forces() const { return normals + generators; }
  Index size() const { return forces() + (generators == 0 ? 0 : 1); }
  Index slip() const { return variable + forces(); }
  /// lambda, with its sign.
  S normal_force(const S* z) const {
    return normals == 2 ? S(z[variable] - z[variable + 1]) : z[variable];
  }
  void set_normal_force(S* z, const S& lambda) const {
    z[variable] = lambda > S(0) ? lambda : S(0);
    if (normals == 2) z[variable + 1] = lambda < S(0) ? S(-lambda) : S(0);
  }
  /// mu |lambda|, what the friction forces may sum up to.
  S friction_limit(const S* z) const { return friction * Eigen::numext::abs(normal_force(z)); }
};

/// Forces that share an actuator: row sum_k coupling_k z_k + inertia s - target = 0, s free.
/// The same coefficients enter the rows of those forces with the opposite sign (skew).
template <class S> struct SumGroup {
  Index first; ///< first entry in the coupling arrays
  Index count;
  S target;  ///< tau
  S inertia; ///< m_a >= 0
};

/// M without its n^2 numbers: G' B G plus the groups' structure. Free unknowns (one a sum group)
/// come last. Size of everything: O(forces).
template <class S> struct FactoredProblem {
  Matrix6<S> mobility;              ///< B = M^-1 of the object, 6 x 6
  Span<const Vector6<S>> wrenches;  ///< G, one column a force
  Span<const ConeGroup<S>> cones;   ///< in the order of their variables
  Span<const SumGroup<S>> sums;     ///< variable of group a: free_begin + a
  Span<const int> coupled_variable; ///< per coupling entry: the force's index in z, ascending in
                                    ///< a sum group
  Span<const S> coupling;           ///< per coupling entry: W' J
};

/// What a solver needs to know. Exactly one of `matrix` and `factored` is set.
template <class S> struct Problem {
  Index size = 0;            ///< n
  Index free_begin = 0;      ///< first free unknown; n if there is none
  const S* matrix = nullptr; ///< n x n, column-major
  const FactoredProblem<S>* factored = nullptr;
  const S* q = nullptr;    ///< n
  const S* push = nullptr; ///< n or null: q is q + sigma push with an infinitesimal sigma > 0
};

/// Which cone group unknown `variable` belongs to, groups in the order of their variables. Pre: one
/// begins at it or before. Cost: O(log groups).
template <class S> Index cone_of(Span<const ConeGroup<S>> cones, Index variable) {
  Index low = 0, high = cones.size;
  while (high - low > 1) {
    const Index middle = (low + high) / 2;
    (cones[middle].variable <= variable ? low : high) = middle;
  }
  return low;
}

/// G f for the forces in z: the contact wrench on the object. O(forces).
template <class S> Vector6<S> contact_wrench(const FactoredProblem<S>& problem, const S* z) {
  Vector6<S> wrench = Vector6<S>::Zero();
  for (const ConeGroup<S>& cone : problem.cones)
    for (Index k = 0; k < cone.forces(); ++k)
      if (const S& force = z[cone.variable + k]; force != S(0)) // most are 0
        wrench += problem.wrenches[cone.force + k] * force;
  return wrench;
}

/// visit(i, j, M_ij) for what the groups add to G' A G in M: first cones, then sums. O(forces).
template <class S, class Visit>
void for_each_group_entry(const FactoredProblem<S>& problem, Index free_begin, Visit visit) {
  for (const ConeGroup<S>& cone : problem.cones) {
    const Index i = cone.variable;
    for (Index j = 0; j < cone.normals; ++j)
      for (Index k = 0; k < cone.normals; ++k)
        visit(i + j, i + k, j == k ? cone.compliance : S(-cone.compliance));
    if (cone.generators == 0) continue;
    for (Index k = 0; k < cone.normals; ++k) visit(cone.slip(), i + k, cone.friction);
    for (Index k = cone.normals; k < cone.forces(); ++k) {
      visit(i + k, cone.slip(), S(1));
      visit(cone.slip(), i + k, S(-1));
    }
  }
  for (Index a = 0; a < problem.sums.size; ++a) {
    const SumGroup<S>& sum = problem.sums[a];
    visit(free_begin + a, free_begin + a, sum.inertia);
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      visit(free_begin + a, Index(problem.coupled_variable[k]), problem.coupling[k]);
      visit(Index(problem.coupled_variable[k]), free_begin + a, S(-problem.coupling[k]));
    }
  }
}

namespace detail {

/// The same entries times z, every sum in a register: this product is in every check of an answer.
template <class S>
void multiply_factored(const FactoredProblem<S>& problem, Index free_begin, const S* z, S* out) {
  const Vector6<S> a = problem.mobility.lazyProduct(contact_wrench(problem, z));
  for (const ConeGroup<S>& cone : problem.cones) {
    const Index i = cone.variable;
    for (Index k = 0; k < cone.forces(); ++k) out[i + k] = problem.wrenches[cone.force + k].dot(a);
    const S yields = cone.compliance * cone.normal_force(z);
    out[i] += yields;
    if (cone.normals == 2) out[i + 1] -= yields;
    if (cone.generators == 0) continue;
    S cone_row = cone.friction * z[i];
    if (cone.normals == 2) cone_row += cone.friction * z[i + 1];
    for (Index k = cone.normals; k < cone.forces(); ++k) {
      out[i + k] += z[cone.slip()];
      cone_row -= z[i + k];
    }
    out[cone.slip()] = cone_row;
  }
  for (Index a_index = 0; a_index < problem.sums.size; ++a_index) {
    const SumGroup<S>& sum = problem.sums[a_index];
    const S s = z[free_begin + a_index];
    S row = sum.inertia * s;
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      row += problem.coupling[k] * z[problem.coupled_variable[k]];
      out[problem.coupled_variable[k]] -= problem.coupling[k] * s;
    }
    out[free_begin + a_index] = row;
  }
}

/// M = G' A G, and zeros elsewhere.
template <class S> void fill_mobility(const FactoredProblem<S>& problem, MatrixMap<S> M) {
  VectorMap<S>(M.data(), M.size()).setZero(); // in one loop, without a call an entry
  for (const ConeGroup<S>& acting : problem.cones)
    for (Index k = 0; k < acting.forces(); ++k) {
      const Vector6<S> a = problem.mobility.lazyProduct(problem.wrenches[acting.force + k]);
      auto column = M.col(acting.variable + k);
      for (const ConeGroup<S>& felt : problem.cones)
        for (Index j = 0; j < felt.forces(); ++j)
          column[felt.variable + j] = problem.wrenches[felt.force + j].dot(a);
    }
}

} // namespace detail

/// out = M z. Cost: n times the number of non-zero z (dense), O(n) (factored).
template <class S> void multiply(const Problem<S>& problem, const S* z, S* out) {
  if (problem.factored != nullptr) {
    detail::multiply_factored(*problem.factored, problem.free_begin, z, out);
    return;
  }
  const Index n = problem.size;
  for (Index i = 0; i < n; ++i) out[i] = S(0);
  for (Index j = 0; j < n; ++j) {
    if (z[j] != S(0)) detail::add_scaled(out, problem.matrix + j * n, z[j], n);
  }
}

/// out = M z where z is -1 for every free unknown, and 0 elsewhere. Cost: O(n) if factored.
template <class S> void multiply_bound(const Problem<S>& problem, VectorMap<S> out) {
  out.setZero();
  if (problem.factored == nullptr) {
    for (Index j = problem.free_begin; j < problem.size; ++j)
      detail::add_scaled(out.data(), problem.matrix + j * problem.size, S(-1), problem.size);
    return;
  }
  const FactoredProblem<S>& factored = *problem.factored;
  for (Index a = 0; a < factored.sums.size; ++a) {
    const SumGroup<S>& sum = factored.sums[a];
    out[problem.free_begin + a] = -sum.inertia;
    for (Index k = sum.first; k < sum.first + sum.count; ++k)
      out[factored.coupled_variable[k]] += factored.coupling[k];
  }
}

/// Writes M into an n x n view.
template <class S> void fill_matrix(const Problem<S>& problem, MatrixMap<S> M) {
  if (problem.factored != nullptr) {
    detail::fill_mobility(*problem.factored, M);
    for_each_group_entry(*problem.factored, problem.free_begin,
                         [&](Index i, Index j, const S& entry) { M(i, j) += entry; });
    return;
  }
  const Index n = problem.size;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) M(i, j) = problem.matrix[j * n + i];
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template Vector6<double> contact_wrench<double>(const FactoredProblem<double>&,
                                                       const double*);
namespace detail {
extern template void multiply_factored<double>(const FactoredProblem<double>&, Index, const double*,
                                               double*);
} // namespace detail
extern template void fill_matrix<double>(const Problem<double>&, MatrixMap<double>);
#endif

} // namespace lcpush
