// Samples of a sweep, each started from its neighbour's answer.
#pragma once

#include "sweep/sweep_pieces.hpp"

namespace lcpush::desktop {

/// Fills sweep.points; where the modes of two neighbours differ, more points down to
/// bisection_width of the range. With both_ways also sweep.points_back and sweep.bistable, unless
/// there are segments.
void sample_line(const VariedScene& scene, SweepSolver& solver,
                 const ParameterSweepOptions& options, Sweep& sweep);

/// Two parameters: rows of the second one, each from `from` to `to` of the first. With both_ways
/// each answer is compared with one from nothing, and marked where the object moves otherwise.
void sample_map(SweepSolver& solver, const ParameterSweepOptions& options, Sweep& sweep);

/// Fills sweep.zeros: of segments from their ends, of points by bisection, which adds the zero and
/// its neighbours to the points.
void find_zeros(SweepSolver& solver, Sweep& sweep);

/// Both answers at one value, and the bases that lead to the next.
struct Sample : OfBoth<DetailedAnswer> {
  double t = 0; ///< 0 to 1 over the range
  OfBoth<RoundBases> bases;
};
/// The answers to these questions at t of the only parameter, from a neighbour's bases or, without
/// one, from nothing.
Sample sample_at(SweepSolver& solver, double t, const Sample* neighbour,
                 const std::vector<Question>& asked = {Question::push, Question::breaking});
SweepPoint point_of(const Sample& sample, const Variation& variation);
/// The same, as one that lies between two of the steps.
SweepPoint refined_point(const Sample& sample, const Variation& variation);

} // namespace lcpush::desktop
