// Where the pads of a wide patch go, by Newton's method: a basis for pivots to begin at.
#pragma once

#include <vector>

#include "lcpush/lcp/problem.hpp"

namespace lcpush::desktop {

/// Newton's method (ProximalNewton) from the forces in z, ever stiffer, until who presses and who
/// slides whither stays, and until that is not for want of stiffness. `active` is 1 where z_i is
/// basic before and, if true is returned, at the end. Post: z is where it came. Pre:
/// ModesOfForces::fits.
bool settle_pads(const Problem<double>& problem, std::vector<double>& z,
                 std::vector<unsigned char>& active);

/// Terms of all sum groups together.
Index coupling_count(const Problem<double>& problem);

} // namespace lcpush::desktop
