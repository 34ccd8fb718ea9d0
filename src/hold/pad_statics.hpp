// Statics under the law of pads [T.7]: how pressure follows a displacement.
#pragma once

#include <vector>

#include "solve/grip_statics.hpp"

namespace lcpush::desktop {

/// The balance with rows more: of patches the affine parts of their pressure, and where the rim of
/// what has parted may not press; of other points one each.
class PadStatics : public GripStatics {
public:
  /// `touching`: which points do.
  PadStatics(const SceneFile& file, const std::vector<bool>& touching)
      : GripStatics(file, touching) {
    add_pads();
  }
  /// How far a displacement presses a point, at `factor` times the grip; < 0: it parts.
  double presses(Index point, const Eigen::VectorXd& displacement, double factor) const;

private:
  void add_pads();
  void bound_locked_forces();
  void add_patch(Index body);
  void follow(const Eigen::VectorXd& normal, double preload, bool parts);
};

} // namespace lcpush::desktop
