// The numbers of TOML 1.0 that lcpush reads, and hexadecimal digits of escapes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lcpush::desktop {

struct TomlNumber {
  bool is_whole = false; ///< then `whole` holds the value, else `real`
  std::int64_t whole = 0;
  double real = 0;
  std::string digits;               ///< as typed, without plus sign and underscores
  std::optional<std::string> error; ///< if set, nothing else holds
};

/// Reads the whole of `word`, a decimal number: [+-]digits[.digits][e[+-]digits], no leading
/// zeros, single underscores between digits.
TomlNumber read_toml_number(std::string_view word);

/// The value of exactly `digits` (at most 8) hexadecimal digits.
std::optional<std::uint32_t> read_hexadecimal(std::string_view word, std::size_t digits);

} // namespace lcpush::desktop
