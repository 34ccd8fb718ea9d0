// The local problem of the Frictional Contact Library, from the paper's matrices in SI units.
#include "dense/decompositions.hpp"
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

void add_fclib(const SceneFile& file, Export& result, Folder& folder) {
  const std::string comment = "FCLIB's local problem, SI units";
  result.fclib_refusal = refusal(file);
  if (!result.fclib_refusal.empty()) {
    for (const char* name : {"W", "V", "R", "mu", "q", "s"})
      result.absent.push_back(std::string("fclib/") + name + ".mtx");
    return;
  }
  const EvenScene even(file.view());
  const Scene<double>& scene = even.scene;
  const Index rows = contact_components(scene), e = scene.actuators.size;

  HostMatrix grasp = zero_matrix(6, rows);
  grasp_matrix(scene, map_of(grasp));
  const MatrixMap<double> G = map_of(grasp);
  // M^-1 in SI units; in a planar scene nothing moves out of the plane.
  const Matrix6<double> B = laws::newton(scene, Scales<double>{1, 1, 1}) / scene.object.mass;
  HostMatrix W = host_matrix(product(G.transpose(), product(B, G)));
  // Rounding has no reason to be symmetric; readers test for it.
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < j; ++i) map_of(W)(j, i) = W(i, j);
  folder.matrix("fclib/W", W, comment);

  HostMatrix V = zero_matrix(rows, e), R = zero_matrix(e, e), s = zero_matrix(e, 1);
  hand_jacobian(scene, map_of(V));
  for (Index a = 0; a < e; ++a) {
    map_of(R)(a, a) = 0.0 - scene.actuators[a].inertia;
    map_of(s)(a, 0) = 0.0 - scene.actuators[a].force;
  }
  if (e > 0) { // as FCLIB has it: V, R and s only where there are equalities
    folder.matrix("fclib/V", host_matrix(map_of(V)), comment);
    folder.matrix("fclib/R", R, comment);
  } else {
    result.absent = {"fclib/V.mtx", "fclib/R.mtx", "fclib/s.mtx"};
  }

  HostMatrix mu = zero_matrix(scene.points.size, 1), q = zero_matrix(rows, 1);
  const Vector6<double> fall = B * load(scene);
  for (const Body<double>& body : scene.bodies)
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      map_of(mu)(i, 0) = body.friction;
      for (Index c = 0; c < 3; ++c)
        map_of(q)(3 * i + c, 0) = G.col(3 * i + c).dot(fall - body.acceleration);
    }
  folder.vector("fclib/mu", mu, comment);
  folder.vector("fclib/q", host_matrix(map_of(q)), comment);
  if (e > 0) folder.vector("fclib/s", s, comment);
}

} // namespace lcpush::desktop
