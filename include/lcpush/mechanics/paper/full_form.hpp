// [T.6] The paper's full form: contact accelerations are unknowns, patch rigidity [P.5] is rows.
//
// Assembly knows every contact acceleration from the object's own [P.10] and has no unknowns for
// them. Here each point has its relative acceleration r_i as the paper has it, in components along
// n, t, o of its body (and the spin about n at a soft point): the references of a patch take their
// rows from [P.10], all its other points follow them by the weights of patch_rigidity.hpp.
//
//   unknowns            rows
//   lambda, beta, xi    n' r_i >= 0, d_ij' r_i + xi_i >= 0, mu lambda_i - sum beta_ij >= 0
//   s                   J' f + m_a s - tau = 0                                             [T.5]
//   a                   M a - w - G f = 0; in a planar scene a_z = a_rx = a_ry = 0         [T.1]
//   r                   r_c - W' (a - A_b - J s) = 0, or r_j - sum_c alpha_c r_c = 0
//
// Unknowns before `a` have the Assembly's order and units, so eliminating a and r must give the
// Assembly's problem again. That is what the full form is for: another road to the same numbers.
// The literal laws, without a pressure law.
#pragma once

#include "lcpush/mechanics/model/assemble.hpp"
#include "lcpush/mechanics/paper/paper_matrices.hpp"
#include "lcpush/mechanics/paper/patch_rigidity.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// The caller's arrays.
template <class S> struct FullFormMemory {
  Span<PatchReferences<S>> patches; ///< one a body
  Span<Index> first;                ///< one a body: its first unknown r
  Span<S> weights;                  ///< most_references a point, in the scene's order
};

