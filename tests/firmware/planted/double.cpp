// Double precision that crept into single.
#include "planted.h"

void __wrap_lcpushf_contact_at(const lcpushf_push* push, int point, lcpushf_contact* out) {
  __real_lcpushf_contact_at(push, point, out);
  volatile double wide = 1;
  wide = wide * static_cast<double>(out->normal_force);
}
