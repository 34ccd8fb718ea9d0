// The playground: a page that solves while its reader drags the grasp.
#pragma once

#include <string>
#include <vector>

namespace lcpush::desktop {

/// One page with the solver inside, nothing from elsewhere. It begins with the scene of `text`,
/// which need not be one: the page says what is wrong, and can be edited.
std::string play_html(const std::string& text);

/// The same for a typed M and q: their pivots, and textbook problems.
std::string lcp_html();

struct PlayFile {
  std::string name, text;
};

/// index.html, play.html, lcp.html and a picture of each shipped scene.
std::vector<PlayFile> play_gallery();

} // namespace lcpush::desktop