template <class S> class FullForm {
public:
  explicit FullForm(const FullFormMemory<S>& memory) : memory_(memory) {}

  /// Chooses references and weights. Post: solved, or bad_input if the memory is too small. The
  /// assembly must outlive the full form. Cost: O(points).
  [[nodiscard]] Status describe(const Assembly<S>& assembly) {
    assembly_ = &assembly;
    if (memory_.patches.size < scene().bodies.size || memory_.first.size < scene().bodies.size ||
        memory_.weights.size < most_references * scene().points.size)
      return Status::bad_input;
    size_ = acceleration() + 6;
    for (Index b = 0; b < scene().bodies.size; ++b) {
      const Body<S>& body = scene().bodies[b];
      const Span<const Vector3<S>> points = patch_points(scene(), body);
      memory_.patches[b] = choose_references(points);
      interpolation_weights(points, memory_.patches[b], weights(b));
      memory_.first[b] = size_;
      size_ += contact_components(body) * body.point_count;
    }
    return Status::solved;
  }

  Index size() const { return size_; }
  /// Unknowns of the assembly's problem; a and r, which elimination removes, come after them.
  Index reduced_size() const { return layout().size; }
  Index acceleration() const { return layout().size; }
  /// The n component of r of a point; t, o and a soft point's spin follow.
  Index relative(Index point) const {
    const Index b = layout().body[point];
    const Body<S>& body = scene().bodies[b];
    return memory_.first[b] + contact_components(body) * (point - body.first_point);
  }

  const PatchReferences<S>& patch(Index body) const { return memory_.patches[body]; }
  /// A body's weights; the memory is the caller's and fill() reads it as it is then.
  Span<S> weights(Index body) const {
    const Body<S>& b = scene().bodies[body];
    return {memory_.weights.data + most_references * b.first_point,
            most_references * b.point_count};
  }

  /// w = M z + q, M size() x size(), the assembly's sigma in q. eliminated[i] (size() of them) is 1
  /// for a and r, 0 for what the assembly's problem has; with these flags for is_free a Reduction
  /// leaves that problem. Flag s as well and s may leave through a row of r: the answers are the
  /// same, but Lemke's guarantee is gone, which needs s paired with its own row. Cost: O(size()^2).
  void fill(MatrixMap<S> M, S* q, unsigned char* eliminated) const {
    M.setZero();
    for (Index i = 0; i < size_; ++i) {
      q[i] = S(0);
      eliminated[i] = i < reduced_size() ? 0 : 1;
    }
    fill_newton(M, q);
    for (Index a = 0; a < layout().actuators; ++a) {
      const SumGroup<S> grip = laws::grip_force(scene(), a, layout().reach[a], scales());
      const Index s = layout().closing_index(a);
      M(s, s) = grip.inertia;
      q[s] = -grip.target;
    }
    for (Index i = 0; i < layout().points; ++i) {
      const Index b = layout().body[i];
      fill_contact(i, M);
      if (patch(b).reference_of(i - scene().bodies[b].first_point) >= 0)
        fill_reference(i, M, q);
      else
        fill_follower(i, M);
    }
  }

private:
  FullFormMemory<S> memory_;
  const Assembly<S>* assembly_ = nullptr;
  Index size_ = 0;

  const Scene<S>& scene() const { return assembly_->scene(); }
  const Layout<S>& layout() const { return assembly_->layout(); }
  const Scales<S>& scales() const { return assembly_->layout().scales; }

  /// [T.1] without its forces.
  void fill_newton(MatrixMap<S> M, S* q) const {
    const Index a = acceleration();
    const S unit = scene().object.mass * scales().length * scales().length;
    const Vector6<S> w = laws::load(scene(), scales());
    for (Index k = 0; k < 6; ++k) {
      M(a + k, a + k) = S(1);
      q[a + k] = S(0);
      if (!moves_along(scene(), k)) continue;
      q[a + k] = -w[k];
      for (Index l = 3; k >= 3 && l < 6; ++l)
        M(a + k, a + l) = scene().object.inertia(k - 3, l - 3) / unit;
    }
  }

  /// What force k of a point does: to the object [T.1] and to the actuators of its body [T.5].
  void fill_force(Index point, Index k, MatrixMap<S> M) const {
    const Index b = layout().body[point], variable = layout().cones[point].variable + k;
    const Body<S>& body = scene().bodies[b];
    Vector6<S> column = polyhedral_column(scene(), body, scene().points[point], k);
    column.template tail<3>() /= scales().length;
    for (Index row = 0; row < 6; ++row)
      if (!(scene().planar && row >= 2 && row <= 4))
        M(acceleration() + row, variable) = -column[row];
    for (const Drive<S>& drive : scene().drives)
      if (drive.body == b)
        M(layout().closing_index(drive.actuator), variable) +=
            laws::grip_coefficient(drive, column, layout().reach[drive.actuator], scales());
  }

  /// [T.2], [T.3] and [T.4] of a point, in its own r.
  void fill_contact(Index point, MatrixMap<S> M) const {
    const Body<S>& body = scene().bodies[layout().body[point]];
    const Index normals = normal_count(body), generators = generator_count(scene(), body);
    const Index lambda = layout().normal_index(point), r = relative(point);
    const Index xi = lambda + normals + generators;
    const Vector3<S> o = cross(body.normal, body.tangent);
    for (Index k = 0; k < normals + generators; ++k) fill_force(point, k, M);
    M(lambda, r) = S(1);
    if (normals == 2) M(lambda + 1, r) = S(-1);
    for (Index j = 0; j < generators; ++j) {
      const Generator<S> d = generator(body, j, scene().facets);
      const Index beta = lambda + normals + j;
      M(beta, r + 1) = d.force.dot(body.tangent);
      M(beta, r + 2) = d.force.dot(o);
      if (contact_components(body) == 4) M(beta, r + 3) = d.torque / scales().length;
      M(beta, xi) = S(1);
      M(xi, beta) = S(-1);
    }
    for (Index k = 0; generators > 0 && k < normals; ++k) M(xi, lambda + k) = body.friction;
  }

  /// [P.10]: r = W' (a - A_b - J s).
  void fill_reference(Index point, MatrixMap<S> M, S* q) const {
    const Index b = layout().body[point];
    const Body<S>& body = scene().bodies[b];
    const Vector6<S> A_b = assembly_->sigma() * laws::prescribed(body, scales());
    for (Index c = 0; c < contact_components(body); ++c) {
      const Index row = relative(point) + c;
      const Vector6<S> W = contact_column<S>(body, scene().points[point] / scales().length, c);
      M(row, row) = S(1);
      for (Index k = 0; k < 6; ++k) M(row, acceleration() + k) = -W[k];
      for (const Drive<S>& drive : scene().drives)
        if (drive.body == b)
          M(row, layout().closing_index(drive.actuator)) +=
              laws::grip_coefficient(drive, W, layout().reach[drive.actuator], scales());
      q[row] = W.dot(A_b);
    }
  }

  /// [P.5]: r_j = sum_c alpha_c r_c, component by component: a body's points share their axes.
  void fill_follower(Index point, MatrixMap<S> M) const {
    const Index b = layout().body[point];
    const Body<S>& body = scene().bodies[b];
    const S* const alpha = &memory_.weights[most_references * point];
    for (Index c = 0; c < contact_components(body); ++c) {
      M(relative(point) + c, relative(point) + c) = S(1);
      for (Index e = 0; e < patch(b).count(); ++e)
        M(relative(point) + c, relative(body.first_point + patch(b).point[e]) + c) = -alpha[e];
    }
  }
};

} // namespace lcpush
