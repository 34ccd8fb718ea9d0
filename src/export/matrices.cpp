#include "lcpush/desktop/matrices.hpp"

#include <utility>

#include "export/export_parts.hpp"
#include "lcpush/mechanics/paper/paper_matrices.hpp"

namespace lcpush::desktop {
namespace {

const std::vector<std::string> wrench_rows = {"fx", "fy", "fz", "mx", "my", "mz"};
const std::vector<std::string> twist_rows = {"ax", "ay", "az", "rx", "ry", "rz"};

NamedMatrix named(std::vector<std::string> rows, std::vector<std::string> columns) {
  const auto size = [](const auto& names) { return static_cast<Index>(names.size()); };
  HostMatrix zeros = zero_matrix(size(rows), size(columns));
  return {std::move(rows), std::move(columns), std::move(zeros)};
}

MatrixMap<double> map_of(NamedMatrix& matrix) { return map_of(matrix.values); }

void add_component_names(const SceneFile& file, const Body<double>& body,
                         std::vector<std::string>& names) {
  static const std::vector<std::string> components = {" n", " t", " o", " torsion"};
  for (const Index i : points_of(body))
    for (Index c = 0; c < contact_components(body); ++c)
      names.push_back(point_name(file, i) + components[static_cast<std::size_t>(c)]);
}

std::vector<std::string> component_names(const SceneFile& file) {
  std::vector<std::string> names;
  for (const Body<double>& body : file.bodies) add_component_names(file, body, names);
  return names;
}

std::vector<std::string> generator_names(Index count) {
  std::vector<std::string> names;
  for (Index j = 0; j < count; ++j) names.push_back("d" + std::to_string(j));
  return names;
}

std::vector<std::string> force_names(const SceneFile& file) {
  const Scene<double> scene = file.view();
  std::vector<std::string> names;
  for (const Body<double>& body : file.bodies)
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      names.push_back(point_name(file, i) + " n");
      if (normal_count(body) == 2) names.push_back(point_name(file, i) + " -n");
      for (const std::string& d : generator_names(generator_count(scene, body)))
        names.push_back(point_name(file, i) + " " + d);
    }
  return names;
}

BodyGenerators body_generators(const SceneFile& file, std::size_t b) {
  const Scene<double> scene = file.view();
  const Body<double>& body = file.bodies[b];
  std::vector<std::string> rows = {"t", "o"};
  if (contact_components(body) == 4) rows.push_back("torsion");
  BodyGenerators generators{file.body_names[b],
                            named(rows, generator_names(generator_count(scene, body)))};
  friction_generators(scene, body, map_of(generators.D));
  return generators;
}

/// The actuators whose acceleration is prescribed, as columns of J beside the others.
void add_prescribed(const SceneFile& file, PaperMatrices& matrices) {
  std::vector<std::string> names;
  std::vector<Drive<double>> drives;
  std::vector<double> accelerations;
  for (const PrescribedDrive<double>& drive : file.prescribed) {
    if (names.empty() || names.back() != drive.actuator) { // an actuator's bodies stand together
      names.push_back(drive.actuator);
      accelerations.push_back(drive.acceleration);
    }
    drives.push_back({drive.body, static_cast<Index>(names.size()) - 1, drive.twist});
  }
  matrices.J_prescribed = named(component_names(file), names);
  hand_jacobian<double>(file.view(), span_of(std::as_const(drives)), map_of(matrices.J_prescribed));
  matrices.s_prescribed = named(names, {"s"});
  matrices.s_prescribed.values.values = accelerations;
}

PusherJacobian pusher_jacobian(const SceneFile& file, Index b) {
  std::vector<std::string> rows;
  add_component_names(file, file.body(b), rows);
  PusherJacobian pusher{file.body_name(b), named(rows, twist_rows), named(twist_rows, {"A"})};
  body_jacobian(file.view(), file.body(b), map_of(pusher.J));
  Vector6<double> own = file.body(b).acceleration;
  for (const PrescribedDrive<double>& drive : file.prescribed)
    if (drive.body == b) own -= drive.acceleration * drive.twist;
  map_of(pusher.twist) = own;
  return pusher;
}

PatchRigidity patch_rigidity(const SceneFile& file, std::size_t b) {
  const Body<double>& body = file.bodies[b];
  const Span<const Vector3<double>> points = patch_points(file.view(), body);
  const PatchReferences<double> at = choose_references(points);
  std::vector<double> alpha(static_cast<std::size_t>(most_references * points.size));
  interpolation_weights(points, at, span_of(alpha));

  PatchRigidity patch;
  patch.body = file.body_names[b];
  for (Index c = 0; c < at.count(); ++c)
    patch.references.push_back(point_name(file, body.first_point + at.point[c]));
  for (Index j = 0; j < points.size; ++j) {
    patch.points.push_back(point_name(file, body.first_point + j));
    const double* const own = &alpha[static_cast<std::size_t>(most_references * j)];
    patch.weights.emplace_back(own, own + at.count());
  }
  patch.checked = points.size <= largest_checked_patch;
  std::vector<double> memory;
  if (patch.checked) memory.resize(static_cast<std::size_t>(rigidity_scalars(points.size)));
  patch.check = check_rigidity<double>(points, at, span_of(std::as_const(alpha)), span_of(memory));
  return patch;
}

} // namespace

PaperMatrices paper_matrices(const SceneFile& file) {
  const Scene<double> scene = file.view();
  PaperMatrices matrices;
  matrices.M = named(wrench_rows, twist_rows);
  map_of(matrices.M) = inertia_matrix(scene);
  matrices.w = named(wrench_rows, {"w"});
  map_of(matrices.w) = load(scene);
  matrices.G = named(wrench_rows, component_names(file));
  grasp_matrix(scene, map_of(matrices.G));
  matrices.G_bar = named(wrench_rows, force_names(file));
  polyhedral_grasp_matrix(scene, map_of(matrices.G_bar));
  matrices.J = named(component_names(file), file.actuator_names);
  hand_jacobian(scene, map_of(matrices.J));
  add_prescribed(file, matrices);
  for (Index b = 0; b < scene.bodies.size; ++b)
    if (file.body(b).role == Role::pusher) matrices.J_pusher.push_back(pusher_jacobian(file, b));
  matrices.v = named(component_names(file), {"v"});
  prescribed_motion(scene, map_of(matrices.v));
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    matrices.D.push_back(body_generators(file, b));
    matrices.rigidity.push_back(patch_rigidity(file, b));
  }
  return matrices;
}

} // namespace lcpush::desktop
