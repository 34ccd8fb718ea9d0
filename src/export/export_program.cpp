// The paper's optimisation problem: complementarity as a quadratic penalty on the full form.
#include "export/export_parts.hpp"

namespace lcpush::desktop {
namespace {

/// M of the full form and q, zeros without a sign so that none of them is written to a file.
void fill_full(const OwnedFullForm& full, HostMatrix& M, HostMatrix& q) {
  const Index n = full.form().size();
  M = zero_matrix(n, n);
  q = zero_matrix(n, 1);
  std::vector<unsigned char> eliminated(static_cast<std::size_t>(n));
  full.form().fill(map_of(M), q.values.data(), eliminated.data());
  for (double& x : M.values) x += 0.0;
  for (double& x : q.values) x += 0.0;
}

/// Rows `first` and on, as many as `to` has, times `sign`.
void copy_rows(const HostMatrix& from, Index first, double sign, HostMatrix& to) {
  for (Index j = 0; j < to.cols; ++j)
    for (Index i = 0; i < to.rows; ++i) map_of(to)(i, j) = sign * from(first + i, j) + 0.0;
}

/// Forces, friction and acceleration of a point, from row `row` on.
void read_contact(const OwnedFullForm& full, Index point, Index row, MatrixMap<double> T) {
  const Scene<double>& scene = full.assembly().scene();
  const Layout<double>& layout = full.assembly().layout();
  const Body<double>& body = scene.bodies[layout.body[point]];
  T(row, layout.normal_index(point)) = layout.scales.force;
  if (body.bilateral) T(row, layout.normal_index(point) + 1) = -layout.scales.force;
  for (Index j = 0; j < layout.cones[point].generators; ++j) {
    const Generator<double> d = generator(body, j, scene.facets);
    T.block<3, 1>(row + 1, layout.friction_index(point, j)) = layout.scales.force * d.force;
    T(row + 4, layout.friction_index(point, j)) = layout.scales.force * d.torque;
  }
  const Vector3<double> axes[] = {body.normal, body.tangent, cross(body.normal, body.tangent)};
  for (Index c = 0; c < 3; ++c)
    T.block<3, 1>(row + 5, full.form().relative(point) + c) = layout.scales.acceleration * axes[c];
}

HostMatrix answer_matrix(const OwnedFullForm& full) {
  const Layout<double>& layout = full.assembly().layout();
  HostMatrix answer = zero_matrix(6 + layout.actuators + 8 * layout.points, full.form().size());
  MatrixMap<double> T = map_of(answer);
  for (Index k = 0; k < 6; ++k)
    T(k, full.form().acceleration() + k) =
        layout.scales.acceleration / (k < 3 ? 1 : layout.scales.length);
  for (Index a = 0; a < layout.actuators; ++a)
    T(6 + a, layout.closing_index(a)) = unknown_unit(layout, layout.closing_index(a));
  for (Index i = 0; i < layout.points; ++i) read_contact(full, i, 6 + layout.actuators + 8 * i, T);
  for (double& x : answer.values) x += 0.0;
  return answer;
}

} // namespace

PaperProgram paper_program(const OwnedFullForm& full) {
  const Index n = full.form().size(), c = full.complementary();
  HostMatrix M, q;
  fill_full(full, M, q);
  PaperProgram program;
  program.complementary = c;
  program.A = zero_matrix(c, n);
  program.b = zero_matrix(c, 1);
  program.Aeq = zero_matrix(n - c, n);
  program.beq = zero_matrix(n - c, 1);
  copy_rows(M, 0, -1, program.A);
  copy_rows(q, 0, 1, program.b);
  copy_rows(M, c, 1, program.Aeq);
  copy_rows(q, c, -1, program.beq);
  map_of(M).bottomRows(n - c).setZero(); // C
  program.H = zero_matrix(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) map_of(program.H)(i, j) = M(i, j) + M(j, i);
  program.f = std::move(q);
  program.lb = zero_matrix(n, 1);
  program.ub = zero_matrix(n, 1);
  for (Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (i >= c) program.f.values[k] = 0;
    program.lb.values[k] = i < c ? 0 : -no_bound;
    program.ub.values[k] = no_bound;
  }
  program.answer = answer_matrix(full);
  return program;
}

PaperProgram paper_program(const SceneFile& file) {
  Push push(file);
  return paper_program(OwnedFullForm(push.assembly()));
}

} // namespace lcpush::desktop
