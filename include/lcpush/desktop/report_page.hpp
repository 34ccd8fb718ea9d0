// A push as one page for people who look rather than read: pictures, the answer in words, tables,
// and plots of sweeps. HTML and SVG without scripts and without anything from elsewhere.
#pragma once

#include "lcpush/desktop/hold.hpp"
#include "lcpush/desktop/sweep.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

/// What the page is about. Everything named must outlive the call.
struct PageContent {
  const SceneFile& file;
  const HoldReport& hold;
  const PushReport& push;                ///< of Push::solve, its answer still valid
  const BreakReport* breaking = nullptr; ///< of Push::find_breaking; null: not asked
  const GripReport* grip = nullptr;      ///< of find_smallest_grip; null only without `breaking`
  std::vector<Sweep> sweeps;             ///< any number, in the page's order
  const HoldStudy* held = nullptr;       ///< of find_hold; null: not asked
  std::string scene_text = "";           ///< as the file has it; may be empty
  std::string command = "";              ///< what was asked, as somebody typed it; may be empty
  std::string box = ""; ///< what holds for every value of the scene's ranges; may be empty
};

struct Picture {
  std::string
      name; ///< "isometric", "front", "top" or "side", "friction", "residuals", "sweep1", ..
  std::string title; ///< for people
  std::string svg;   ///< a document of its own, for light and dark
};

/// Every picture of the page. Three views of the grasp come first; friction and residuals only with
/// an answer. Cost: O(points facets) and the plots.
std::vector<Picture> report_pictures(const PageContent& content);

/// The whole page, HTML 5 that is well-formed XML too. A push without an answer gives a page that
/// says so, with the certificate in words.
std::string report_html(const PageContent& content);

/// Is everything on the page solved: the push, the breaking force and every value of the sweeps?
bool is_solved(const PageContent& content);

} // namespace lcpush::desktop
