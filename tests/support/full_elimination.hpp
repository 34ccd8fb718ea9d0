// The full form of an assembled scene, built and eliminated, on the heap.
#pragma once

#include <cmath>

#include "lcpush/lcp/pivots/reduce.hpp"
#include "lcpush/mechanics/paper/full_form.hpp"
#include "support/dense_lcp.hpp"

namespace lcpush::test {

template <class T> Span<T> span_of(std::vector<T>& array) {
  return {array.data(), static_cast<Index>(array.size())};
}

struct FullElimination {
  const Assembly<double>& assembly;
  std::vector<PatchReferences<double>> patches;
  std::vector<Index> first;
  std::vector<double> weights;
  FullForm<double> form;
  MatrixX<double> M; // of the full form
  VectorX<double> q;
  std::vector<unsigned char> eliminated;
  std::vector<double> scalars;
  std::vector<int> integers;
  DenseLcp<double> reduced; // what elimination leaves, in the assembly's units

  explicit FullElimination(const Assembly<double>& given)
      : assembly(given), patches(static_cast<std::size_t>(given.scene().bodies.size)),
        first(patches.size()),
        weights(static_cast<std::size_t>(most_references * given.scene().points.size)),
        form({span_of(patches), span_of(first), span_of(weights)}) {
    REQUIRE(form.describe(assembly) == Status::solved);
    const Index n = form.size();
    M.resize(n, n);
    q.resize(n);
    eliminated.resize(static_cast<std::size_t>(n));
    scalars.resize(static_cast<std::size_t>(reduction_scalars(n)));
    integers.resize(static_cast<std::size_t>(reduction_integers(n)));
    fill();
  }
  FullElimination(const FullElimination&) = delete;
  FullElimination& operator=(const FullElimination&) = delete;

  /// With the weights as they are now.
  void fill() {
    form.fill(MatrixMap<double>(M.data(), form.size(), form.size()), q.data(), eliminated.data());
  }

  Reduction<double> reduction() { return {span_of(scalars), span_of(integers)}; }

  /// Takes a and r out again; false if that is not what is left.
  bool eliminate() {
    Reduction<double> reduction = this->reduction();
    if (reduction.init(form.size(), M.data(), q.data(), eliminated.data(), SingularBlock::bound) !=
        Status::solved)
      return false;
    const Index n = reduction.problem().size;
    if (n != form.reduced_size() || reduction.redundant_rows().size != 0) return false;
    for (Index k = 0; k < n; ++k)
      if (reduction.unknown_of(k).index != k || reduction.unknown_of(k).swapped) return false;
    reduced = {MatrixX<double>(n, n), VectorX<double>(n), assembly.layout().actuators};
    write_unscaled(reduction);
    return true;
  }

  /// The reduced problem without its scales, powers of two: a column's is the size that a unit of
  /// its unknown recovers to, a row's what then is left between its largest entry and the same one
  /// of M times what was recovered.
  void write_unscaled(const Reduction<double>& reduction) {
    const Problem<double>& problem = reduction.problem();
    const Index n = problem.size;
    const Eigen::Map<const MatrixX<double>> scaled(problem.matrix, n, n);
    MatrixX<double> responses(form.size(), n);
    for (Index j = 0; j < n; ++j) {
      const VectorX<double> unit = VectorX<double>::Unit(n, j);
      reduction.recover_direction(unit.data(), responses.col(j).data());
      reduced.M.col(j) = scaled.col(j) / responses(j, j);
      responses.col(j) /= responses(j, j);
    }
    const MatrixX<double> rows = M.topRows(n) * responses;
    for (Index i = 0; i < n; ++i) {
      Index j = 0;
      const double largest = reduced.M.row(i).cwiseAbs().maxCoeff(&j);
      const double unit =
          largest > 0 ? std::exp2(std::round(std::log2(rows(i, j) / reduced.M(i, j)))) : 1;
      reduced.M.row(i) *= unit;
      reduced.q[i] = problem.q[i] * unit;
    }
  }

  /// The largest difference to the assembly's own (M, q), M's against its largest entry (at least
  /// 1), q's against its own. NaN if anything is.
  double difference() {
    if (!eliminate()) return std::numeric_limits<double>::quiet_NaN();
    const Problem<double> problem = assembly.problem();
    const Index n = problem.size;
    MatrixX<double> own(n, n);
    fill_matrix(problem, MatrixMap<double>(own.data(), n, n));
    double m_size = 1, q_size = 1, worst = 0;
    for (Index i = 0; i < n; ++i) {
      q_size = larger(q_size, absolute(problem.q[i]));
      for (Index j = 0; j < n; ++j) m_size = larger(m_size, absolute(own(i, j)));
    }
    for (Index i = 0; i < n; ++i) {
      worst = larger(worst, absolute(problem.q[i] - reduced.q[i]) / q_size);
      for (Index j = 0; j < n; ++j)
        worst = larger(worst, absolute(own(i, j) - reduced.M(i, j)) / m_size);
    }
    return worst;
  }

  RigidityCheck<double> rigidity(Index body) {
    const Span<const Vector3<double>> points =
        patch_points(assembly.scene(), assembly.scene().bodies[body]);
    std::vector<double> memory(static_cast<std::size_t>(rigidity_scalars(points.size)));
    const Span<double> alpha = form.weights(body);
    return check_rigidity<double>(points, form.patch(body), {alpha.data, alpha.size},
                                  span_of(memory));
  }
};

} // namespace lcpush::test
