// What the final basis says about uniqueness: are there other answers next to this one?
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush::desktop {

/// How every contact of an answer behaves fixes a system of linear equations. If no contact is
/// between two modes, the answers nearby are exactly its solutions.
struct FinalBasis {
  bool studied = false;
  Index tied_contacts = 0;  ///< between two modes: at the limit of both
  bool motion_open = false; ///< a direction of the system changes the object's acceleration
  bool wrench_open = false; ///< one changes the pushers' total wrench

  /// No other motion nearby: proved, where no contact is between two modes.
  bool motion_isolated() const { return studied && tied_contacts == 0 && !motion_open; }
  bool wrench_isolated() const { return studied && tied_contacts == 0 && !wrench_open; }
};

/// [T.9] Studies `answer` of assembly.problem() with the compliances of its last round, in the
/// limit of stiff pads. Cost: O(points (6 + actuators)^2).
FinalBasis study_final_basis(const Assembly<double>& assembly, const Answer<double>& answer);

} // namespace lcpush::desktop
