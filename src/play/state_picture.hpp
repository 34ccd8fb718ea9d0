// The picture of the playground's state: the grasp from where it is looked at, with its forces,
// cones and modes, and where the object goes; or a moment of its motion.
#pragma once

#include "lcpush/desktop/push.hpp"
#include "picture/grasp_figures.hpp"
#include "play/picture_request.hpp"

namespace lcpush::desktop {

struct StatePicture {
  std::string svg; ///< an element; a body's parts are in a group with its name in data-body
  Sight sight;
};
/// `title`: what is to be heard of it.
StatePicture state_picture(const DrawnScene& drawn, const PushReport& report,
                           const PictureRequest& look, const std::string& title);

/// What the picture's signs mean, as a list.
std::string state_key();

} // namespace lcpush::desktop
