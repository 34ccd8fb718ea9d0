// How a push changes with each number that a controller commands: what it linearises.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

#include <optional>

namespace lcpush::desktop {

/// The derivative of an answer by one number, the others fixed. If `reason` is not empty, there is
/// none, and it says why.
struct Sensitivity {
  struct OfPusher {
    Index body;
    Vector3<double> force; ///< N per unit of the number, the pusher's on the object
    double normal_force;   ///< the same of the sum of its points'
  };
  std::string number; ///< "wall.twist[0]", "left.grip_force", "*.grip_force", "tendon.force"
  double value = 0;   ///< in the scene: m/s^2, rad/s^2, N
  std::string reason{};
  std::vector<OfPusher> pushers{};
  Vector6<double> acceleration = Vector6<double>::Zero(); ///< of the object, per unit
  /// The basis holds for all values from here to there, `value` among them: between breakpoints of
  /// pyramids the answer is a straight line. One of the two is `value` where the basis ends: the
  /// derivative is that to the other side. None: without end.
  std::optional<double> from{}, to{};
  bool is_curved = false; ///< of round friction: the derivative at `value` alone, no range
};

/// By each component of each pusher's acceleration, and by each grip force. `assembly` and `work`
/// are as a solve in pivots has left them; of any other state every `reason` says that there is no
/// basis. Turns round friction to the slips of the answer. Cost: for each number a few looks at the
/// basis, of O(points) each.
std::vector<Sensitivity> find_sensitivity(const SceneFile& file, Assembly<double>& assembly,
                                          Workspace<double>& work);

} // namespace lcpush::desktop
