#include "solve/rest_by_friction.hpp"

#include <cmath>

#include "dense/decompositions.hpp"

namespace lcpush::desktop {
double onto_neighbours(double along, double across, Index g, double* beta) {
  for (Index k = 0; k < g; ++k) beta[k] = 0;
  if (!(std::hypot(along, across) > 0)) return 0;
  if (g == 2) return beta[along < 0 ? 1 : 0] = std::abs(along); // an interval has no across
  constexpr double turn = 6.283185307179586;
  const double angle = std::atan2(across, along) / turn;
  const auto j =
      static_cast<Index>(std::floor((angle < 0 ? angle + 1 : angle) * static_cast<double>(g)));
  const Index k = j % g, next = (j + 1) % g;
  const double c = circle_cosine<double>(k, g), s = circle_sine<double>(k, g);
  const double c_next = circle_cosine<double>(next, g), s_next = circle_sine<double>(next, g);
  const double sine = c * s_next - s * c_next; // of the angle between them
  beta[k] = std::max(0.0, (along * s_next - across * c_next) / sine);
  beta[next] = std::max(0.0, (across * c - along * s) / sine);
  return beta[k] + beta[next];
}

std::vector<double> rest_by_friction(const Assembly<double>& assembly, const double* preload) {
  const Scene<double>& scene = assembly.scene();
  const Layout<double>& layout = assembly.layout();
  constexpr Index most_sums = 16;
  if (layout.actuators > most_sums) return {};
  for (Index b = 0; b < scene.bodies.size; ++b)
    if (!is_driven(scene, b) || scene.bodies[b].torsion_radius > 0 || scene.bodies[b].bilateral)
      return {};
  // What a unit of force does to the balance of the object and of the actuators.
  const Index balances = 6 + layout.actuators;
  const auto column = [&](Index i, const Vector3<double>& direction) {
    Eigen::VectorXd does = Eigen::VectorXd::Zero(balances);
    const Vector6<double> wrench =
        wrench_column<double>(scene.points[i] / layout.scales.length, direction);
    does.head<6>() = wrench;
    stay_in_plane(scene, does);
    for_each_grip(scene, layout, layout.body[i], wrench,
                  [&](Index a, double grip) { does[6 + a] += grip; });
    return does;
  };
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(balances, balances);
  Eigen::VectorXd wanted(balances);
  wanted.head<6>() = -laws::load(scene, layout.scales);
  stay_in_plane(scene, wanted);
  for (Index a = 0; a < layout.actuators; ++a) wanted[6 + a] = assembly.factored().sums[a].target;
  for (Index i = 0; i < layout.points; ++i) {
    const Body<double>& body = scene.bodies[layout.body[i]];
    const Eigen::VectorXd n = column(i, body.normal), t = column(i, body.tangent),
                          o = column(i, cross(body.normal, body.tangent));
    wanted -= preload[i] * n;
    stiffness += preload[i] * (n * n.transpose());
    const double grips = preload[i] * layout.cones[i].friction;
    stiffness += grips * (t * t.transpose() + o * o.transpose());
  }
  const Eigen::VectorXd motion = PivotedQr(stiffness).solve(wanted);
  if (!((stiffness * motion - wanted).norm() <= 1e-12 * (1 + wanted.norm()))) return {};
  std::vector<double> z(static_cast<std::size_t>(layout.size), 0.0);
  for (Index i = 0; i < layout.points; ++i) {
    const Body<double>& body = scene.bodies[layout.body[i]];
    const ConeGroup<double>& cone = layout.cones[i];
    double* const forces = &z[static_cast<std::size_t>(cone.variable)];
    forces[0] = preload[i] * (1 + column(i, body.normal).dot(motion));
    if (!(forces[0] >= 0)) return {};
    if (cone.generators == 0) continue;
    const double grips = preload[i] * cone.friction;
    const double along = grips * column(i, body.tangent).dot(motion);
    const double across = grips * column(i, cross(body.normal, body.tangent)).dot(motion);
    if (onto_neighbours(along, across, cone.generators, forces + 1) > cone.friction * forces[0])
      return {};
  }
  return z;
}

} // namespace lcpush::desktop
