// One wrong bit of one force.
#include "planted.h"

#include <string.h>

void __wrap_lcpushf_contact_at(const lcpushf_push* push, int point, lcpushf_contact* out) {
  __real_lcpushf_contact_at(push, point, out);
  uint32_t bits;
  memcpy(&bits, &out->friction_force[1], sizeof bits);
  bits ^= point == 1 ? 1 : 0;
  memcpy(&out->friction_force[1], &bits, sizeof bits);
}
