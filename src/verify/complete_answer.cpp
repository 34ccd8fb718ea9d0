#include "verify/answer_completer.hpp"

#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// The x that all rows agree on; nothing if they leave a part of it open.
std::optional<Eigen::VectorXd> least_squares(const Rows& rows, Index unknowns) {
  if (static_cast<Index>(rows.size()) < unknowns) return std::nullopt;
  Eigen::MatrixXd A(static_cast<Index>(rows.size()), unknowns);
  Eigen::VectorXd b(A.rows());
  for (Index k = 0; k < A.rows(); ++k) {
    A.row(k) = rows[static_cast<std::size_t>(k)].first.transpose();
    b[k] = rows[static_cast<std::size_t>(k)].second;
  }
  return desktop::least_squares(A, b, VerifySettings::dependent);
}

} // namespace

/// Of a soft point, force and torque.
bool AnswerCompleter::friction_known(Index i) const {
  const ForeignContact contact = contact_of(i);
  if (!has_friction(i)) return true;
  if (contact.normal_force && *contact.normal_force == 0 && !contact.friction_force) return true;
  return contact.friction_force && (!(body_of(i).torsion_radius > 0) || contact.torsion);
}

bool AnswerCompleter::forces_known() const {
  for (Index i = 0; i < layout_.points; ++i)
    if (!normal_known(i) || !friction_known(i)) return false;
  return true;
}

/// What a unit of each actuator moves the point of its body along `direction`.
Eigen::VectorXd AnswerCompleter::drive_speeds(Index point, const Vector3<double>& direction) const {
  Eigen::VectorXd speeds = Eigen::VectorXd::Zero(layout_.actuators);
  for (const Drive<double>& drive : scene_.drives)
    if (drive.body == layout_.body[point])
      speeds[drive.actuator] += acceleration_at(scene_.points[point], drive.twist).dot(direction);
  return speeds;
}

/// What a unit of each actuator closes the point by.
Eigen::VectorXd AnswerCompleter::closing_speeds(Index point) const {
  return drive_speeds(point, body_of(point).normal);
}

/// Without what the actuators add, m/s^2.
double AnswerCompleter::opening(Index point) const {
  const Body<double>& body = body_of(point);
  const Vector6<double> relative = answer_.acceleration - body.acceleration;
  return acceleration_at<double>(scene_.points[point], relative).dot(body.normal);
}

/// r_i = (a - A_b - J s) at p_i, for the points whose motion is given: rows on [a; s] or on s.
Rows AnswerCompleter::point_rows(bool with_acceleration) const {
  Rows rows;
  const double L = layout_.scales.length;
  const Index before = with_acceleration ? 6 : 0;
  for (Index i = 0; i < layout_.points; ++i) {
    const std::optional<Vector3<double>> r = contact_of(i).acceleration;
    if (!r) continue;
    for (Index k = 0; k < 3; ++k) {
      const Vector3<double> axis = Vector3<double>::Unit(k);
      const Vector6<double> W = wrench_column<double>(scene_.points[i], axis);
      Eigen::VectorXd row(before + layout_.actuators);
      double right = (*r)[k] + W.dot(body_of(i).acceleration);
      if (with_acceleration)
        row.head<6>() << W.head<3>(), W.tail<3>() / L;
      else
        right -= W.dot(answer_.acceleration);
      row.tail(layout_.actuators) = -drive_speeds(i, axis);
      if (row.norm() > 0) rows.emplace_back(row, right);
    }
  }
  return rows;
}

