#include "complete_answer.hpp"

#include "nonnegative_least_squares.hpp"
#include "owned_program.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace lcpush::host {
namespace {

using Rows = std::vector<std::pair<Eigen::VectorXd, double>>;

/// The x that all rows agree on; nothing if they leave a part of it open.
std::optional<Eigen::VectorXd> least_squares(const Rows& rows, Index unknowns) {
  if (static_cast<Index>(rows.size()) < unknowns) return std::nullopt;
  Eigen::MatrixXd A(static_cast<Index>(rows.size()), unknowns);
  Eigen::VectorXd b(A.rows());
  for (Index k = 0; k < A.rows(); ++k) {
    A.row(k) = rows[static_cast<std::size_t>(k)].first.transpose();
    b[k] = rows[static_cast<std::size_t>(k)].second;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  qr.setThreshold(1e-10);
  if (qr.rank() < unknowns) return std::nullopt;
  return Eigen::VectorXd(qr.solve(b));
}

class Completer {
public:
  Completer(Push& push, const ForeignAnswer& given, double tolerance, OwnedAnswer& answer)
      : scene_(push.scene()), layout_(push.layout()), factored_(push.assembly().factored()),
        given_(given), file_(push.file()), tolerance_(tolerance), out_(answer),
        answer_(answer.view()) {}

  Completion run();

private:
  const Scene<double>& scene_;
  const Layout<double>& layout_;
  const FactoredProblem<double>& factored_;
  const ForeignAnswer& given_;
  const SceneFile& file_;
  double tolerance_;
  OwnedAnswer& out_;
  Answer<double> answer_;
  Completion completion_;

  const Body<double>& body_of(Index i) const { return scene_.bodies[layout_.body[i]]; }
  ForeignContact contact_of(Index i) const {
    return given_.contacts.empty() ? ForeignContact()
                                   : given_.contacts[static_cast<std::size_t>(i)];
  }
  bool normal_known(Index i) const { return contact_of(i).normal_force.has_value(); }
  bool has_friction(Index i) const { return layout_.cones[i].generators > 0; }
  bool friction_known(Index i) const;
  bool forces_known() const;
  void take_given();

  bool find_acceleration();
  bool acceleration_from_points();
  Rows point_rows(bool with_acceleration) const;
  Eigen::VectorXd drive_speeds(Index point, const Vector3<double>& direction) const;
  double opening(Index point) const;
  void find_closings();
  std::optional<Eigen::VectorXd> closings_given() const;
  std::optional<Eigen::VectorXd> closings_from_forces() const;
  std::optional<Eigen::VectorXd> closings_from_openings() const;
  void find_slips();
  double slides_against(Index point, Index j) const;
  double gap(Index point) const;
  struct ForceRows {
    Eigen::MatrixXd A; // columns: the forces, then what each cone has left
    Eigen::VectorXd b;
  };
  ForceRows force_rows();
  void find_forces();
  void split_friction(Index point, double* beta);
  void split_soft(Index point, double* beta);
  void find_motions();
};

/// Of a soft point, force and torque.
bool Completer::friction_known(Index i) const {
  const ForeignContact contact = contact_of(i);
  if (!has_friction(i)) return true;
  if (contact.normal_force && *contact.normal_force == 0 && !contact.friction_force) return true;
  return contact.friction_force && (!(body_of(i).torsion_radius > 0) || contact.torsion);
}

bool Completer::forces_known() const {
  for (Index i = 0; i < layout_.points; ++i)
    if (!normal_known(i) || !friction_known(i)) return false;
  return true;
}

void Completer::take_given() {
  for (Index i = 0; i < layout_.points; ++i) {
    const ForeignContact given = contact_of(i);
    ContactAnswer<double>& contact = answer_.contacts[i];
    contact.body = layout_.body[i];
    contact.normal_force = given.normal_force.value_or(0);
    contact.friction_force = given.friction_force.value_or(Vector3<double>::Zero());
    contact.torsion = given.torsion.value_or(0);
  }
}

/// What a unit of each actuator moves the point of its body along `direction`.
Eigen::VectorXd Completer::drive_speeds(Index point, const Vector3<double>& direction) const {
  Eigen::VectorXd speeds = Eigen::VectorXd::Zero(layout_.actuators);
  for (const Drive<double>& drive : scene_.drives)
    if (drive.body == layout_.body[point])
      speeds[drive.actuator] += acceleration_at(scene_.points[point], drive.twist).dot(direction);
  return speeds;
}

/// Without what the actuators add, m/s^2.
double Completer::opening(Index point) const {
  const Body<double>& body = body_of(point);
  const Vector6<double> relative = out_.acceleration - body.acceleration;
  return acceleration_at<double>(scene_.points[point], relative).dot(body.normal);
}

/// r_i = (a - A_b - J s) at p_i, for the points whose motion is given: rows on [a; s] or on s.
Rows Completer::point_rows(bool with_acceleration) const {
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
        right -= W.dot(out_.acceleration);
      row.tail(layout_.actuators) = -drive_speeds(i, axis);
      if (row.norm() > 0) rows.emplace_back(row, right);
    }
  }
  return rows;
}

