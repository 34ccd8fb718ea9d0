// The basis of an answer, with the change of q by a command as an infinitesimal right-hand side.
#include "lcpush/desktop/sensitivity.hpp"

#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/lcp/pivots/held_basis.hpp"
#include "lcpush/mechanics/solve/pad_law.hpp"
#include "lcpush/mechanics/solve/round_friction.hpp"
#include "solve/settings.hpp"

#include <algorithm>
#include <functional>

namespace lcpush::desktop {
namespace {

using Eigen::VectorXd;

/// A component of a pusher's acceleration, or a grip force.
struct Command {
  std::string name;
  double unit; ///< of the scene's number a unit of the command: a jaw holds both fingers' force
  std::function<double&(SceneFile&)> number;
};

std::vector<Command> commands_of(const SceneFile& file) {
  std::vector<Command> list;
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    for (Index k = 0; file.bodies[b].role == Role::pusher && k < 6; ++k)
      if (!file.planar || k < 2 || k == 5)
        list.push_back({file.body_names[b] + ".twist[" + std::to_string(k) + "]", 1,
                        [=](SceneFile& f) -> double& { return f.bodies[b].acceleration[k]; }});
  for (const Drive<double>& drive : file.drives) {
    const auto a = static_cast<std::size_t>(drive.actuator);
    const bool is_jaw = file.actuator_names[a] == "jaws" && file.hand == Hand::parallel;
    const bool pushes = file.body(drive.body).role == Role::pusher;
    const char* const key = pushes                         ? ".normal_force"
                            : file.hand == Hand::actuators ? ".force"
                                                           : ".grip_force";
    const std::string name = (is_jaw ? "*" : file.actuator_names[a]) + key;
    if (list.empty() || list.back().name != name)
      list.push_back({name, is_jaw ? 2.0 : 1.0,
                      [=](SceneFile& f) -> double& { return f.actuators[a].force; }});
  }
  return list;
}

/// The laws are linear in loads and commands: what a command brings about is the scene without any
/// other.
SceneFile without_commands(SceneFile file) {
  file.gravity.setZero();
  file.object.wrench.setZero();
  for (Body<double>& body : file.bodies) body.acceleration.setZero();
  for (Actuator<double>& actuator : file.actuators) actuator.force = 0;
  return file;
}

/// [T.16] about the slips of the answer: one that settles at once has turned no pyramid. Pads stay
/// as compliant as they are.
void linearize(Assembly<double>& assembly, Workspace<double>& work) {
  const PressureMemory<double>& pressure = work.pressure;
  double eps = 0;
  for (Index i = 0; i < assembly.layout().points; ++i)
    if (pressure.compliance[i] > 0)
      eps = assembly.layout().cones[i].compliance / pressure.compliance[i];
  RoundFriction<double> friction(assembly, work.friction_memory(assembly.scene()));
  (void)friction.is_settled(pressure.z.data);
  friction.turn(pressure, false);
  set_compliance(assembly, pressure, eps);
}

class Derivatives {
public:
  Derivatives(const SceneFile& file, Assembly<double>& assembly, Workspace<double>& work)
      : given_(file), alone_(without_commands(file)), assembly_(assembly),
        pressure_(work.pressure) {
    if (just_slides(work.answer)) linearize(assembly, work);
    const Layout<double>& layout = assembly.layout();
    const Index shared = shared_actuators(assembly.factored());
    with_room(held_, held_basis_scalars(layout.size, layout.points, shared),
              held_basis_integers(layout.size, layout.points));
    reason_ = why_none(work.answer);
  }

  Sensitivity by(const Command& command) {
    Sensitivity found{command.name, command.number(given_) / command.unit, reason_};
    found.is_curved = is_round();
    if (!reason_.empty()) return found;
    // The basis may hold on one side alone.
    const VectorXd none = VectorXd::Zero(assembly_.layout().size);
    const bool falls = follow(command, -1, none, found), rises = follow(command, 1, none, found);
    if (!falls && !rises)
      found.reason = "not unique: the basis holds on neither side, as between two modes";
    else if (is_round() && depends_on_start(command, falls ? -1 : 1, found))
      found.reason = "the basis leaves open how pads of round friction share their pressure";
    if (!found.reason.empty()) return found;
    if (!falls) found.from = found.value;
    if (!rises) found.to = found.value;
    return found;
  }

private:
  SceneFile given_, alone_;
  const Assembly<double>& assembly_;
  const PressureMemory<double> pressure_;
  std::optional<Owned<HeldBasis<double>>> held_;
  std::string reason_;

  bool is_round() const { return has_round_friction(assembly_.scene()); }
  VectorXd last_z() const {
    return Eigen::Map<const VectorXd>(pressure_.z.data, assembly_.layout().size);
  }
  static bool differ(const VectorXd& a, const VectorXd& b) {
    return !((a - b).norm() <= SolveSettings().same * std::max(a.norm(), b.norm()));
  }

