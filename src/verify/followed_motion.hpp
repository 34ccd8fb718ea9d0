// The laws' own motion, begun again and again where somebody else's is.
#pragma once

#include "move/motion_run.hpp"
#include "verify/trajectory_steps.hpp"

namespace lcpush::desktop {

class FollowedMotion {
public:
  /// Both must outlive it. `rim`: so far beyond its end, m, a face still touches.
  FollowedMotion(const SceneFile& file, const std::vector<TrajectoryFrame>& given, double rim)
      : given_(given), seen_(file, given), run_(file) {
    if (rim > 0) run_.widen_faces(rim);
  }

  MotionRun& run() { return run_; }
  const TellingPoints& telling() const { return seen_.telling(); }
  /// At frame k with this velocity; the fingers are where that has them, if it says so, else where
  /// they were. Pre: called with growing k.
  void begin_at(std::size_t k, const Vector6<double>& twist);
  /// One step; where it is too long for the laws, two of half its length may be there.
  [[nodiscard]] Status advance(double h, bool& is_halved, int halvings);

private:
  const std::vector<TrajectoryFrame>& given_;
  SeenMotion seen_;
  MotionRun run_;

  void follow_with(Index actuator, const Pose<double>& to);
};

/// `change_frames` of a motion at most, so that its velocity changes by more than its digits from
/// one to the next.
std::vector<TrajectoryFrame> thinned(const std::vector<TrajectoryFrame>& given);

/// How the velocity changes from frame to frame, in windows of a quarter of the motion that overlap
/// by half. `allowed`, m/s: by more, the laws are followed in finer steps as well. Cost: two steps
/// a frame of `change_frames` at most, then these.
MissedChange judge_changes(const SceneFile& file, const std::vector<TrajectoryFrame>& given,
                           double allowed, double rim);

} // namespace lcpush::desktop
