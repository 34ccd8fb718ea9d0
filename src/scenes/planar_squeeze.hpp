// What a planar object cannot make way for.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

// Rounding of a normal that no decimal number can give exactly.
constexpr double direction_slack = 1e-9;

/// The first body that moves into the object where its normal force does not move the object in the
/// plane: pressing on would be a jam of one contact. -1 if there is none. S is double or Rational.
template <class S> Index squeezes_out_of_plane(const SceneOf<S>& scene);

} // namespace lcpush::desktop
