// A planted fault stands before one function of the C interface (ld --wrap): __real_ is that one.
#pragma once

#include "device.h"

extern "C" {
lcpush_status __real_lcpushf_solve(lcpushf_push* push);
lcpush_status __wrap_lcpushf_solve(lcpushf_push* push);
void __real_lcpushf_contact_at(const lcpushf_push* push, int point, lcpushf_contact* out);
void __wrap_lcpushf_contact_at(const lcpushf_push* push, int point, lcpushf_contact* out);
void __real_lcpushf_limit(lcpushf_push* push, int pivots);
void __wrap_lcpushf_limit(lcpushf_push* push, int pivots);
}
