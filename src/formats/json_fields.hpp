// Typed fields of a JSON object, with messages that say where and what.
#pragma once

#include "formats/json_reader.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/types.hpp"
#include "text/wording.hpp"

#include <optional>

namespace lcpush::desktop {

/// Fields of objects in `file`. All throw InputError if a value has the wrong type; what is not
/// there, or null, is empty.
class JsonFields {
public:
  explicit JsonFields(const std::string& file) : file_(file) {}

  std::string text(const JsonValue& object, const char* key) const {
    const auto* const text = find<std::string>(object, key, "a string");
    return text != nullptr ? *text : "";
  }
  std::optional<double> number(const JsonValue& object, const char* key) const {
    const auto* const number = find<double>(object, key, "a number");
    return number != nullptr ? std::optional(*number) : std::nullopt;
  }
  /// Exactly n numbers. If one of them is null nothing is known.
  template <int n>
  std::optional<Eigen::Matrix<double, n, 1>> vector(const JsonValue& object,
                                                    const char* key) const {
    const std::optional<std::vector<double>> list = numbers(object, key, n);
    if (!list) return std::nullopt;
    return Eigen::Matrix<double, n, 1>(Eigen::Map<const Eigen::Matrix<double, n, 1>>(list->data()));
  }
  /// An array of `count` numbers, of any number if `count` < 0; nothing if one of them is null.
  std::optional<std::vector<double>> numbers(const JsonValue& object, const char* key,
                                             Index count) const {
    const std::string what =
        "an array of " + (count < 0 ? "" : std::to_string(count) + " ") + "numbers";
    const auto* const array = find<JsonArray>(object, key, what);
    if (array == nullptr) return std::nullopt;
    const std::string wanted = quoted(key) + " must be " + what + ", got ";
    if (count >= 0 && static_cast<Index>(array->size()) != count)
      refuse(*object.find(key), wanted + std::to_string(array->size()));
    std::vector<double> list;
    bool known = true;
    for (const JsonValue& entry : *array) {
      if (entry.is_null()) {
        known = false;
        continue;
      }
      if (entry.as<double>() == nullptr) refuse(entry, wanted + entry.type() + " among them");
      list.push_back(*entry.as<double>());
    }
    return known ? std::optional(list) : std::nullopt;
  }
  /// An array of objects, or nullptr.
  const JsonArray* objects(const JsonValue& object, const char* key) const {
    const auto* const array = find<JsonArray>(object, key, "an array");
    if (array == nullptr) return nullptr;
    for (const JsonValue& entry : *array)
      if (entry.as<JsonObject>() == nullptr)
        refuse(entry, quoted(key) + " must hold objects, got " + entry.type());
    return array;
  }

  [[noreturn]] void refuse(const JsonValue& value, const std::string& message) const {
    throw InputError(file_, value.line, message);
  }

private:
  /// nullptr if it is not there; refuses another type than the one `wanted`.
  template <class T>
  const T* find(const JsonValue& object, const char* key, const std::string& wanted) const {
    const JsonValue* const value = object.find(key);
    if (value != nullptr && value->as<T>() == nullptr)
      refuse(*value, quoted(key) + " must be " + wanted + ", got " + value->type());
    return value != nullptr ? value->as<T>() : nullptr;
  }

  const std::string& file_;
};

} // namespace lcpush::desktop
