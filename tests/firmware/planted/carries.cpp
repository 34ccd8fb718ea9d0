// A program that carries what it does not say that it calls.
#include "planted.h"

void __wrap_lcpushf_contact_at(const lcpushf_push* push, int point, lcpushf_contact* out) {
  lcpushf_breaking breaking;
  if (point < 0) lcpushf_break_grasp(const_cast<lcpushf_push*>(push), 0, &breaking);
  __real_lcpushf_contact_at(push, point, out);
}
