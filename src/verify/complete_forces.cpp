// The forces of an AnswerCompleter: from the motion and the bodies' sums, and as generators.
#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"
#include "solve/rest_by_friction.hpp"
#include "text/limits.hpp"
#include "verify/answer_completer.hpp"
#include "verify/settings.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {
using Settings = VerifySettings;
}

/// What a unit of the force is in every row, scaled: Newton's law, the grip, the sums that are
/// given of its body, its point's cone, and what is given of a soft point's friction.
Eigen::VectorXd AnswerCompleter::column(const PointForce& force) const {
  const Index i = force.point, b = layout_.body[i], cones = force_rows();
  const Scales<double>& scales = layout_.scales;
  const Body<double>& body = body_of(i);
  const bool is_normal = force.sign != 0;
  const Generator<double> d = is_normal ? Generator<double>{force.sign * body.normal, 0}
                                        : generator_along(body, force.direction);
  const Vector6<double> W = laws::friction_direction(body, scene_.points[i], d, scales);
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(cones + 4 * layout_.points);
  rows.head<6>() = W;
  stay_in_plane(scene_, rows);
  for_each_grip(scene_, layout_, b, W, [&](Index a, double grip) { rows[6 + a] += grip; });
  if (!given_.bodies.empty()) {
    const Index of = file_.body_of(i); // under even pressure each of its points is a body
    const ForeignBody& given = given_.bodies[static_cast<std::size_t>(of)];
    const Index sums = 6 + layout_.actuators + 7 * of;
    if (given.force) rows.segment<3>(sums) = W.head<3>();
    if (given.moment) rows.segment<3>(sums + 3) = W.tail<3>();
    if (given.normal_force) rows[sums + 6] = force.sign;
  }
  if (layout_.cones[i].generators > 0) rows[cones + i] = is_normal ? body.friction : -1;
  if (!is_normal && !friction_known(i) && contact_of(i).friction_force)
    rows.segment<3>(cones + layout_.points + 3 * i) = d.force;
  return rows;
}

/// What the rows of unknown forces sum up to.
Eigen::VectorXd AnswerCompleter::targets() const {
  const Scales<double>& scales = layout_.scales;
  const Index cones = force_rows();
  Eigen::VectorXd b = Eigen::VectorXd::Zero(cones + 4 * layout_.points);
  b.head<6>() << scene_.object.mass * answer_.acceleration.head<3>() / scales.force,
      scene_.object.inertia * answer_.acceleration.tail<3>() / (scales.force * scales.length);
  b.head<6>() -= laws::load(scene_, scales);
  stay_in_plane(scene_, b);
  for (Index a = 0; a < layout_.actuators; ++a) {
    const SumGroup<double> grip = laws::grip_force(scene_, a, layout_.reach[a], scales);
    b[6 + a] =
        grip.target - grip.inertia * answer_.closing[a] * layout_.reach[a] / scales.acceleration;
  }
  for (std::size_t k = 0; k < given_.bodies.size(); ++k) {
    const ForeignBody& given = given_.bodies[k];
    const Index sums = 6 + layout_.actuators + 7 * static_cast<Index>(k);
    if (given.force) b.segment<3>(sums) = *given.force / scales.force;
    if (given.moment) b.segment<3>(sums + 3) = *given.moment / (scales.force * scales.length);
    if (given.normal_force) b[sums + 6] = *given.normal_force / scales.force;
  }
  std::vector<double> beta;
  for (Index i = 0; i < layout_.points; ++i) {
    const ContactAnswer<double>& contact = answer_.contacts[i];
    const double lambda = contact.normal_force / scales.force;
    if (normal_known(i)) b -= std::abs(lambda) * column({i, lambda < 0 ? -1.0 : 1.0, {}});
    const Vector3<double> friction = friction_of(body_of(i), contact) / scales.force;
    const double size = friction.norm();
    if (friction_known(i) && size > 0) {
      beta.resize(static_cast<std::size_t>(layout_.cones[i].generators));
      Eigen::VectorXd known = size * column({i, 0, friction / size});
      known[cones + i] = has_round_friction(scene_, body_of(i))
                             ? -size
                             : -split_friction(i, beta.data()) / scales.force;
      b -= known;
    } else if (!friction_known(i) && contact_of(i).friction_force) {
      b.segment<3>(cones + layout_.points + 3 * i) = contact.friction_force / scales.force;
    }
  }
  return b;
}

