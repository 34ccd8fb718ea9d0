#include "verify/settings.hpp"
#include "verify/trajectory_forces.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// What a pyramid, or a soft point's polyhedron, has of its cone in the direction where it has
/// least; 1 of a round cone.
double least_share(const SceneFile& file, const Body<double>& body) {
  if (file.is_round || body.in_plane) return 1;
  const double corner = std::cos(std::acos(-1.0) / static_cast<double>(file.facets));
  if (!(body.torsion_radius > 0)) return corner;
  // Least between the generators of no torque and those of 30 degrees.
  const double between = std::tan(std::acos(-1.0) / 12);
  return corner / std::hypot(1.0, corner * between);
}

WorstForce of_point(ForceLaw law, Index i, double off, double found, double lawful) {
  WorstForce force;
  force.law = law;
  force.of = i;
  force.off = off;
  force.found = found;
  force.lawful = lawful;
  return force;
}

/// The smaller of force and gap: they exclude each other.
WorstForce judge_gap(Index i, const FrameContact& said, const SeenContact& seen, double h,
                     const ForceUnits& units) {
  const double force = force_size(said);
  WorstForce worst = of_point(ForceLaw::gap, i, force / units.point_force, force, 0);
  if (!seen.touches) return worst;
  for (const std::optional<double>& gap : {seen.gap, said.gap})
    if (gap) worst.gap = std::max(worst.gap.value_or(0), *gap);
  const double unit = h * units.speed + VerifySettings::gap * units.size;
  worst.off = std::min(worst.off, std::max(0.0, worst.gap.value_or(0) - seen.missed) / unit);
  return worst;
}

/// Foreign cones are round, or pyramids within: the round one bounds them all.
WorstForce judge_cone(const Body<double>& body, Index i, const FrameContact& said,
                      const SeenContact& seen, const ForceUnits& units) {
  const Vector3<double>& friction = *said.friction_force;
  const double out = friction.dot(seen.normal);
  const double lever = body.torsion_radius > 0 ? body.torsion_radius : units.size / 2;
  const double all = std::hypot(Vector3<double>(friction - out * seen.normal).norm(),
                                said.torsion.value_or(0) / lever);
  const double limit = body.friction * std::abs(*said.normal_force);
  const double off = std::max({0.0, all - limit, std::abs(out)});
  // Out of the plane it is no friction at all: then what it has there stands against none.
  const bool is_out = std::abs(out) > all - limit;
  WorstForce worst = of_point(ForceLaw::cone, i, off / units.point_force,
                              is_out ? std::abs(out) : all, is_out ? 0 : limit);
  worst.is_out_of_plane = is_out;
  return worst;
}

/// What the cone has left to take from the slip. Of a speed whose error is a part `off` of the
/// fastest, the slip's direction is off by that over the slip, and the power by its square: the
/// part of forces and speeds is looked for that explains what is missing.
WorstForce judge_slip(const SceneFile& file, const Body<double>& body, Index i,
                      const FrameContact& said, const SeenContact& seen, const ForceUnits& units) {
  const double slip = std::hypot(seen.slip->norm(), body.torsion_radius * seen.spin);
  const double against = -said.friction_force->dot(*seen.slip) - *said.torsion * seen.spin;
  const double least = least_share(file, body) * body.friction * std::abs(*said.normal_force);
  if (!(slip > seen.unsure)) return of_point(ForceLaw::dissipation, i, 0, least, least);
  // missing = off F + off^2 2 mu lambda (fastest / slip)^2: never more than slip / fastest.
  const double turned = seen.unsure / slip, faster = units.speed / slip;
  const double missing = std::max(0.0, least * (1 - 2 * turned * turned) - against / slip);
  const double root = std::hypot(units.point_force, faster * std::sqrt(8 * least * missing));
  return of_point(ForceLaw::dissipation, i, 2 * missing / (units.point_force + root),
                  against / slip, least);
}

} // namespace

double force_size(const FrameContact& contact) {
  return std::max(std::abs(contact.normal_force.value_or(0)),
                  contact.friction_force.value_or(Vector3<double>::Zero()).norm());
}

std::vector<WorstForce> judge_point(const SceneFile& file, Index i, const FrameContact& said,
                                    const SeenContact& seen, double h, const ForceUnits& units) {
  const Body<double>& body = file.body(file.body_of(i));
  std::vector<WorstForce> judged{judge_gap(i, said, seen, h, units)};
  if (!said.normal_force) return judged;
  const double normal = *said.normal_force;
  if (!body.bilateral)
    judged.push_back(
        of_point(ForceLaw::normal, i, std::max(0.0, -normal) / units.point_force, normal, 0));
  if (!said.friction_force || !seen.is_placed) return judged;
  judged.push_back(judge_cone(body, i, said, seen, units));
  if (body.friction > 0 && said.torsion && seen.slip && seen.touches)
    judged.push_back(judge_slip(file, body, i, said, seen, units));
  return judged;
}

} // namespace lcpush::desktop
