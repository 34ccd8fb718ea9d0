// Samples of a sweep, each started from its neighbour's answer.
#pragma once

#include "sweep_solver.hpp"

namespace lcpush::host {

/// Fills sweep.points; where the modes of two neighbours differ, more points down to 1e-6 of the
/// range. With both_ways also sweep.points_back and sweep.bistable, unless there are segments.
void sample_line(const VariedScene& scene, SweepSolver& solver,
                 const ParameterSweepOptions& options, Sweep& sweep);

/// Two parameters: rows of the second one, each from `from` to `to` of the first.
void sample_map(SweepSolver& solver, const ParameterSweepOptions& options, Sweep& sweep);

/// One answer to both questions.
SweepValue merged(const Outputs* push, const Outputs* breaking);

} // namespace lcpush::host
