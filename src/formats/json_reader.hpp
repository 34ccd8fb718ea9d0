// lcpush: reads JSON (RFC 8259) into a tree that knows its lines.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lcpush::desktop {

struct JsonValue;
using JsonArray = std::vector<JsonValue>;
using JsonObject = std::vector<std::pair<std::string, JsonValue>>;

struct JsonValue {
  int line = 1; ///< where the value starts, from 1
  std::variant<std::nullptr_t, bool, double, std::string, JsonArray, JsonObject> data = nullptr;

  bool is_null() const { return std::holds_alternative<std::nullptr_t>(data); }
  /// The value of this type, or nullptr.
  template <class T> const T* as() const { return std::get_if<T>(&data); }
  /// The value of `key` if this is an object that has it and it is not null; otherwise nullptr.
  const JsonValue* find(std::string_view key) const;
  /// "a number", "an array", ...
  const char* type() const;
};

/// Reads `text`; `file_name` only names it in messages. Throws InputError with file and line on
/// anything that is no JSON, on a key that an object has twice, on numbers beyond a double and on
/// more than 100 levels.
JsonValue parse_json(std::string_view text, const std::string& file_name);

} // namespace lcpush::desktop