/// The unknown ones that this motion allows. Round friction that sticks may have any direction:
/// here it has its axes'.
std::vector<AnswerCompleter::PointForce> AnswerCompleter::possible_forces() const {
  std::vector<PointForce> forces;
  for (Index i = 0; i < layout_.points; ++i) {
    const ConeGroup<double>& cone = layout_.cones[i];
    if (!normal_known(i) && gap(i) <= least())
      for (Index k = 0; k < cone.normals; ++k)
        forces.push_back({i, k == 0 ? 1.0 : -1.0, Vector3<double>::Zero()});
    if (friction_known(i)) continue;
    const Body<double>& body = body_of(i);
    const Index g = generator_count(scene_, body);
    const Vector3<double> v = slip(i);
    if (!has_round_friction(scene_, body)) {
      for (Index j = 0; j < g; ++j)
        if (slides_against(i, j) <= least())
          forces.push_back({i, 0, generator_direction<double>(j, facets_of(body, scene_.facets))});
    } else if (v.norm() > least()) {
      forces.push_back({i, 0, -v.normalized()});
    } else {
      for (Index k = 0; k < (body.torsion_radius > 0 ? 6 : 4); ++k)
        forces.push_back({i, 0, (k % 2 == 0 ? 1.0 : -1.0) * Vector3<double>::Unit(k / 2)});
    }
  }
  return forces;
}

/// The direction of a sticking point's round friction that takes most off what the fit leaves.
std::optional<AnswerCompleter::PointForce>
AnswerCompleter::steepest(Index point, const Eigen::VectorXd& off) const {
  if (friction_known(point) || !has_round_friction(scene_, body_of(point)) ||
      answer_.contacts[point].slip > least())
    return std::nullopt;
  Vector3<double> down = Vector3<double>::Zero();
  for (Index k = 0; k < (body_of(point).torsion_radius > 0 ? 3 : 2); ++k) {
    Eigen::VectorXd along = column({point, 0, Vector3<double>::Unit(k)});
    along[force_rows() + point] = 0; // of every direction alike
    down[k] = -along.dot(off);
  }
  if (!(down.norm() > 0)) return std::nullopt;
  return PointForce{point, 0, down.normalized()};
}

/// Forces >= 0 that fit the rows best. A bilateral contact that pushed and pulled at once would
/// widen its own cone: where the fit does that, every choice of one of the two is tried.
Eigen::VectorXd AnswerCompleter::fitting(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                         const std::vector<PointForce>& forces) const {
  Eigen::VectorXd best = nonnegative_least_squares(A, b);
  std::vector<Index> pulls; // the second of two columns
  for (std::size_t k = 0; k < forces.size(); ++k)
    if (forces[k].sign < 0) pulls.push_back(static_cast<Index>(k));
  const bool splits = std::any_of(pulls.begin(), pulls.end(),
                                  [&](Index k) { return best[k] > 0 && best[k - 1] > 0; });
  if (!splits || pulls.size() > limits::pulls_enumerated) return best;
  double smallest = -1;
  for (unsigned choice = 0; choice < 1U << pulls.size(); ++choice) {
    Eigen::MatrixXd chosen = A;
    for (std::size_t k = 0; k < pulls.size(); ++k)
      chosen.col(pulls[k] - ((choice >> k & 1U) != 0 ? 1 : 0)).setZero();
    const Eigen::VectorXd x = nonnegative_least_squares(chosen, b);
    const double rest = (chosen * x - b).norm();
    if (smallest >= 0 && rest >= smallest) continue;
    smallest = rest;
    best = x;
  }
  return best;
}

