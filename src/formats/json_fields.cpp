#include "formats/json_fields.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {

void JsonFields::refuse(const JsonValue& value, const std::string& message) const {
  throw InputError(file_, value.line, message);
}

template <class T>
const T* JsonFields::find(const JsonValue& object, const char* key,
                          const std::string& wanted) const {
  const JsonValue* const value = object.find(key);
  if (value != nullptr && value->as<T>() == nullptr)
    refuse(*value, quoted(key) + " must be " + wanted + ", got " + value->type());
  return value != nullptr ? value->as<T>() : nullptr;
}

std::string JsonFields::text(const JsonValue& object, const char* key) const {
  const auto* const text = find<std::string>(object, key, "a string");
  return text != nullptr ? *text : "";
}

std::optional<double> JsonFields::number(const JsonValue& object, const char* key) const {
  const auto* const number = find<double>(object, key, "a number");
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

std::optional<std::vector<double>> JsonFields::numbers(const JsonValue& object, const char* key,
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

const JsonArray* JsonFields::objects(const JsonValue& object, const char* key) const {
  const auto* const array = find<JsonArray>(object, key, "an array");
  if (array == nullptr) return nullptr;
  for (const JsonValue& entry : *array)
    if (entry.as<JsonObject>() == nullptr)
      refuse(entry, quoted(key) + " must hold objects, got " + entry.type());
  return array;
}

} // namespace lcpush::desktop
