// Behind lcpush_push and lcpushf_push: a scene's copy, its workspace, and what is known of its
// answer. How it is solved is c_pivot_push.hpp's, or c_sweep_push.hpp's.
#pragma once

#include <new>

#include "c_motion.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/mechanics/model/validate.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"

namespace lcpush::c {

/// A place for one object that comes later.
template <class T> class InPlace {
public:
  template <class... Args> T& make(Args&&... args) {
    made_ = new (bytes_) T(static_cast<Args&&>(args)...);
    return *made_;
  }
  T* get() const { return made_; }
  void forget() { made_ = nullptr; }

private:
  alignas(T) unsigned char bytes_[sizeof(T)];
  T* made_ = nullptr;
};

/// The most that a push holds, as lcpush_size says.
struct Capacity {
  Index bodies, points, facets, actuators, drives, pulls;
};

template <class S> class CPush {
public:
  using Scalar = S;

  /// What spreading evenly replaces in a scene, as it was before.
  struct Given {
    Span<const Body<S>> bodies;
    Span<const Actuator<S>> actuators;
    Span<const Drive<S>> drives;
    Span<const S> weights;
  };

  /// By pivots or by sweeps. What a program never makes, and what it never calls, the linker leaves
  /// out: so there is no table of all functions, but a pointer to the one that every push needs.
  struct Method {
    Status (*step)(CPush&, int pivots);
    Status (*break_grasp)(CPush&, const Body<S>& pusher, Breaking<S>&); ///< null: by pivots
    bool takes_motions;
    Workspace<S> (*take)(Arena, const AssemblySize&);
  };

  /// Cuts everything out of `arena`; complete() says whether it was enough.
  CPush(Arena& arena, const Capacity& most, const Method& method)
      : most_(most), method_(&method), bodies_(arena.zeros<Body<S>>(most.bodies)),
        points_(arena.zeros<Vector3<S>>(most.points)), weights_(arena.zeros<S>(most.points)),
        actuators_(arena.zeros<Actuator<S>>(most.actuators)),
        drives_(arena.zeros<Drive<S>>(most.drives)),
        last_active_(arena.zeros<unsigned char>(assembly_size(most).unknowns())),
        work_(method.take(arena, assembly_size(most))), assembly_(work_.assembly) {}

  bool complete() const { return work_.complete; }

  /// Is there room for a scene with so many of each?
  bool holds(Index bodies, Index points, Index actuators, Index drives) const {
    return is_within(bodies, bodies_.size) && is_within(points, points_.size) &&
           is_within(actuators, actuators_.size) && is_within(drives, drives_.size);
  }
  // What describe() fills before it calls accept(): the scene that was there is gone.
  Scene<S>& begin_scene() {
    motion_ = nullptr;
    return scene_;
  }
  Span<Body<S>> bodies(Index count) { return {bodies_.data, count}; }
  Span<Vector3<S>> points(Index count) { return {points_.data, count}; }
  Span<S> weights(Index count) { return {weights_.data, count}; }
  Span<Actuator<S>> actuators(Index count) { return {actuators_.data, count}; }
  Span<Drive<S>> drives(Index count) { return {drives_.data, count}; }

  Status refuse(Mistake mistake) {
    mistake_ = mistake;
    described_ = false;
    return status_ = Status::bad_input;
  }

  /// Takes the scene that begin_scene() gave out, over this push's own arrays.
  Status accept(bool is_round) {
    given_ = {scene_.bodies, scene_.actuators, scene_.drives, scene_.weights};
    if (is_round) scene_.round_cones = {work_.round_cones.data, scene_.points.size};
    last_.known = false;
    return set_up(&assemble_anew);
  }
  /// Its grip forces or motions have changed.
  Status take_command() { return set_up(&assemble_command); }

  Status step(int pivots) {
    if (!described_) return refuse(Mistake::not_described);
    return status_ == Status::running ? method_->step(*this, pivots) : status_;
  }

  Status solve() {
    constexpr int many = 1 << 20;
    while (step(many) == Status::running) continue;
    return status_;
  }

  /// `by_pivots(pusher, breaking)` unless this push has another method.
  template <class ByPivots>
  Status break_grasp(Index pusher, Breaking<S>& breaking, const ByPivots& by_pivots) {
    if (!described_) return refuse(Mistake::not_described);
    begun_ = false;
    breaking = {};
    if (pusher < 0 || pusher >= given_.bodies.size) return refuse(Mistake::index);
    if (!(push_size(scene_) > S(0))) return refuse(Mistake::nothing_moves);
    const Body<S>& body = given_.bodies[pusher];
    status_ = method_->break_grasp != nullptr ? method_->break_grasp(*this, body, breaking)
                                              : by_pivots(body, breaking);
    residual_ = breaking.residuals.max();
    return status_;
  }

  /// A motion of the scene as described.
  Status set_off(Arena arena) {
    motion_ = nullptr;
    if (!described_) return refuse(Mistake::not_described);
    if (!method_->takes_motions) return refuse(Mistake::unsupported);
    described_ = false; // its equations' arrays are the motion's from now on
    moved_ = true;
    last_.known = false;
    motion_ = begin_motion(as_given(), work_, arena, mistake_);
    return motion_ == nullptr ? refuse(mistake_) : status_ = Status::running;
  }

  Status advance(S h) {
    if (motion_ == nullptr) return refuse(Mistake::not_described);
    described_ = false;
    moved_ = true;
    status_ = motion_->motion.advance(h);
    const StepRun<S>& step = motion_->motion.run();
    if (status_ == Status::bad_input) mistake_ = step.mistake;
    run_ = {};
    run_.pivots = step.pivots;
    run_.rounds = step.rounds;
    return status_;
  }

  CMotion<S>* motion() const { return motion_; }

  void limit(Index pivots) { limit_ = pivots; }

  Status status() const { return status_; }
  Mistake mistake() const { return mistake_; }
  bool has_answer() const {
    return !moved_ && (status_ == Status::solved || status_ == Status::does_not_hold);
  }
  const Answer<S>& answer() const { return work_.answer; }
  const Given& given() const { return given_; }
  const Scene<S>& scene() const { return scene_; } ///< as it is solved
  bool is_spread() const { return scene_.bodies.data != given_.bodies.data; }
  Scene<S> as_given() const {
    Scene<S> scene = scene_;
    give_back(scene);
    return scene;
  }
  const PressureRun& run() const { return run_; }
  S residual() const { return residual_; }

protected:
  Capacity most_;
  const Method* method_;
  bool described_ = false;
  bool begun_ = false; ///< a solve has begun and the scene is still the same
  Span<Body<S>> bodies_;
  Span<Vector3<S>> points_;
  Span<S> weights_;
  Span<Actuator<S>> actuators_;
  Span<Drive<S>> drives_;
  Span<unsigned char> last_active_;
  Workspace<S> work_;
  Assembly<S> assembly_;
  Given given_{};
  Scene<S> scene_{};
  LastStep last_{last_active_, false, Guess::basis}; ///< of the last command's solve
  PressureRun run_{};
  Status status_ = Status::bad_input;
  Mistake mistake_ = Mistake::not_described;
  Index limit_ = 0;
  CMotion<S>* motion_ = nullptr;
  bool moved_ = false; ///< the answer's arrays hold a step's
  S residual_{0};

  /// What the solver calls solved is read, and the laws are asked as well.
  Status conclude() {
    if (status_ != Status::solved) return status_;
    read_answer(assembly_, work_.pressure.z.data, work_.answer, S(1));
    residual_ = check(scene_, assembly_.layout().scales, work_.answer, S(1)).max();
    if (!(residual_ <= Tolerances<S>().residual)) status_ = Status::numerical_breakdown;
    return status_;
  }

private:
  /// By a pointer: what never commands links nothing for it.
  Status set_up(bool (*assemble)(CPush&)) {
    begun_ = false;
    described_ = false;
    give_back(scene_);
    const Mistake mistake = find_mistake(scene_);
    if (mistake != Mistake::none) return refuse(mistake);
    const EvenMemory<S> further{rest(bodies_, given_.bodies.size),
                                rest(actuators_, given_.actuators.size),
                                rest(drives_, given_.drives.size)};
    const bool spreads = presses_evenly(scene_) && has_driven_patch(scene_);
    if (spreads && spread_evenly(scene_, further, scene_) != Status::solved)
      return refuse(Mistake::memory_too_small);
    if (!assemble(*this)) return refuse(Mistake::memory_too_small);
    described_ = true;
    moved_ = false;
    mistake_ = Mistake::none;
    run_ = {};
    return status_ = Status::running;
  }

  static bool assemble_anew(CPush& push) {
    return push.fits(size_of(push.scene_)) &&
           push.assembly_.assemble(push.scene_) == Status::running;
  }
  /// A motion's steps write into the same arrays.
  static bool assemble_command(CPush& push) {
    if (push.moved_) return assemble_anew(push);
    push.assembly_.command();
    return true;
  }

  /// What spreading has replaced.
  void give_back(Scene<S>& scene) const {
    scene.bodies = given_.bodies;
    scene.actuators = given_.actuators;
    scene.drives = given_.drives;
    scene.weights = given_.weights;
  }

  static AssemblySize assembly_size(const Capacity& most) {
    return {most.points, most.points * most.facets, most.actuators, most.drives, most.pulls};
  }

  /// What holds() and spreading have not looked at.
  bool fits(const AssemblySize& size) const {
    return size.generators <= assembly_size(most_).generators && size.pulls <= most_.pulls;
  }

  static bool is_within(Index count, Index most) { return count >= 0 && count <= most; }
  template <class T> static Span<T> rest(const Span<T>& whole, Index used) {
    return {whole.data + used, whole.size - used};
  }
};

} // namespace lcpush::c
