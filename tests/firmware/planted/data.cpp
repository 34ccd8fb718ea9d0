// A variable that does not start at zero: flash that is copied at start.
#include "planted.h"

volatile int planted_number = 3;

lcpush_status __wrap_lcpushf_solve(lcpushf_push* push) {
  planted_number = planted_number + 1;
  return __real_lcpushf_solve(push);
}
