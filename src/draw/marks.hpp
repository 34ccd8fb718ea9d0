// The marks that pictures of grasps share, and the key that explains them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "draw/markup.hpp"

namespace lcpush::desktop {

enum class Mark { square, triangle, ring, small_ring, cross };

std::string mark_element(Mark mark, const std::string& kind, const Pixel& at);
/// Three quarters of a circle about `center` that end at its top with a head.
std::string turning_arc(const Pixel& center, bool is_clockwise);
/// The point that something turns about.
std::string turning_center(const Pixel& at);
/// A normal force along the line of sight: a cross where it points away from the viewer (its tail),
/// none where it comes from behind (its tip).
std::string sight_ring(const Pixel& at, bool is_behind);

/// Drawings with the words that explain them.
using KeyItems = std::vector<std::pair<std::string, std::string>>;
std::string key_html(const KeyItems& items);
/// A little drawing beside words that say the same.
std::string sample(const std::string& view_box, const std::string& elements);

} // namespace lcpush::desktop
