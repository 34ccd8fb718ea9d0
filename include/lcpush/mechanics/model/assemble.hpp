// Assembly: from a scene to the factored problem, one law at a time, in the caller's memory.
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/mechanics/model/even_pressure.hpp"
#include "lcpush/mechanics/model/laws.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// How large a scene may be; everything else about memory follows. `generators` counts those of all
/// points together (points times facets, or generator_count by generator_count), `drives` the
/// (body, actuator) pairs, `pulls` the points of bilateral bodies.
struct AssemblySize {
  Index points, generators, actuators, drives, pulls = 0;
  constexpr Index unknowns() const { return forces() + points + actuators; }
  constexpr Index forces() const { return points + pulls + generators; }
  constexpr Index couplings() const { return forces() * (drives > 0 ? drives : 1); }
};

/// The size of one scene, spread evenly if it is to be.
template <class S> AssemblySize size_of(const Scene<S>& scene) {
  AssemblySize size{scene.points.size, 0, scene.actuators.size, scene.drives.size};
  if (presses_evenly(scene)) size.actuators = size.drives = even_size(scene).drives;
  for (const Body<S>& body : scene.bodies) {
    size.generators += body.point_count * generator_count(scene, body);
    if (body.bilateral) size.pulls += body.point_count;
  }
  return size;
}

/// The arrays that an assembly writes into; all of them the caller's.
template <class S> struct AssemblyMemory {
  Span<Vector6<S>> wrenches;
  Span<ConeGroup<S>> cones;
  Span<SumGroup<S>> sums;
  Span<int> coupled_variable;
  Span<S> coupling;
  Span<Index> body;
  Span<S> reach;
  Span<S> push, q; ///< n each
};

