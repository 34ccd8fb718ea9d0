// UTF-8 (RFC 3629), the encoding of every text that lcpush reads.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lcpush::desktop {

/// True for a code point that UTF-8 can carry: up to U+10FFFF and no surrogate.
bool is_unicode_scalar(std::uint32_t code);

/// Bytes of the well-formed character that starts `text`, or 0 if it is malformed (overlong,
/// truncated, surrogate, beyond U+10FFFF). Precondition: `text` is not empty.
std::size_t utf8_length(std::string_view text);

/// Is this byte one of a character that started before it?
inline bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Appends `code`. Precondition: is_unicode_scalar(code).
void append_utf8(std::string& text, std::uint32_t code);

} // namespace lcpush::desktop
