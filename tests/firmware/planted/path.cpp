// One pivot that is not the desktop's.
#include "planted.h"

extern "C" {
uint32_t __real_hash_bits(uint32_t hash, uint32_t bits);
uint32_t __wrap_hash_bits(uint32_t hash, uint32_t bits);
}

uint32_t __wrap_hash_bits(uint32_t hash, uint32_t bits) {
  static int calls;
  return __real_hash_bits(hash, ++calls == 50 ? bits + 1 : bits);
}
