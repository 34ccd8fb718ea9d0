// A push that is solved by sweeps: memory grows with the points alone.
#pragma once

#include "c_push.hpp"

namespace lcpush::c {

/// `Push`: lcpush_push or lcpushf_push.
template <class Push> class CSweepPush : public Push {
public:
  using S = typename Push::Scalar;
  using Base = CPush<S>;

  CSweepPush(Arena& arena, const Capacity& most)
      : Push(arena, most, method), sweeps_(this->work_.sweep_scalars, this->work_.sweep_integers) {}

private:
  BlockGaussSeidel<S> sweeps_;

  static Status step_of(Base& push, int) { return static_cast<CSweepPush&>(push).sweep(); }
  static Status break_of(Base& push, const Body<S>& pusher, Breaking<S>& breaking) {
    CSweepPush& p = static_cast<CSweepPush&>(push);
    return find_breaking(p.assembly_, SweepRounds<S>{p.sweeps_}, p.work_, pusher,
                         PressureOptions<S>(), breaking, p.run_);
  }

  static std::uint32_t work_of(const Base&) { return 0; } ///< a step solves all
  static constexpr
      typename Base::Method method{&step_of, &break_of, false, &make_sweep_workspace<S>, &work_of};

  /// Sweeps stop at a residual that large forces make look small: the laws may ask for more.
  Status sweep() {
    SweepOptions<S> options;
    Index sweeps = 0;
    for (;;) {
      this->status_ = solve_pressure(this->assembly_, SweepRounds<S>{sweeps_, options},
                                     this->work_.pressure, PressureOptions<S>(), this->run_,
                                     this->work_.friction_memory(*this->scene_));
      this->run_.sweeps += sweeps;
      sweeps = this->run_.sweeps;
      const Status judged = this->conclude();
      const bool refused = judged == Status::numerical_breakdown || judged == Status::not_settled;
      if (!refused || options.tolerance < S(64) * Eigen::NumTraits<S>::epsilon()) return judged;
      options.tolerance /= S(16);
    }
  }
};

} // namespace lcpush::c