/// Forces that were not given: of those that obey the laws best the nearest to the sums that were.
/// Round cones get generators where the friction is to go, until it goes there.
void AnswerCompleter::find_forces() {
  const Eigen::VectorXd b = targets();
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(b.size(), Settings::laws_first);
  weights.segment(6 + layout_.actuators, force_rows() - 6 - layout_.actuators).setOnes();
  weights.tail(3 * layout_.points).setOnes();
  std::vector<PointForce> forces = possible_forces();
  std::vector<Index> sticking; // sliding leaves nothing of the cone
  for (Index i = 0; i < layout_.points; ++i)
    if (!(answer_.contacts[i].slip > least())) sticking.push_back(i);
  Eigen::VectorXd x;
  double left = -1; // after the round before
  for (int round = 0;; ++round) {
    const auto count = static_cast<Index>(forces.size());
    Eigen::MatrixXd A =
        Eigen::MatrixXd::Zero(b.size(), count + static_cast<Index>(sticking.size()));
    for (Index k = 0; k < count; ++k) A.col(k) = column(forces[static_cast<std::size_t>(k)]);
    for (std::size_t k = 0; k < sticking.size(); ++k)
      A(force_rows() + sticking[k], count + static_cast<Index>(k)) = -1;
    x = fitting(weights.asDiagonal() * A, weights.cwiseProduct(b), forces);
    const Eigen::VectorXd off = A * x - b;
    const double now = weights.cwiseProduct(off).norm();
    if (!file_.is_round || round == Settings::cone_rounds ||
        off.cwiseAbs().maxCoeff() <= Settings::fits * tolerance_ ||
        (round > 0 && now >= (1 - Settings::cone_gain) * left))
      break;
    left = now;
    for (const Index i : sticking)
      if (const auto more = steepest(i, weights.cwiseAbs2().cwiseProduct(off)))
        forces.push_back(*more);
  }
  completion_.has_forces = true;
  completion_.completed.emplace_back("forces that were not given, from the motion");
  for (Index i = 0; i < layout_.points; ++i) {
    if (friction_known(i)) continue;
    answer_.contacts[i].friction_force.setZero();
    answer_.contacts[i].torsion = 0;
  }
  for (std::size_t k = 0; k < forces.size(); ++k) {
    ContactAnswer<double>& contact = answer_.contacts[forces[k].point];
    const double force = x[static_cast<Index>(k)] * layout_.scales.force;
    contact.normal_force += forces[k].sign * force;
    if (forces[k].sign != 0) continue;
    const Generator<double> d = generator_along(body_of(forces[k].point), forces[k].direction);
    contact.friction_force += force * d.force;
    contact.torsion += force * d.torque;
  }
}

/// A friction force as generators with the least sum, N, which is returned.
double AnswerCompleter::split_friction(Index point, double* beta) const {
  const Body<double>& body = body_of(point);
  const ContactAnswer<double>& contact = answer_.contacts[point];
  const Index g = generator_count(scene_, body);
  if (!(body.torsion_radius > 0)) { // round friction turns its generators
    const Vector3<double> t = generator(scene_, body, point, 0).force;
    const Vector3<double>& f = contact.friction_force;
    return onto_neighbours(f.dot(t), f.dot(cross(body.normal, t)), g, beta);
  }
  std::fill_n(beta, g, 0.0);
  const Vector3<double> friction = friction_of(body, contact);
  const double size = friction.norm();
  if (!(size > 0)) return 0;
  Eigen::MatrixXd A(3, g);
  for (Index j = 0; j < g; ++j) {
    const Generator<double> d = generator(scene_, body, point, j);
    A.col(j) << d.force.dot(body.tangent), d.force.dot(cross(body.normal, body.tangent)),
        d.torque / body.torsion_radius;
  }
  double sum = 0;
  if (const auto least = cheapest_point(A, friction / size, Eigen::VectorXd::Ones(g), 0))
    for (Index j = 0; j < g; ++j) sum += beta[j] = size * (*least)[j];
  return sum;
}

/// All of them; round cones are turned to the forces first, or against the slip.
void AnswerCompleter::split_frictions() {
  if (file_.is_round) {
    std::vector<Vector3<double>> directions;
    for (Index i = 0; i < layout_.points; ++i) {
      const Vector3<double> friction = friction_of(body_of(i), answer_.contacts[i]);
      directions.push_back(friction.norm() > 0 ? friction : Vector3<double>(-slip(i)));
    }
    push_.linearize_cones(directions);
  }
  double* beta = answer_.friction.data;
  for (Index i = 0; i < layout_.points; ++i) {
    const Index g = layout_.cones[i].generators;
    if (g > 0) split_friction(i, beta);
    beta += g;
  }
}

} // namespace lcpush::desktop
