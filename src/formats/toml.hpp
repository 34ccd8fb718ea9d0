// lcpush: a strict subset of TOML 1.0 (https://toml.io/en/v1.0.0).
//
// Read: comments, `[table]`, `[[array of tables]]`, bare keys, basic strings with every escape,
// decimal whole and real numbers, booleans, nested multi-line arrays of numbers or strings.
// Refused, each by a located message: dotted and quoted keys, inline tables, literal and multi-line
// strings, hexadecimal, octal and binary numbers, inf, nan, dates, whole numbers beyond 64 bits,
// reals that overflow or vanish. What is read is valid TOML and means what TOML says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lcpush::desktop {

struct TomlValue;
using TomlArray = std::vector<TomlValue>;

struct TomlValue {
  int line; ///< where the value starts, from 1
  std::variant<bool, std::int64_t, double, std::string, TomlArray> data;
  /// A number as typed, without plus sign and underscores; empty for everything else.
  std::string digits = {};
  /// Of the middle of a range: its two ends, numbers; empty for everything else.
  std::vector<TomlValue> range = {};

  /// Nothing if it is no number.
  std::optional<double> number() const;
};

struct TomlEntry {
  std::string key;
  TomlValue value;                ///< a key and its value start on the same line
  std::size_t begin = 0, end = 0; ///< in the text: from the key to behind the value
};

struct TomlTable {
  int line; ///< of its header; 1 for the keys above the first header
  std::vector<TomlEntry> entries;
  std::size_t end = 0; ///< in the text: behind its last value, or its header

  /// The value of `key`, or nullptr.
  const TomlValue* find(std::string_view key) const;
  TomlValue* find(std::string_view key) {
    return const_cast<TomlValue*>(std::as_const(*this).find(key));
  }
  /// The text of the key "name", or nullptr if there is none or it is no text.
  const std::string* name() const;
};

/// `[name]`, or every `[[name]]` of the file.
struct TomlSection {
  std::string name;
  bool is_array;
  std::vector<TomlTable> tables; ///< exactly one if not is_array, else one or more
};

struct TomlDocument {
  std::string file; ///< as given, for messages
  TomlTable root;
  std::vector<TomlSection> sections; ///< in the order of their first headers

  /// The section called `name`, or nullptr.
  const TomlSection* find(std::string_view name) const;
};

/// Reads `text`; `file_name` only names it in messages. Keys are unique within a table, names
/// among root keys and sections. Throws InputError with file and line on anything else.
TomlDocument parse_toml(std::string_view text, const std::string& file_name);

/// Reads the whole of `word`, a decimal number: [+-]digits[.digits][e[+-]digits], no leading
/// zeros, single underscores between digits. Returns what is wrong with it, if anything.
std::optional<std::string> read_toml_number(std::string_view word, TomlValue& value);

/// As a file has it, on one line.
std::string toml_text(const TomlValue& value);
/// The whole file, without its comments.
std::string toml_text(const TomlDocument& document);

} // namespace lcpush::desktop
