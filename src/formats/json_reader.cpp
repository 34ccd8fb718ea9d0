#include "formats/json_reader.hpp"

#include "formats/read_number.hpp"
#include "formats/text_cursor.hpp"
#include "text/limits.hpp"
#include "text/utf8.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace lcpush::desktop {
namespace {

class JsonReader : TextCursor {
public:
  JsonReader(std::string_view text, const std::string& file) : TextCursor(text, file) {}

  JsonValue read_all() {
    JsonValue value = read_value(0);
    skip_blanks();
    if (!at_end()) fail("nothing may follow the JSON value, found " + next_shown());
    return value;
  }

private:
  std::string next_shown() const {
    return at_end() ? "the end of the file" : quoted(text_.substr(at_, 1));
  }
  void skip_blanks() {
    for (; !at_end() && std::strchr(" \t\r\n", text_[at_]) != nullptr && text_[at_] != '\0'; ++at_)
      if (text_[at_] == '\n') ++line_;
  }

  JsonValue read_value(int level) {
    if (level > limits::json_depth) fail("nested more than 100 levels deep");
    skip_blanks();
    JsonValue value;
    value.line = line_;
    if (peek() == '{')
      value.data = read_object(level);
    else if (peek() == '[')
      value.data = read_array(level);
    else if (peek() == '"')
      value.data = read_string();
    else if (take("true"))
      value.data = true;
    else if (take("false"))
      value.data = false;
    else if (take("null"))
      value.data = nullptr;
    else
      value.data = read_number();
    return value;
  }

  JsonArray read_array(int level) {
    JsonArray array;
    take("[");
    skip_blanks();
    if (take("]")) return array;
    do {
      array.push_back(read_value(level + 1));
      skip_blanks();
    } while (take(","));
    if (!take("]")) fail("expected , or ] in an array, found " + next_shown());
    return array;
  }

  JsonObject read_object(int level) {
    JsonObject object;
    take("{");
    skip_blanks();
    if (take("}")) return object;
    do {
      skip_blanks();
      if (peek() != '"') fail("expected a key in double quotes, found " + next_shown());
      std::string key = read_string();
      for (const auto& entry : object)
        if (entry.first == key) fail("key " + quoted(key) + " comes twice");
      skip_blanks();
      if (!take(":")) fail("expected : after key " + quoted(key) + ", found " + next_shown());
      object.emplace_back(std::move(key), read_value(level + 1));
      skip_blanks();
    } while (take(","));
    if (!take("}")) fail("expected , or } in an object, found " + next_shown());
    return object;
  }

  std::uint32_t read_hex() {
    if (const auto code = take_hexadecimal(4)) return *code;
    at_ = std::min(text_.find_first_not_of("0123456789abcdefABCDEF", at_), text_.size());
    fail("\\u takes four hexadecimal digits, found " + next_shown());
  }

  /// After \u: one code unit, or the two of a surrogate pair.
  std::uint32_t read_code_point() {
    const std::uint32_t first = read_hex();
    if (first < 0xD800 || first > 0xDFFF) return first;
    if (first > 0xDBFF || !take("\\u")) fail("half of a surrogate pair stands alone");
    const std::uint32_t second = read_hex();
    if (second < 0xDC00 || second > 0xDFFF) fail("half of a surrogate pair stands alone");
    return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
  }

  std::string read_string() {
    std::string text;
    take("\"");
    while (!take("\"")) {
      if (at_end()) fail("a string has no closing quote");
      if (static_cast<unsigned char>(peek()) < 0x20)
        fail("a string has a control character; write it as \\u00XX");
      if (!take("\\")) {
        text += text_[at_++];
        continue;
      }
      if (take("u"))
        append_utf8(text, read_code_point());
      else if (!take_escape("\"\\/bfnrt", "\"\\/\b\f\n\r\t", text))
        fail("unknown escape \\ before " + next_shown());
    }
    return text;
  }

  double read_number() {
    const std::string_view rest = text_.substr(at_);
    const auto [length, is_whole] = decimal_prefix(rest);
    at_ += length;
    for (const char* const word : {"NaN", "Infinity"})
      if (take(word)) fail(std::string(word) + " is no JSON; leave the number out, or write null");
    if (length == 0)
      fail("expected a value (an object, an array, a string, a number, true, false or null), "
           "found " +
           next_shown());
    if (!is_whole) fail("no JSON number: " + quoted(rest.substr(0, length + 1)));
    const NumberText number = read_finite_number(rest.substr(0, length));
    if (number.error) fail(*number.error);
    return number.value;
  }
};

} // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const JsonObject* const object = as<JsonObject>();
  if (object == nullptr) return nullptr;
  for (const auto& entry : *object)
    if (entry.first == key) return entry.second.is_null() ? nullptr : &entry.second;
  return nullptr;
}

const char* JsonValue::type() const {
  static const char* const names[] = {"null",     "true or false", "a number",
                                      "a string", "an array",      "an object"};
  return names[data.index()];
}

JsonValue parse_json(std::string_view text, const std::string& file_name) {
  return JsonReader(text, file_name).read_all();
}

} // namespace lcpush::desktop
