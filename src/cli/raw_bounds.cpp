#include "cli/raw_bounds.hpp"

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <cmath>
#include <limits>

namespace lcpush::cli {
namespace {

/// A list of an option, and how messages name it.
struct OptionList {
  std::vector<double> numbers;
  std::string where;
};

/// "0 1 inf": numbers by blanks or commas. Nothing if a word is no number: it names a file then.
std::optional<std::vector<double>> typed_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string_view part : split_at(text, ','))
    for (const std::string_view word : split_words(part)) {
      if (const auto infinite = read_infinite(word)) {
        numbers.push_back(*infinite);
        continue;
      }
      const NumberText number = read_finite_number(word);
      if (number.error) return std::nullopt;
      numbers.push_back(number.value);
    }
  return numbers.empty() ? std::nullopt : std::optional(numbers);
}

/// n numbers of an option: a file's, or typed ones, of which one may stand for all.
OptionList read_list(const Arguments& arguments, const std::string& option, Index n,
                     double otherwise) {
  const auto count = static_cast<std::size_t>(n);
  OptionList list{std::vector<double>(count, otherwise), option};
  const auto text = arguments.value(option);
  if (!text) return list;
  std::optional<std::vector<double>> numbers = typed_numbers(*text);
  if (!numbers) {
    const HostMatrix file = read_matrix_market(*text, Entries::bounds);
    list.where = *text;
    if (file.cols != 1 && file.rows != 1)
      throw InputError(*text + ": " + option + " must be " + std::to_string(n) +
                       " x 1, but it is " + std::to_string(file.rows) + " x " +
                       std::to_string(file.cols));
    numbers = file.values;
  } else if (numbers->size() == 1) {
    numbers->assign(count, numbers->front());
  }
  if (numbers->size() != count)
    throw InputError(list.where + ": " + option + " has " + std::to_string(numbers->size()) +
                     " numbers, M has " + std::to_string(n) + " rows");
  list.numbers = *numbers;
  return list;
}

std::string row_name(std::size_t i) { return "row " + std::to_string(i + 1); }

/// -1 or a row from 0, another one.
std::vector<Index> read_followed(const OptionList& list, Index n) {
  std::vector<Index> follows;
  for (std::size_t i = 0; i < list.numbers.size(); ++i) {
    const double number = list.numbers[i];
    if (!(number >= -1 && number < static_cast<double>(n)) || number != std::floor(number))
      throw InputError(list.where + ": " + row_name(i) + " follows " + shown(number) +
                       "; give -1, or a row counted from 0, up to " + std::to_string(n - 1));
    if (number == static_cast<double>(i))
      throw InputError(list.where + ": " + row_name(i) + " follows itself (rows count from 0)");
    follows.push_back(static_cast<Index>(number));
  }
  return follows;
}

void check_leader(const RawBounds& bounds, const OptionList& hi, const OptionList& findex,
                  std::size_t i) {
  const double friction = bounds.hi[i];
  if (!(friction >= 0 && std::isfinite(friction)))
    throw InputError(hi.where + ": " + row_name(i) + " follows another row: its --hi is the " +
                     "friction, a finite number >= 0, not " + shown(friction));
  const auto leader = static_cast<std::size_t>(bounds.follows[i]);
  const std::string what = findex.where + ": " + row_name(i) + " follows " + row_name(leader) +
                           " (from 0: " + std::to_string(leader) + "), ";
  if (bounds.follows[leader] >= 0)
    throw InputError(what + "which follows a row itself; name one with ends of its own");
  if (!(bounds.lo[leader] >= 0))
    throw InputError(what + "which may be negative; its --lo must be >= 0");
}

} // namespace

RawBounds read_bounds(const Arguments& arguments, Index n) {
  RawBounds bounds;
  const bool follows = arguments.has("--findex");
  if (!arguments.has("--lo") && !arguments.has("--hi") && !follows) return bounds;
  if (arguments.has("--free"))
    throw UsageError("--free goes without --lo, --hi and --findex: a free unknown has the ends "
                     "-inf and inf");
  if (follows && !arguments.has("--hi"))
    throw UsageError("--findex needs --hi, which holds the friction of the rows it names");
  const OptionList lo = read_list(arguments, "--lo", n, 0.0);
  const OptionList hi = read_list(arguments, "--hi", n, std::numeric_limits<double>::infinity());
  const OptionList findex = read_list(arguments, "--findex", n, -1.0);
  bounds.lo = lo.numbers;
  bounds.hi = hi.numbers;
  bounds.follows = read_followed(findex, n);
  for (std::size_t i = 0; i < bounds.lo.size(); ++i) {
    if (bounds.follows[i] >= 0) {
      check_leader(bounds, hi, findex, i);
      continue;
    }
    if (!(bounds.lo[i] <= bounds.hi[i]))
      throw InputError(lo.where + ": " + row_name(i) + ": the lower end " + shown(bounds.lo[i]) +
                       " is above the upper end " + shown(bounds.hi[i]));
    if (bounds.lo[i] == bounds.hi[i] && !std::isfinite(bounds.lo[i]))
      throw InputError(lo.where + ": " + row_name(i) + ": both ends are " + shown(bounds.lo[i]));
  }
  return bounds;
}

} // namespace lcpush::cli
