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
  not_settled,         ///< rounds of round friction came to no end: see Reason
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
  case Status::not_settled: return "not_settled";
  case Status::numerical_breakdown: return "numerical_breakdown";
  case Status::bad_input: return "bad_input";
  }
  return "unknown";
}

/// Why a run did not end in a solution, beyond its Status.
enum class Reason {
  none,
  memory_too_small,    ///< bad_input: see lemke_scalars and lemke_integers; numerical_breakdown:
                       ///< the structured basis holds no more exchanges
  unsupported_problem, ///< bad_input: a dense matrix, or a tie rule, for the structured basis
  unsupported,    ///< bad_input: a pressure law or contact model that the scene's patches exclude
  not_finite,     ///< bad_input: a number of M or q is NaN or infinite
  residual,       ///< numerical_breakdown: the answer reached fails its residual check
  false_ray,      ///< numerical_breakdown: the ray reached fails its certificate
  singular_basis, ///< numerical_breakdown: the basis cannot be factored
  small_load,     ///< numerical_breakdown: a row is right beside the largest force, but not by its
                  ///< own terms
  retreat,        ///< a free unknown ended at its symbolic bound -S: it runs away
  unsettled,      ///< numerical_breakdown: the pads' pressures settle in no number of rounds
  turning,        ///< not_settled: slips turn from round to round, and friction with them
  leap,           ///< numerical_breakdown: a time step leads too far to be one
  pull,           ///< numerical_breakdown: the breaking force comes out below zero
};

/// The reason as a sentence for people.
constexpr const char* reason_text(Reason reason) {
  switch (reason) {
  case Reason::none: return "";
  case Reason::memory_too_small: return "the solver's memory is too small for this problem";
  case Reason::unsupported_problem:
    return "the structured basis takes factored problems and generic tie columns only";
  case Reason::unsupported:
    return "a soft contact of several points, or even pressure that was not spread over its points";
  case Reason::not_finite: return "a number of M or q is not finite, or overflows when scaled";
  case Reason::residual: return "an answer was reached but fails the residual check";
  case Reason::small_load:
    return "a small load cannot be told from rounding beside the largest force";
  case Reason::false_ray: return "nothing blocks, yet the ray fails its certificate";
  case Reason::singular_basis: return "a basis is singular to working precision";
  case Reason::retreat: return "a free unknown runs off to minus infinity";
  case Reason::unsettled: return "the pads' pressures do not settle";
  case Reason::turning: return "round friction does not settle: slips turn from round to round";
  case Reason::leap: return "a time step leads too far to be one: take a shorter one";
  case Reason::pull: return "the grasp is too near a fall to tell the force that breaks it";
  }
  return "";
}

} // namespace lcpush
