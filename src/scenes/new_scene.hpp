// A scene to start from, of one's own object: what `lcpush new` writes.
#pragma once

#include <string>

namespace lcpush::desktop {

/// As typed; where a text is empty, what is usual.
struct NewScene {
  std::string object = "box"; ///< or cylinder
  std::string push = "slide"; ///< pivot, roll (a cylinder) or none
  std::string size;           ///< "80 mm x 40 mm x 20 mm"; of a cylinder diameter x length
  std::string mass;           ///< "120 g"
  std::string pads;           ///< "20 mm x 10 mm", or round: "8 mm"
  std::string grip;           ///< "20 N", of each finger
  std::string friction;       ///< of the pads
};

/// The scene's text. Throws InputError, which begins with the option whose value is wrong, if the
/// scene would not be read, or something about it would look odd.
std::string new_scene(const NewScene& given);

/// What is given, and what is usual of the rest. Throws InputError as new_scene does.
NewScene usual_scene(const NewScene& given);

} // namespace lcpush::desktop
