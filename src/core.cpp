// The one compiled copy of the core for float and double.
#include "lcpush/lcp/lemke.hpp"

namespace lcpush {
template class Lemke<float>;
template class Lemke<double>;
} // namespace lcpush
