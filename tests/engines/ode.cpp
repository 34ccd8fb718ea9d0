// ODE for `score.py --engine`: [step=S] [friction=slip|pyramid] SCENE SECONDS
// Friction is a square: with a side across the slip, or as ODE turns it by itself.
#include "exported.hpp"

#include <ode/ode.h>

#include <deque>

namespace {

using exported::Body;
using exported::Geom;
using exported::Pair;
using exported::Scene;
using exported::Vector;

class World {
public:
  World(const Scene& scene, std::map<std::string, std::string> options)
      : scene_(scene), is_slip_(options["friction"] != "pyramid") {
    dInitODE2(0);
    world_ = dWorldCreate();
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    dWorldSetContactMaxCorrectingVel(world_, 1e-5);
    object_ = body(scene.start, scene.mass, scene.inertia);
    dBodySetGravityMode(object_, 1);
    dBodySetLinearVel(object_, scene.velocity[0], scene.velocity[1], scene.velocity[2]);
    dBodySetAngularVel(object_, scene.spin[0], scene.spin[1], scene.spin[2]);
    if (scene.is_planar) dJointAttach(dJointCreatePlane2D(world_, nullptr), object_, nullptr);
    for (const Geom& g : scene.geoms) object_geoms_.push_back(geom(g, object_, scene.start));
    for (const Body& b : scene.bodies) add(b);
  }

  void step(double time, double step) {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      const Body& body = scene_.bodies[b];
      const Vector v = body.mean_velocity(time, step), f = body.force * body.axis;
      if (carriers_[b] != nullptr) dBodySetLinearVel(carriers_[b], v[0], v[1], v[2]);
      if (fingers_[b] != nullptr) dBodyAddForce(fingers_[b], f[0], f[1], f[2]);
    }
    feedbacks_.clear();
    for (const Pair& pair : scene_.pairs) touch(pair);
    dWorldStep(world_, step);
    dJointGroupEmpty(contacts_);
  }

  exported::State state() const {
    const dReal *x = dBodyGetPosition(object_), *q = dBodyGetQuaternion(object_);
    const dReal *v = dBodyGetLinearVel(object_), *w = dBodyGetAngularVel(object_);
    std::vector<Vector> forces(scene_.bodies.size(), Vector::Zero());
    for (const auto& [body, feedback] : feedbacks_) forces[body] += Vector(feedback.f1);
    return {Vector(x), Eigen::Quaterniond(q[0], q[1], q[2], q[3]), Vector(v), Vector(w), forces};
  }

private:
  dBodyID body(const Vector& at, double mass, const Eigen::Matrix3d& I) {
    const dBodyID body = dBodyCreate(world_);
    dMass inertia;
    dMassSetParameters(&inertia, mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2),
                       I(1, 2));
    dBodySetMass(body, &inertia);
    dBodySetPosition(body, at[0], at[1], at[2]);
    dBodySetGravityMode(body, 0);
    return body;
  }

  void add(const Body& b) {
    dBodyID carrier = nullptr, finger = nullptr;
    if (b.is_prescribed()) {
      carrier = body(scene_.start, 1, Eigen::Matrix3d::Identity());
      dBodySetKinematic(carrier);
    }
    if (b.mass > 0) {
      finger = body(scene_.start, b.mass, b.inertia * Eigen::Matrix3d::Identity());
      const Vector v = b.velocity;
      dBodySetLinearVel(finger, v[0], v[1], v[2]);
      const dJointID slide = dJointCreateSlider(world_, nullptr);
      dJointAttach(slide, finger, carrier);
      dJointSetSliderAxis(slide, b.axis[0], b.axis[1], b.axis[2]);
    }
    carriers_.push_back(carrier);
    fingers_.push_back(finger);
    body_geoms_.emplace_back();
    for (const Geom& g : b.geoms)
      body_geoms_.back().push_back(geom(g, finger != nullptr ? finger : carrier, scene_.start));
  }

  static dGeomID geom(const Geom& g, dBodyID body, const Vector& origin) {
    const Vector at = origin + g.center;
    if (g.type == "plane")
      return dCreatePlane(nullptr, g.axis[0], g.axis[1], g.axis[2], g.axis.dot(at));
    const dGeomID geom = g.type == "sphere" ? dCreateSphere(nullptr, g.size[0])
                         : g.type == "box"
                             ? dCreateBox(nullptr, 2 * g.size[0], 2 * g.size[1], 2 * g.size[2])
                             : dCreateCylinder(nullptr, g.size[0], 2 * g.size[1]);
    dGeomSetBody(geom, body);
    const Eigen::Matrix3d R = g.rotation();
    const dMatrix3 rows = {R(0, 0), R(0, 1), R(0, 2), 0,       R(1, 0), R(1, 1),
                           R(1, 2), 0,       R(2, 0), R(2, 1), R(2, 2), 0};
    (body != nullptr ? dGeomSetOffsetWorldPosition : dGeomSetPosition)(geom, at[0], at[1], at[2]);
    (body != nullptr ? dGeomSetOffsetWorldRotation : dGeomSetRotation)(geom, rows);
    return geom;
  }

  void touch(const Pair& pair) {
    dContactGeom found[8];
    const dGeomID on = body_geoms_[pair.body][pair.geom];
    const int count = dCollide(object_geoms_[pair.object_geom], on, 8, found, sizeof(dContactGeom));
    for (int k = 0; k < count; ++k) {
      dContact contact{};
      contact.geom = found[k];
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = pair.friction;
      if (pair.torsion > 0) {
        contact.surface.mode |= dContactRolling | dContactAxisDep;
        contact.surface.mu2 = pair.friction;
        contact.surface.rhoN = pair.torsion;
      }
      const Vector slip = slip_at(found[k], dGeomGetBody(on));
      if (is_slip_ && slip.norm() > 0) {
        contact.surface.mode |= dContactFDir1;
        Eigen::Map<Vector>(contact.fdir1) = slip.normalized();
      }
      const dJointID joint = dJointCreateContact(world_, contacts_, &contact);
      dJointAttach(joint, object_, dGeomGetBody(on));
      dJointSetFeedback(joint, &feedbacks_.emplace_back(pair.body, dJointFeedback{}).second);
    }
  }

  Vector slip_at(const dContactGeom& at, dBodyID on) const {
    dVector3 v = {0, 0, 0, 0}, u = {0, 0, 0, 0};
    dBodyGetPointVel(object_, at.pos[0], at.pos[1], at.pos[2], v);
    if (on != nullptr) dBodyGetPointVel(on, at.pos[0], at.pos[1], at.pos[2], u);
    const Vector slip = Vector(v) - Vector(u), normal(at.normal);
    return slip - normal * normal.dot(slip);
  }

  Scene scene_;
  bool is_slip_;
  dWorldID world_;
  dJointGroupID contacts_;
  dBodyID object_;
  std::vector<dBodyID> carriers_, fingers_; ///< of each body; null: it has none
  std::deque<std::pair<std::size_t, dJointFeedback>> feedbacks_; ///< of contacts, by body
  std::vector<dGeomID> object_geoms_;
  std::vector<std::vector<dGeomID>> body_geoms_;
};

} // namespace

int main(int argc, char** argv) { return exported::run<World>(argc, argv); }
