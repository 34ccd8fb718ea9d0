/* Links lcpush::c from C, without a C++ runtime. */
#include <lcpush/lcpush.h>

int main(void) {
  static double memory[LCPUSH_BYTES(double, 3, 3, 4, 2, 2) / sizeof(double) + 1];
  const lcpush_size size = {3, 3, 4, 2, 2, 0};
  lcpush_push* push = lcpush_make(memory, sizeof memory, &size);
  return push != NULL && lcpush_solve(push) == LCPUSH_BAD_INPUT ? 0 : 1;
}
