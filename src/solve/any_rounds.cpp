#include "solve/any_rounds.hpp"

namespace lcpush {

template Status solve_pressure(Assembly<double>&, const desktop::AnyRounds&,
                               const PressureMemory<double>&, const PressureOptions<double>&,
                               PressureRun&, const FrictionMemory<double>&);
template Status find_breaking(Assembly<double>&, desktop::AnyRounds, Workspace<double>&,
                              const Body<double>&, const PressureOptions<double>&,
                              Breaking<double>&, PressureRun&);

} // namespace lcpush
