// A grasp and what a push does to it, drawn: the object, bodies, forces, friction cones, modes,
// motions, and the axis that the object turns about.
#pragma once

#include <cmath>

#include "draw/marks.hpp"
#include "draw/view.hpp"
#include "lcpush/desktop/push.hpp"
#include "picture/grasp_figures.hpp"

namespace lcpush::desktop {

inline std::vector<View> chosen_views(const SceneFile& file) {
  return two_views(file.gravity, file.shape.size, file.bodies);
}

/// Is the axis a screw's? `length`: the size of the grasp, m.
inline bool has_pitch(const Motion<double>& motion, double length) {
  return std::abs(motion.pitch) > 1e-6 * length;
}
/// Is the axis a point in the view, the instantaneous centre?
inline bool is_along_sight(const View& view, const Vector3<double>& axis) {
  return view.flat(axis).norm() <= 1e-6;
}

/// The isometric view: bodies as things, what each does, and a ghost of where the object goes.
Drawing isometric_picture(const DrawnScene& drawn, const PushReport& report);

/// One picture a view, to the same scales. Without an answer it shows the prescribed motions, and
/// of a jam who squeezes.
std::vector<Drawing> scene_pictures(const DrawnScene& drawn, const PushReport& report);

/// The friction of each body that has some, within its cone's section of radius mu lambda: of all
/// its points together, and point by point where it has several; of large patches the first points.
/// Precondition, here and below: the push is solved.
struct FrictionGroup {
  std::string body;
  Drawing whole;
  std::vector<Drawing> points;
};
std::vector<FrictionGroup> friction_panels(const SceneFile& file, const PushReport& report);
/// All points in one drawing, six in a row.
Drawing friction_picture(const SceneFile& file, const PushReport& report);

/// The points that friction_picture leaves out, with the reason: "wall.1 (no normal force)",
/// "left.3 to left.8 (no room)".
std::vector<std::string> without_friction(const SceneFile& file, const PushReport& report);

/// Each law's largest residual as a bar on a logarithmic scale, beside the tolerance.
Drawing residual_picture(const Residuals<double>& residuals);
struct LawRow {
  std::string name, tag;
  double residual;
};
std::vector<LawRow> law_rows(Residuals<double> residuals);

} // namespace lcpush::desktop
