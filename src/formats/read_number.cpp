#include "formats/read_number.hpp"

#include "lcpush/desktop/rational.hpp"
#include "text/wording.hpp"

#include <charconv>
#include <cmath>
#include <limits>
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

template <> NumberText read_finite_number<double>(std::string_view word) {
  std::string_view digits = word;
  // std::from_chars knows no plus sign; "+-1" must not pass for that reason.
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  NumberText number;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, outcome] = std::from_chars(digits.data(), end, number.value);
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

std::optional<double> read_infinite(std::string_view word) {
  const bool is_negative = !word.empty() && word[0] == '-';
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
  std::string letters(word);
  for (char& c : letters)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
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
