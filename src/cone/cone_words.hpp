// What text and pictures say of a motion cone.
#pragma once

#include "lcpush/desktop/cone.hpp"

namespace lcpush::desktop {

/// "the push of wall sticks: 12.3 degrees more and the box slips over it along +y".
std::string cone_sentence(const SceneFile& file, const ConeReport& report);
/// What happens at an edge, and beyond a side: "wall.1 alone presses, the box is about to slip
/// along +y there".
std::string edge_words(const SceneFile& file, const ConeReport& report,
                       const ConeReport::Edge& edge);
std::string side_words(const SceneFile& file, const ConeReport::Side& side);

} // namespace lcpush::desktop
