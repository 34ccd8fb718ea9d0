// The paper's optimisation problem: complementarity as a quadratic penalty on the full form.
#include "export/export_parts.hpp"

namespace lcpush::desktop {
namespace {

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
  return host_matrix(T);
}

} // namespace

void add_program(const OwnedFullForm& full, const std::string& units, Folder& folder) {
  const Index n = full.form().size(), c = full.complementary();
  HostMatrix M = zero_matrix(n, n), q = zero_matrix(n, 1);
  std::vector<unsigned char> eliminated(static_cast<std::size_t>(n));
  full.form().fill(map_of(M), q.values.data(), eliminated.data());
  auto C = map_of(M), f = map_of(q);
  const HostMatrix A = host_matrix(-C.topRows(c)), b = host_matrix(f.topRows(c)),
                   Aeq = host_matrix(C.bottomRows(n - c)), beq = host_matrix(-f.bottomRows(n - c));
  C.bottomRows(n - c).setZero();
  f.bottomRows(n - c).setZero();
  const HostMatrix ub = host_matrix(Eigen::VectorXd::Constant(n, no_bound));
  HostMatrix lb = host_matrix(-Eigen::VectorXd::Constant(n, no_bound));
  map_of(lb).topRows(c).setZero();
  const std::string bounds = units + "; 1e30 stands for no bound";
  folder.matrix("H", host_matrix(C + C.transpose()), "minimise x' H x / 2 + f' x; " + units);
  folder.vector("f", host_matrix(f), units);
  folder.matrix("A", A, "A x <= b; " + units);
  folder.vector("b", b, units);
  folder.matrix("Aeq", Aeq, "Aeq x = beq; " + units);
  folder.vector("beq", beq, units);
  folder.vector("lb", lb, bounds);
  folder.vector("ub", ub, bounds);
  folder.matrix("answer", answer_matrix(full), "the answer in SI units: answer x");
}

} // namespace lcpush::desktop
