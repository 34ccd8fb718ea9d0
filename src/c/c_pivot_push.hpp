// A push that is solved by Lemke's pivots on the structured basis, some of them a call.
#pragma once

#include "c_push.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"

namespace lcpush::c {

/// Exchanges that a basis on a device has room for. In the end it holds about a normal force a
/// point, 6 forces and two an actuator; the rest are met on the way. Factoring it that often makes
/// float more reliable, too. Who asks for more ends in memory_too_small.
constexpr Index exchanges_of(const AssemblySize& size) {
  return size.points + size.pulls + 2 * size.actuators + 10;
}

/// The numbers of a solve by pivots on a device.
struct CSettings {
  /// Of a solve, each under the next covering vectors, with slower pads and more pivots: so 6,000
  /// of 6,000 random grasps are solved in float (docs/embed/tables.md). Fewer are not measured.
  static constexpr int attempts = 3;
  /// Under one covering vector: what takes more goes astray. Of 23,000 that led to an answer three
  /// in ten thousand took more.
  static constexpr Index most_pivots(Index n) { return 50 + 2 * n; }
  /// Rounds of pads that have settled: each leaves a third of what they violate.
  static constexpr Index fine_rounds = 4;
  /// Of those pivots: a tighter answer is a few away, or cannot be had in this precision.
  static constexpr Index refining_part = 4;
};

/// `Push`: lcpush_push or lcpushf_push.
template <class Push> class CPivotPush : public Push {
public:
  using S = typename Push::Scalar;
  using Base = CPush<S>;

  CPivotPush(Arena& arena, const Capacity& most)
      : Push(arena, most, method), lemke_(this->work_.lemke_scalars, this->work_.lemke_integers) {}

  /// In float, a ray of the limit of small pushes is more often rounding's than a jam, whatever it
  /// is covered with: then small pushes themselves are asked.
  Status break_grasp(const Body<S>& pusher, Breaking<S>& breaking) {
    Status status = Status::running;
    PressureOptions<S> pads;
    for (int attempt = 0; attempt < attempts; ++attempt, pads.exact_limit = false) {
      breaking = {};
      LemkeOptions<S> pivots = options(attempt);
      if (breaks_exactly(Rounds{lemke_}, *this->scene_, pads)) pivots.covers = 1;
      status = find_breaking(this->assembly_, Rounds{lemke_, pivots}, this->work_, pusher, pads,
                             breaking, this->run_);
      if (status == Status::solved || status == Status::does_not_hold) break;
    }
    return status;
  }

private:
  using Rounds = LemkeRounds<S, const Unwatched, SmallLemke<S>>;
  using Pivots = StepRounds<S, SmallLemke<S>>;
  using PivotSolve = PressureSolve<S, Pivots>;

  SmallLemke<S> lemke_;
  InPlace<PivotSolve> solve_;
  static constexpr int attempts = CSettings::attempts;
  short attempt_ = 0;
  bool refines_ = false;
  LastStep found_{};  // where refining begins
  Index pivots_ = 0;  // of the attempts before
  Index allowed_ = 0; // until the solve is interrupted

  static Workspace<S> take(Arena arena, const AssemblySize& size) {
    return make_small_workspace<S>(arena, size, size.actuators, exchanges_of(size));
  }
  static Status step_of(Base& push, int pivots) {
    return static_cast<CPivotPush&>(push).pivot(pivots);
  }
  static constexpr typename Base::Method method{&step_of, nullptr, true, &take};

  LemkeOptions<S> options(int attempt) const {
    LemkeOptions<S> options;
    options.first_cover = attempt * options.covers;
    options.exchanges = exchanges_of(size_of(*this->scene_)); // whatever the memory is for
    options.max_pivots = (attempt + 1) * CSettings::most_pivots(this->assembly_.layout().size);
    return options;
  }

  /// A first attempt begins at the modes that one expects, if it does not go on from the last
  /// command's, and is content with what the check lets pass; later ones take other covering
  /// vectors and slower pads, the last is exact to rounding. `refines`: what lets float find an
  /// answer at all leaves some of it, so that one that took pivots and passes barely is kept, and a
  /// tighter one sought from its basis and pressure, until that is lost. Pre: the push stands at
  /// its pace (sigma 1); rounds make normal rows anew.
  [[gnu::noinline]] void begin(int attempt, bool refines = false) {
    const bool goes_on = this->goes_on_ && !refines_ && attempt == 0;
    attempt_ = static_cast<short>(attempt);
    refines_ = refines;
    LemkeOptions<S> options = this->options(attempt);
    PressureOptions<S> pads;
    // A lost round ends the first attempt: the next one's other covering vectors are cheaper.
    if (attempt == 0) pads.slowest = S(0);
    if (refines) {
      take_over(pads);
      options.covers = 1;
      options.max_pivots /= CSettings::refining_part;
      pads.fine_rounds = CSettings::fine_rounds;
      pads.finest = barely();
    } else {
      if (attempt + 1 < attempts) options.tolerances.finish = options.tolerances.residual / S(8);
      for (int k = 0; k < attempt; ++k) pads.factor = Eigen::numext::sqrt(pads.factor);
      if (goes_on)
        take_over(pads);
      else if (attempt > 0)
        this->last_.known = false;
      else if (!this->last_.known || this->last_.guess != Guess::basis)
        predict();
    }
    this->goes_on_ = false;
    PivotSolve& solve =
        solve_.make(this->assembly_, Pivots(lemke_, this->last_, options), this->work_.pressure,
                    pads, this->work_.friction_memory(*this->scene_));
    this->status_ = solve.init();
  }
  static S barely() { return Tolerances<S>().residual / S(LemkeSettings::barely); }

  /// The modes that one expects, marked by Guess::near until they have led to an answer.
  void predict() {
    predict_modes_in_little_stack(this->assembly_, this->last_.active);
    this->last_.known = true;
    this->last_.guess = Guess::near;
  }

  /// Where the solve before has ended, or a command has ended it: its pivots still serve, and its
  /// pads' rounds, with the pressure and the compliance that they have come to.
  void take_over(PressureOptions<S>& pads) {
    for (Index i = 0; i < this->assembly_.layout().size; ++i)
      this->last_.active[i] = lemke_.is_basic(i) ? 1 : 0;
    pads.keeps_cones = true;
    pads.goes_on = solve_.get()->run().rounds > 1;
    if (pads.goes_on) pads.first_compliance = solve_.get()->compliance();
    this->last_.known = true;
    this->last_.guess = Guess::near;
  }

  /// What the solve has done, and pivots of a round that is under way.
  void note(Index pivots) {
    this->run_ = solve_.get()->run();
    this->run_.pivots += pivots_ + pivots;
  }

  Status end_refining() {
    refines_ = false;
    this->last_.guess = Guess::basis;
    return this->conclude_tighter();
  }

  Status pivot(int pivots) {
    Status& status = this->status_;
    if (!this->begun_) {
      this->begun_ = true;
      pivots_ = allowed_ = 0;
      begin(0);
    }
    if (allowed_ == 0 || this->is_interrupted_) allowed_ += this->limit_;
    this->is_interrupted_ = false;
    for (int k = 0; k < pivots && status == Status::running; ++k) {
      if (this->limit_ > 0 && pivots_ + solve_.get()->run().pivots + lemke_.pivots() >= allowed_) {
        if (refines_) return end_refining();
        this->is_interrupted_ = true;
        status = Status::pivot_limit;
        break;
      }
      status = solve_.get()->step();
      const bool is_lost = refines_ && solve_.get()->run().cold_restarts > 0;
      if (status == Status::running && !is_lost) continue;
      note(0);
      if (refines_) return end_refining();
      const bool failed =
          this->conclude() == Status::numerical_breakdown || status == Status::pivot_limit;
      if (status == Status::solved) {
        this->last_.guess = Guess::basis;
        pivots_ = this->run_.pivots;
        if (pivots_ == 0 || !(this->residual_ > barely())) return status;
        begin(attempt_, true);
        continue;
      }
      if (!failed || attempt_ + 1 == attempts) return status;
      pivots_ = this->run_.pivots;
      begin(attempt_ + 1);
    }
    note(lemke_.pivots());
    return status;
  }
};

} // namespace lcpush::c
