// lcpush: writes JSON (RFC 8259), one value after the other.
//
//   JsonWriter json;
//   json.begin_object().member("status", "solved").member("z", z);
//   json.key("object").begin_object().member("mass", 0.2).end_object().end_object();
//   std::cout << json.text();
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
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

  /// A bool, a number, a string, nullptr; a vector of one of these (a std::vector, an Eigen vector
  /// or map), which is an array on one line if it fits; a vector of anything else, one below the
  /// other; an optional of all that (empty: null); or whatever has a function write(JsonWriter&, T)
  /// beside it. Numbers read back as the same double; those that are not finite become null.
  template <class T> JsonWriter& value(const T& data) {
    if constexpr (is_literal<T>) {
      return scalar(literal(data));
    } else if constexpr (is_vector<T>::value) {
      return array(data);
    } else {
      write(*this, data);
      return *this;
    }
  }
  template <class T> JsonWriter& value(const std::optional<T>& data) {
    return data ? value(*data) : value(nullptr);
  }

  /// key() and value().
  template <class T> JsonWriter& member(std::string_view name, const T& data) {
    return key(name).value(data);
  }

  /// key() and an array, entry below entry: `write(entry)` writes one value for each of `list`, or
  /// for each number below it if it is a count.
  template <class List, class Write>
  JsonWriter& list(std::string_view name, const List& list, const Write& write) {
    key(name).begin_array();
    if constexpr (std::is_integral_v<List>)
      for (List i = 0; i < list; ++i) write(i);
    else
      for (const auto& entry : list) write(entry);
    return end_array();
  }
  /// The same of objects: `write(entry)` writes the members of one.
  template <class List, class Write>
  JsonWriter& objects(std::string_view name, const List& entries, const Write& write) {
    return list(name, entries, [&](const auto& entry) {
      begin_object();
      write(entry);
      end_object();
    });
  }

  /// What was written so far; after the last end, the whole text with its final newline.
  const std::string& text() const { return text_; }

private:
  template <class T, class = void> struct is_vector : std::false_type {};
  template <class T>
  struct is_vector<T, std::void_t<decltype(std::declval<const T&>().size())>> : std::true_type {};

  template <class T>
  static constexpr bool is_literal = std::is_arithmetic_v<T> || std::is_null_pointer_v<T> ||
                                     std::is_convertible_v<const T&, std::string_view>;

  template <class List> JsonWriter& array(const List& list) {
    if constexpr (is_literal<std::decay_t<decltype(list[0])>>) {
      std::vector<std::string> literals;
      for (decltype(list.size()) i = 0; i < list.size(); ++i) literals.push_back(literal(list[i]));
      return scalars(literals);
    } else {
      begin_array();
      for (const auto& entry : list) value(entry);
      return end_array();
    }
  }

  static std::string literal(double number);
  static std::string literal(std::string_view text);
  static std::string literal(std::nullptr_t) { return "null"; }
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

/// What is written as null while it is not known.
template <class T> std::optional<std::decay_t<T>> when(bool is_known, const T& data) {
  return is_known ? std::optional<std::decay_t<T>>(data) : std::nullopt;
}
/// A text or a list that is written as null if it is empty.
template <class T> std::optional<T> unless_empty(const T& data) {
  return when(!data.empty(), data);
}

} // namespace lcpush::desktop
