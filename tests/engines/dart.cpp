// DART, with ODE's collisions, for `score.py --engine`: [step=S] SCENE SECONDS
#include "exported.hpp"

#include <dart/collision/CollisionFilter.hpp>
#include <dart/collision/CollisionObject.hpp>
#include <dart/collision/ode/OdeCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/CylinderShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/PlaneShape.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/ShapeNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include <set>

namespace {

using namespace dart::dynamics;
using exported::Body;
using exported::Geom;
using exported::Pair;
using exported::Scene;
using exported::Vector;

/// Nothing touches but what the scene pairs.
struct Pairs : dart::collision::CollisionFilter {
  std::set<std::pair<const ShapeFrame*, const ShapeFrame*>> touching;
  bool ignoresCollision(const dart::collision::CollisionObject* a,
                        const dart::collision::CollisionObject* b) const override {
    return !touching.count({a->getShapeFrame(), b->getShapeFrame()}) &&
           !touching.count({b->getShapeFrame(), a->getShapeFrame()});
  }
};

class World {
public:
  World(const Scene& scene, const std::map<std::string, std::string>&) : scene_(scene) {
    dart::constraint::ContactConstraint::setMaxErrorReductionVelocity(1e-5);
    world_->setGravity(scene.gravity);
    auto* solver = world_->getConstraintSolver();
    solver->setCollisionDetector(dart::collision::OdeCollisionDetector::create());
    solver->getCollisionOption().maxNumContacts = 1000;
    solver->getCollisionOption().collisionFilter = pairs_;
    add_object();
    for (const Body& body : scene.bodies) add(body);
    for (const Pair& pair : scene.pairs) {
      if (pair.torsion > 0)
        throw std::runtime_error("DART has no friction against turning about a normal");
      ShapeNode* on = shapes_[pair.body][pair.geom];
      on->getDynamicsAspect()->setFrictionCoeff(pair.friction);
      pairs_->touching.insert({object_shapes_[pair.object_geom], on});
    }
  }

  void step(double time, double step) {
    world_->setTimeStep(step);
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      const Body& body = scene_.bodies[b];
      if (carriers_[b] != nullptr)
        carriers_[b]->setCommand(0, body.mean_velocity(time, step).dot(carriers_[b]->getAxis()));
      if (fingers_[b] != nullptr) fingers_[b]->setForce(0, body.force);
    }
    world_->step();
  }

  exported::State state() const {
    std::vector<Vector> forces(scene_.bodies.size(), Vector::Zero());
    for (const auto& contact : world_->getLastCollisionResult().getContacts())
      for (std::size_t b = 0; b < shapes_.size(); ++b)
        for (const ShapeNode* shape : shapes_[b])
          if (contact.collisionObject1->getShapeFrame() == shape ||
              contact.collisionObject2->getShapeFrame() == shape)
            forces[b] += contact.force;
    const Eigen::Isometry3d& T = object_->getTransform();
    return {T.translation(), Eigen::Quaterniond(T.linear()), object_->getLinearVelocity(),
            object_->getAngularVelocity(), forces};
  }

private:
  void add_object() {
    const SkeletonPtr skeleton = Skeleton::create("object");
    Joint* joint = nullptr;
    if (scene_.is_planar)
      std::tie(joint, object_) = skeleton->createJointAndBodyNodePair<PlanarJoint>();
    else
      std::tie(joint, object_) = skeleton->createJointAndBodyNodePair<FreeJoint>();
    Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
    start.translation() = scene_.start;
    joint->setTransformFromParentBodyNode(start);
    object_->setInertia(Inertia(scene_.mass, Vector::Zero(), scene_.inertia));
    if (scene_.is_planar)
      joint->setVelocities(Vector(scene_.velocity[0], scene_.velocity[1], scene_.spin[2]));
    else
      joint->setVelocities(
          (Eigen::VectorXd(6) << scene_.spin, scene_.velocity).finished()); // in the body's frame
    for (const Geom& geom : scene_.geoms) {
      object_shapes_.push_back(add(geom, object_));
      object_shapes_.back()->getDynamicsAspect()->setFrictionCoeff(1e6); // the smaller one counts
    }
    world_->addSkeleton(skeleton);
  }

  void add(const Body& body) {
    const SkeletonPtr skeleton = Skeleton::create(body.name);
    PrismaticJoint *carrier = nullptr, *finger = nullptr;
    BodyNode* node = nullptr;
    const Vector motion = body.velocity + body.acceleration;
    if (body.is_prescribed()) {
      std::tie(carrier, node) = skeleton->createJointAndBodyNodePair<PrismaticJoint>();
      node->setName("carrier"); // DART tells of names that it changes
      carrier->setName("carrier");
      carrier->setAxis(motion.normalized());
      carrier->setActuatorType(Joint::VELOCITY);
      carrier->setVelocity(0, body.velocity.dot(carrier->getAxis()));
    }
    if (body.mass > 0) {
      std::tie(finger, node) = skeleton->createJointAndBodyNodePair<PrismaticJoint>(node);
      finger->setAxis(body.axis);
      node->setInertia(
          Inertia(body.mass, Vector::Zero(), body.inertia * Eigen::Matrix3d::Identity()));
    }
    if (node == nullptr) node = skeleton->createJointAndBodyNodePair<WeldJoint>().second;
    Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
    start.translation() = scene_.start;
    skeleton->getJoint(0)->setTransformFromParentBodyNode(start);
    for (BodyNode* each : skeleton->getBodyNodes()) each->setGravityMode(false);
    shapes_.emplace_back();
    for (const Geom& geom : body.geoms) shapes_.back().push_back(add(geom, node));
    carriers_.push_back(carrier);
    fingers_.push_back(finger);
    world_->addSkeleton(skeleton);
  }

  static ShapeNode* add(const Geom& g, BodyNode* node) {
    ShapePtr shape = std::make_shared<SphereShape>(g.size[0]);
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.translation() = g.center;
    at.linear() = g.rotation();
    if (g.type == "box") shape = std::make_shared<BoxShape>(2 * g.size);
    if (g.type == "cylinder") shape = std::make_shared<CylinderShape>(g.size[0], 2 * g.size[1]);
    if (g.type == "plane") shape = std::make_shared<PlaneShape>(Vector::UnitZ(), 0);
    ShapeNode* made = node->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape);
    made->setRelativeTransform(at);
    return made;
  }

  Scene scene_;
  dart::simulation::WorldPtr world_ = dart::simulation::World::create();
  std::shared_ptr<Pairs> pairs_ = std::make_shared<Pairs>();
  BodyNode* object_ = nullptr;
  std::vector<PrismaticJoint*> carriers_, fingers_; ///< of each body; null: it has none
  std::vector<ShapeNode*> object_shapes_;
  std::vector<std::vector<ShapeNode*>> shapes_;
};

} // namespace

int main(int argc, char** argv) { return exported::run<World>(argc, argv); }
