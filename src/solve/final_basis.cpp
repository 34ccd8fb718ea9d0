#include "lcpush/desktop/final_basis.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "text/limits.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lcpush::desktop {
namespace {

constexpr double strict = 1e-6;   // of the scene's units: farther than this from a limit
constexpr double rounding = 1e-9; // of a direction's largest entry

enum class Regime {
  open,   ///< no force, moving apart
  smooth, ///< pressed, no friction
  stick,  ///< pressed, friction well inside its cone
  slide,  ///< pressed, friction on one generator
  tied,   ///< at the limit of two of these
};

struct Contact {
  Regime regime = Regime::tied;
  bool pressed = false;
  Vector6<double> force; // of a unit of lambda: with the friction that goes with it

  bool has_lambda() const { return pressed && regime != Regime::tied; }
};

/// The least sum of generator forces that makes this friction force: below mu lambda, it sticks.
double least_sum(const Body<double>& body, const Vector3<double>& friction, Index g) {
  double largest = 0;
  const double side = circle_cosine<double>(1, 2 * g);
  for (Index j = 0; j < g; ++j) {
    const Vector3<double> facet =
        generator(body, j, g).force + generator(body, (j + 1) % g, g).force;
    largest = std::max(largest, friction.dot(facet) / (2 * side * side));
  }
  return largest;
}

/// A force of the system and what a unit of it does at the centre of mass.
struct ForceColumn {
  Index point;
  Vector6<double> wrench;
};

class Study {
public:
  Study(const Assembly<double>& assembly, const Answer<double>& answer)
      : assembly_(assembly), scene_(assembly.scene()), layout_(assembly.layout()), answer_(answer) {
    double fastest = 1e-9 * layout_.scales.acceleration;
    for (const ContactAnswer<double>& contact : answer.contacts)
      fastest = std::max(fastest, contact.acceleration.norm());
    margins_ = {strict * layout_.scales.force, strict * fastest};
    Index entry = 0;
    for (Index i = 0; i < layout_.points; ++i) {
      contacts_.push_back(classify(i, answer.friction.data + entry));
      entry += layout_.cones[i].generators;
      const Contact& contact = contacts_.back();
      if (contact.has_lambda()) forces_.push_back({i, contact.force});
      if (contact.regime != Regime::stick) continue;
      for (const Vector6<double>& wrench : held_directions(i)) forces_.push_back({i, wrench});
    }
  }

  FinalBasis result() const {
    FinalBasis found;
    found.studied = true;
    for (const Contact& contact : contacts_)
      if (contact.regime == Regime::tied) ++found.tied_contacts;
    const Eigen::MatrixXd K = equations();
    Eigen::FullPivLU<Eigen::MatrixXd> lu(K);
    lu.setThreshold(1e-11);
    if (lu.rank() == K.cols()) return found;
    double yields = 0; // what the last round's compliance lets a unit of force move
    for (const ConeGroup<double>& cone : layout_.cones) yields = std::max(yields, cone.compliance);
    // A row of small numbers counts as much as the others: only what solves each is a direction.
    const Eigen::VectorXd size = K.cwiseAbs().rowwise().maxCoeff();
    const Eigen::MatrixXd kernel = lu.kernel();
    for (Index k = 0; k < kernel.cols(); ++k) {
      const Eigen::VectorXd x = kernel.col(k) / kernel.col(k).cwiseAbs().maxCoeff();
      if (!(((K * x).cwiseAbs() - rounding * size).maxCoeff() <= 0)) continue;
      found.motion_open = found.motion_open || x.head<6>().norm() > rounding + 10 * yields;
      found.wrench_open = found.wrench_open || opens_wrench(x);
    }
    return found;
  }

private:
  const Assembly<double>& assembly_;
  const Scene<double>& scene_;
  const Layout<double>& layout_;
  const Answer<double>& answer_;
  ContactMargins<double> margins_{};
  std::vector<Contact> contacts_;
  std::vector<ForceColumn> forces_; // point by point: what is pressed, then what sticks

  const Body<double>& body_of(Index i) const { return scene_.bodies[layout_.body[i]]; }

  Contact classify(Index i, const double* beta) const {
    const ContactAnswer<double>& answer = answer_.contacts[i];
    const Body<double>& body = body_of(i);
    Contact contact;
    contact.force = assembly_.factored().wrenches[layout_.cones[i].force];
    const bool loaded = margins_.presses(answer);
    contact.pressed = loaded || body.bilateral;
    if (!contact.pressed) {
      contact.regime = margins_.opens(answer, body) ? Regime::open : Regime::tied;
    } else if (layout_.cones[i].generators == 0) {
      contact.regime = Regime::smooth;
    } else {
      contact.regime = loaded ? friction_regime(i, beta, contact) : Regime::tied;
    }
    return contact;
  }

