// The forces of an AnswerCompleter: from the motion, and as generators.
#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"
#include "solve/rest_by_friction.hpp"
#include "text/limits.hpp"
#include "verify/answer_completer.hpp"

#include <algorithm>

namespace lcpush::desktop {

/// Newton's law, the grip, the cones and what is given of a soft point's friction, as rows on the
/// forces that this motion allows, scaled; then what sticking leaves of the cones.
AnswerCompleter::ForceRows AnswerCompleter::force_rows() {
  const Scales<double>& scales = layout_.scales;
  const Index grips = layout_.actuators, points = layout_.points, cone_rows = 6 + grips;
  const double least = tolerance_ * scales.acceleration;
  ForceRows rows{Eigen::MatrixXd::Zero(cone_rows + 4 * points, layout_.forces + points),
                 Eigen::VectorXd::Zero(cone_rows + 4 * points)};
  rows.b.head<6>() << scene_.object.mass * answer_.acceleration.head<3>() / scales.force,
      scene_.object.inertia * answer_.acceleration.tail<3>() / (scales.force * scales.length);
  rows.b.head<6>() -= laws::load(scene_, scales);
  for (Index a = 0; a < grips; ++a)
    rows.b[6 + a] = factored_.sums[a].target - factored_.sums[a].inertia * answer_.closing[a] *
                                                   layout_.reach[a] / scales.acceleration;
  Index entry = 0;
  for (Index i = 0; i < points; ++i) {
    const ConeGroup<double>& cone = layout_.cones[i];
    const Index cone_row = cone_rows + i, given_row = cone_rows + points + 3 * i;
    const bool friction_is_known = friction_known(i);
    for (Index k = 0; k < cone.forces(); ++k) {
      const bool is_normal = k < cone.normals;
      Eigen::VectorXd column = Eigen::VectorXd::Zero(rows.b.size());
      column.head<6>() = factored_.wrenches[cone.force + k];
      for (const Drive<double>& drive : scene_.drives)
        if (drive.body == layout_.body[i])
          column[6 + drive.actuator] += laws::grip_coefficient(
              drive, factored_.wrenches[cone.force + k], layout_.reach[drive.actuator], scales);
      if (cone.generators > 0) column[cone_row] = is_normal ? cone.friction : -1;
      if (!is_normal && !friction_is_known && contact_of(i).friction_force)
        column.segment<3>(given_row) = generator(scene_, body_of(i), i, k - cone.normals).force;
      const double beta = is_normal ? 0 : answer_.friction[entry++];
      const double lambda = (k == 0 ? 1 : -1) * answer_.contacts[i].normal_force;
      if (is_normal ? normal_known(i) : friction_is_known)
        rows.b -= std::max(is_normal ? lambda : beta, 0.0) / scales.force * column;
      else if (is_normal ? gap(i) <= least : slides_against(i, k - cone.normals) <= least)
        rows.A.col(cone.force + k) = column;
    }
    // What sliding leaves of the cone is nothing.
    if (cone.generators > 0 && !(answer_.contacts[i].slip > least))
      rows.A(cone_row, layout_.forces + i) = -1;
    if (!friction_is_known && contact_of(i).friction_force)
      rows.b.segment<3>(given_row) = *contact_of(i).friction_force / scales.force;
  }
  for (Index row = 2; scene_.planar && row <= 4; ++row) { // out-of-plane balance is dropped
    rows.A.row(row).setZero();
    rows.b[row] = 0;
  }
  return rows;
}

/// Forces >= 0 that fit the rows best. A bilateral contact that pushed and pulled at once would
/// widen its own cone: where the fit does that, every choice of one of the two is tried.
Eigen::VectorXd AnswerCompleter::fitting_forces(const ForceRows& rows) const {
  Eigen::VectorXd best = nonnegative_least_squares(rows.A, rows.b);
  std::vector<Index> pulls; // the first of two columns
  for (Index i = 0; i < layout_.points; ++i)
    if (layout_.cones[i].normals == 2 && !normal_known(i)) pulls.push_back(layout_.cones[i].force);
  const bool splits = std::any_of(pulls.begin(), pulls.end(),
                                  [&](Index k) { return best[k] > 0 && best[k + 1] > 0; });
  if (!splits || pulls.size() > limits::pulls_enumerated) return best;
  double least = -1;
  for (unsigned choice = 0; choice < 1U << pulls.size(); ++choice) {
    Eigen::MatrixXd A = rows.A;
    for (std::size_t k = 0; k < pulls.size(); ++k)
      A.col(pulls[k] + ((choice >> k & 1U) != 0 ? 0 : 1)).setZero();
    const Eigen::VectorXd x = nonnegative_least_squares(A, rows.b);
    const double rest = (A * x - rows.b).norm();
    if (least >= 0 && rest >= least) continue;
    least = rest;
    best = x;
  }
  return best;
}

/// Forces that were not given: those that leave the laws least to complain about.
void AnswerCompleter::find_forces() {
  const Eigen::VectorXd x = fitting_forces(force_rows());
  completion_.has_forces = true;
  completion_.completed.emplace_back("forces that were not given, from the motion");
  Index entry = 0;
  for (Index i = 0; i < layout_.points; ++i) {
    const ConeGroup<double>& cone = layout_.cones[i];
    ContactAnswer<double>& contact = answer_.contacts[i];
    const auto force = [&](Index k) { return x[cone.force + k] * layout_.scales.force; };
    if (!normal_known(i)) contact.normal_force = force(0) - (cone.normals == 2 ? force(1) : 0);
    if (friction_known(i)) {
      entry += cone.generators;
      continue;
    }
    contact.friction_force.setZero();
    contact.torsion = 0;
    for (Index j = 0; j < cone.generators; ++j) {
      const double beta = force(cone.normals + j);
      const Generator<double> d = generator(scene_, body_of(i), i, j);
      answer_.friction[entry++] = beta;
      contact.friction_force += beta * d.force;
      contact.torsion += beta * d.torque;
    }
  }
}

/// A friction force as generators with the least sum.
void AnswerCompleter::split_friction(Index point, double* beta) {
  const Body<double>& body = body_of(point);
  const Vector3<double>& f = answer_.contacts[point].friction_force;
  if (body.torsion_radius > 0) return split_soft(point, beta);
  const Vector3<double> t = generator(scene_, body, point, 0).force; // round friction turns it
  onto_neighbours(f.dot(t), f.dot(cross(body.normal, t)), layout_.cones[point].generators, beta);
}

void AnswerCompleter::split_soft(Index point, double* beta) {
  const Body<double>& body = body_of(point);
  const ContactAnswer<double>& contact = answer_.contacts[point];
  const Index g = layout_.cones[point].generators;
  for (Index j = 0; j < g; ++j) beta[j] = 0;
  const Vector3<double> o = cross(body.normal, body.tangent);
  Eigen::MatrixXd A(3, g);
  Eigen::Vector3d b(contact.friction_force.dot(body.tangent), contact.friction_force.dot(o),
                    contact.torsion / body.torsion_radius);
  const double size = b.norm();
  if (!(size > 0)) return;
  for (Index j = 0; j < g; ++j) {
    const Generator<double> d = generator(scene_, body, point, j);
    A.col(j) << d.force.dot(body.tangent), d.force.dot(o), d.torque / body.torsion_radius;
  }
  if (const auto least = cheapest_point(A, b / size, Eigen::VectorXd::Ones(g), 0))
    for (Index j = 0; j < g; ++j) beta[j] = size * (*least)[j];
}

} // namespace lcpush::desktop
