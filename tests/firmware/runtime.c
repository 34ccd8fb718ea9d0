/* The few functions that a compiler takes for granted, so that nothing but libgcc is linked. */
#include <stddef.h>
#include <stdint.h>

void* memcpy(void* to, const void* from, size_t count) {
  unsigned char* t = to;
  const unsigned char* f = from;
  while (count-- > 0) *t++ = *f++;
  return to;
}

void* memmove(void* to, const void* from, size_t count) {
  unsigned char* t = to;
  const unsigned char* f = from;
  if (t <= f) return memcpy(to, from, count);
  while (count-- > 0) t[count] = f[count];
  return to;
}

void* memset(void* to, int value, size_t count) {
  unsigned char* t = to;
  while (count-- > 0) *t++ = (unsigned char)value;
  return to;
}

/* Where the processor has no square root: digit by digit, rounded to nearest as IEEE 754 asks. */
float sqrtf(float x) {
  union {
    float number;
    uint32_t bits;
  } u = {x};
  uint32_t fraction, root = 0, rest = 0;
  int exponent, i;
  if (u.bits == 0x80000000u || u.bits == 0 || u.bits == 0x7F800000u || (u.bits << 1) > 0xFF000000u)
    return x;
  if (u.bits >> 31) return (x - x) / (x - x);
  exponent = (int)(u.bits >> 23);
  fraction = u.bits & 0x7FFFFFu;
  if (exponent == 0) {
    exponent = 1;
    for (; !(fraction & 0x800000u); --exponent) fraction <<= 1;
  }
  fraction |= 0x800000u;
  exponent -= 127;
  if (exponent & 1) {
    fraction <<= 1;
    --exponent;
  }
  /* The root of fraction * 2^25 has 25 bits: 24, and one to round by. */
  for (i = 24; i >= 0; --i) {
    const uint32_t two = (uint32_t)((uint64_t)fraction << 25 >> 2 * i) & 3;
    rest = rest << 2 | two;
    root <<= 1;
    if (rest >= (root << 1 | 1)) {
      rest -= root << 1 | 1;
      root |= 1;
    }
  }
  root = (root + 1) >> 1; /* an exact tie cannot happen */
  u.bits = ((uint32_t)(exponent / 2 + 127) << 23) + (root - 0x800000u);
  return u.number;
}
