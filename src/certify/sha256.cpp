#include "certify/sha256.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace lcpush::desktop {
namespace {

std::uint32_t turned(std::uint32_t x, unsigned by) { return (x >> by) | (x << (32U - by)); }

/// The first 32 bits of the fractional part of the square or the cubic root of the first primes.
template <std::size_t count> std::array<std::uint32_t, count> root_bits(bool is_cubic) {
  std::array<std::uint32_t, count> bits{};
  std::size_t found = 0;
  for (int candidate = 2; found < count; ++candidate) {
    bool is_prime = true;
    for (int d = 2; d * d <= candidate; ++d) is_prime = is_prime && candidate % d != 0;
    if (!is_prime) continue;
    const double root = is_cubic ? std::cbrt(candidate) : std::sqrt(candidate);
    bits[found++] = static_cast<std::uint32_t>(std::ldexp(root - std::floor(root), 32));
  }
  return bits;
}

} // namespace

std::string sha256(std::string_view bytes) {
  static const auto rounds = root_bits<64>(true);
  auto state = root_bits<8>(false);
  std::string text(bytes);
  text += '\x80';
  while (text.size() % 64 != 56) text += '\0';
  for (unsigned shift = 64; shift > 0; shift -= 8)
    text += static_cast<char>((std::uint64_t{8} * bytes.size()) >> (shift - 8));
  for (std::size_t block = 0; block < text.size(); block += 64) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i)
      w[i / 4] = (w[i / 4] << 8U) | static_cast<unsigned char>(text[block + i]);
    for (std::size_t i = 16; i < 64; ++i)
      w[i] = w[i - 16] + (turned(w[i - 15], 7) ^ turned(w[i - 15], 18) ^ (w[i - 15] >> 3U)) +
             w[i - 7] + (turned(w[i - 2], 17) ^ turned(w[i - 2], 19) ^ (w[i - 2] >> 10U));
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t first = h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) +
                                  ((e & f) ^ (~e & g)) + rounds[i] + w[i];
      const std::uint32_t second =
          (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
      h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
    }
    const std::array<std::uint32_t, 8> mixed = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) state[i] += mixed[i];
  }
  std::string digits;
  for (const std::uint32_t word : state)
    for (unsigned shift = 32; shift > 0; shift -= 4)
      digits += "0123456789abcdef"[(word >> (shift - 4)) & 15U];
  return digits;
}

} // namespace lcpush::desktop
