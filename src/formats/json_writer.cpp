#include "formats/json_writer.hpp"

#include "text/utf8.hpp"
#include "text/wording.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr std::size_t line_width = 100;
constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

std::string escaped(char c) {
  constexpr std::string_view named = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt";
  if (const std::size_t k = named.find(c); k != std::string_view::npos) return {'\\', letters[k]};
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20) return {c};
  constexpr std::string_view digits = "0123456789abcdef";
  return {'\\', 'u', '0', '0', digits[byte >> 4U], digits[byte & 15U]};
}

} // namespace

std::string JsonWriter::literal(double number) {
  if (!std::isfinite(number)) return "null";
  // Python and others read -0 as the whole number 0, which has no sign.
  if (number == 0 && std::signbit(number)) return "-0.0";
  return shown(number);
}

std::string JsonWriter::literal(std::string_view text) {
  std::string result = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0)
      result += replacement_character;
    else if (length == 1)
      result += escaped(text[0]);
    else
      result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result + '"';
}

JsonWriter& JsonWriter::key(std::string_view name) {
  start_value();
  text_ += literal(name) + ": ";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::scalar(const std::string& literal) {
  start_value();
  text_ += literal;
  end_value();
  return *this;
}

JsonWriter& JsonWriter::scalars(const std::vector<std::string>& literals) {
  start_value();
  std::size_t length = 1; // brackets, separators, and a comma after it all
  for (const std::string& literal : literals) length += literal.size() + 2;
  const bool fits = column() + length <= line_width;

  text_ += '[';
  ++depth_;
  if (!fits) new_line();
  std::size_t at = column();
  for (std::size_t i = 0; i < literals.size(); ++i) {
    const bool is_last = i + 1 == literals.size();
    text_ += literals[i];
    at += literals[i].size();
    if (is_last) break;
    text_ += ',';
    if (!fits && at + literals[i + 1].size() + 3 > line_width) {
      new_line();
      at = 2 * depth_;
    } else {
      text_ += ' ';
      at += 2;
    }
  }
  --depth_;
  if (!fits) new_line();
  text_ += ']';
  end_value();
  return *this;
}

JsonWriter& JsonWriter::open(char bracket) {
  start_value();
  text_ += bracket;
  ++depth_;
  is_first_ = true;
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  --depth_;
  if (!is_first_) new_line();
  text_ += bracket;
  end_value();
  return *this;
}

void JsonWriter::start_value() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (depth_ == 0) return;
  if (!is_first_) text_ += ',';
  new_line();
  is_first_ = false;
}

void JsonWriter::end_value() {
  is_first_ = false;
  if (depth_ == 0) text_ += '\n';
}

void JsonWriter::new_line() { text_.append(1, '\n').append(2 * depth_, ' '); }

std::size_t JsonWriter::column() const {
  const std::size_t newline = text_.rfind('\n');
  return newline == std::string::npos ? text_.size() : text_.size() - newline - 1;
}

} // namespace lcpush::desktop
