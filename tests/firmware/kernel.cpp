// The ratio test, the exchange and the bookkeeping between them: what a pivot is made of, and all
// of it. The size of this object in the linked program is gated.
#include "kernel.h"

using namespace lcpush;

int turn(Dictionary<REAL>& dictionary, int entering, REAL* scratch, int* candidates) {
  const Index n = dictionary.size(), column = dictionary.column_of(entering);
  RatioTest<REAL> test(dictionary, 1, TieRule::generic, Tolerances<REAL>(), {candidates, n});
  const bool starts = entering == artificial(n);
  const Blocking blocking = starts ? test.most_violated_row(column) : test.blocking_row(column);
  if (blocking.row < 0) return -2;
  const Index leaving = dictionary.basic[blocking.row];
  dictionary.exchange(blocking.row, column, VectorMap<REAL>(scratch, n));
  return leaving == artificial(n) ? -1 : static_cast<int>(complement(leaving, n));
}
