// What the scene's own law of pads holds: the statics of its surfaces says where the limit is, the
// law is asked inside, and searched where it disagrees.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hold/pad_limits.hpp"
#include "solve/grip_search.hpp"
#include "solve/grip_statics.hpp"

namespace lcpush::desktop {

class HoldingLaw {
public:
  /// Of the hand's statics, which outlive this; `is_squeezed`: they have a self-stress.
  HoldingLaw(const SceneFile& hand, const PushOptions& options, const GripStatics& statics,
             bool is_squeezed);
  HoldingLaw(const HoldingLaw&) = delete; // its options point at its watcher
  HoldingLaw& operator=(const HoldingLaw&) = delete;

  /// Does it hold at this factor on the grip with this wrench, [N; N m], beside the load? None: the
  /// law has no answer that is found, which is no verdict.
  std::optional<bool> holds(double factor, const Vector6<double>& more);
  /// The load as it is; forces of pads that carry it prove it where the law has no answer.
  std::optional<bool> holds_now() const { return holds_now_; }
  /// What follows may use so much of the law's work, until this is said again.
  void allow(double part) { work_.allow(part); }
  /// Was a limit told beyond which the law was not asked, as the work was used up?
  bool may_bear_more() const { return may_bear_more_; }
  const SceneFile& surfaces() const { return pads_.surfaces(); }
  /// The least factor on the grip; `bound`: of statics, from below; nan: not known.
  double least_grip(double bound);
  /// `bound`: of statics, from above; nan: no more than the least grip is known.
  double most_grip(double bound);
  /// The largest factor on a wrench; `bound`: of statics, from above; `asks`: or what pads can
  /// hold.
  double limit(const Vector6<double>& wrench, double bound, bool asks = true);

private:
  const SceneFile& hand_;
  const GripStatics& statics_;
  CountingWatcher work_;
  bool is_first_ = true; // before what asks
  bool may_bear_more_ = false;
  std::vector<bool> touching_;
  std::optional<bool> holds_now_;
  PadLimits pads_;
  double pads_least_;
  bool is_open_; // what does not close by itself may hold by a prestress, more than less of a load
  bool knows_prestress_; // of locked jaws it is given: which grip holds is their pads' to say

  PushOptions options() const;

  using Question = std::function<std::optional<bool>(double)>;
  double searched(double refuted, double sign, const Question& is_held) const;
  double halved(double refuted, double held, const Question& is_held) const;
  double from_unit(double unit, double most, const Question& is_held) const;
  double lowered(double from, double bound, const Question& is_held) const;
  double least_from(double start, bool is_proved, const Question& is_held) const;
  double not_less(double held, const Question& is_held) const;
  double beyond_falls(double least, const Question& is_held);
};

} // namespace lcpush::desktop
