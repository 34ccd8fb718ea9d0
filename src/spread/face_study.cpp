#include "spread/face_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spread/settings.hpp"

namespace lcpush::desktop {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The answer to a push so small that no force has changed its sign: at rest, and what is added to
/// first order.
Face::Answer a_little_later(Face::Answer rest, const Face::Answer& added, Index closings) {
  rest.push = SpreadSettings::small_push;
  for (Index i = 0; i < rest.z.size() - closings; ++i)
    if (added.z[i] < 0) rest.push = std::min(rest.push, rest.z[i] / (-2 * added.z[i]));
  rest.z += rest.push * added.z;
  return rest;
}

} // namespace

Face::Answer between(const Face::Answer& rest, const Face::Answer& pushed, double share) {
  return {(1 - share) * rest.z + share * pushed.z, (1 - share) * rest.push + share * pushed.push};
}

FaceStudy::FaceStudy(LiteralProblem& problem, SpreadReport& report, bool breaking)
    : problem_(problem), report_(report), breaking_(breaking),
      quantities_(list_quantities(problem, report)) {
  if (!breaking || problem.moving() == 6) return;
  for (const Index axis : {2, 3, 4}) report.twist[axis].include(0); // planar: out of the question
}

void FaceStudy::take(const Face& face) {
  work_ += face.work();
  report_.programs += face.programs();
}

bool FaceStudy::may_have_answers(const FaceModes& part) {
  const ModeMotions motions = motions_of(problem_, part, true);
  ++report_.programs;
  if (!has_own_motion(motions, work_)) return false;
  if (breaking_) {
    Face::Answer pushed;
    bool failed = false;
    return reaches_down(part, motions, pushed, failed) || failed;
  }
  Face face(problem_, part, motions, Instant::pushed);
  const Face::Ending point = face.find_point();
  take(face);
  return point != Face::Ending::none;
}

/// Are there answers to arbitrarily small pushes, down to one at rest? Then, as the face is a
/// polyhedron in the answer and the push together, all its answers at rest are limits of such.
bool FaceStudy::reaches_down(const FaceModes& modes, const ModeMotions& motions,
                             Face::Answer& pushed, bool& failed) {
  Face rest(problem_, modes, motions, Instant::at_rest);
  const Face::Ending at_rest = rest.find_point();
  take(rest);
  if (at_rest == Face::Ending::none) return false;
  Face face(problem_, modes, motions, Instant::any_push);
  Face::Ending point = face.find_point();
  if (point == Face::Ending::found) point = face.largest_push(pushed);
  take(face);
  failed = at_rest == Face::Ending::failed || point == Face::Ending::failed;
  return !failed && point == Face::Ending::found && pushed.push > SpreadSettings::no_push;
}

bool FaceStudy::is_answer(Face::Answer answer) {
  problem_.complete(answer.push, answer.z);
  const auto& read = problem_.read(answer.z, answer.push);
  const Residuals<double> residuals = problem_.check(read, answer.push);
  if (!problem_.passes(residuals, answer.push)) return false;
  report_.residual = std::max(report_.residual, residuals.max());
  return true;
}

bool FaceStudy::accept(Face::Answer answer) {
  if (!is_answer(answer)) return false;
  const auto& read = problem_.read(answer.z, answer.push);
  (breaking_ ? include_forces : include)(read, problem_.scene(), report_);
  return true;
}

FaceStudy::Result FaceStudy::study(const FaceModes& modes, double most_work,
                                   std::vector<Face::Answer>& corners) {
  const ModeMotions motions = motions_of(problem_, modes);
  Face::Answer pushed;
  bool failed = false;
  if (breaking_ && !reaches_down(modes, motions, pushed, failed))
    return failed ? Result::failed : Result::empty;
  Face face(problem_, modes, motions, breaking_ ? Instant::at_rest : Instant::pushed);
  const Face::Ending point = face.find_point();
  Result result = Result::failed;
  if (point == Face::Ending::none) result = Result::empty;
  if (point == Face::Ending::found)
    result = bound_all(face, breaking_ ? &pushed : nullptr, most_work, corners);
  if (breaking_ && result == Result::studied && !bound_first_motion(face, motions))
    result = Result::failed;
  take(face);
  return result;
}

FaceStudy::Result FaceStudy::bound_all(Face& face, const Face::Answer* pushed, double most_work,
                                       std::vector<Face::Answer>& corners) {
  Result result = Result::studied;
  for (const Quantity& quantity : quantities_) {
    if (work_ + face.work() > most_work) return Result::out_of_work;
    if (breaking_ && quantity.is_motion) continue; // nothing moves at rest: see below
    for (const double sign : {1.0, -1.0})
      if (!bound(face, pushed, quantity, sign, corners)) result = Result::failed;
  }
  return result;
}

/// One end, if it lies beyond what is known. At rest its answer has to be one a little later too,
/// on the way to `pushed`.
bool FaceStudy::bound(Face& face, const Face::Answer* pushed, const Quantity& quantity, double sign,
                      std::vector<Face::Answer>& corners) {
  Face::Answer corner;
  const Face::Ending found = face.lowest(sign * quantity.f, corner);
  if (found == Face::Ending::failed || found == Face::Ending::none) return false;
  const Face::Answer answer =
      pushed != nullptr ? between(corner, *pushed, SpreadSettings::small_push) : corner;
  if (found == Face::Ending::found) corners.push_back(answer);
  double& end = sign > 0 ? quantity.bounds->low : quantity.bounds->high;
  // Only what widens the interval has to pass the referee.
  if (std::isinf(end) && sign * end < 0) return true;
  if (found == Face::Ending::found && sign * quantity.value(corner.z) >= sign * end) return true;
  if ((pushed != nullptr && !is_answer(answer)) || !accept(corner)) return false;
  if (found == Face::Ending::unbounded) end = -sign * infinity;
  return true;
}

/// The twists per unit push. Each is believed with an answer to a small push that has it.
bool FaceStudy::bound_first_motion(Face& rest, const ModeMotions& motions) {
  std::vector<bool> carries;
  if (!rest.find_inner_point(carries)) return false;
  Face first(rest, motions, carries);
  const bool has_point = first.find_point() == Face::Ending::found;
  bool all = has_point;
  for (Index k = 0; has_point && k < problem_.moving(); ++k)
    for (const double sign : {1.0, -1.0}) {
      Face::Answer added;
      const Face::Ending ending = first.slowest(k, sign, added);
      const Index axis = problem_.axis(k);
      if (ending == Face::Ending::unbounded) { // the object may also begin to move by itself
        (sign > 0 ? report_.twist[axis].low : report_.twist[axis].high) = -sign * infinity;
        continue;
      }
      if (ending != Face::Ending::found ||
          !is_answer(a_little_later(rest.inner_point(), added, problem_.actuators()))) {
        all = false;
        continue;
      }
      report_.twist[axis].include(first.motion(k) / (axis < 3 ? 1 : report_.scales.length));
    }
  take(first);
  return all;
}

} // namespace lcpush::desktop
