// Behind lcpush_push and lcpushf_push: a scene's copy, its workspace, and what is known of its
// answer. How it is solved is c_pivot_push.hpp's, or c_sweep_push.hpp's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

#include "c_motion.hpp"
#include "c_present_grip.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/mechanics/model/validate.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"
#include "lcpush/mechanics/study/holding.hpp"

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
    std::uint32_t (*work)(const CPush&); ///< of all solves so far, modulo 2^32
  };

  /// Cuts everything out of `arena`; complete() says whether it was enough.
  CPush(Arena& arena, const Capacity& most, const Method& method)
      : generators_(assembly_size(most).generators), pulls_(most.pulls), method_(&method),
        kept_(take_answer(arena, most)), scene_(arena.zeros<Scene<S>>(1).data),
        bodies_(
            arena.zeros<Body<S>>(most.bodies < 2 * most.points ? most.bodies : 2 * most.points)),
        points_(arena.zeros<Vector3<S>>(most.points)), weights_(arena.zeros<S>(most.points)),
        actuators_(arena.zeros<Actuator<S>>(most.actuators)),
        drives_(arena.zeros<Drive<S>>(most.drives)), last_{arena.zeros<unsigned char>(
                                                               assembly_size(most).unknowns()),
                                                           false, Guess::basis},
        new_scene_((last_.active.size + arena.rest().size) & -widest_alignment<S>()),
        work_(method.take(arena, assembly_size(most))), assembly_(work_.assembly) {}

  /// As find_mistake wants numbers: what becomes of them does not overflow.
  static bool is_finite(const S& x) {
    const S square = x * x, power = square * square;
    return power - power == S(0);
  }

  static AssemblySize assembly_size(const Capacity& most) {
    return {most.points, most.points * most.facets, most.actuators, most.drives, most.pulls};
  }

  bool complete() const {
    const Span<S>& solver = method_->takes_motions ? work_.lemke_scalars : work_.sweep_scalars;
    return work_.complete && static_cast<void*>(new_scene()) >= solver.data;
  }

  /// Is there room for a scene with so many of each?
  bool holds(Index bodies, Index points, Index actuators, Index drives) const {
    return is_within(bodies, bodies_.size) && is_within(points, points_.size) &&
           is_within(actuators, actuators_.size) && is_within(drives, drives_.size);
  }
  // The arrays of a scene that is being described, over the solver's memory: what was going on
  // there begins anew. accept() takes it, or the scene that was there stays.
  Scene<S>* new_scene() const { return beyond(Span<Scene<S>>{scene_, 1}, 1).data; }
  Span<Body<S>> new_bodies(Index count) {
    forget_solve();
    return beyond(bodies_, count);
  }
  Span<Vector3<S>> new_points(Index count) { return beyond(points_, count); }
  Span<S> new_weights(Index count) { return beyond(weights_, count); }
  Span<Actuator<S>> new_actuators(Index count) { return beyond(actuators_, count); }
  Span<Drive<S>> new_drives(Index count) { return beyond(drives_, count); }

  /// Says what is wrong; scene and answer stay as they are.
  Status refuse(Mistake mistake) {
    mistake_ = mistake;
    return Status::bad_input;
  }

  /// Takes it, unless something is wrong with it.
  Status accept(bool is_round) {
    const Scene<S>& scene = *new_scene();
    const Mistake mistake = find_mistake(scene);
    if (mistake != Mistake::none) return refuse(mistake);
    bool is_spread;
    if (!fits(scene, is_spread)) return refuse(Mistake::memory_too_small);
    is_spread_ = is_spread;
    copy_words(scene_, &scene, last_.active.data);
    given_ = {{bodies_.data, scene.bodies.size},
              {actuators_.data, scene.actuators.size},
              {drives_.data, scene.drives.size},
              {weights_.data, scene.weights.size}};
    scene_->points.data = points_.data;
    is_round_ = is_round;
    motion_ = nullptr;
    last_.known = false;
    age_ = -1;
    return set_up(&assemble_anew);
  }

  /// A tick is a command with the steps that follow, or a step alone.
  void tick() {
    if (age_ >= 0) ++age_;
  }
  void begin_command() {
    tick();
    commanded_ = true;
  }
  /// What is wrong with such a command.
  Mistake mistake_of(const S* forces, const S* accelerations) const {
    if (given_.bodies.size == 0) return Mistake::not_described;
    for (Index a = 0; forces != nullptr && a < given_.actuators.size; ++a) {
      if (!is_finite(forces[a])) return Mistake::not_finite;
      if (forces[a] < S(0)) return Mistake::actuator;
    }
    for (Index i = 0; accelerations != nullptr && i < 6 * given_.bodies.size; ++i)
      if (!is_finite(accelerations[i])) return Mistake::not_finite;
    return Mistake::none;
  }
  // What a command changes.
  S& force(Index actuator) { return actuators_[actuator].force; }
  Vector6<S>& acceleration(Index body) { return bodies_[body].acceleration; }
  /// Its grip forces or motions have changed. The last answer's forces are fitted to the grip.
  Status take_command(bool grips_anew) {
    goes_on_ = goes_on_ || is_under_way();
    (void)set_up(&assemble_command);
    if (grips_anew && has_answer())
      PresentGrip<S>(*scene_, assembly_.layout().scales.length, kept_).fit();
    return status_;
  }

  bool is_under_way() const { return begun_ && (status_ == Status::running || is_interrupted_); }

  Status step(int pivots) {
    const Status status = begin_step();
    return status == Status::running && pivots > 0 ? method_->step(*this, pivots) : status;
  }
  /// Pivots until so much work is done; the last of them may take more.
  Status step_within(std::uint32_t work) {
    Status status = begin_step();
    const std::uint32_t before = method_->work(*this);
    while (status == Status::running && method_->work(*this) - before < work)
      status = method_->step(*this, 1);
    return status;
  }
  std::uint32_t work() const { return method_->work(*this); }

  Status solve() { return step(std::numeric_limits<int>::max()); }

  /// `by_pivots(pusher, breaking)` unless this push has another method.
  template <class ByPivots>
  Status break_grasp(Index pusher, Breaking<S>& breaking, const ByPivots& by_pivots) {
    breaking = {};
    if (!described_) return refuse(Mistake::not_described);
    if (pusher < 0 || pusher >= given_.bodies.size) return refuse(Mistake::index);
    if (!(push_size(*scene_) > S(0))) return refuse(Mistake::nothing_moves);
    forget_solve();
    const Body<S>& body = given_.bodies[pusher];
    status_ = method_->break_grasp != nullptr ? method_->break_grasp(*this, body, breaking)
                                              : by_pivots(body, breaking);
    residual_ = breaking.residuals.max();
    if (status_ == Status::solved || status_ == Status::does_not_hold) keep();
    return status_;
  }

  /// A motion of the scene as described.
  Status set_off(Arena arena) {
    if (!described_) return refuse(Mistake::not_described);
    if (!method_->takes_motions) return refuse(Mistake::unsupported);
    Mistake mistake = Mistake::none;
    forget_solve();
    CMotion<S>* const motion = begin_motion(as_given(), work_, arena, mistake);
    if (motion == nullptr) {
      if (mistake != Mistake::memory_too_small) (void)set_up(&assemble_anew);
      return refuse(mistake);
    }
    motion_ = motion;
    described_ = false; // its equations' arrays are the motion's from now on
    moved_ = true;
    last_.known = false;
    return status_ = Status::running;
  }

  Status advance(S h) {
    if (motion_ == nullptr) return refuse(Mistake::not_described);
    if (!(h > S(0)) || !is_finite(h)) return refuse(Mistake::not_finite);
    forget_solve();
    described_ = false;
    moved_ = true;
    status_ = motion_->motion.advance(h);
    const StepRun<S>& step = motion_->motion.run();
    run_ = {};
    run_.pivots = step.pivots;
    run_.rounds = step.rounds;
    return status_;
  }

  /// `ask(hand)` of the fingers at rest, in the solver's memory.
  template <class Question> Held<S> hold(const Question& ask) {
    if (!described_) return {refuse(Mistake::not_described)};
    if (is_under_way()) status_ = Status::running;
    forget_solve();
    const Span<S>& scratch = method_->takes_motions ? work_.lemke_scalars : work_.sweep_scalars;
    Holding<S> hand(assembly_, {reinterpret_cast<unsigned char*>(scratch.data),
                                scratch.size * static_cast<Index>(sizeof(S))});
    const Held<S> held = ask(hand);
    if (held.status == Status::bad_input)
      refuse(held.reason == Reason::unsupported ? Mistake::unsupported : Mistake::memory_too_small);
    return held;
  }

  CMotion<S>* motion() const { return motion_; }

  void limit(Index pivots) { limit_ = pivots; }

  Status status() const { return status_; }
  Mistake mistake() const { return mistake_; }
  bool has_answer() const { return age_ >= 0; }
  const Answer<S>& answer() const { return kept_; }
  Index age() const { return age_; }
  const Given& given() const { return given_; }
  const Scene<S>& scene() const { return *scene_; } ///< as it is solved
  bool is_spread() const { return is_spread_; }
  Scene<S> as_given() const {
    Scene<S> scene = *scene_;
    give_back(scene);
    return scene;
  }
  const PressureRun& run() const { return run_; }
  /// Of an older answer as one to the present command.
  S residual() const {
    return age_ > 0 ? check(*scene_, assembly_.layout().scales, kept_, S(1)).max() : residual_;
  }

