// Random factored problems: groups with and without friction, actuators over some of their forces.
#pragma once

#include <vector>

#include "lcpush/lcp/problem.hpp"
#include "support/dense_lcp.hpp"

namespace lcpush::test {

struct FactoredGroups {
  std::vector<Vector6<double>> wrenches;
  std::vector<ConeGroup<double>> cones;
  std::vector<SumGroup<double>> sums;
  std::vector<int> coupled_variable;
  std::vector<double> coupling;
  FactoredProblem<double> factored;
  Index size = 0, free_begin = 0;

  explicit FactoredGroups(Random& random) {
    const MatrixX<double> A = random_matrix(random, 6, 6);
    factored.mobility = A * A.transpose();
    const Index groups = random.integer(1, 6), actuators = random.integer(0, 2);
    for (Index k = 0; k < groups; ++k) add_cone(random);
    free_begin = size;
    for (Index a = 0; a < actuators; ++a) add_sum(random);
    size += actuators;
    factored.wrenches = {wrenches.data(), count(wrenches)};
    factored.cones = {cones.data(), count(cones)};
    factored.sums = {sums.data(), count(sums)};
    factored.coupled_variable = {coupled_variable.data(), count(coupled_variable)};
    factored.coupling = {coupling.data(), count(coupling)};
  }
  FactoredGroups(const FactoredGroups&) = delete;
  FactoredGroups& operator=(const FactoredGroups&) = delete;

  Problem<double> view() const {
    Problem<double> problem;
    problem.size = size;
    problem.free_begin = free_begin;
    problem.factored = &factored;
    return problem;
  }
  MatrixX<double> matrix() const {
    MatrixX<double> M(size, size);
    fill_matrix(view(), MatrixMap<double>(M.data(), size, size));
    return M;
  }

private:
  template <class T> static Index count(const std::vector<T>& v) {
    return static_cast<Index>(v.size());
  }
  void add_cone(Random& random) {
    const Index g = 2 * random.integer(0, 4);
    cones.push_back({count(wrenches), g, size, g > 0 ? random.uniform(0.1, 1) : 0,
                     random.integer(0, 1) == 1 ? random.uniform(0, 1) : 0});
    for (Index k = 0; k <= g; ++k) wrenches.push_back(random_vector(random, 6));
    size += cones.back().size();
  }
  void add_sum(Random& random) {
    SumGroup<double> sum{count(coupling), 0, random.uniform(1, 2), random.uniform(0, 1)};
    for (const ConeGroup<double>& cone : cones)
      for (Index k = 0; k <= cone.generators; ++k) {
        if (random.integer(0, 2) == 0) continue;
        coupled_variable.push_back(static_cast<int>(cone.variable + k));
        coupling.push_back(random.uniform(-1, 1));
      }
    sum.count = count(coupling) - sum.first;
    sums.push_back(sum);
  }
};

} // namespace lcpush::test
