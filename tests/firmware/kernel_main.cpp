// Problems of 8, 32 and 64 unknowns by the pivot alone: instructions by size, and the same stack
// for all of them.
#include "kernel.h"

using namespace lcpush;

namespace {

constexpr Index most = 64;
REAL table[most * (most + 1)], values[most * 3], scratch[most];
int basic[most], nonbasic[most + 1], candidates[most];
Dictionary<REAL> dictionary;
int next;

void one_turn() { next = turn(dictionary, next, scratch, candidates); }

/// Numbers in (-1, 1) that float holds exactly.
std::uint32_t state;
REAL random_number() {
  state = state * 1664525u + 1013904223u;
  return static_cast<REAL>(static_cast<int>(state >> 23) - 256) / REAL(256);
}

/// M = skew part + diagonal: positive definite, so pivots end in a solution. The cover and the two
/// columns that break ties are positive.
void fill(Index n) {
  new (&dictionary.table) MatrixMap<REAL>(table, n, n + 1);
  new (&dictionary.values) MatrixMap<REAL>(values, n, 3);
  dictionary.basic = {basic, n};
  dictionary.nonbasic = {nonbasic, n + 1};
  dictionary.reset_basis();
  state = 7;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < i; ++j) {
      const REAL x = random_number() / REAL(4);
      dictionary.table(i, j) = x;
      dictionary.table(j, i) = -x;
    }
    dictionary.table(i, i) = 1;
    dictionary.table(i, n) = REAL(1.5) + random_number() / REAL(4);
    dictionary.values(i, 0) = random_number();
    for (Index k = 1; k < 3; ++k) dictionary.values(i, k) = REAL(1.5) + random_number() / REAL(4);
  }
  next = static_cast<int>(artificial(n));
}

void run(Index n) {
  std::uint32_t pivots = 0, hash = HASH_START;
  cost all{0, 0};
  fill(n);
  while (next >= 0 && pivots < 1000) {
    const cost one = measure(one_turn);
    ++pivots;
    all.ticks += one.ticks;
    if (one.stack > all.stack) all.stack = one.stack;
    hash = hash_bits(hash, static_cast<std::uint32_t>(next));
  }
  for (Index i = 0; i < n; ++i) hash = hash_real(hash, dictionary.values(i, 0));
  put_number("run kernel.", static_cast<std::uint32_t>(n));
  put(next == -1 ? " status solved" : " status failed");
  put_number(" pivots ", pivots);
  put_hex(" hash ", hash);
  put_number(" ticks ", all.ticks);
  put_number(" stack ", all.stack);
  put("\n");
}

} // namespace

int main() {
  for (const Index n : {8, 32, 64}) run(n);
  put("end\n");
  return 0;
}