/// The problem with its meaning. `problem.q` = rest + sigma push, sigma set by push_by; what is at
/// rest is as quickly computed as it is kept.
template <class S> class Assembly {
public:
  explicit Assembly(const AssemblyMemory<S>& memory) : memory_(memory) {}

  /// Post: running, and problem() and layout() describe the scene, pushed as prescribed (sigma =
  /// 1); or bad_input if the memory is too small for it, and there is no problem to solve. Pre: the
  /// scene outlives the assembly. Cost: O(forces (1 + drives)).
  Status assemble(const Scene<S>& scene);

  /// The scene that was assembled, with other grip forces, loads or prescribed motions; nothing
  /// else of it has changed. Post: as assemble(scene()) would leave it, bit by bit. Cost:
  /// O(forces), half of an assembly's or less: directions and couplings stand as they are.
  void command();

  /// The same scene with its prescribed motions scaled by sigma.
  void push_by(S sigma) {
    sigma_ = sigma;
    set_q(sigma);
  }
  /// The normal rows again, which a pressure law changes.
  void push_normals() {
    for (Index i = 0; i < layout_.points; ++i)
      for (Index k = 0; k < memory_.cones[i].normals; ++k) set_q(i, k, sigma_);
  }

  const Scene<S>& scene() const { return *scene_; }
  const Layout<S>& layout() const { return layout_; }
  S sigma() const { return sigma_; }

  /// The problem of the present sigma.
  Problem<S> problem() const {
    Problem<S> p;
    p.size = layout_.size;
    p.free_begin = layout_.size - layout_.actuators;
    p.factored = &factored_;
    p.q = memory_.q.data;
    return p;
  }

  /// The problem at rest with the push as an infinitesimal extra right-hand side. It takes the
  /// place of problem() until push_by.
  Problem<S> breaking_problem() {
    set_q(S(0));
    Problem<S> p = problem();
    p.push = memory_.push.data;
    return p;
  }

  // What a pressure law changes: the compliance of a normal row and its right-hand side.
  Span<ConeGroup<S>> cones() const { return {memory_.cones.data, layout_.points}; }
  Span<S> q() const { return {memory_.q.data, layout_.size}; }
  const FactoredProblem<S>& factored() const { return factored_; }
  /// The load that factored().mobility belongs to, scaled: the object's, and of round friction what
  /// stands on the other side of its inertia.
  const Vector6<S>& load() const { return load_; }

private:
  AssemblyMemory<S> memory_;
  const Scene<S>* scene_ = nullptr;
  Layout<S> layout_{};
  FactoredProblem<S> factored_{};
  Vector6<S> load_, free_fall_;
  S sigma_{1};

  void set_q(const S& sigma) {
    for (Index i = 0; i < layout_.points; ++i) {
      const ConeGroup<S>& cone = memory_.cones[i];
      for (Index k = 0; k < cone.forces(); ++k) set_q(i, k, sigma);
      if (cone.generators > 0) memory_.q[cone.slip()] = S(0);
    }
    for (Index a = 0; a < layout_.actuators; ++a)
      memory_.q[layout_.closing_index(a)] = -memory_.sums[a].target;
    if (scene_->clearances.size > 0) drop_rounding();
  }
  /// A step in time begins with velocities: where a body rolls, large ones cancel, at every contact
  /// if it rolls between two. What rounding leaves of them is no slip, or the points that stick
  /// would contradict each other; all of the body's, or those that are left would.
  void drop_rounding() {
    using Eigen::numext::maxi;
    S fastest(1);
    for (const Body<S>& body : scene_->bodies)
      fastest = maxi(fastest, S(laws::prescribed(body, layout_.scales).cwiseAbs().maxCoeff()));
    const S rounding = ModelSettings<S>::no_slip() * fastest;
    const auto largest_of = [&](const Body<S>& body, bool drops) {
      S largest(0);
      for (const Index i : points_of(body)) {
        const ConeGroup<S>& cone = memory_.cones[i];
        for (Index k = cone.normals; k < cone.forces(); ++k) {
          S& row = memory_.q[cone.variable + k];
          largest = maxi(largest, S(Eigen::numext::abs(row)));
          if (drops) row = S(0);
        }
      }
      return largest;
    };
    for (const Body<S>& body : scene_->bodies)
      if (largest_of(body, false) <= rounding) largest_of(body, true);
  }
  /// What force k of a point feels at rest and of the push.
  void set_q(Index point, Index k, const S& sigma) {
    const ConeGroup<S>& cone = memory_.cones[point];
    S rest = memory_.wrenches[cone.force + k].dot(free_fall_);
    if (k < cone.normals && scene_->clearances.size > 0) {
      const S clearance = scene_->clearances[point] / layout_.scales.acceleration;
      rest += k == 0 ? clearance : S(-clearance);
    }
    memory_.q[cone.variable + k] = rest + sigma * memory_.push[cone.variable + k];
  }

  /// L of a scene, and the reach of its actuators. Cost: O(points).
  void choose_lengths() {
    using Eigen::numext::maxi;
    const Scene<S>& scene = *scene_;
    S& length = layout_.scales.length = S(0);
    for (const Vector3<S>& p : scene.points) length = maxi(length, S(p.norm()));
    if (!(length > S(0))) length = S(1);
    for (Index a = 0; a < scene.actuators.size; ++a) memory_.reach[a] = S(0);
    for (const Drive<S>& drive : scene.drives)
      memory_.reach[drive.actuator] =
          maxi(memory_.reach[drive.actuator], drive_reach(scene, drive));
    for (Index a = 0; a < scene.actuators.size; ++a)
      if (!(memory_.reach[a] > S(0))) memory_.reach[a] = S(1);
  }

  /// F and F / m.
  void choose_force() {
    using Eigen::numext::maxi;
    const Scene<S>& scene = *scene_;
    const S& length = layout_.scales.length;
    S push(0);
    for (const Body<S>& body : scene.bodies)
      push = maxi(push, maxi(S(body.acceleration.template head<3>().norm()),
                             S(length * body.acceleration.template tail<3>().norm())));
    S force = scene.object.mass * scene.gravity.norm();
    force = maxi(
        force,
        maxi(S(scene.object.wrench.template head<3>().norm()),
             S((scene.object.wrench.template tail<3>() + scene.object.turning).norm() / length)));
    for (const Body<S>& body : scene.bodies) force = maxi(force, body.preload);
    for (Index a = 0; a < scene.actuators.size; ++a) {
      const S tau = scene.actuators[a].force / memory_.reach[a];
      force = maxi(force, Eigen::numext::abs(tau));
    }
    const S mass = scene.object.mass;
    const S inertia = mass * push;
    force = force > S(0) ? maxi(force, S(inertia / ModelSettings<S>::push_over_forces())) : inertia;
    if (!(force > S(0))) force = mass;
    layout_.scales.force = force;
    layout_.scales.acceleration = force / mass;
  }

  /// [T.1], and [T.16] of every point.
  void add_object() {
    const Scene<S>& scene = *scene_;
    factored_.mobility = laws::newton(scene, layout_.scales);
    load_ = laws::load(scene, layout_.scales);
    if (!has_round_friction(scene)) return;
    for (const Body<S>& body : scene.bodies)
      for (const Index i : points_of(body))
        laws::round_cone(body, scene.points[i], scene.round_cones[i], scene.object.mass,
                         layout_.scales, factored_.mobility, load_);
  }

  /// [T.2], [T.3] and [T.4] of every point.
  void add_points() {
    const Scene<S>& scene = *scene_;
    Index force = 0, variable = 0;
    for (Index b = 0; b < scene.bodies.size; ++b) {
      const Body<S>& body = scene.bodies[b];
      const Index g = generator_count(scene, body), first_force = force;
      // Directions are the body's: those of its first point are there to be read, but for a soft
      // point's torques.
      const auto generator_at = [&](Index i, Index normals, Index j) -> Generator<S> {
        if (i == body.first_point || body.torsion_radius > S(0) || has_round_friction(scene))
          return generator(scene, body, i, j);
        return {memory_.wrenches[first_force + normals + j].template head<3>(), S(0)};
      };
      for (const Index i : points_of(body)) {
        const Vector3<S>& p = scene.points[i];
        const ConeGroup<S> cone = laws::friction_cone(body, g, force, variable);
        memory_.cones[layout_.points] = cone;
        memory_.body[layout_.points++] = b;
        const Vector6<S> normal = laws::normal_direction(body, p, layout_.scales);
        memory_.wrenches[force++] = normal;
        if (cone.normals == 2) memory_.wrenches[force++] = -normal;
        for (Index j = 0; j < g; ++j)
          memory_.wrenches[force++] =
              laws::friction_direction(body, p, generator_at(i, cone.normals, j), layout_.scales);
        variable += cone.size();
      }
    }
    layout_.forces = force;
    layout_.size = variable;
  }

  /// The first body after b that the actuator drives, or -1.
  Index next_driven(Index actuator, Index b) const {
    Index next = -1;
    for (const Drive<S>& drive : scene_->drives)
      if (drive.actuator == actuator && drive.body > b && (next < 0 || drive.body < next))
        next = drive.body;
    return next;
  }

  /// [T.5] of every actuator.
  void add_actuators() {
    const Scene<S>& scene = *scene_;
    Index entry = 0;
    for (Index a = 0; a < scene.actuators.size; ++a) {
      SumGroup<S> sum = laws::grip_force(scene, a, memory_.reach[a], layout_.scales);
      sum.first = entry;
      for (Index b = next_driven(a, -1); b >= 0; b = next_driven(a, b)) {
        const Body<S>& body = scene.bodies[b];
        Vector6<S> twist = Vector6<S>::Zero();
        for (const Drive<S>& drive : scene.drives)
          if (drive.actuator == a && drive.body == b)
            twist += laws::drive_twist(drive, memory_.reach[a], layout_.scales);
        for (const Index i : points_of(body)) {
          const ConeGroup<S>& cone = memory_.cones[i];
          for (Index k = 0; k < cone.forces(); ++k) {
            const S coefficient = laws::grip_coefficient(twist, memory_.wrenches[cone.force + k]);
            if (!(Eigen::numext::abs(coefficient) > ModelSettings<S>::across_drive())) continue;
            memory_.coupled_variable[entry] = static_cast<int>(cone.variable + k);
            memory_.coupling[entry++] = coefficient;
          }
        }
      }
      sum.count = entry - sum.first;
      memory_.sums[a] = sum;
      ++layout_.size;
    }
  }

  /// What the load and the bodies' own motions make of the rows of [T.2], [T.3] and [T.5].
  void add_motions() {
    free_fall_ = factored_.mobility.lazyProduct(load_);
    for (Index i = 0; i < layout_.points; ++i) {
      const ConeGroup<S>& cone = memory_.cones[i];
      const Vector6<S> A_b = laws::prescribed(scene_->bodies[memory_.body[i]], layout_.scales);
      for (Index k = 0; k < cone.forces(); ++k)
        memory_.push[cone.variable + k] = -memory_.wrenches[cone.force + k].dot(A_b);
      if (cone.generators > 0) memory_.push[cone.slip()] = S(0);
    }
    for (Index a = 0; a < layout_.actuators; ++a) memory_.push[layout_.closing_index(a)] = S(0);
    push_by(S(1));
  }

  bool fits(const Scene<S>& scene) const {
    const AssemblySize size = size_of(scene);
    const AssemblyMemory<S>& m = memory_;
    return m.wrenches.size >= size.forces() && m.cones.size >= size.points &&
           m.body.size >= size.points && m.sums.size >= size.actuators &&
           m.reach.size >= size.actuators && m.coupling.size >= size.couplings() &&
           m.coupled_variable.size >= size.couplings() && m.q.size >= size.unknowns() &&
           m.push.size >= size.unknowns();
  }
};

