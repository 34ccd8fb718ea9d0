// The limits of pads: statics in which a point's force follows the displacement that opens or
// presses it, as it does between rounds of [T.7].
#pragma once

#include <utility>
#include <vector>

#include "hold/pad_surfaces.hpp"
#include "hold/settings.hpp"

namespace lcpush::desktop {

/// The most of a wrench beside the load; or, of the grip's factor, the least or the most.
struct PadQuestion {
  Vector6<double> wrench = Vector6<double>::Zero();
  bool of_grip = false, of_least = false;
};

class PadLimits {
public:
  /// `touching`: the points that carry the load, one a point of the file's.
  PadLimits(const SceneFile& hand, std::vector<bool> touching)
      : hand_(hand), surfaces_(with_surfaces(hand)), touching_(std::move(touching)) {}

  const SceneFile& surfaces() const { return surfaces_; }
  /// By how much less the law of the scene's own points may hold.
  double slack() const {
    return surfaces_.points.size() == hand_.points.size() ? hold_settings.same
                                                          : hold_settings.of_points;
  }
  /// The largest factor on a wrench, [N; N m], that is held beside the load; nan: none is found, or
  /// all of them have cost too much, unless it is for a picture.
  double limit(const Vector6<double>& wrench, bool for_picture = false) const;
  /// The least factor on the grip, or the most: of the scene's own points, as a grip that is told
  /// has to hold.
  double grip(bool least) const;

private:
  const SceneFile& hand_;
  SceneFile surfaces_;
  std::vector<bool> touching_;
  mutable double work_ = 0;

  double best(const PadQuestion& question, double& work) const;
};

} // namespace lcpush::desktop
