// The one compiled copy of the laws, for double.
#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "lcpush/mechanics/solve/step.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush {
template double circle_cosine<double>(Index, Index);
template Generator<double> generator<double>(const Body<double>&, Index, Index);
template class Assembly<double>;
template Status spread_evenly<double>(const Scene<double>&, const EvenMemory<double>&,
                                      Scene<double>&);
template void read_answer<double>(const Assembly<double>&, const double*, Answer<double>&, double,
                                  bool);
template Residuals<double> check<double>(const Scene<double>&, const Scales<double>&,
                                         const Answer<double>&, double);
template class TimeStepper<double, StructuredLemke<double>>;
namespace detail {
template struct TermSizes<double>;
template Workspace<double> take_common<double>(Arena&, const AssemblySize&);
} // namespace detail
} // namespace lcpush
