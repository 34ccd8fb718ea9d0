// Stack that depends on the input.
#include "planted.h"

lcpush_status __wrap_lcpushf_solve(lcpushf_push* push) {
  volatile int size = 512;
  volatile char* const hog = static_cast<volatile char*>(__builtin_alloca(size));
  for (int i = 0; i < size; ++i) hog[i] = 1;
  return __real_lcpushf_solve(push);
}
