#include "lcpush/host/pivots.hpp"

namespace lcpush::host {

std::string variable_name(Index variable, Index n) {
  if (variable == artificial(n)) return "z0";
  return variable < n ? "w" + std::to_string(variable + 1) : "z" + std::to_string(variable - n + 1);
}

std::string RawStory::meaning(Index variable) const {
  if (variable == artificial(n_)) return "artificial variable, times the cover d in every row";
  const std::string number = std::to_string((variable < n_ ? variable : variable - n_) + 1);
  return variable < n_ ? "slack of row " + number : "unknown " + number;
}

std::string RawStory::sentence(Index entering, Index leaving, const std::vector<bool>&) const {
  const std::string in = variable_name(entering, n_), out = variable_name(leaving, n_);
  if (entering == artificial(n_))
    return "z0 enters, just large enough to make every value >= 0; " + out + " needs it most.";
  if (leaving == artificial(n_))
    return "As " + in + " grows, z0 falls to zero first: this basis solves the problem.";
  return "As " + in + " grows, " + out + " falls to zero first; its complement " +
         variable_name(complement(leaving, n_), n_) + " enters next.";
}

std::string RawStory::ray_sentence(Index entering, const std::vector<double>&) const {
  return variable_name(entering, n_) +
         " may grow without end: nothing blocks, and z0 never reaches zero.";
}

} // namespace lcpush::host