template <class S> Status Assembly<S>::assemble(const Scene<S>& scene) {
  scene_ = &scene;
  layout_ = {};
  if (!fits(scene)) return Status::bad_input;
  choose_lengths();
  choose_force();
  add_object();
  add_points();
  layout_.actuators = scene.actuators.size;
  layout_.cones = {memory_.cones.data, layout_.points};
  layout_.body = {memory_.body.data, layout_.points};
  layout_.reach = {memory_.reach.data, layout_.actuators};
  add_actuators();
  factored_.wrenches = {memory_.wrenches.data, layout_.forces};
  factored_.cones = layout_.cones;
  factored_.sums = {memory_.sums.data, layout_.actuators};
  factored_.coupled_variable = {memory_.coupled_variable.data, memory_.coupled_variable.size};
  factored_.coupling = {memory_.coupling.data, memory_.coupling.size};
  add_motions();
  return Status::running;
}

template <class S> void Assembly<S>::command() {
  if (has_round_friction(*scene_)) return (void)assemble(*scene_); // directions follow the slips
  choose_force();
  load_ = laws::load(*scene_, layout_.scales);
  for (Index i = 0; i < layout_.points; ++i) memory_.cones[i].compliance = S(0);
  for (Index a = 0; a < layout_.actuators; ++a)
    memory_.sums[a].target = laws::grip_force(*scene_, a, memory_.reach[a], layout_.scales).target;
  add_motions();
}

/// [T.5] What a force on `body` with this column does to the hand: visit(actuator, coefficient),
/// once a drive of the body.
template <class S, class Visit>
void for_each_grip(const Scene<S>& scene, const Layout<S>& layout, Index body,
                   const Vector6<S>& column, const Visit& visit) {
  for (const Drive<S>& drive : scene.drives)
    if (drive.body == body)
      visit(drive.actuator,
            laws::grip_coefficient(drive, column, layout.reach[drive.actuator], layout.scales));
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class Assembly<double>;
#endif

} // namespace lcpush
