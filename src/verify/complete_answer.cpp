// The motion of an AnswerCompleter, and the order in which it goes.
#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"
#include "verify/answer_completer.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Settings = VerifySettings;

struct System {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;

  System(const Rows& rows, Index unknowns)
      : A(static_cast<Index>(rows.size()), unknowns), b(A.rows()) {
    for (Index k = 0; k < A.rows(); ++k) {
      A.row(k) = rows[static_cast<std::size_t>(k)].first.transpose();
      b[k] = rows[static_cast<std::size_t>(k)].second;
    }
  }
  /// The x that all rows agree on; nothing if they leave a part of it open.
  std::optional<Eigen::VectorXd> only() const {
    if (A.rows() < A.cols()) return std::nullopt;
    return least_squares(A, b, Settings::dependent);
  }
  Eigen::VectorXd nearest_to(const Eigen::VectorXd& x) const {
    if (A.rows() == 0) return x;
    const PivotedQr qr(A, Settings::dependent * longest_column(A));
    return x + qr.shortest(b - A * x);
  }
};

void append(Rows& rows, const Rows& more) { rows.insert(rows.end(), more.begin(), more.end()); }

} // namespace

const PushReport& OwnSolution::report() {
  if (report_) return *report_;
  PushOptions options;
  options.explain_jams = false;
  options.other_paths = 0;
  push_.emplace(file_);
  return report_.emplace(push_->solve(options));
}

/// Of a soft point, force and torque.
bool AnswerCompleter::friction_known(Index i) const {
  const ForeignContact contact = contact_of(i);
  if (layout_.cones[i].generators == 0) return true;
  if (contact.normal_force && *contact.normal_force == 0 && !contact.friction_force) return true;
  return contact.friction_force && (!(body_of(i).torsion_radius > 0) || contact.torsion);
}

bool AnswerCompleter::forces_known(const Body<double>& body) const {
  const auto points = points_of(body);
  return std::all_of(points.begin(), points.end(),
                     [&](Index i) { return normal_known(i) && friction_known(i); });
}

bool AnswerCompleter::forces_known() const {
  return std::all_of(scene_.bodies.begin(), scene_.bodies.end(),
                     [&](const Body<double>& body) { return forces_known(body); });
}

/// From its contacts, or as the file gives it: nothing of a part of the file's body.
AnswerCompleter::KnownWrench AnswerCompleter::wrench_of(const Body<double>& body) const {
  if (forces_known(body)) {
    const Vector6<double> sum = body_wrench(scene_, answer_, body);
    return {Vector3<double>(sum.head<3>()), Vector3<double>(sum.tail<3>())};
  }
  const auto of = static_cast<std::size_t>(file_.body_of(body.first_point));
  if (given_.bodies.empty() || body.point_count < file_.bodies[of].point_count) return {};
  const ForeignBody& given = given_.bodies[of];
  return {given.force, given.moment};
}

/// What the known forces make of the acceleration.
Rows AnswerCompleter::newton_rows() const {
  const Scales<double>& scales = layout_.scales;
  Vector6<double> wrench = laws::load(scene_, scales);
  bool has_force = true, has_moment = true;
  for (const Body<double>& body : file_.bodies) {
    const KnownWrench known = wrench_of(body);
    has_force = has_force && known.force;
    has_moment = has_moment && known.moment;
    if (known.force) wrench.head<3>() += *known.force / scales.force;
    if (known.moment) wrench.tail<3>() += *known.moment / (scales.force * scales.length);
  }
  const Vector6<double> a = scales.acceleration * (laws::newton(scene_, scales) * wrench);
  Rows rows;
  for (Index k = 0; k < 6; ++k) {
    if (!moves_along(scene_, k) || (k < 3 ? has_force : has_moment))
      rows.emplace_back(Eigen::VectorXd::Unit(6 + layout_.actuators, k),
                        moves_along(scene_, k) ? a[k] : 0);
  }
  return rows;
}

/// What a unit of each actuator moves the point of its body along `direction`.
Eigen::VectorXd AnswerCompleter::drive_speeds(Index point, const Vector3<double>& direction) const {
  Eigen::VectorXd speeds = Eigen::VectorXd::Zero(layout_.actuators);
  for (const Drive<double>& drive : scene_.drives)
    if (drive.body == layout_.body[point])
      speeds[drive.actuator] += acceleration_at(scene_.points[point], drive.twist).dot(direction) /
                                layout_.reach[drive.actuator];
  return speeds;
}

