// lcpush: writes JSON (RFC 8259), one value after the other.
//
//   JsonWriter json;
//   json.begin_object().member("status", "solved").key("z").numbers(z);
//   json.key("object").begin_object().member("mass", 0.2).end_object().end_object();
//   std::cout << json.text();
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lcpush::desktop {

/// Preconditions, not checked: every begin has its end, every value of an object its key.
class JsonWriter {
public:
  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }

  /// The key of the next value. Keys and strings may hold anything: what is no UTF-8 becomes
  /// U+FFFD.
  JsonWriter& key(std::string_view name);

  /// A bool, a number, a string, nullptr, or an optional of one of these (empty: null).
  /// Numbers read back as the same double; those that are not finite become null.
  template <class T> JsonWriter& value(const T& data) { return scalar(literal(data)); }

  /// key() and value().
  template <class T> JsonWriter& member(std::string_view name, const T& data) {
    return key(name).value(data);
  }

  /// An array of scalars, on one line if it fits.
  JsonWriter& numbers(const double* first, std::ptrdiff_t count);
  JsonWriter& strings(const std::vector<std::string>& texts);

  /// The same for a contiguous vector of doubles (std::vector, an Eigen vector or map).
  template <class Vector> JsonWriter& numbers(const Vector& vector) {
    return numbers(vector.data(), static_cast<std::ptrdiff_t>(vector.size()));
  }

  /// What was written so far; after the last end, the whole text with its final newline.
  const std::string& text() const { return text_; }

private:
  static std::string literal(double number);
  static std::string literal(std::string_view text);
  static std::string literal(const std::string& text) { return literal(std::string_view(text)); }
  static std::string literal(const char* text) { return literal(std::string_view(text)); }
  static std::string literal(std::nullptr_t) { return "null"; }
  template <class T> static std::string literal(const std::optional<T>& data) {
    return data ? literal(*data) : "null";
  }
  // A template, so that no pointer can turn into a bool.
  template <class T> static std::enable_if_t<std::is_integral_v<T>, std::string> literal(T number) {
    if constexpr (std::is_same_v<T, bool>)
      return number ? "true" : "false";
    else
      return std::to_string(number);
  }

  JsonWriter& scalar(const std::string& literal);
  JsonWriter& scalars(const std::vector<std::string>& literals);
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  void start_value();
  void end_value();
  void new_line();
  std::size_t column() const;

  std::string text_;
  std::size_t depth_ = 0;
  bool is_first_ = true; ///< of its object or array
  bool after_key_ = false;
};

} // namespace lcpush::desktop
