// Lemke's pivot alone, as a firmware that brings its own dictionary would call it.
#pragma once

#include "device.h"
#include "lcpush/lcp/pivots/ratio_test.hpp"

/// Lets the variable `entering` into the basis and returns the one to enter next; -1: the
/// artificial variable has left, a solution; -2: nothing blocks, a ray. `scratch`: n Scalars, n
/// ints.
int turn(lcpush::Dictionary<REAL>& dictionary, int entering, REAL* scratch, int* candidates);
