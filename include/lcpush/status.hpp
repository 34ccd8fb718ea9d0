// How a run ended. Every function that can fail says so with one of these, never with a bare bool.
#pragma once

namespace lcpush {

enum class Status {
  running,             ///< not finished: call step() again
  solved,              ///< an answer was found and passed the residual check
  does_not_hold,       ///< `break`: the object moves before it is pushed
  ray,                 ///< Lemke ended on a secondary ray; the ray is a verified certificate
  pivot_limit,         ///< the allowed number of pivots was used up
  sweep_limit,         ///< the allowed number of Gauss-Seidel sweeps was used up
  stagnated,           ///< Gauss-Seidel makes no more progress
  numerical_breakdown, ///< an answer or a ray was reached, but it fails its check
  bad_input,           ///< sizes or numbers that do not describe a problem
};

/// The status as `--json` and the C interface print it.
constexpr const char* status_text(Status status) {
  switch (status) {
  case Status::running: return "running";
  case Status::solved: return "solved";
  case Status::does_not_hold: return "does_not_hold";
  case Status::ray: return "ray";
  case Status::pivot_limit: return "pivot_limit";
  case Status::sweep_limit: return "sweep_limit";
  case Status::stagnated: return "stagnated";
  case Status::numerical_breakdown: return "numerical_breakdown";
  case Status::bad_input: return "bad_input";
  }
  return "unknown";
}

} // namespace lcpush
