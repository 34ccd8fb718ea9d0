// A limit on pivots that is heeded late.
#include "planted.h"

void __wrap_lcpushf_limit(lcpushf_push* push, int pivots) {
  __real_lcpushf_limit(push, pivots == 20 ? 50 : pivots);
}
