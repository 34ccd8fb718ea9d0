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
  static constexpr int attempts = 3;
  int attempt_ = 0;
  bool falls_back_ = false;
  Index pivots_ = 0;  // of the attempts before
  Index allowed_ = 0; // until the solve is interrupted

  static Workspace<S> take(Arena arena, const AssemblySize& size) {
    return make_small_workspace<S>(arena, size, size.actuators, exchanges_of(size));
  }
  static Status step_of(Base& push, int pivots) {
    return static_cast<CPivotPush&>(push).pivot(pivots);
  }
  static std::uint32_t work_of(const Base& push) {
    return static_cast<const CPivotPush&>(push).lemke_.basis().work();
  }
  static constexpr typename Base::Method method{&step_of, nullptr, true, &take, &work_of};

  LemkeOptions<S> options(int attempt) const {
    LemkeOptions<S> options;
    options.first_cover = attempt * options.covers;
    options.exchanges = exchanges_of(size_of(*this->scene_));     // whatever the memory is for
    options.max_pivots = 200 + 3 * this->assembly_.layout().size; // what takes more goes astray
    return options;
  }

  /// A first attempt begins at the modes that one expects, if it does not go on from the last
  /// command's, and is content with what the check lets pass; later ones take other covering
  /// vectors and slower pads, the last is exact to rounding. Pre: the push stands at its pace
  /// (sigma 1); rounds make normal rows anew.
  void begin(int attempt) {
    attempt_ = attempt;
    LemkeOptions<S> options = this->options(attempt);
    PressureOptions<S> pads;
    if (attempt + 1 < attempts) options.tolerances.finish = options.tolerances.residual / S(8);
    for (int k = 0; k < attempt; ++k) pads.factor = Eigen::numext::sqrt(pads.factor);
    if (attempt > 0)
      this->last_.known = false;
    else if (this->goes_on_)
      take_over(pads);
    else if (!this->last_.known || this->last_.guess != Guess::basis)
      predict();
    this->goes_on_ = false;
    PivotSolve& solve =
        solve_.make(this->assembly_, Pivots(lemke_, this->last_, options), this->work_.pressure,
                    pads, this->work_.friction_memory(*this->scene_));
    this->status_ = solve.init();
  }

  /// May another attempt answer? Of 20 rays that double does not find, float's next attempts solve
  /// 15; double's rays are jams.
  static constexpr bool may_be_lost(Status status) {
    constexpr bool believes_rays = Eigen::NumTraits<S>::digits10() > 6;
    return status == Status::numerical_breakdown || status == Status::pivot_limit ||
           (status == Status::ray && !believes_rays);
  }

  /// The modes that one expects, marked by Guess::near until they have led to an answer.
  void predict() {
    predict_modes_in_little_stack(this->assembly_, this->last_.active);
    this->last_.known = true;
    this->last_.guess = Guess::near;
  }

  /// Where a command has ended the solve before: its pivots still serve, and its pads' rounds, with
  /// the pressure and the compliance that they have come to.
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

  /// Round friction that does not settle: an answer over pyramids of eight facets is one to go by.
  void fall_back() {
    falls_back_ = true;
    this->scene_->round_cones = {};
    (void)this->assembly_.assemble(*this->scene_); // it has fitted before
    this->last_.known = false;
    begin(0);
  }
  /// Judged by the round cone's law.
  Status end_fall_back() {
    this->make_round();
    if (this->status_ == Status::solved)
      this->residual_ =
          check(*this->scene_, this->assembly_.layout().scales, this->kept_, S(1)).max();
    return this->status_ = Status::not_settled;
  }

  Status pivot(int pivots) {
    Status& status = this->status_;
    if (!this->begun_) {
      this->begun_ = true;
      if (falls_back_) this->goes_on_ = this->last_.known = falls_back_ = false;
      pivots_ = allowed_ = 0;
      begin(0);
    }
    if (allowed_ == 0 || this->is_interrupted_) allowed_ += this->limit_;
    this->is_interrupted_ = false;
    for (int k = 0; k < pivots && status == Status::running; ++k) {
      if (this->limit_ > 0 && pivots_ + solve_.get()->run().pivots + lemke_.pivots() >= allowed_) {
        this->is_interrupted_ = true;
        status = Status::pivot_limit;
        break;
      }
      status = solve_.get()->step();
      if (status == Status::running) continue;
      note(0);
      (void)this->conclude();
      if (status == Status::solved) this->last_.guess = Guess::basis;
      pivots_ = this->run_.pivots;
      if (may_be_lost(status) && attempt_ + 1 < attempts)
        begin(attempt_ + 1);
      else if (falls_back_)
        return end_fall_back();
      else if (status == Status::not_settled)
        fall_back();
      else
        return status;
    }
    note(lemke_.pivots());
    return status;
  }
};

} // namespace lcpush::c