bool AnswerCompleter::find_acceleration() {
  if (given_.acceleration) {
    answer_.acceleration = *given_.acceleration;
    return true;
  }
  if (forces_known()) {
    const Scales<double>& scales = layout_.scales;
    Vector6<double> wrench = laws::load(scene_, scales);
    for (const Body<double>& body : scene_.bodies) {
      Vector6<double> force = body_wrench(scene_, answer_, body) / scales.force;
      force.tail<3>() /= scales.length;
      wrench += force;
    }
    answer_.acceleration = factored_.mobility * wrench * scales.acceleration;
    answer_.acceleration.tail<3>() /= scales.length;
    completion_.completed.emplace_back("the object's acceleration, from the forces");
    return true;
  }
  if (const auto found = least_squares(point_rows(true), 6 + layout_.actuators)) {
    answer_.acceleration = found->head<6>();
    answer_.acceleration.tail<3>() /= layout_.scales.length;
    completion_.completed.emplace_back("the object's acceleration, from its contact points'");
    return true;
  }
  completion_.missing = "the object's acceleration, or every contact's normal and friction force";
  return false;
}

/// As the file names them, or as its bodies or its points close.
std::optional<Eigen::VectorXd> AnswerCompleter::closings_given() const {
  const Index n = layout_.actuators;
  if (static_cast<Index>(given_.closing.size()) == n)
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(given_.closing.data(), n));
  Rows rows;
  for (std::size_t b = 0; b < given_.bodies.size(); ++b) {
    const std::vector<double>& closing = given_.bodies[b].closing;
    const Index first = file_.bodies[b].first_point, count = file_.bodies[b].point_count;
    const bool each = static_cast<Index>(closing.size()) == count;
    if (closing.empty() || (!each && closing.size() != 1)) continue;
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
    for (Index k = 0; k < count; ++k) {
      const Eigen::VectorXd speeds = closing_speeds(first + k);
      if (each && count > 1) rows.emplace_back(speeds, closing[static_cast<std::size_t>(k)]);
      mean += speeds / static_cast<double>(count);
    }
    if (!each || count == 1) rows.emplace_back(mean, closing[0]);
  }
  if (const auto found = least_squares(rows, n)) return found;
  return least_squares(point_rows(false), n);
}

/// A pressed contact stays closed; what presses most counts most.
std::optional<Eigen::VectorXd> AnswerCompleter::closings_from_forces() const {
  Rows rows;
  for (Index i = 0; i < layout_.points; ++i) {
    if (!normal_known(i)) continue;
    const double weight = std::abs(answer_.contacts[i].normal_force) / layout_.scales.force;
    const Eigen::VectorXd speeds = closing_speeds(i);
    if (weight > tolerance_ && speeds.norm() > 0)
      rows.emplace_back(weight * speeds, weight * opening(i));
  }
  for (Index a = 0; a < layout_.actuators; ++a) {
    const Actuator<double>& actuator = scene_.actuators[a];
    if (!(actuator.inertia > 0) || !forces_known()) continue;
    double rest = actuator.force;
    for (const Drive<double>& drive : scene_.drives)
      if (drive.actuator == a)
        rest -= drive.twist.dot(body_wrench(scene_, answer_, scene_.bodies[drive.body]));
    rows.emplace_back(Eigen::VectorXd::Unit(layout_.actuators, a), rest / actuator.inertia);
  }
  return least_squares(rows, layout_.actuators);
}

/// As far as the object lets the actuators close: maximise tau s while no contact is entered.
std::optional<Eigen::VectorXd> AnswerCompleter::closings_from_openings() const {
  const Index n = layout_.actuators, points = layout_.points;
  double unit = 0;
  for (Index i = 0; i < points; ++i) unit = std::max(unit, std::abs(opening(i)));
  if (!(unit > 0)) unit = 1;
  Eigen::MatrixXd A(points, n + points); // the closings, what is left to each contact
  Eigen::VectorXd b(points), c = Eigen::VectorXd::Zero(n + points);
  for (Index a = 0; a < n; ++a) c[a] = -scene_.actuators[a].force / layout_.scales.force;
  A.rightCols(points).setIdentity();
  for (Index i = 0; i < points; ++i) {
    const Eigen::VectorXd speeds = closing_speeds(i);
    A.row(i).head(n) = speeds.transpose();
    // A body that no actuator moves sets no limit.
    b[i] = speeds.norm() > 0 ? opening(i) / unit : 1;
  }
  const std::optional<Eigen::VectorXd> closed = cheapest_point(A, b, c, n);
  if (!closed) return std::nullopt;
  return Eigen::VectorXd(unit * closed->head(n));
}

