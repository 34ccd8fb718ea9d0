/* What the programs need from the machine they run on: device.c on the boards, desktop.c elsewhere.
 */
#ifndef DEVICE_H
#define DEVICE_H

#include <stdint.h>

#include "lcpush/lcpush.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One precision a program. */
#ifdef FIRMWARE_DOUBLE
#define REAL double
#define LCPUSH(name) lcpush_##name
#else
#define REAL float
#define LCPUSH(name) lcpushf_##name
#endif
#define R(x) ((REAL)(x))

/* Inertia of a box of sides a, b, c and of a cylinder of radius r and length h along z. */
#define BOX(m, a, b, c)                                                                            \
  {                                                                                                \
    R((m) / 12.0 * ((b) * (b) + (c) * (c))), 0, 0, 0, R((m) / 12.0 * ((a) * (a) + (c) * (c))), 0,  \
        0, 0, R((m) / 12.0 * ((a) * (a) + (b) * (b)))                                              \
  }
#define CYLINDER(m, r, h)                                                                          \
  {                                                                                                \
    R((m) / 12.0 * (3 * (r) * (r) + (h) * (h))), 0, 0, 0,                                          \
        R((m) / 12.0 * (3 * (r) * (r) + (h) * (h))), 0, 0, 0, R((m) / 2.0 * (r) * (r))             \
  }

/* Text for the test script: "key value key value ...", one line a result. */
void put(const char* text);
void put_number(const char* key, uint32_t number);
void put_hex(const char* key, uint32_t bits);
void put_real(const char* key, REAL number); /* its bits */

/* What a piece of work costs; zeros on the desktop. */
typedef struct cost {
  uint32_t ticks; /* of the timer, 40 ns each; an instruction takes 64 ns */
  uint32_t stack; /* bytes, the deepest */
} cost;
cost measure(void (*work)(void));

/* FNV-1a over the bits of what is fed to it. */
#define HASH_START 2166136261u
uint32_t hash_bits(uint32_t hash, uint32_t bits);
uint32_t hash_real(uint32_t hash, REAL number);

#ifdef __cplusplus
}
#endif
#endif
