// The playground: a page that solves while its reader drags the grasp.
#pragma once

#include <string>

namespace lcpush::desktop {

/// One page with the solver inside, nothing from elsewhere. It begins with the scene of `text`,
/// which need not be one: the page says what is wrong, and can be edited.
std::string play_html(const std::string& text);

} // namespace lcpush::desktop
