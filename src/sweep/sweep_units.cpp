// A sweep in the units in which its ranges were typed.
#include "lcpush/desktop/sweep.hpp"

namespace lcpush::desktop {
namespace {

/// Of what has a range, every end.
template <class Ranges> void measure(Ranges& ranges, double size) {
  for (auto& range : ranges) {
    range.from /= size;
    range.to /= size;
  }
}

} // namespace

Sweep in_typed_units(Sweep sweep) {
  const double size = sweep.variations[0].parameter.typed_size;
  measure(sweep.segments, size);
  measure(sweep.back, size);
  measure(sweep.bistable, size);
  measure(sweep.zeros, size);
  if (sweep.open) sweep.open->value /= size;
  for (auto* const points : {&sweep.points, &sweep.points_back})
    for (SweepPoint& point : *points) {
      point.value /= size;
      if (point.second) *point.second /= sweep.variations[1].parameter.typed_size;
    }
  for (Variation& variation : sweep.variations) {
    Parameter& parameter = variation.parameter;
    variation.from /= parameter.typed_size;
    variation.to /= parameter.typed_size;
    if (!parameter.typed_unit.empty()) parameter.unit = parameter.typed_unit;
    parameter.typed_size = 1;
  }
  return sweep;
}

} // namespace lcpush::desktop
