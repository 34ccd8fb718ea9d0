// Parts of a motion that one word describes.
#pragma once

#include "lcpush/desktop/move.hpp"

namespace lcpush::desktop {

/// A step of h: what it did is `motion`, in words of the instant.
MotionPhase phase_of(const Motion<double>& motion, const MotionFrame& end, double h);

/// Neighbours of one kind become one; what is over at once, or moves the object by next to nothing
/// of `size`, goes to its neighbour.
std::vector<MotionPhase> merged_phases(std::vector<MotionPhase> phases, double size);

} // namespace lcpush::desktop
