// Which views of a grasp are drawn, and how they show the axis that it turns about.
#pragma once

#include "draw/view.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// A front view, and of the other two the one that shows more: where gravity points along z, that
/// axis is up.
std::vector<View> chosen_views(const SceneFile& file);

/// How a view shows the axis that an object turns about, in the scene's frame and metres.
struct TurningMark {
  bool is_point = false; ///< the axis points at the viewer: the instantaneous centre
  Vector3<double> at;    ///< a point of the axis, the one nearest to the centre of mass
  Vector3<double> along; ///< unit
  double pitch = 0;      ///< m per rad
  bool is_screw = false; ///< the pitch is not zero
};

/// Nothing if the object does not turn. `length`: the size of the grasp, m.
std::optional<TurningMark> turning_mark(const SceneFile& file, const Motion<double>& motion,
                                        const View& view, double length);

} // namespace lcpush::desktop