protected:
  Index generators_, pulls_; ///< at most
  const Method* method_;
  bool described_ = false, is_spread_ = false;
  bool is_round_ = false;       ///< friction, as the scene was described
  bool begun_ = false;          ///< a solve has begun and the scene is still the same
  bool is_interrupted_ = false; ///< by limit(): the next step goes on
  bool goes_on_ = false;        ///< the solver has a basis of a solve that a command has ended
  bool commanded_ = false;      ///< since the last step
  Answer<S> kept_;              ///< the last answer; work_'s is a solve's scratch
  Index age_ = -1;              ///< of kept_, in ticks; -1: there is none
  Scene<S>* scene_;             ///< as it is solved
  Span<Body<S>> bodies_;
  Span<Vector3<S>> points_;
  Span<S> weights_;
  Span<Actuator<S>> actuators_;
  Span<Drive<S>> drives_;
  LastStep last_;   ///< of the last command's solve
  Index new_scene_; ///< bytes from these arrays to those of a scene that is being described
  Workspace<S> work_;
  Assembly<S> assembly_;
  Given given_{};
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
    residual_ = check(*scene_, assembly_.layout().scales, work_.answer, S(1)).max();
    if (!(residual_ <= Tolerances<S>().residual)) return status_ = Status::numerical_breakdown;
    keep();
    return status_;
  }
  /// Not where a solve falls back to pyramids.
  void make_round() {
    if (is_round_) scene_->round_cones = {work_.round_cones.data, scene_->points.size};
  }
  void keep() {
    const Answer<S>& found = work_.answer;
    kept_.acceleration = found.acceleration;
    copy_words(kept_.contacts.data, found.contacts.data, kept_.friction.end()); // and friction
    copy_words(kept_.closing.data, found.closing.data, kept_.closing.end());
    age_ = 0;
  }
  /// Up to `end` of the first: word by word, which a device's memcpy may not be.
  static void copy_words(void* to, const void* from, const void* end) {
    char* const words = static_cast<char*>(to);
    const std::ptrdiff_t bytes = static_cast<const char*>(end) - words;
    for (std::ptrdiff_t i = 0; i < bytes; i += 4)
      std::memcpy(words + i, static_cast<const char*>(from) + i, 4);
  }

