// A place in a text, for the parsers of JSON and TOML.
#pragma once

#include "lcpush/desktop/input_error.hpp"
#include "text/whole_number.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lcpush::desktop {

/// `file` only names the text in messages.
class TextCursor {
protected:
  TextCursor(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  [[noreturn]] void fail(const std::string& message) const { fail_at(line_, message); }
  [[noreturn]] void fail_at(int line, const std::string& message) const {
    throw InputError(file_, line, message);
  }

  bool at_end() const { return at_ == text_.size(); }
  /// NUL at the end; who allows NUL in the text has to ask at_end() too.
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  bool next_is(std::string_view word) const { return text_.substr(at_, word.size()) == word; }
  /// Goes past `word` if it comes next. It holds no line end.
  bool take(std::string_view word) {
    if (!next_is(word)) return false;
    at_ += word.size();
    return true;
  }
  /// Goes past a letter of an escape and appends what it means, the letter's place among `letters`.
  bool take_escape(std::string_view letters, std::string_view meanings, std::string& text) {
    const std::size_t which = at_end() ? std::string_view::npos : letters.find(text_[at_]);
    if (which == std::string_view::npos) return false;
    text += meanings[which];
    ++at_;
    return true;
  }
  /// Goes past exactly so many hexadecimal digits, at most 8.
  std::optional<std::uint32_t> take_hexadecimal(std::size_t digits) {
    const std::string_view word = text_.substr(at_, digits);
    const auto number = whole_number<std::uint32_t>(word, 16);
    if (word.size() != digits || !number) return std::nullopt;
    at_ += digits;
    return number;
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  int line_ = 1; ///< of at_
};

} // namespace lcpush::desktop
