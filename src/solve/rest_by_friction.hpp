// A grasp at rest that needs no pivots: every finger presses as evenly as it may, and friction
// carries the load.
#pragma once

#include <vector>

#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush::desktop {

/// A force in the contact plane, along the first of g generators and across it, as shares beta >= 0
/// of the two that it lies between: no others have a smaller sum, which is returned.
double onto_neighbours(double along, double across, Index g, double* beta);

/// Unknowns of assembly.problem() at which nothing moves, if driven fingers alone hold the object:
/// each under its even share, friction as a slow motion of the object would spread it. `preload`:
/// the share of every point. None where that does not lie in the friction cones; another
/// distribution may. Cost: O(points).
std::vector<double> rest_by_friction(const Assembly<double>& assembly, const double* preload);

} // namespace lcpush::desktop
