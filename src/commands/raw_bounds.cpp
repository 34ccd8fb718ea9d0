// The box of a raw problem: lo, hi and findex.
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <cmath>

namespace lcpush::commands {
namespace {

/// -1 or a row from 0, another one.
Index followed(const Values& values, const NumberList& list, Index i) {
  const auto n = static_cast<Index>(list.numbers.size());
  const double number = list.numbers[static_cast<std::size_t>(i)];
  const std::string row = list.name + ": " + values.row_name(i) + " follows ";
  if (!(number >= -1 && number < static_cast<double>(n)) || number != std::floor(number))
    throw InputError(row + shown(number) + "; give -1, or a row counted from 0, up to " +
                     std::to_string(n - 1));
  if (number == static_cast<double>(i)) throw InputError(row + "itself (rows count from 0)");
  return static_cast<Index>(number);
}

void check_leader(const Values& values, const RawBounds& bounds, const NumberList& hi,
                  const NumberList& findex, Index i) {
  const double friction = bounds.hi[static_cast<std::size_t>(i)];
  if (!(friction >= 0 && std::isfinite(friction)))
    throw InputError(hi.name + ": " + values.row_name(i) + " follows another row: its " +
                     values.label("hi") + " is the friction, a finite number >= 0, not " +
                     shown(friction));
  const auto leader = static_cast<std::size_t>(bounds.follows[static_cast<std::size_t>(i)]);
  const std::string what = findex.name + ": " + values.row_name(i) + " follows " +
                           values.row_name(static_cast<Index>(leader)) +
                           " (from 0: " + std::to_string(leader) + "), ";
  if (bounds.follows[leader] >= 0)
    throw InputError(what + "which follows a row itself; name one with ends of its own");
  if (!(bounds.lo[leader] >= 0))
    throw InputError(what + "which may be negative; its " + values.label("lo") + " must be >= 0");
}

/// Other programs write 1e20 or 1e30 where there is no end. How many are taken so.
Index make_infinite(std::vector<double>& ends) {
  Index count = 0;
  for (double& end : ends) {
    if (!std::isfinite(end) || std::abs(end) < infinite_end) continue;
    end = std::copysign(std::numeric_limits<double>::infinity(), end);
    ++count;
  }
  return count;
}

} // namespace

void announce_infinite(const RawProblem& problem, Listener& listener) {
  if (problem.bounds.huge > 0)
    listener.announce(std::to_string(problem.bounds.huge) + " of the ends " +
                      (problem.bounds.huge == 1 ? "is" : "are") + " " + shown(infinite_end) +
                      " or more in size, and taken as infinite");
}

RawBounds Values::bounds(Index n) const {
  RawBounds bounds;
  if (!has("lo") && !has("hi") && !has("findex")) return bounds;
  if (has("free"))
    refuse("free", label("free") + " goes without " + label("lo") + ", " + label("hi") + " and " +
                       label("findex") + ": a free unknown has the ends -inf and inf");
  if (has("findex") && !has("hi"))
    refuse("findex", label("findex") + " needs " + label("hi") +
                         ", which holds the friction of the rows it names");
  const auto given = [&](const char* option, double otherwise) {
    return list(option, n).value_or(
        NumberList{std::vector<double>(static_cast<std::size_t>(n), otherwise), label(option)});
  };
  const NumberList lo = given("lo", 0), hi = given("hi", std::numeric_limits<double>::infinity()),
                   findex = given("findex", -1);
  bounds.lo = lo.numbers;
  bounds.hi = hi.numbers;
  bounds.huge = make_infinite(bounds.lo) + make_infinite(bounds.hi);
  for (Index i = 0; i < n; ++i) bounds.follows.push_back(followed(*this, findex, i));
  for (Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (bounds.follows[at] >= 0) {
      check_leader(*this, bounds, hi, findex, i);
      continue;
    }
    const std::string row = lo.name + ": " + row_name(i) + ": ";
    if (!(bounds.lo[at] <= bounds.hi[at]))
      throw InputError(row + "the lower end " + shown(bounds.lo[at]) + " is above the upper end " +
                       shown(bounds.hi[at]));
    if (bounds.lo[at] == bounds.hi[at] && !std::isfinite(bounds.lo[at]))
      throw InputError(row + "both ends are " + shown(bounds.lo[at]));
  }
  return bounds;
}

} // namespace lcpush::commands
