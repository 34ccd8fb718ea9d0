// Is this the scene that was meant? What a scene file says can be solved and still be a slip: a
// finger beside the object, a normal that points outward, millimetres for metres.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

enum class Doubt {
  outside_object,   ///< a contact point lies off the object's surface
  far_from_object,  ///< .. so far off that its unit, or a digit, must be wrong
  normal_outward,   ///< a normal points out of the object, or along its surface
  moves_away,       ///< a pusher recedes from the object at each of its points
  density,          ///< no material is so light, or so heavy
  jaws_independent, ///< opposed fingers that a push carries along with it
  center_of_mass,   ///< the contacts fit the object around another middle than the file's
  normal_along,     ///< a patch extends along its normal, where a plane should touch
  friction,         ///< more than any pair of materials has: percent, or an angle
  gravity,          ///< no planet's
  acceleration,     ///< a push that no machine makes
  inertia,          ///< of a body far larger than where its contacts lie
  jaws_same_side,   ///< parallel jaws that press the same way
  unknown_shape,    ///< a motion goes over the surface of an object that has none
  overhang,         ///< a line or rectangle reaches beyond the box, and is cut to what touches
  left_out,         ///< a load that planar = true drops: across the plane, or a moment out of it
  middle,           ///< nothing odd: numbers have ranges, and the scene is the middle of them
  unopposed,        ///< fingers press the same way, and nothing meets them
  small_table,      ///< where a push goes along it, the object slides off it
  no_load,          ///< nothing presses: without gravity, forces and grip there is no friction
};

/// As JSON spells it.
const char* doubt_code(Doubt doubt);

struct SceneDoubt {
  Doubt doubt;
  std::string file;
  int line;
  std::string text; ///< what is odd, with numbers, and what to do; without file and line
};

/// What is odd about the scene, in the order of the file's lines. Judged by the shape (box or
/// cylinder, its middle at the centre of mass) where the file gives one. Solves nothing.
/// Cost: O(points).
std::vector<SceneDoubt> check_scene(const SceneFile& file);

/// `FILE:LINE: TEXT`
std::string doubt_text(const SceneDoubt& doubt);

} // namespace lcpush::desktop
