#include "formats/json_fields.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {

void JsonFields::refuse(const JsonValue& value, const std::string& message) const {
  throw InputError(file_, value.line, message);
}

std::string JsonFields::text(const JsonValue& object, const char* key) const {
  const JsonValue* const value = object.find(key);
  if (value == nullptr) return {};
  if (value->as<std::string>() == nullptr)
    refuse(*value, quoted(key) + " must be a string, got " + value->type());
  return *value->as<std::string>();
}

std::optional<double> JsonFields::number(const JsonValue& object, const char* key) const {
  const JsonValue* const value = object.find(key);
  if (value == nullptr) return std::nullopt;
  if (value->as<double>() == nullptr)
    refuse(*value, quoted(key) + " must be a number, got " + value->type());
  return *value->as<double>();
}

std::optional<std::vector<double>> JsonFields::numbers(const JsonValue& object, const char* key,
                                                       Index count) const {
  const JsonValue* const value = object.find(key);
  if (value == nullptr) return std::nullopt;
  const std::string wanted = quoted(key) + " must be an array of " +
                             (count < 0 ? "" : std::to_string(count) + " ") + "numbers, got ";
  const JsonArray* const array = value->as<JsonArray>();
  if (array == nullptr) refuse(*value, wanted + value->type());
  if (count >= 0 && static_cast<Index>(array->size()) != count)
    refuse(*value, wanted + std::to_string(array->size()));
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
  const JsonValue* const value = object.find(key);
  if (value == nullptr) return nullptr;
  const JsonArray* const array = value->as<JsonArray>();
  if (array == nullptr) refuse(*value, quoted(key) + " must be an array, got " + value->type());
  for (const JsonValue& entry : *array)
    if (entry.as<JsonObject>() == nullptr)
      refuse(entry, quoted(key) + " must hold objects, got " + entry.type());
  return array;
}

} // namespace lcpush::desktop
