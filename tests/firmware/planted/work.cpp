// A solve that takes a tenth longer than it did.
#include "planted.h"

lcpush_status __wrap_lcpushf_solve(lcpushf_push* push) {
  for (volatile int i = 0; i < 3000; i = i + 1) continue;
  return __real_lcpushf_solve(push);
}
