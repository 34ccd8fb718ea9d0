// Is it proved, before any pivot, that there is no answer? A squeeze by normal forces alone.
#pragma once

#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush::desktop {

/// Normal forces that balance, that no actuator feels and that the prescribed motions tighten by
/// far more than the referee lets pass: then the literal laws have no answer (theory 5), whatever
/// the forces, the loads and the pushes' size. False: not known.
bool is_proven_jam(const Assembly<double>& assembly);

} // namespace lcpush::desktop
