// The limits of pads: statics in which a point's force follows the displacement that opens or
// presses it, as it does between rounds of [T.7].
#pragma once

#include <utility>
#include <vector>

#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

class PadLimits {
public:
  /// `touching`: the points that carry the load, one a point of the file's.
  PadLimits(const SceneFile& hand, std::vector<bool> touching)
      : hand_(hand), touching_(std::move(touching)) {}

  /// The largest factor on a wrench, [N; N m], that is held beside the load; nan: none is found, or
  /// all of them have cost too much, unless it is for a picture.
  double limit(const Vector6<double>& wrench, bool for_picture = false) const;
  /// The least factor on the grip, or the most.
  double grip(bool least) const;

private:
  const SceneFile& hand_;
  std::vector<bool> touching_;
  mutable double work_ = 0;
};

} // namespace lcpush::desktop