bool Completer::acceleration_from_points() {
  const auto found = least_squares(point_rows(true), 6 + layout_.actuators);
  if (!found) return false;
  out_.acceleration = found->head<6>();
  out_.acceleration.tail<3>() /= layout_.scales.length;
  return true;
}

bool Completer::find_acceleration() {
  if (given_.acceleration) {
    out_.acceleration = *given_.acceleration;
    return true;
  }
  if (forces_known()) {
    const Scales<double>& scales = layout_.scales;
    Vector6<double> wrench = laws::weight(scene_, scales);
    for (const Body<double>& body : scene_.bodies) {
      Vector6<double> force = body_wrench(scene_, answer_, body) / scales.force;
      force.tail<3>() /= scales.length;
      wrench += force;
    }
    out_.acceleration = factored_.mobility * wrench * scales.acceleration;
    out_.acceleration.tail<3>() /= scales.length;
    completion_.completed.emplace_back("the object's acceleration, from the forces");
    return true;
  }
  if (acceleration_from_points()) {
    completion_.completed.emplace_back("the object's acceleration, from its contact points'");
    return true;
  }
  completion_.missing = "the object's acceleration, or every contact's normal and friction force";
  return false;
}

/// As the file names them, or as its bodies or its points close.
std::optional<Eigen::VectorXd> Completer::closings_given() const {
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
      const Eigen::VectorXd speeds = drive_speeds(first + k, body_of(first + k).normal);
      if (each && count > 1) rows.emplace_back(speeds, closing[static_cast<std::size_t>(k)]);
      mean += speeds / static_cast<double>(count);
    }
    if (!each || count == 1) rows.emplace_back(mean, closing[0]);
  }
  if (const auto found = least_squares(rows, n)) return found;
  return least_squares(point_rows(false), n);
}

/// A pressed contact stays closed; what presses most counts most.
std::optional<Eigen::VectorXd> Completer::closings_from_forces() const {
  Rows rows;
  for (Index i = 0; i < layout_.points; ++i) {
    if (!normal_known(i)) continue;
    const double weight = std::abs(answer_.contacts[i].normal_force) / layout_.scales.force;
    const Eigen::VectorXd speeds = drive_speeds(i, body_of(i).normal);
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
std::optional<Eigen::VectorXd> Completer::closings_from_openings() const {
  const Index n = layout_.actuators, points = layout_.points;
  double unit = 0;
  for (Index i = 0; i < points; ++i) unit = std::max(unit, std::abs(opening(i)));
  if (!(unit > 0)) unit = 1;
  OwnedProgram program(2 * n + points, points);
  for (Index a = 0; a < n; ++a) {
    program.c[a] = -scene_.actuators[a].force / layout_.scales.force;
    program.c[n + a] = -program.c[a];
  }
  for (Index i = 0; i < points; ++i) {
    const Eigen::VectorXd speeds = drive_speeds(i, body_of(i).normal);
    program.A.row(i).head(n) = speeds.transpose();
    program.A.row(i).segment(n, n) = -speeds.transpose();
    program.A(i, 2 * n + i) = 1;
    // A body that no actuator moves sets no limit.
    program.b[i] = speeds.norm() > 0 ? opening(i) / unit : 1;
  }
  const auto x = program.solve();
  if (!x) return std::nullopt;
  return Eigen::VectorXd(unit * (x->head(n) - x->segment(n, n)));
}

void Completer::find_closings() {
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
  std::copy(s->data(), s->data() + s->size(), out_.closing.begin());
}

/// d_j' r + xi, m/s^2.
double Completer::slides_against(Index point, Index j) const {
  const Body<double>& body = body_of(point);
  const Vector6<double> relative =
      out_.acceleration - body_twist(scene_, answer_, layout_.body[point], 1.0);
  const Generator<double> d = generator(body, j, scene_.facets);
  return acceleration_at<double>(scene_.points[point], relative).dot(d.force) +
         relative.tail<3>().dot(body.normal) * d.torque + answer_.contacts[point].slip;
}

/// n' r, m/s^2.
double Completer::gap(Index point) const {
  const Vector6<double> relative =
      out_.acceleration - body_twist(scene_, answer_, layout_.body[point], 1.0);
  return acceleration_at<double>(scene_.points[point], relative).dot(body_of(point).normal);
}

/// xi = max (0, - d_j' r): what [T.3] makes of the motion.
void Completer::find_slips() {
  answer_.acceleration = out_.acceleration;
  for (Index i = 0; i < layout_.points; ++i) {
    double& slip = answer_.contacts[i].slip;
    slip = 0;
    double most = 0;
    for (Index j = 0; j < layout_.cones[i].generators; ++j)
      most = std::max(most, -slides_against(i, j));
    slip = most;
  }
}

/// Newton's law, the grip, the cones and what is given of a soft point's friction, as rows on the
/// forces that this motion allows, scaled; then what sticking leaves of the cones.
Completer::ForceRows Completer::force_rows() {
  const Scales<double>& scales = layout_.scales;
  const Index grips = layout_.actuators, points = layout_.points, cone_rows = 6 + grips;
  const double least = tolerance_ * scales.acceleration;
  ForceRows rows{Eigen::MatrixXd::Zero(cone_rows + 4 * points, layout_.forces + points),
                 Eigen::VectorXd::Zero(cone_rows + 4 * points)};
  rows.b.head<6>() << scene_.object.mass * (out_.acceleration.head<3>() - scene_.gravity) /
                          scales.force,
      scene_.object.inertia * out_.acceleration.tail<3>() / (scales.force * scales.length);
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
        column.segment<3>(given_row) = generator(body_of(i), k - cone.normals, scene_.facets).force;
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
  return rows;
}

/// Forces that were not given: those that leave the laws least to complain about.
void Completer::find_forces() {
  const ForceRows rows = force_rows();
  const Eigen::VectorXd x = nonnegative_least_squares(rows.A, rows.b);
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
      const Generator<double> d = generator(body_of(i), j, scene_.facets);
      answer_.friction[entry++] = beta;
      contact.friction_force += beta * d.force;
      contact.torsion += beta * d.torque;
    }
  }
}

