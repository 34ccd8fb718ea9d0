// The numbers of TOML 1.0 that lcpush reads.
#include "formats/read_number.hpp"
#include "formats/toml.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The grammar check: copies a number without its plus sign and underscores.
class NumberScanner {
public:
  explicit NumberScanner(std::string_view word) : word_(word) {}

  /// True if the whole word is a number as TOML writes them.
  bool scan() {
    take_sign();
    const std::size_t first = at_;
    if (!take_digits()) return false;
    if (word_[first] == '0' && at_ - first > 1) return false;
    if (next_is('.') && !(take() && take_digits())) return false;
    if (next_is('e') || next_is('E')) {
      take();
      take_sign();
      if (!take_digits()) return false;
    }
    return at_ == word_.size();
  }

  const std::string& plain() const { return plain_; }

private:
  bool next_is(char c) const { return at_ < word_.size() && word_[at_] == c; }
  bool take() {
    plain_ += word_[at_++];
    return true;
  }
  void take_sign() {
    if (next_is('+')) {
      ++at_;
    } else if (next_is('-')) {
      take();
    }
  }
  bool digit_at(std::size_t i) const { return i < word_.size() && is_digit(word_[i]); }
  bool take_digits() {
    if (!digit_at(at_)) return false;
    for (;;) {
      while (digit_at(at_)) take();
      if (!next_is('_') || !digit_at(at_ + 1)) return true;
      ++at_;
    }
  }

  std::string_view word_;
  std::size_t at_ = 0;
  std::string plain_;
};

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
  NumberScanner scanner(word);
  if (!scanner.scan()) return why_not_a_number(word);
  value.digits = scanner.plain();
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
