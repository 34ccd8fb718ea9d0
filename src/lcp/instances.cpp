// The one compiled copy of the solvers, for double.
#include "lcpush/lcp/pivots/linear_program.hpp"
#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"

namespace lcpush {
template class DenseBasis<double>;
template class StructuredBasis<double>;
template class Lemke<double>;
template class Lemke<double, StructuredBasis<double>>;
template class LinearProgramSolver<double>;
template class ProximalNewton<double>;
template class BlockGaussSeidel<double>;
} // namespace lcpush