void AnswerCompleter::find_closings() {
  if (layout_.actuators == 0) return;
  std::optional<Eigen::VectorXd> s = closings_given();
  if (!s) {
    s = closings_from_forces();
    if (!s) s = closings_from_openings();
    if (!s) {
      completion_.missing = "the closing accelerations (\"closing\", a number an actuator)";
      return;
    }
    completion_.completed.emplace_back("how the actuators close, from the motion of the contacts");
  }
  std::copy(s->data(), s->data() + s->size(), answer_.closing.begin());
}

/// Of the object beside the point's body.
Vector6<double> AnswerCompleter::relative_twist(Index point) const {
  return answer_.acceleration - body_twist(scene_, answer_, layout_.body[point], 1.0);
}

/// d_j' r + xi, m/s^2.
double AnswerCompleter::slides_against(Index point, Index j) const {
  const Body<double>& body = body_of(point);
  const Vector6<double> relative = relative_twist(point);
  const Generator<double> d = generator(scene_, body, point, j);
  return acceleration_at<double>(scene_.points[point], relative).dot(d.force) +
         relative.tail<3>().dot(body.normal) * d.torque + answer_.contacts[point].slip;
}

/// n' r, m/s^2.
double AnswerCompleter::gap(Index point) const {
  return acceleration_at<double>(scene_.points[point], relative_twist(point))
      .dot(body_of(point).normal);
}

/// xi = max (0, - d_j' r): what [T.3] makes of the motion.
void AnswerCompleter::find_slips() {
  for (Index i = 0; i < layout_.points; ++i) {
    answer_.contacts[i].slip = 0;
    double most = 0;
    for (Index j = 0; j < layout_.cones[i].generators; ++j)
      most = std::max(most, -slides_against(i, j));
    answer_.contacts[i].slip = most;
  }
}

/// Every contact's motion, as given or as it follows.
void AnswerCompleter::find_motions() {
  for (Index i = 0; i < layout_.points; ++i) {
    const Body<double>& body = body_of(i);
    const Vector6<double> twist = body_twist(scene_, answer_, layout_.body[i], 1.0);
    const Vector6<double> relative = answer_.acceleration - twist;
    ContactAnswer<double>& contact = answer_.contacts[i];
    contact.acceleration =
        contact_of(i).acceleration.value_or(acceleration_at<double>(scene_.points[i], relative));
    contact.spin = relative.tail<3>().dot(body.normal);
    contact.closing_acceleration =
        acceleration_at<double>(scene_.points[i], twist - body.acceleration).dot(body.normal);
  }
}

Completion AnswerCompleter::run() {
  for (Index i = 0; i < layout_.points; ++i) {
    const ForeignContact given = contact_of(i);
    ContactAnswer<double>& contact = answer_.contacts[i];
    contact.body = layout_.body[i];
    contact.normal_force = given.normal_force.value_or(0);
    contact.friction_force = given.friction_force.value_or(Vector3<double>::Zero());
    contact.torsion = given.torsion.value_or(0);
  }
  if (!find_acceleration()) return completion_;
  find_closings();
  if (!completion_.missing.empty()) return completion_;
  find_slips();
  Index entry = 0;
  for (Index i = 0; i < layout_.points; ++i) {
    if (friction_known(i) && has_friction(i)) split_friction(i, &answer_.friction[entry]);
    entry += layout_.cones[i].generators;
  }
  if (!forces_known()) find_forces();
  find_motions();
  return completion_;
}

} // namespace lcpush::desktop
