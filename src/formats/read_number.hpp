// Words and numbers of matrices, in files and on the command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lcpush::desktop {

class Rational;

/// The parts of `line` between blanks (space, tab, carriage return).
std::vector<std::string_view> split_words(std::string_view line);

/// ASCII letters only.
std::string lower_case(std::string_view word);

template <class S> struct NumberTextOf {
  S value{0};
  std::optional<std::string> error; ///< if set, `value` means nothing
};
using NumberText = NumberTextOf<double>;

/// The whole of `word` as a finite decimal number: the nearest double, or exactly (S = Rational).
template <class S = double> NumberTextOf<S> read_finite_number(std::string_view word);
template <> NumberText read_finite_number<double>(std::string_view word);
template <> NumberTextOf<Rational> read_finite_number<Rational>(std::string_view word);

/// How many characters at the beginning of `text` are a decimal number without leading zeros,
/// [-]digits[.digits][e[+-]digits]; `is_whole`: and nothing of one is missing there.
struct DecimalPrefix {
  std::size_t length;
  bool is_whole;
};
DecimalPrefix decimal_prefix(std::string_view text);

/// "inf" or "infinity", with a sign or without, in capitals or not.
std::optional<double> read_infinite(std::string_view word);

/// The same, and fractions of whole numbers such as 1/3.
template <class S = double> NumberTextOf<S> read_number_or_fraction(std::string_view word);

} // namespace lcpush::desktop