/// r_i = (a - A_b - J s) at p_i, for the points whose motion is given.
Rows AnswerCompleter::point_rows() const {
  Rows rows;
  for (Index i = 0; i < layout_.points; ++i) {
    const std::optional<Vector3<double>> r = contact_of(i).acceleration;
    for (Index k = 0; r && k < 3; ++k) {
      const Vector3<double> axis = Vector3<double>::Unit(k);
      const Vector6<double> W = wrench_column<double>(scene_.points[i], axis);
      Eigen::VectorXd row(6 + layout_.actuators);
      row << W.head<3>(), W.tail<3>() / layout_.scales.length, -drive_speeds(i, axis);
      rows.emplace_back(row, (*r)[k] + W.dot(body_of(i).acceleration));
    }
  }
  return rows;
}

/// As the file names the closings, or as its bodies close: each point, or their mean.
Rows AnswerCompleter::closing_rows() const {
  Rows rows;
  const Index n = layout_.actuators;
  const auto add = [&](const Eigen::VectorXd& speeds, double closes) {
    Eigen::VectorXd row(6 + n);
    row << Eigen::VectorXd::Zero(6), speeds;
    rows.emplace_back(row, closes);
  };
  if (static_cast<Index>(given_.closing.size()) == n)
    for (Index a = 0; a < n; ++a)
      add(Eigen::VectorXd::Unit(n, a),
          given_.closing[static_cast<std::size_t>(a)] * layout_.reach[a]);
  for (std::size_t b = 0; rows.empty() && b < given_.bodies.size(); ++b) {
    const std::vector<double>& closing = given_.bodies[b].closing;
    const Index first = file_.bodies[b].first_point, count = file_.bodies[b].point_count;
    if (closing.size() != 1 && static_cast<Index>(closing.size()) != count) continue;
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
    for (Index k = 0; k < count; ++k) {
      const Eigen::VectorXd speeds = drive_speeds(first + k, file_.bodies[b].normal);
      if (closing.size() > 1) add(speeds, closing[static_cast<std::size_t>(k)]);
      mean += speeds / static_cast<double>(count);
    }
    if (closing.size() == 1) add(mean, closing[0]);
  }
  return rows;
}

/// A pressed contact stays closed, and what presses most counts most; what has an inertia closes as
/// its forces say.
Rows AnswerCompleter::pressed_rows() const {
  Rows rows;
  for (Index i = 0; i < layout_.points; ++i) {
    const double weight = std::abs(answer_.contacts[i].normal_force) / layout_.scales.force;
    const Eigen::VectorXd speeds = drive_speeds(i, body_of(i).normal);
    if (normal_known(i) && weight > tolerance_ && speeds.norm() > 0)
      rows.emplace_back(weight * speeds, weight * opening(i));
  }
  for (Index a = 0; a < layout_.actuators; ++a) {
    const Actuator<double>& actuator = scene_.actuators[a];
    double rest = actuator.force;
    bool is_known = actuator.inertia > 0;
    for (const Drive<double>& drive : scene_.drives) {
      if (drive.actuator != a) continue;
      const KnownWrench known = wrench_of(scene_.bodies[drive.body]);
      const Vector3<double> turns = drive.twist.tail<3>();
      is_known = is_known && known.force && (known.moment || turns.isZero());
      if (is_known)
        rest -= drive.twist.head<3>().dot(*known.force) +
                (known.moment ? turns.dot(*known.moment) : 0.0);
    }
    if (is_known)
      rows.emplace_back(Eigen::VectorXd::Unit(layout_.actuators, a),
                        rest / actuator.inertia * layout_.reach[a]);
  }
  return rows;
}

void AnswerCompleter::set_acceleration(const Eigen::VectorXd& scaled) {
  answer_.acceleration = scaled.head<6>();
  answer_.acceleration.tail<3>() /= layout_.scales.length;
}

void AnswerCompleter::set_closings(const Eigen::VectorXd& scaled) {
  for (Index a = 0; a < layout_.actuators; ++a) answer_.closing[a] = scaled[a] / layout_.reach[a];
}

/// Without what the actuators add, m/s^2.
double AnswerCompleter::opening(Index point) const {
  const Body<double>& body = body_of(point);
  const Vector6<double> relative = answer_.acceleration - body.acceleration;
  return acceleration_at<double>(scene_.points[point], relative).dot(body.normal);
}