/// A friction force as generators with the least sum: two neighbours.
void Completer::split_friction(Index point, double* beta) {
  const Body<double>& body = body_of(point);
  const Index g = layout_.cones[point].generators;
  const Vector3<double>& f = answer_.contacts[point].friction_force;
  for (Index j = 0; j < g; ++j) beta[j] = 0;
  if (body.torsion_radius > 0) return split_soft(point, beta);
  double best = -1;
  for (Index j = 0; j < g; ++j) {
    const Vector3<double> d = generator(body, j, g).force,
                          e = generator(body, (j + 1) % g, g).force;
    const double c = d.dot(e), determinant = 1 - c * c;
    const double x = (f.dot(d) - c * f.dot(e)) / determinant;
    const double y = (f.dot(e) - c * f.dot(d)) / determinant;
    const double rounding = -1e-12 * f.norm();
    if (x < rounding || y < rounding || (best >= 0 && x + y >= best)) continue;
    for (Index k = 0; k < g; ++k) beta[k] = 0;
    best = x + y;
    beta[j] = std::max(x, 0.0);
    beta[(j + 1) % g] = std::max(y, 0.0);
  }
}

void Completer::split_soft(Index point, double* beta) {
  const Body<double>& body = body_of(point);
  const ContactAnswer<double>& contact = answer_.contacts[point];
  const Index g = layout_.cones[point].generators;
  const Vector3<double> o = cross(body.normal, body.tangent);
  OwnedProgram program(g, 3);
  program.b << contact.friction_force.dot(body.tangent), contact.friction_force.dot(o),
      contact.torsion / body.torsion_radius;
  const double size = program.b.norm();
  if (!(size > 0)) return;
  program.b /= size;
  program.c.setOnes();
  for (Index j = 0; j < g; ++j) {
    const Generator<double> d = generator(body, j, scene_.facets);
    program.A.col(j) << d.force.dot(body.tangent), d.force.dot(o), d.torque / body.torsion_radius;
  }
  if (const auto x = program.solve())
    for (Index j = 0; j < g; ++j) beta[j] = (*x)[j] * size;
}

/// Every contact's motion, as given or as it follows.
void Completer::find_motions() {
  for (Index i = 0; i < layout_.points; ++i) {
    const Body<double>& body = body_of(i);
    const Vector6<double> twist = body_twist(scene_, answer_, layout_.body[i], 1.0);
    const Vector6<double> relative = out_.acceleration - twist;
    ContactAnswer<double>& contact = answer_.contacts[i];
    contact.acceleration =
        contact_of(i).acceleration.value_or(acceleration_at<double>(scene_.points[i], relative));
    contact.spin = relative.tail<3>().dot(body.normal);
    contact.closing =
        acceleration_at<double>(scene_.points[i], twist - body.acceleration).dot(body.normal);
  }
}

Completion Completer::run() {
  take_given();
  if (!find_acceleration()) return completion_;
  find_closings();
  if (!completion_.missing.empty()) return completion_;
  find_slips();
  std::size_t entry = 0;
  for (Index i = 0; i < layout_.points; ++i) {
    if (friction_known(i) && has_friction(i)) split_friction(i, &out_.friction[entry]);
    entry += static_cast<std::size_t>(layout_.cones[i].generators);
  }
  if (!forces_known()) find_forces();
  find_motions();
  return completion_;
}

} // namespace

OwnedAnswer::OwnedAnswer(const Layout<double>& layout)
    : contacts(static_cast<std::size_t>(layout.points)),
      closing(static_cast<std::size_t>(layout.actuators)) {
  std::size_t generators = 0;
  for (const ConeGroup<double>& cone : layout.cones)
    generators += static_cast<std::size_t>(cone.generators);
  friction.resize(generators);
}

Completion complete_answer(Push& push, const ForeignAnswer& given, double tolerance,
                           OwnedAnswer& answer) {
  return Completer(push, given, tolerance, answer).run();
}

} // namespace lcpush::host
