/* What a unit of work costs: pushes of random grasps, solved at once and in calls of bounded work. */
#include "random_grasps.h"

#define PUSHES 60
#define BUDGET 4000u

static LCPUSH(push) * push;
static lcpush_status status;
static void solve(void) { status = LCPUSH(solve)(push); }
static void tick(void) { status = LCPUSH(step_within)(push, BUDGET); }

int main(void) {
  static const lcpush_pressure laws[3] = {LCPUSH_PAD, LCPUSH_RIGID, LCPUSH_EVEN};
  int k;
  for (k = 0; k < PUSHES; ++k) {
    unsigned before, most = 0, calls = 0;
    cost whole, dearest = {0, 0};
    push = LCPUSH(make)(memory, sizeof memory, &size);
    if (push == NULL) return 1;
    make_grasp();
    scene.pressure = laws[k % 3];
    if (LCPUSH(describe)(push, &scene) != LCPUSH_RUNNING) return 1;
    before = LCPUSH(work)(push);
    whole = measure(solve);
    put_number("run ", (uint32_t)k);
    put(" status ");
    put(lcpush_status_text(status));
    put_number(" work ", LCPUSH(work)(push) - before);
    put_number(" ticks ", whole.ticks);
    if (LCPUSH(describe)(push, &scene) != LCPUSH_RUNNING) return 1;
    do {
      cost one;
      before = LCPUSH(work)(push);
      one = measure(tick);
      before = LCPUSH(work)(push) - before;
      if (before > most) most = before;
      if (one.ticks > dearest.ticks) dearest = one;
      ++calls;
    } while (status == LCPUSH_RUNNING);
    put(" in_calls ");
    put(lcpush_status_text(status));
    put_number(" calls ", calls);
    put_number(" most ", most);
    put_number(" dearest_ticks ", dearest.ticks);
    put("\n");
  }
  put("end\n");
  return 0;
}
