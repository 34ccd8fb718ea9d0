// A matrix whose size is known at run time only: it comes from the heap.
#include <Eigen/Core>

#include "planted.h"

// Inlined, it would leave no name to find.
extern "C" __attribute__((noinline)) void* malloc(std::size_t bytes) {
  static unsigned char pool[8];
  return bytes == 0 ? nullptr : pool;
}
extern "C" void free(void*) {}

lcpush_status __wrap_lcpushf_solve(lcpushf_push* push) {
  volatile int one = 1;
  const Eigen::MatrixXf matrix = Eigen::MatrixXf::Constant(one, one, 0.0F);
  return matrix(0, 0) > 0 ? LCPUSH_RAY : __real_lcpushf_solve(push);
}
