// The numbers of TOML 1.0 that lcpush reads.
#include "formats/read_number.hpp"
#include "formats/toml.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// `word` without a plus sign and without single underscores between digits.
std::string plain_number(std::string_view word) {
  const auto is_digit = [word](std::size_t i) {
    return i < word.size() && word[i] >= '0' && word[i] <= '9';
  };
  std::string plain;
  for (std::size_t i = word.substr(0, 1) == "+" ? 1 : 0; i < word.size(); ++i)
    if (word[i] != '_' || !is_digit(i - 1) || !is_digit(i + 1)) plain += word[i];
  return plain;
}

std::string why_not_a_number(std::string_view word) {
  std::string_view digits = word;
  if (digits[0] == '+' || digits[0] == '-') digits.remove_prefix(1);
  const std::string_view prefix = digits.substr(0, 2);
  if (prefix == "0x" || prefix == "0o" || prefix == "0b")
    return quoted(word) + ": only decimal numbers are supported";
  if (digits == "inf" || digits == "nan") return quoted(word) + ": numbers must be finite";
  if (digits.find_first_of("0123456789") != 0 && prefix.substr(0, 1) != ".")
    return quoted(word) + " is not a value" +
           (word[0] == '('
                ? "; a list has [square brackets]"
                : suggestion(word, {"true", "false"}) + "; a text needs \"double quotes\"");
  if (digits.find(':') != std::string_view::npos ||
      (digits.size() > 4 && digits[4] == '-' && digits.find('e') == std::string_view::npos))
    return quoted(word) + ": dates and times are not supported";
  return quoted(word) + " is not a decimal number; write it like 12, -0.5 or 1e-3 (no leading " +
         "zeros, digits on both sides of the point, single _ between digits)";
}

} // namespace

std::optional<std::string> read_toml_number(std::string_view word, TomlValue& value) {
  std::string plain = plain_number(word);
  const auto [length, is_whole] = decimal_prefix(plain);
  if (!is_whole || length != plain.size() || word.substr(0, 2) == "+-")
    return why_not_a_number(word);
  value.digits = std::move(plain);
  if (value.digits.find_first_of(".eE") == std::string::npos) {
    const auto whole = whole_number<std::int64_t>(value.digits);
    if (!whole) return quoted(word) + " does not fit in 64 bits; write it as a real, like 1e20";
    value.data = *whole;
    return std::nullopt;
  }
  const NumberText real = read_finite_number(value.digits);
  if (real.error) return quoted(word) + " is too large or too small for a double";
  value.data = real.value;
  return std::nullopt;
}

} // namespace lcpush::desktop
