// A limit on pivots that nobody heeds.
#include "planted.h"

void __wrap_lcpushf_limit(lcpushf_push*, int) {}
