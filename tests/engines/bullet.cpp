// Bullet, in double precision, for `score.py --engine`:
//   [step=S] [iterations=N] [breaking=SIZES] SCENE SECONDS
// iterations of its Gauss-Seidel (200); breaking: how far apart, in sizes of a shape, points of
// earlier steps may lie that still count as touching (Bullet's: 0.02).
#include "exported.hpp"

#include <btBulletDynamicsCommon.h>

#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>

#include <memory>
#include <set>

namespace {

using exported::Body;
using exported::Geom;
using exported::Pair;
using exported::Scene;
using exported::Vector;

btVector3 bullets(const Vector& v) { return {v[0], v[1], v[2]}; }
Vector ours(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

using Shapes = std::pair<const btCollisionShape*, const btCollisionShape*>;
std::set<Shapes> touching;
bool may_touch(const btCollisionShape* a, const btCollisionShape* b) {
  return a->isCompound() || b->isCompound() || touching.count({a, b}) || touching.count({b, a});
}

/// Bodies that go as prescribed keep the velocity that they are given.
struct Dynamics : btDiscreteDynamicsWorld {
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  void saveKinematicState(btScalar) override {}
};

class World {
public:
  World(const Scene& scene, std::map<std::string, std::string> options) : scene_(scene) {
    gCompoundChildShapePairCallback = gCompoundCompoundChildShapePairCallback = may_touch;
    configuration_.setPlaneConvexMultipointIterations(3, 3);
    configuration_.setConvexConvexMultipointIterations(3, 3);
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = options.count("iterations") ? std::stoi(options["iterations"]) : 200;
    if (options.count("breaking")) gContactBreakingThreshold = std::stod(options["breaking"]);
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    info.m_splitImpulsePenetrationThreshold = 0;
    world_.setGravity(bullets(scene.gravity));
    if (!Vector(scene.inertia.diagonal()).asDiagonal().toDenseMatrix().isApprox(scene.inertia))
      throw std::runtime_error("Bullet has no inertia but about a body's axes");
    object_ = add(scene.geoms, object_shapes_, scene.mass, scene.inertia.diagonal(), 1);
    object_->setLinearVelocity(bullets(scene.velocity));
    object_->setAngularVelocity(bullets(scene.spin));
    object_->setFriction(1); // Bullet multiplies
    if (scene.is_planar) {
      object_->setLinearFactor({1, 1, 0});
      object_->setAngularFactor({0, 0, 1});
    }
    for (const Body& body : scene.bodies) add(body);
    for (const Pair& pair : scene.pairs) {
      touching.insert({object_shapes_[pair.object_geom], body_shapes_[pair.body][pair.geom]});
      bodies_[pair.body]->setFriction(pair.friction);
      bodies_[pair.body]->setSpinningFriction(pair.torsion);
      if (pair.torsion > 0) // without any against rolling Bullet leaves it out
        bodies_[pair.body]->setRollingFriction(1e-12);
    }
  }

  void step(double time, double step) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const Body& body = scene_.bodies[b];
      const Vector along = body.axis * body.axis.dot(ours(bodies_[b]->getLinearVelocity()));
      bodies_[b]->setLinearVelocity(bullets(body.mean_velocity(time, step) + along));
      bodies_[b]->applyCentralForce(bullets(body.force * body.axis));
    }
    world_.stepSimulation(step_ = step, 0);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (bodies_[b]->isKinematicObject())
        bodies_[b]->translate(bullets(step * scene_.bodies[b].mean_velocity(time, step)));
  }

  exported::State state() const {
    std::vector<Vector> forces(bodies_.size(), Vector::Zero());
    for (int k = 0; k < dispatcher_.getNumManifolds(); ++k) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(k);
      const bool is_first = manifold.getBody0() == object_;
      const auto body = std::find(bodies_.begin(), bodies_.end(),
                                  is_first ? manifold.getBody1() : manifold.getBody0());
      for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& at = manifold.getContactPoint(i);
        const btVector3 impulse = at.m_appliedImpulse * at.m_normalWorldOnB +
                                  at.m_appliedImpulseLateral1 * at.m_lateralFrictionDir1 +
                                  at.m_appliedImpulseLateral2 * at.m_lateralFrictionDir2;
        forces[static_cast<std::size_t>(body - bodies_.begin())] += ours(impulse) / step_;
      }
    }
    const btQuaternion q = object_->getOrientation();
    return {ours(object_->getCenterOfMassPosition()),
            {q.w(), q.x(), q.y(), q.z()},
            ours(object_->getLinearVelocity()),
            ours(object_->getAngularVelocity()),
            forces};
  }

private:
  void add(const Body& body) {
    body_shapes_.emplace_back();
    btRigidBody* made =
        add(body.geoms, body_shapes_.back(), body.mass, body.inertia * Vector::Ones(), 2);
    const Vector free = body.axis.cwiseAbs();
    if (body.mass > 0 && free.maxCoeff() != free.sum())
      throw std::runtime_error("Bullet has no slide but along x, y or z: " + body.name);
    made->setLinearFactor(bullets(free));
    made->setAngularFactor(0);
    made->setFlags(made->getFlags() | BT_DISABLE_WORLD_GRAVITY);
    made->setGravity({0, 0, 0});
    if (body.mass == 0 && body.is_prescribed())
      made->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    bodies_.push_back(made);
  }

  btRigidBody* add(const std::vector<Geom>& geoms, std::vector<btCollisionShape*>& shapes,
                   double mass, const Vector& inertia, int group) {
    auto* compound = new btCompoundShape;
    for (const Geom& geom : geoms) {
      shapes.push_back(shape(geom));
      const Eigen::Matrix3d R =
          geom.type == "plane" ? Eigen::Matrix3d::Identity().eval() : geom.rotation();
      const btMatrix3x3 turned(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0),
                               R(2, 1), R(2, 2));
      compound->addChildShape(btTransform(turned, bullets(geom.center)), shapes.back());
    }
    auto* body = new btRigidBody(mass, nullptr, compound, bullets(inertia));
    body->setWorldTransform(btTransform(btMatrix3x3::getIdentity(), bullets(scene_.start)));
    body->setInterpolationWorldTransform(body->getWorldTransform());
    body->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(body, group, 3 - group);
    return body;
  }

  static btCollisionShape* shape(const Geom& g) {
    if (g.type == "plane") return new btStaticPlaneShape(bullets(g.axis), 0);
    if (g.type == "sphere") return new btSphereShape(g.size[0]);
    btCollisionShape* shape = g.type == "box"
                                  ? static_cast<btCollisionShape*>(new btBoxShape(bullets(g.size)))
                                  : new btCylinderShapeZ({g.size[0], g.size[0], g.size[1]});
    shape->setMargin(1e-6); // edges are round with it
    return shape;
  }

  Scene scene_;
  double step_ = 1;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  Dynamics world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btRigidBody* object_;
  std::vector<btRigidBody*> bodies_;
  std::vector<btCollisionShape*> object_shapes_;
  std::vector<std::vector<btCollisionShape*>> body_shapes_;
};

} // namespace

int main(int argc, char** argv) { return exported::run<World>(argc, argv); }
