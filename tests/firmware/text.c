/* Text and hashes, the same on boards and desktop. */
#include "device.h"

#include <string.h>

void put_number(const char* key, uint32_t number) {
  char digits[12];
  char* at = digits + sizeof digits - 1;
  *at = 0;
  do {
    *--at = (char)('0' + number % 10);
    number /= 10;
  } while (number > 0);
  put(key);
  put(at);
}

void put_hex(const char* key, uint32_t bits) {
  char digits[9];
  int i;
  for (i = 0; i < 8; ++i) digits[i] = "0123456789abcdef"[bits >> (28 - 4 * i) & 15];
  digits[8] = 0;
  put(key);
  put(digits);
}

static void words_of(REAL number, uint32_t words[2]) {
  words[0] = words[1] = 0;
  memcpy(words, &number, sizeof number);
}

void put_real(const char* key, REAL number) {
  uint32_t words[2];
  words_of(number, words);
  if (sizeof number == 4) {
    put_hex(key, words[0]);
  } else {
    put_hex(key, words[1]);
    put_hex("", words[0]);
  }
}

uint32_t hash_bits(uint32_t hash, uint32_t bits) {
  int i;
  for (i = 0; i < 4; ++i) hash = (hash ^ (bits >> 8 * i & 255)) * 16777619u;
  return hash;
}

uint32_t hash_real(uint32_t hash, REAL number) {
  uint32_t words[2];
  words_of(number, words);
  hash = hash_bits(hash, words[0]);
  return sizeof number == 4 ? hash : hash_bits(hash, words[1]);
}
