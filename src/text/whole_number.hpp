// Digits become a whole number.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace lcpush::desktop {

/// The whole of `word`: digits, after a minus sign if N has one. Nothing if N cannot hold it.
template <class N> std::optional<N> whole_number(std::string_view word, int base = 10) {
  N number{0};
  const char* const end = word.data() + word.size();
  const auto [stopped, outcome] = std::from_chars(word.data(), end, number, base);
  if (stopped != end || outcome != std::errc{}) return std::nullopt;
  return number;
}

} // namespace lcpush::desktop