private:
  Status begin_step() {
    if (!described_) return refuse(Mistake::not_described);
    if (!commanded_ && status_ != Status::solved) tick();
    commanded_ = false;
    if (is_interrupted_) status_ = Status::running;
    return status_;
  }

  /// The solver's memory is about to be something else's.
  void forget_solve() {
    begun_ = goes_on_ = is_interrupted_ = false;
    make_round();
  }

  static Answer<S> take_answer(Arena& arena, const Capacity& most) {
    Answer<S> answer;
    arena.fill(most.points, answer.contacts);
    arena.fill(most.points * most.facets, answer.friction);
    arena.fill(most.actuators, answer.closing);
    return answer;
  }

  /// By a pointer: what never commands links nothing for it.
  Status set_up(bool (*assemble)(CPush&)) {
    begun_ = is_interrupted_ = false;
    make_round();
    give_back(*scene_);
    const EvenMemory<S> further{rest(bodies_, given_.bodies.size),
                                rest(actuators_, given_.actuators.size),
                                rest(drives_, given_.drives.size)};
    if (is_spread_) (void)spread_evenly(*scene_, further, *scene_);
    described_ = assemble(*this); // it has to fit
    moved_ = false;
    mistake_ = Mistake::none;
    run_ = {};
    return status_ = Status::running;
  }

  /// Where an array of a new scene is described.
  template <class T> Span<T> beyond(const Span<T>& own, Index count) const {
    void* const bytes = reinterpret_cast<unsigned char*>(own.data) + new_scene_;
    return {static_cast<T*>(bytes), count};
  }

  static bool assemble_anew(CPush& push) {
    return push.assembly_.assemble(*push.scene_) == Status::running;
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

  /// What holds() has not looked at.
  bool fits(const Scene<S>& scene, bool& is_spread) const {
    const AssemblySize size = size_of(scene);
    EvenSize more;
    if (presses_evenly(scene)) more = even_size(scene);
    if (more.bodies == scene.bodies.size) more = {}; // every point is a pad of its own already
    is_spread = more.bodies > 0;
    return size.generators <= generators_ && size.pulls <= pulls_ &&
           scene.bodies.size + more.bodies <= bodies_.size &&
           scene.actuators.size + more.drives <= actuators_.size &&
           scene.drives.size + more.drives <= drives_.size;
  }

  static bool is_within(Index count, Index most) {
    return static_cast<std::size_t>(count) <= static_cast<std::size_t>(most); // none is negative
  }
  template <class T> static Span<T> rest(const Span<T>& whole, Index used) {
    return {whole.data + used, whole.size - used};
  }
};

} // namespace lcpush::c
