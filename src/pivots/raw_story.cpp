#include "lcpush/desktop/pivots.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {

std::string variable_name(Index variable, Index n) {
  if (variable == artificial(n)) return "z0";
  return variable < n ? "w" + std::to_string(variable + 1) : "z" + std::to_string(variable - n + 1);
}

std::string RawStory::meaning(Index variable) const {
  if (variable == artificial(n_)) return "artificial variable, times the cover d in every row";
  const std::string number = std::to_string((variable < n_ ? variable : variable - n_) + 1);
  return variable < n_ ? "slack of row " + number : "unknown " + number;
}

std::string RawStory::sentence(const TracedPivot& pivot, const std::vector<bool>&) const {
  const std::string in = variable_name(pivot.entering, n_), out = variable_name(pivot.leaving, n_);
  std::vector<std::string> tied;
  for (const Index variable : pivot.ties) tied.push_back(variable_name(variable, n_));
  if (pivot.entering == artificial(n_)) {
    const std::string enters = "z0 enters, just large enough to make every value >= 0; ";
    if (tied.empty()) return enters + out + " needs it most.";
    return enters + listed(tied, "and") + " need it most, and " + out + " leaves.";
  }
  std::string text = "As " + in + " grows, ";
  text += tied.empty() ? out + " falls to zero first"
                       : listed(tied, "and") + " fall to zero together, and " + out + " leaves";
  if (pivot.leaving == artificial(n_)) return text + ": this basis solves the problem.";
  return text + "; its complement " + variable_name(complement(pivot.leaving, n_), n_) +
         " enters next.";
}

std::string RawStory::ray_sentence(Index entering, const std::vector<double>&) const {
  return variable_name(entering, n_) +
         " may grow without end: nothing blocks, and z0 never reaches zero.";
}

} // namespace lcpush::desktop
