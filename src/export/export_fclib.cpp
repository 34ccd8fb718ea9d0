// The local problem of the Frictional Contact Library, from the paper's matrices in SI units.
#include "export/export_parts.hpp"

namespace lcpush::desktop {
namespace {

std::string refusal(const SceneFile& file) {
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].torsion_radius > 0)
      return "\"" + file.body_names[b] +
             "\" resists twisting at a point; a contact of FCLIB does not";
    if (file.bodies[b].bilateral)
      return "\"" + file.body_names[b] + "\" pulls as well; a contact of FCLIB only pushes";
  }
  return "";
}

} // namespace

FclibProblem fclib_problem(const SceneFile& file) {
  FclibProblem problem;
  problem.refusal = refusal(file);
  if (!problem.refusal.empty()) return problem;
  const EvenScene even(file.view());
  const Scene<double>& scene = even.scene;
  const Index rows = contact_components(scene), e = scene.actuators.size;

  HostMatrix grasp = zero_matrix(6, rows);
  grasp_matrix(scene, map_of(grasp));
  const MatrixMap<double> G = map_of(grasp);
  // M^-1 in SI units; in a planar scene nothing moves out of the plane.
  const Matrix6<double> B = laws::newton(scene, Scales<double>{1, 1, 1}) / scene.object.mass;
  problem.W = host_matrix(G.transpose() * (B * G));
  // Rounding has no reason to be symmetric; readers test for it.
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < j; ++i) map_of(problem.W)(j, i) = problem.W(i, j);

  problem.V = zero_matrix(rows, e);
  hand_jacobian(scene, map_of(problem.V));
  problem.R = zero_matrix(e, e);
  problem.s = zero_matrix(e, 1);
  for (Index a = 0; a < e; ++a) {
    map_of(problem.R)(a, a) = 0.0 - scene.actuators[a].inertia;
    map_of(problem.s)(a, 0) = 0.0 - scene.actuators[a].force;
  }

  problem.mu = zero_matrix(scene.points.size, 1);
  problem.q = zero_matrix(rows, 1);
  const Vector6<double> fall = B * load(scene);
  for (const Body<double>& body : scene.bodies)
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      map_of(problem.mu)(i, 0) = body.friction;
      map_of(problem.q).middleRows<3>(3 * i) =
          G.middleCols<3>(3 * i).transpose() * (fall - body.acceleration);
    }
  for (HostMatrix* matrix : {&problem.W, &problem.V, &problem.q})
    for (double& x : matrix->values) x += 0.0;
  return problem;
}

} // namespace lcpush::desktop
