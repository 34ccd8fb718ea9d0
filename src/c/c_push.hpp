// Behind lcpush_push and lcpushf_push: a scene's copy, its workspace, a solve that can be left.
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
  using PivotSolve = PressureSolve<S, LemkeRounds<S>>;

  /// Cuts everything out of `arena`; complete() says whether it was enough.
  CPush(Arena& arena, const Capacity& most, bool by_sweeps)
      : most_(most), by_sweeps_(by_sweeps), bodies_(arena.take<Body<S>>(most.bodies)),
        points_(arena.take<Vector3<S>>(most.points)), weights_(arena.take<S>(most.points)),
        actuators_(arena.take<Actuator<S>>(most.actuators)),
        drives_(arena.take<Drive<S>>(most.drives)),
        even_({arena.take<Body<S>>(most.points), arena.take<Actuator<S>>(most.actuators),
               arena.take<Drive<S>>(most.drives)}),
        work_(by_sweeps ? make_sweep_workspace<S>(arena, assembly_size(most))
                        : make_workspace<S>(arena, assembly_size(most))),
        assembly_(work_.assembly), lemke_(work_.lemke_scalars, work_.lemke_integers),
        sweeps_(work_.sweep_scalars, work_.sweep_integers) {}

  bool complete() const { return work_.complete; }

  // What describe() fills before it calls accept(); lengths are checked against `most`.
  Span<Body<S>> bodies(Index count) { return cut(bodies_, count); }
  Span<Vector3<S>> points(Index count) { return cut(points_, count); }
  Span<S> weights(Index count) { return cut(weights_, count); }
  Span<Actuator<S>> actuators(Index count) { return cut(actuators_, count); }
  Span<Drive<S>> drives(Index count) { return cut(drives_, count); }

  Status refuse(Mistake mistake) {
    mistake_ = mistake;
    described_ = false;
    solve_.forget();
    return status_ = Status::bad_input;
  }

  /// Takes a scene over this push's own arrays.
  Status accept(const Scene<S>& scene, bool is_round) {
    given_ = scene;
    if (is_round) given_.aims = {work_.aims.data, scene.points.size};
    motion_ = nullptr;
    return assemble();
  }

  /// The scene's grip forces or motions have changed.
  Status assemble() {
    solve_.forget();
    described_ = false;
    const Mistake mistake = find_mistake(given_);
    if (mistake != Mistake::none) return refuse(mistake);
    if (spread_evenly(given_, even_, scene_) != Status::solved || !fits(size_of(scene_)) ||
        assembly_.assemble(scene_) != Status::running)
      return refuse(Mistake::memory_too_small);
    described_ = true;
    moved_ = false;
    mistake_ = Mistake::none;
    run_ = {};
    return status_ = Status::running;
  }

  Status step(int pivots) {
    if (!described_) return refuse(Mistake::not_described);
    if (status_ != Status::running) return status_;
    if (by_sweeps_) return sweep();
    if (solve_.get() == nullptr) {
      assembly_.push_by(S(1));
      PivotSolve& solve = solve_.make(assembly_, LemkeRounds<S>{lemke_, options_}, work_.pressure,
                                      PressureOptions<S>(), work_.friction_memory(scene_));
      status_ = solve.init();
    }
    for (int k = 0; k < pivots && status_ == Status::running; ++k) {
      if (limit_ > 0 && solve_.get()->run().pivots + lemke_.pivots() >= limit_)
        status_ = Status::pivot_limit;
      else
        status_ = solve_.get()->step();
    }
    run_ = solve_.get()->run();
    return status_ == Status::running ? status_ : conclude();
  }

  Status solve() {
    constexpr int many = 1 << 20;
    while (step(many) == Status::running) continue;
    return status_;
  }

  Status break_grasp(Index pusher, Breaking<S>& breaking) {
    if (!described_) return refuse(Mistake::not_described);
    solve_.forget();
    breaking = {};
    if (pusher < 0 || pusher >= given_.bodies.size) return refuse(Mistake::index);
    if (!(push_size(scene_) > S(0))) return refuse(Mistake::nothing_moves);
    const Body<S>& body = given_.bodies[pusher];
    status_ = by_sweeps_ ? find_breaking(assembly_, SweepRounds<S>{sweeps_}, work_, body,
                                         PressureOptions<S>(), breaking, run_)
                         : find_breaking(assembly_, LemkeRounds<S>{lemke_, options_}, work_, body,
                                         PressureOptions<S>(), breaking, run_);
    residual_ = breaking.residuals.max();
    return status_;
  }

  /// A motion of the scene as described.
  Status set_off(Arena arena) {
    motion_ = nullptr;
    if (!described_) return refuse(Mistake::not_described);
    if (by_sweeps_) return refuse(Mistake::unsupported);
    solve_.forget();
    described_ = false; // its equations' arrays are the motion's from now on
    moved_ = true;
    motion_ = begin_motion(given_, work_, arena, mistake_);
    return motion_ == nullptr ? refuse(mistake_) : status_ = Status::running;
  }

  Status advance(S h) {
    if (motion_ == nullptr) return refuse(Mistake::not_described);
    solve_.forget();
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
  const Scene<S>& given() const { return given_; }
  const PressureRun& run() const { return run_; }
  Index pivots() const { return run_.pivots + (status_ == Status::running ? lemke_.pivots() : 0); }
  S residual() const { return residual_; }

private:
  Capacity most_;
  bool by_sweeps_, described_ = false;
  Span<Body<S>> bodies_;
  Span<Vector3<S>> points_;
  Span<S> weights_;
  Span<Actuator<S>> actuators_;
  Span<Drive<S>> drives_;
  EvenMemory<S> even_;
  Workspace<S> work_;
  Assembly<S> assembly_;
  Lemke<S> lemke_;
  BlockGaussSeidel<S> sweeps_;
  LemkeOptions<S> options_{};
  Scene<S> given_{}, scene_{};
  InPlace<PivotSolve> solve_;
  PressureRun run_{};
  Status status_ = Status::bad_input;
  Mistake mistake_ = Mistake::not_described;
  Index limit_ = 0;
  CMotion<S>* motion_ = nullptr;
  bool moved_ = false; ///< the answer's arrays hold a step's
  S residual_{0};

  static AssemblySize assembly_size(const Capacity& most) {
    return {most.points, most.points * most.facets, most.actuators, most.drives, most.pulls};
  }

  bool fits(const AssemblySize& size) const {
    const AssemblySize all = assembly_size(most_);
    return size.points <= all.points && size.generators <= all.generators &&
           size.actuators <= all.actuators && size.drives <= all.drives && size.pulls <= all.pulls;
  }

  template <class T> static Span<T> cut(const Span<T>& whole, Index count) {
    return count < 0 || count > whole.size ? Span<T>{nullptr, -1} : Span<T>{whole.data, count};
  }

  /// Sweeps stop at a residual that large forces make look small: the laws may ask for more.
  Status sweep() {
    SweepOptions<S> options;
    Index sweeps = 0;
    for (;;) {
      status_ = solve_pressure(assembly_, SweepRounds<S>{sweeps_, options}, work_.pressure,
                               PressureOptions<S>(), run_, work_.friction_memory(scene_));
      run_.sweeps += sweeps;
      sweeps = run_.sweeps;
      const Status judged = conclude();
      const bool refused = judged == Status::numerical_breakdown || judged == Status::not_settled;
      if (!refused || options.tolerance < S(64) * Eigen::NumTraits<S>::epsilon()) return status_;
      options.tolerance /= S(16);
    }
  }

  /// What the solver calls solved is read, and the laws are asked as well.
  Status conclude() {
    if (status_ != Status::solved) return status_;
    read_answer(assembly_, work_.pressure.z.data, work_.answer, S(1));
    residual_ = check(scene_, assembly_.layout().scales, work_.answer, S(1)).max();
    if (!(residual_ <= Tolerances<S>().residual)) status_ = Status::numerical_breakdown;
    return status_;
  }
};

} // namespace lcpush::c