  /// Stick, slide or tied; for slide the friction joins the contact's force column.
  Regime friction_regime(Index i, const double* beta, Contact& contact) const {
    const ContactAnswer<double>& answer = answer_.contacts[i];
    const ConeGroup<double>& cone = layout_.cones[i];
    const Body<double>& body = body_of(i);
    if (!(answer.slip > margins_.motion)) {
      double sum = 0;
      for (Index j = 0; j < cone.generators; ++j) sum += beta[j];
      if (!(body.torsion_radius > 0)) sum = least_sum(body, answer.friction_force, scene_.facets);
      const double room = body.friction * std::abs(answer.normal_force) - sum;
      return room > margins_.force ? Regime::stick : Regime::tied;
    }
    Index active = -1;
    for (Index j = 0; j < cone.generators; ++j) {
      const Generator<double> d = generator(body, j, scene_.facets);
      const double w = answer.acceleration.dot(d.force) + answer.spin * d.torque + answer.slip;
      if (w > margins_.motion) continue;
      if (active >= 0) return Regime::tied; // between two generators
      active = j;
    }
    if (active < 0) return Regime::tied;
    const double sign = answer.normal_force < 0 ? -1 : 1;
    contact.force +=
        sign * body.friction * assembly_.factored().wrenches[cone.force + cone.normals + active];
    return Regime::slide;
  }

  /// Where point i cannot slide: along its face and, of a soft point, about its normal.
  std::vector<Vector6<double>> held_directions(Index i) const {
    const Body<double>& body = body_of(i);
    const Vector3<double> p = scene_.points[i] / layout_.scales.length;
    std::vector<Vector6<double>> held = {
        wrench_column<double>(p, body.tangent),
        wrench_column<double>(p, cross(body.normal, body.tangent))};
    if (body.torsion_radius > 0) {
      held.emplace_back(Vector6<double>::Zero());
      held.back().tail<3>() = body.normal * (body.torsion_radius / layout_.scales.length);
    }
    return held;
  }

  /// K x = 0 for x = [a; s; forces]. What is tied keeps its force and its relative motion here,
  /// which is a part of what it might do.
  Eigen::MatrixXd equations() const {
    const FactoredProblem<double>& factored = assembly_.factored();
    const Index actuators = layout_.actuators, first = 6 + actuators;
    const Index unknowns = first + static_cast<Index>(forces_.size());
    const auto along_drives = [&](Index i, const Vector6<double>& wrench, const auto& use) {
      for (const Drive<double>& drive : scene_.drives)
        if (drive.body == layout_.body[i])
          use(drive.actuator,
              laws::grip_coefficient(drive, wrench, layout_.reach[drive.actuator], layout_.scales));
    };
    Eigen::MatrixXd balance = Eigen::MatrixXd::Zero(first, unknowns);
    balance.topLeftCorner(6, 6).setIdentity();
    for (Index a = 0; a < actuators; ++a) balance(6 + a, 6 + a) = factored.sums[a].inertia;
    for (Index k = 0; k < unknowns - first; ++k) {
      const ForceColumn& force = forces_[static_cast<std::size_t>(k)];
      balance.col(first + k).head<6>() = -factored.mobility.lazyProduct(force.wrench);
      along_drives(force.point, force.wrench,
                   [&](Index a, double c) { balance(6 + a, first + k) += c; });
    }
    std::vector<Eigen::RowVectorXd> rows;
    const auto stays = [&](Index i, const Vector6<double>& wrench) -> Eigen::RowVectorXd& {
      Eigen::RowVectorXd& row = rows.emplace_back(Eigen::RowVectorXd::Zero(unknowns));
      row.head<6>() = wrench.transpose();
      along_drives(i, wrench, [&](Index a, double c) { row[6 + a] -= c; });
      return row;
    };
    Index next = first; // of point i's forces
    for (Index i = 0; i < layout_.points; ++i) {
      const Contact& contact = contacts_[static_cast<std::size_t>(i)];
      if (contact.regime == Regime::open) continue;
      Eigen::RowVectorXd& closed = stays(i, factored.wrenches[layout_.cones[i].force]);
      if (contact.has_lambda()) closed[next] += layout_.cones[i].compliance;
      while (next < unknowns && forces_[static_cast<std::size_t>(next - first)].point == i) ++next;
      if (!contact.pressed || (contact.regime != Regime::stick && contact.regime != Regime::tied))
        continue;
      for (const Vector6<double>& wrench : held_directions(i)) stays(i, wrench);
    }
    Eigen::MatrixXd K(first + static_cast<Index>(rows.size()), unknowns);
    K.topRows(first) = balance;
    for (std::size_t k = 0; k < rows.size(); ++k) K.row(first + static_cast<Index>(k)) = rows[k];
    return K;
  }

  /// Does the direction x change the pushers' total wrench?
  bool opens_wrench(const Eigen::VectorXd& x) const {
    Vector6<double> pushers = Vector6<double>::Zero();
    Index next = 6 + layout_.actuators;
    for (const ForceColumn& force : forces_) {
      if (body_of(force.point).role == Role::pusher) pushers += x[next] * force.wrench;
      ++next;
    }
    return pushers.norm() > rounding;
  }
};

} // namespace

FinalBasis study_final_basis(const Assembly<double>& assembly, const Answer<double>& answer) {
  if (assembly.layout().points > limits::points_final_basis) return {};
  return Study(assembly, answer).result();
}

} // namespace lcpush::desktop
