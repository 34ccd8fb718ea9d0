#include "formats/read_number.hpp"

#include "lcpush/desktop/rational.hpp"
#include "text/wording.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

namespace lcpush::desktop {

std::vector<std::string_view> split_words(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t end = 0;;) {
    const std::size_t begin = line.find_first_not_of(blanks, end);
    if (begin == std::string_view::npos) return words;
    end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
  }
}

std::string lower_case(std::string_view word) {
  std::string result(word);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

namespace {

#if defined(__cpp_lib_to_chars)
std::from_chars_result read_digits(const char* begin, const char* end, double& value) {
  return std::from_chars(begin, end, value);
}
#else
// libc++ reads no doubles so far. strtod does, by the same rounding, but it also takes blanks,
// plus signs and hexadecimal digits.
std::from_chars_result read_digits(const char* begin, const char* end, double& value) {
  const std::string digits(begin, end);
  if (digits.empty() || digits.find_first_not_of("-.0123456789eEinfatyINFATY") == 0 ||
      digits.find_first_of("xX") != std::string::npos)
    return {begin, std::errc::invalid_argument};
  char* stopped = nullptr;
  value = std::strtod(digits.c_str(), &stopped);
  const bool leaves_range = std::isinf(value) && digits.find_first_of("iI") == std::string::npos;
  const auto read = stopped - digits.c_str();
  return {begin + read, read == 0      ? std::errc::invalid_argument
                        : leaves_range ? std::errc::result_out_of_range
                                       : std::errc()};
}
#endif

} // namespace

template <> NumberText read_finite_number<double>(std::string_view word) {
  std::string_view digits = word;
  // std::from_chars knows no plus sign; "+-1" must not pass for that reason.
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  NumberText number;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, outcome] = read_digits(digits.data(), end, number.value);
  if (outcome == std::errc::invalid_argument || stopped != end)
    number.error = quoted(word) + " is not a number; write it like 12, -0.5 or 1e-3";
  else if (outcome == std::errc::result_out_of_range)
    number.error = quoted(word) + " is too large or too small for a double";
  else if (!std::isfinite(number.value))
    number.error = quoted(word) + ": numbers must be finite";
  return number;
}

template <> NumberTextOf<Rational> read_finite_number<Rational>(std::string_view word) {
  NumberTextOf<Rational> number;
  const auto exact = Rational::parse(word);
  if (exact && word.find('/') == std::string_view::npos) {
    number.value = *exact; // beyond a double's range too
    return number;
  }
  number.error = read_finite_number<double>(word).error;
  if (!number.error) number.error = quoted(word) + " has too many digits or too large an exponent";
  return number;
}

DecimalPrefix decimal_prefix(std::string_view text) {
  std::size_t at = 0;
  const auto take = [&](std::string_view letters) {
    const bool is_next = at < text.size() && letters.find(text[at]) != std::string_view::npos;
    if (is_next) ++at;
    return is_next;
  };
  const auto digits = [&] {
    const std::size_t first = at;
    while (take("0123456789")) {
    }
    return at - first;
  };
  take("-");
  const bool begins_with_zero = text.substr(at, 1) == "0";
  const std::size_t whole = digits();
  if (whole == 0 || (whole > 1 && begins_with_zero)) return {at, false};
  if (take(".") && digits() == 0) return {at, false};
  if (!take("eE")) return {at, true};
  take("+-");
  const bool has_exponent = digits() > 0;
  return {at, has_exponent};
}

std::optional<double> read_infinite(std::string_view word) {
  const bool is_negative = !word.empty() && word[0] == '-';
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
  const std::string letters = lower_case(word);
  if (letters != "inf" && letters != "infinity") return std::nullopt;
  const double infinite = std::numeric_limits<double>::infinity();
  return is_negative ? -infinite : infinite;
}

template <class S> NumberTextOf<S> read_number_or_fraction(std::string_view word) {
  if (word.find('/') == std::string_view::npos) return read_finite_number<S>(word);
  NumberTextOf<S> number;
  const auto fraction = Rational::parse(word);
  if (!fraction || !std::isfinite(fraction->value()))
    number.error = quoted(word) + " is not a fraction; write two whole numbers like 1/3 or -2/7";
  else if constexpr (std::is_same_v<S, double>)
    number.value = fraction->value();
  else
    number.value = *fraction;
  return number;
}
template NumberText read_number_or_fraction<double>(std::string_view word);
template NumberTextOf<Rational> read_number_or_fraction<Rational>(std::string_view word);

} // namespace lcpush::desktop
