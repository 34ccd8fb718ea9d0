// Typed fields of a JSON object, with messages that say where and what.
#pragma once

#include "formats/json_reader.hpp"
#include "lcpush/types.hpp"

#include <optional>

namespace lcpush::desktop {

/// Fields of objects in `file`. All throw InputError if a value has the wrong type; what is not
/// there, or null, is empty.
class JsonFields {
public:
  explicit JsonFields(const std::string& file) : file_(file) {}

  std::string text(const JsonValue& object, const char* key) const;
  std::optional<double> number(const JsonValue& object, const char* key) const;
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
                                             Index count) const;
  /// An array of objects, or nullptr.
  const JsonArray* objects(const JsonValue& object, const char* key) const;

  [[noreturn]] void refuse(const JsonValue& value, const std::string& message) const;

private:
  /// nullptr if it is not there; refuses another type than the one `wanted`.
  template <class T>
  const T* find(const JsonValue& object, const char* key, const std::string& wanted) const;

  const std::string& file_;
};

} // namespace lcpush::desktop
