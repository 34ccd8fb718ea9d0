// Memory that is nobody's.
#include "planted.h"

volatile unsigned char planted_memory[1024];

lcpush_status __wrap_lcpushf_solve(lcpushf_push* push) {
  planted_memory[1023] = 1;
  return __real_lcpushf_solve(push);
}