  /// Why nothing has a derivative, or nothing.
  std::string why_none(const Answer<double>& answer) {
    if (given_.hand == Hand::locked)
      return "locked fingers press by how they closed, which no basis tells";
    if (given_.is_round && !is_round())
      return "pyramids stand for round friction that did not settle";
    if (just_slides(answer)) return "round friction that just begins to slide has no derivative";
    const VectorXd z = last_z();
    if (held_->look(assembly_.problem(), pressure_.active.data) != Status::solved ||
        differ(Eigen::Map<const VectorXd>(held_->z(), z.size()), z))
      return "the answer does not stand in a basis, as after sweeps";
    return {};
  }

  /// Does a point slide along a pyramid that has not been turned to its slip?
  bool just_slides(const Answer<double>& answer) const {
    const auto& cones = assembly_.scene().round_cones;
    for (Index i = 0; i < cones.size; ++i)
      if (assembly_.layout().cones[i].generators > 2 && answer.contacts[i].mode == Mode::slide &&
          !(cones[i].inertia > 0))
        return true;
    return false;
  }

  /// The derivative to the one side, with its end. Pads follow their own change, round friction
  /// that of its bodies' motion, until both agree. False if the basis ends, or they do not.
  bool follow(const Command& command, double sign, const VectorXd& start, Sensitivity& found) {
    SceneFile alone = alone_;
    command.number(alone) = sign * command.unit;
    AssembledScene change(alone.view(), is_round());
    VectorXd z = start;
    for (Index pass = 0; pass < SolveSettings().most_passes; ++pass) {
      if (is_round()) turn(change);
      const VectorXd rates = with_pads(change, z), before = z;
      Problem<double> problem = assembly_.problem();
      problem.push = rates.data();
      if (held_->look(problem, pressure_.active.data) != Status::solved) return false;
      z = Eigen::Map<const VectorXd>(held_->z_push(), z.size());
      read_answer(change.assembly, z.data(), change.work.answer, 1.0);
      if ((z - before).norm() > SolveSettings().settled_passes * z.norm()) continue;
      take(change, sign, found);
      return true;
    }
    return false;
  }

  /// [T.16] A unit of the command moves bodies, and friction turns with their slips.
  void turn(AssembledScene& change) const {
    const Scene<double>& scene = assembly_.scene();
    for (Index i = 0; i < scene.round_cones.size; ++i) {
      const Index b = assembly_.layout().body[i];
      const Vector6<double> twist = body_twist(change.scene, change.work.answer, b, 1.0);
      change.work.round_cones[i] = scene.round_cones[i];
      change.work.round_cones[i].body_motion = slip_of(scene.bodies[b], scene.points[i], twist);
    }
    change.assembly.assemble(change.scene);
  }

  /// The change of q, in the change's own units; a pad's last round stands around its pressure.
  VectorXd with_pads(const AssembledScene& change, const VectorXd& z) const {
    VectorXd rates = Eigen::Map<const VectorXd>(change.assembly.problem().q, z.size());
    for (const ConeGroup<double>& cone : assembly_.layout().cones) {
      const double yields = cone.compliance * cone.normal_force(z.data());
      rates[cone.variable] -= yields;
      if (cone.normals == 2) rates[cone.variable + 1] += yields;
    }
    return rates;
  }

  void take(const AssembledScene& change, double sign, Sensitivity& found) const {
    const Answer<double>& answer = change.work.answer;
    const Scene<double> scene = given_.view();
    found.acceleration = sign * answer.acceleration;
    found.pushers.clear();
    for (Index b = 0; b < scene.bodies.size; ++b)
      if (scene.bodies[b].role == Role::pusher)
        found.pushers.push_back({b, sign * body_wrench(scene, answer, scene.bodies[b]).head<3>(),
                                 sign * normal_sum(answer, scene.bodies[b])});
    if (held_->valid_to() < 0 || found.is_curved) return;
    const double unit = assembly_.layout().scales.force / change.assembly.layout().scales.force;
    (sign < 0 ? found.from : found.to) = found.value + sign * unit * held_->valid_to();
  }

  /// Turning pyramids change the rounds before the last, and with them what these leave of a share
  /// that the last basis leaves open: then it is no derivative of the answer.
  bool depends_on_start(const Command& command, double sign, const Sensitivity& found) {
    Sensitivity other = found;
    if (!follow(command, sign, last_z(), other)) return true;
    bool differs = differ(found.acceleration, other.acceleration);
    for (std::size_t k = 0; k < found.pushers.size(); ++k)
      differs = differs || differ(found.pushers[k].force, other.pushers[k].force);
    return differs;
  }
};

} // namespace

std::vector<Sensitivity> find_sensitivity(const SceneFile& file, Assembly<double>& assembly,
                                          Workspace<double>& work) {
  Derivatives derivatives(file, assembly, work);
  std::vector<Sensitivity> list;
  for (const Command& command : commands_of(file)) list.push_back(derivatives.by(command));
  return list;
}

} // namespace lcpush::desktop
