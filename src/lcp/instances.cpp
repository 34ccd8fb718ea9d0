// The one compiled copy of the solvers, for double.
#include "lcpush/lcp/cone_membership.hpp"
#include "lcpush/lcp/nonnegative_least_squares.hpp"
#include "lcpush/lcp/pivots/held_basis.hpp"
#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"

namespace lcpush {
template class NonnegativeLeastSquares<double>;
template struct ConeMembership<double>;
template class Dictionary<double>;
template class RatioTest<double>;
template class DenseBasis<double>;
template class StructuredBasis<double>;
template class HeldBasis<double>;
template class Lemke<double>;
template class Lemke<double, StructuredBasis<double>>;
template class ProximalNewton<double>;
template class BlockGaussSeidel<double>;
template void fill_matrix<double>(const Problem<double>&, MatrixMap<double>);
template void equilibrate<double>(MatrixMap<double>, VectorMap<double>, VectorMap<double>,
                                  VectorMap<double>);
template Vector6<double> contact_wrench<double>(const FactoredProblem<double>&, const double*);
namespace detail {
template void multiply_factored<double>(const FactoredProblem<double>&, Index, const double*,
                                        double*);
template void neighbour_sizes<true, double>(const Problem<double>&, const double*, const double*,
                                            const double&, double*, double*);
template void neighbour_sizes<false, double>(const Problem<double>&, const double*, const double*,
                                             const double&, double*, double*);
template void dense_rows<double>(const Problem<double>&, const double*, const double*, double*,
                                 double*);
template void factored_rows<double>(const Problem<double>&, const double*, const double*, double*,
                                    double*);
} // namespace detail
} // namespace lcpush
