// The one compiled copy of the core for float and double.
#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"

namespace lcpush {
template class Lemke<float>;
template class Lemke<double>;
template class Lemke<float, StructuredBasis<float>>;
template class Lemke<double, StructuredBasis<double>>;
template class ProximalNewton<float>;
template class ProximalNewton<double>;
template class BlockGaussSeidel<float>;
template class BlockGaussSeidel<double>;
} // namespace lcpush
