#include "lcpush/desktop/final_basis.hpp"
#include "text/limits.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lcpush::desktop {
namespace {

constexpr double strict = 1e-6; // of the scene's units: farther than this from a limit
constexpr double zero = 1e-9;   // of a direction's largest entry

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

class Study {
public:
  Study(const Assembly<double>& assembly, const Answer<double>& answer)
      : assembly_(assembly), scene_(assembly.scene()), layout_(assembly.layout()), answer_(answer) {
    for (const ContactAnswer<double>& contact : answer.contacts)
      unit_ = std::max(unit_, contact.acceleration.norm());
    unit_ = std::max(unit_, 1e-9 * layout_.scales.acceleration);
    Index entry = 0;
    for (Index i = 0; i < layout_.points; ++i) {
      contacts_.push_back(classify(i, answer.friction.data + entry));
      entry += layout_.cones[i].generators;
    }
  }

  FinalBasis result() const;

private:
  const Assembly<double>& assembly_;
  const Scene<double>& scene_;
  const Layout<double>& layout_;
  const Answer<double>& answer_;
  double unit_ = 0; // m/s^2, what counts as moving
  std::vector<Contact> contacts_;

  const Body<double>& body_of(Index i) const { return scene_.bodies[layout_.body[i]]; }
  Contact classify(Index i, const double* beta) const;
  Regime friction_regime(Index i, const double* beta, Contact& contact) const;
  Eigen::MatrixXd equations(Index unknowns) const;
};

/// Stick, slide or tied; for slide the friction joins the contact's force column.
Regime Study::friction_regime(Index i, const double* beta, Contact& contact) const {
  const ContactAnswer<double>& answer = answer_.contacts[i];
  const ConeGroup<double>& cone = layout_.cones[i];
  const Body<double>& body = body_of(i);
  const double F = layout_.scales.force;
  if (!(answer.slip > strict * unit_)) {
    double sum = 0;
    for (Index j = 0; j < cone.generators; ++j) sum += beta[j];
    if (!(body.torsion_radius > 0)) sum = least_sum(body, answer.friction_force, scene_.facets);
    const double room = body.friction * std::abs(answer.normal_force) - sum;
    return room > strict * F ? Regime::stick : Regime::tied;
  }
  Index active = -1;
  for (Index j = 0; j < cone.generators; ++j) {
    const Generator<double> d = generator(body, j, scene_.facets);
    const double w = answer.acceleration.dot(d.force) + answer.spin * d.torque + answer.slip;
    if (w > strict * unit_) continue;
    if (active >= 0) return Regime::tied; // between two generators
    active = j;
  }
  if (active < 0) return Regime::tied;
  const double sign = answer.normal_force < 0 ? -1 : 1;
  contact.force +=
      sign * body.friction * assembly_.factored().wrenches[cone.force + cone.normals + active];
  return Regime::slide;
}

Contact Study::classify(Index i, const double* beta) const {
  const ContactAnswer<double>& answer = answer_.contacts[i];
  const Body<double>& body = body_of(i);
  Contact contact;
  contact.force = assembly_.factored().wrenches[layout_.cones[i].force];
  const bool loaded = std::abs(answer.normal_force) > strict * layout_.scales.force;
  contact.pressed = loaded || body.bilateral;
  if (!contact.pressed) {
    const bool apart = answer.acceleration.dot(body.normal) > strict * unit_;
    contact.regime = apart ? Regime::open : Regime::tied;
  } else if (layout_.cones[i].generators == 0) {
    contact.regime = Regime::smooth;
  } else {
    contact.regime = loaded ? friction_regime(i, beta, contact) : Regime::tied;
  }
  return contact;
}

/// K x = 0 for x = [a; s; lambda, then two or three tangential forces where it sticks]. What is
/// tied keeps its force and its relative motion here, which is a part of what it might do.
Eigen::MatrixXd Study::equations(Index unknowns) const {
  const FactoredProblem<double>& factored = assembly_.factored();
  const Index actuators = layout_.actuators;
  std::vector<Eigen::RowVectorXd> rows;
  const auto row = [&]() -> Eigen::RowVectorXd& {
    rows.emplace_back(Eigen::RowVectorXd::Zero(unknowns));
    return rows.back();
  };
  Eigen::MatrixXd newton = Eigen::MatrixXd::Zero(6, unknowns);
  Eigen::MatrixXd grip = Eigen::MatrixXd::Zero(actuators, unknowns);
  newton.leftCols(6).setIdentity();
  for (Index a = 0; a < actuators; ++a) grip(a, 6 + a) = factored.sums[a].inertia;
  const auto coupling = [&](Index drive, const Vector6<double>& column) {
    const Drive<double>& d = scene_.drives[drive];
    return laws::grip_coefficient(d, column, layout_.reach[d.actuator], layout_.scales);
  };
  Index next = 6 + actuators;
  const auto add_force = [&](Index i, const Vector6<double>& column) {
    newton.col(next) = -factored.mobility.lazyProduct(column);
    for (Index k = 0; k < scene_.drives.size; ++k)
      if (scene_.drives[k].body == layout_.body[i])
        grip(scene_.drives[k].actuator, next) += coupling(k, column);
    return next++;
  };
  const auto stays = [&](Index i, const Vector6<double>& column) -> Eigen::RowVectorXd& {
    Eigen::RowVectorXd& equation = row();
    equation.head<6>() = column.transpose();
    for (Index k = 0; k < scene_.drives.size; ++k)
      if (scene_.drives[k].body == layout_.body[i])
        equation[6 + scene_.drives[k].actuator] -= coupling(k, column);
    return equation;
  };
  for (Index i = 0; i < layout_.points; ++i) {
    const Contact& contact = contacts_[static_cast<std::size_t>(i)];
    if (contact.regime == Regime::open) continue;
    const Body<double>& body = body_of(i);
    const Vector6<double> normal = factored.wrenches[layout_.cones[i].force];
    Eigen::RowVectorXd& closed = stays(i, normal);
    if (contact.has_lambda()) closed[add_force(i, contact.force)] += layout_.cones[i].compliance;
    if (contact.regime != Regime::stick && contact.regime != Regime::tied) continue;
    const Vector3<double> p = scene_.points[i] / layout_.scales.length;
    std::vector<Vector6<double>> held = {
        wrench_column<double>(p, body.tangent),
        wrench_column<double>(p, cross(body.normal, body.tangent))};
    if (body.torsion_radius > 0) {
      held.emplace_back(Vector6<double>::Zero());
      held.back().tail<3>() = body.normal * (body.torsion_radius / layout_.scales.length);
    }
    for (const Vector6<double>& column : held) {
      if (contact.pressed) stays(i, column);
      if (contact.regime == Regime::stick) add_force(i, column);
    }
  }
  Eigen::MatrixXd K(6 + actuators + static_cast<Index>(rows.size()), unknowns);
  K.topRows(6) = newton;
  K.middleRows(6, actuators) = grip;
  for (std::size_t k = 0; k < rows.size(); ++k)
    K.row(6 + actuators + static_cast<Index>(k)) = rows[k];
  return K;
}

FinalBasis Study::result() const {
  FinalBasis found;
  found.studied = true;
  Index unknowns = 6 + layout_.actuators;
  for (Index i = 0; i < layout_.points; ++i) {
    const Contact& contact = contacts_[static_cast<std::size_t>(i)];
    if (contact.regime == Regime::tied) ++found.tied_contacts;
    if (contact.has_lambda()) ++unknowns;
    if (contact.regime == Regime::stick) unknowns += body_of(i).torsion_radius > 0 ? 3 : 2;
  }
  const Eigen::MatrixXd K = equations(unknowns);
  Eigen::FullPivLU<Eigen::MatrixXd> lu(K);
  lu.setThreshold(1e-11);
  if (lu.rank() == unknowns) return found;
  double yields = 0; // what the last round's compliance lets a unit of force move
  for (const ConeGroup<double>& cone : layout_.cones) yields = std::max(yields, cone.compliance);
  const Eigen::MatrixXd kernel = lu.kernel();
  for (Index k = 0; k < kernel.cols(); ++k) {
    const Eigen::VectorXd x = kernel.col(k) / kernel.col(k).cwiseAbs().maxCoeff();
    // A row of small numbers counts as much as the others: believe what solves each.
    const Eigen::VectorXd size = K.cwiseAbs().rowwise().maxCoeff();
    if (!(((K * x).cwiseAbs() - zero * size).maxCoeff() <= 0)) continue;
    found.motion_open = found.motion_open || x.head<6>().norm() > zero + 10 * yields;
    Vector6<double> pushers = Vector6<double>::Zero();
    Index next = 6 + layout_.actuators;
    for (Index i = 0; i < layout_.points; ++i) {
      const Contact& contact = contacts_[static_cast<std::size_t>(i)];
      const bool pushes = body_of(i).role == Role::pusher;
      if (contact.has_lambda()) {
        if (pushes) pushers += x[next] * contact.force;
        ++next;
      }
      if (contact.regime != Regime::stick) continue;
      const Body<double>& body = body_of(i);
      const Vector3<double> p = scene_.points[i] / layout_.scales.length;
      const Vector3<double> t = body.tangent, o = cross(body.normal, body.tangent);
      if (pushes)
        pushers +=
            x[next] * wrench_column<double>(p, t) + x[next + 1] * wrench_column<double>(p, o);
      next += 2;
      if (!(body.torsion_radius > 0)) continue;
      if (pushes)
        pushers.tail<3>() += x[next] * body.normal * (body.torsion_radius / layout_.scales.length);
      ++next;
    }
    found.wrench_open = found.wrench_open || pushers.norm() > zero;
  }
  return found;
}

} // namespace

FinalBasis study_final_basis(const Assembly<double>& assembly, const Answer<double>& answer) {
  if (assembly.layout().points > limits::points_final_basis) return {};
  return Study(assembly, answer).result();
}

} // namespace lcpush::desktop
