// How much a report tells.
#pragma once

namespace lcpush::desktop {

enum class Telling {
  brief, ///< a sentence and a table, three digits, what to look out for
  full,  ///< also every fact with all digits, the theory, and how the answer was found
};

} // namespace lcpush::desktop
