// A grasp and what a push does to it, drawn: the object, bodies, forces, friction cones, modes,
// motions, and the axis that the object turns about.
#pragma once

#include "draw/marks.hpp"
#include "draw/view.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// One picture a view, to the same scales. Without an answer it shows the prescribed motions, and
/// of a jam who squeezes.
std::vector<Drawing> scene_pictures(const SceneFile& file, const PushReport& report);

/// The friction of each contact point that has some, within its polygon of radius mu lambda; of
/// large patches the first points. Precondition, here and below: the push is solved.
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

/// Three significant digits: what is easy to read in a picture; more stand in the tables.
std::string rough_number(double x);
/// Square, triangle or ring.
std::string mode_mark(Mode mode, const Pixel& at);
/// "sticks", "slides", "separates".
std::string mode_verb(Mode mode);

} // namespace lcpush::desktop
