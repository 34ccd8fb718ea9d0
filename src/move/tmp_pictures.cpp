#include "lcpush/desktop/move.hpp"
namespace lcpush::desktop {
std::string move_svg(const SceneFile&, const MotionReport&) { return ""; }
std::string move_html(const SceneFile&, const MotionReport&) { return ""; }
} // namespace lcpush::desktop
