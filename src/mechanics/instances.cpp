// The one compiled copy of the laws, for double.
#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/model/even_pressure.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"

namespace lcpush {
template double circle_cosine<double>(Index, Index);
template Generator<double> generator<double>(const Body<double>&, Index, Index);
template class Assembly<double>;
template Status spread_evenly<double>(const Scene<double>&, const EvenMemory<double>&,
                                      Scene<double>&);
template void read_answer<double>(const Assembly<double>&, const double*, Answer<double>&, double,
                                  bool);
template Vector6<double> body_wrench<double>(const Scene<double>&, const Answer<double>&,
                                             const Body<double>&);
template Residuals<double> check<double>(const Scene<double>&, const Scales<double>&,
                                         const Answer<double>&, double);
template Status read_breaking<double>(Assembly<double>&, const double*, const double*,
                                      const double&, Workspace<double>&, const Body<double>&,
                                      double, Breaking<double>&, PressureRun&);
namespace detail {
template Workspace<double> take_common<double>(Arena&, const AssemblySize&);
template Breaking<double> extrapolate<double>(const SmallPush<double>*, double,
                                              const Scales<double>&);
} // namespace detail
} // namespace lcpush