/// The acceleration, and the closings if they are found with it.
bool AnswerCompleter::find_motion() {
  if (given_.acceleration) {
    answer_.acceleration = *given_.acceleration;
    return find_closings();
  }
  Rows rows = newton_rows();
  if (rows.size() == 6) {
    const System newton(rows, 6 + layout_.actuators);
    set_acceleration(newton.b);
    completion_.completed.emplace_back("the object's acceleration, from the forces");
    return find_closings();
  }
  append(rows, point_rows());
  append(rows, closing_rows());
  const System system(rows, 6 + layout_.actuators);
  std::optional<Eigen::VectorXd> x = system.only();
  if (x) {
    completion_.completed.emplace_back("the object's acceleration, from its contact points'");
  } else {
    const PushReport& own = own_.report();
    if (own.status != Status::solved) {
      completion_.missing = "the object's acceleration, or every body's force and moment";
      return false;
    }
    Eigen::VectorXd of_own(6 + layout_.actuators);
    of_own.head<6>() = own.answer.acceleration;
    of_own.segment<3>(3) *= layout_.scales.length;
    for (Index a = 0; a < layout_.actuators; ++a)
      of_own[6 + a] = own.answer.closing[a] * layout_.reach[a];
    x = system.nearest_to(of_own);
    completion_.completed.emplace_back(
        "the motion, where it was open as lcpush's own answer has it");
  }
  set_acceleration(*x);
  set_closings(x->tail(layout_.actuators));
  return true;
}

/// As far as the object lets the actuators close: maximise tau s while no contact is entered.
std::optional<Eigen::VectorXd> AnswerCompleter::closings_from_openings() const {
  const Index n = layout_.actuators, points = layout_.points;
  double unit = 0;
  for (Index i = 0; i < points; ++i) unit = std::max(unit, std::abs(opening(i)));
  if (!(unit > 0)) unit = 1;
  Eigen::MatrixXd A(points, n + points); // the closings, what is left to each contact
  Eigen::VectorXd b(points), c = Eigen::VectorXd::Zero(n + points);
  for (Index a = 0; a < n; ++a)
    c[a] = -scene_.actuators[a].force / (layout_.scales.force * layout_.reach[a]);
  A.rightCols(points).setIdentity();
  for (Index i = 0; i < points; ++i) {
    const Eigen::VectorXd speeds = drive_speeds(i, body_of(i).normal);
    A.row(i).head(n) = speeds.transpose();
    // A body that no actuator moves sets no limit.
    b[i] = speeds.norm() > 0 ? opening(i) / unit : 1;
  }
  const std::optional<Eigen::VectorXd> closed = cheapest_point(A, b, c, n);
  if (!closed) return std::nullopt;
  return Eigen::VectorXd(unit * closed->head(n));
}

/// Of a known acceleration.
bool AnswerCompleter::find_closings() {
  const Index n = layout_.actuators;
  if (n == 0) return true;
  Vector6<double> a = answer_.acceleration;
  a.tail<3>() *= layout_.scales.length;
  const auto by = [&](const Rows& given) {
    Rows rows;
    for (const auto& [row, right] : given) {
      const Eigen::VectorXd closings = row.tail(n);
      if (closings.norm() > 0) rows.emplace_back(closings, right - row.head(6).dot(a));
    }
    return System(rows, n).only();
  };
  std::optional<Eigen::VectorXd> s = by(closing_rows());
  if (!s) s = by(point_rows());
  if (!s) {
    s = System(pressed_rows(), n).only();
    if (!s) s = closings_from_openings();
    if (!s) {
      completion_.missing = "the closing accelerations (\"closing\", a number an actuator)";
      return false;
    }
    completion_.completed.emplace_back("how the actuators close, from the motion of the contacts");
  }
  set_closings(*s);
  return true;
}

/// Of the object beside the point's body.
Vector6<double> AnswerCompleter::relative_twist(Index point) const {
  return answer_.acceleration - body_twist(scene_, answer_, layout_.body[point], 1.0);
}

/// In the point's friction space, m/s^2.
Vector3<double> AnswerCompleter::slip(Index point) const {
  return slip_of<double>(body_of(point), scene_.points[point], relative_twist(point));
}

/// n' r, m/s^2.
double AnswerCompleter::gap(Index point) const {
  return acceleration_at<double>(scene_.points[point], relative_twist(point))
      .dot(body_of(point).normal);
}

/// d_j' r + xi, m/s^2.
double AnswerCompleter::slides_against(Index point, Index j) const {
  const Body<double>& body = body_of(point);
  const Vector6<double> relative = relative_twist(point);
  const Generator<double> d = generator(scene_, body, point, j);
  return acceleration_at<double>(scene_.points[point], relative).dot(d.force) +
         relative.tail<3>().dot(body.normal) * d.torque + answer_.contacts[point].slip;
}

/// xi = max (0, - d_j' r): what [T.3] makes of the motion; of round friction |r|.
void AnswerCompleter::find_slips() {
  for (Index i = 0; i < layout_.points; ++i) {
    answer_.contacts[i].slip = 0;
    const bool is_round = has_round_friction(scene_, body_of(i));
    double most = is_round ? slip(i).norm() : 0;
    for (Index j = 0; !is_round && j < layout_.cones[i].generators; ++j)
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
  if (!find_motion()) return completion_;
  find_slips();
  if (!forces_known()) find_forces();
  split_frictions();
  find_motions();
  return completion_;
}

} // namespace lcpush::desktop
