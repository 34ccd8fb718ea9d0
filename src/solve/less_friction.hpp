// Another answer by less friction: what sticks has the friction that is needed, and where nothing
// says how much that is, the laws leave it open; pivots end at one end of it.
#pragma once

#include <optional>
#include <vector>

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush::desktop {

/// The scene with less friction at bodies that stick.
struct LessFriction {
  SceneFile file;
  std::vector<Index> bodies;
  double still; ///< m/s^2: what moves no faster sticks

  /// Do they all stick in this answer, too? Then its forces are within the given friction, and it
  /// is an answer of the given scene.
  bool sticks(const Answer<double>& answer) const;
};

/// With this part of the friction of each body that presses and nowhere slips; nothing: there is
/// none.
std::optional<LessFriction> with_less_friction(const SceneFile& file, const Answer<double>& answer,
                                               double part, const Scales<double>& scales);

/// With hardly any, to ask whether it rests then: under the law of pads, and where no contacts may
/// squeeze it against each other, for how hard they would nobody says.
std::optional<LessFriction> with_hardly_any_friction(const SceneFile& file,
                                                     const Answer<double>& answer,
                                                     const Scales<double>& scales);

} // namespace lcpush::desktop
