/* The least that a controller links: describe, solve, read. Built with more of the interface as well
 * (BREAK, MOTION, HOLD, SWEEPS), for what each part takes of the flash. */
#include "scenes.h"

#ifdef SWEEPS
static double memory[LCPUSH_SWEEP_BYTES(REAL, 3, 10, 8, 2, 2) / sizeof(double) + 1];
#define MAKE LCPUSH(make_for_sweeps)
#else
static double memory[LCPUSH_BYTES(REAL, 3, 10, 8, 2, 2) / sizeof(double) + 1];
#define MAKE LCPUSH(make)
#endif

#ifdef MOTION
static double motion_memory[LCPUSH_MOTION_BYTES(REAL, 3, 10, 8, 2, 2) / sizeof(double) + 1];
#endif

static LCPUSH(push) * push;
static lcpush_status status;
static void solve(void) { status = LCPUSH(solve)(push); }

int main(void) {
  static const lcpush_size size = {3, 10, 8, 2, 2, 0};
  LCPUSH(contact) contact;
  LCPUSH(scene) scene = straight_slide;
  cost solved;
  push = MAKE(memory, sizeof memory, &size);
  scene.pressure = LCPUSH_PAD;
  if (push == NULL || LCPUSH(describe)(push, &scene) != LCPUSH_RUNNING) return 1;
  solved = measure(solve);
  LCPUSH(contact_at)(push, 8, &contact);
#ifdef BREAK
  {
    LCPUSH(breaking) breaking;
    if (status == LCPUSH_SOLVED) status = LCPUSH(break_grasp)(push, 2, &breaking);
  }
#endif
#ifdef MOTION
  if (status == LCPUSH_SOLVED) status = LCPUSH(set_off)(push, motion_memory, sizeof motion_memory, 0);
  if (status == LCPUSH_RUNNING) status = LCPUSH(advance)(push, R(0.001));
#endif
#ifdef HOLD
  {
    static const REAL down[6] = {0, -1, 0, 0, 0, 0};
    LCPUSH(held) held;
    scene.pressure = LCPUSH_RIGID;
    status = LCPUSH(describe)(push, &scene);
    if (status == LCPUSH_RUNNING) status = LCPUSH(least_grip)(push, 99, &held);
    if (status == LCPUSH_SOLVED) status = LCPUSH(margin)(push, down, 99, &held);
  }
#endif
  put("run small status ");
  put(lcpush_status_text(status));
  put_real(" force ", contact.normal_force);
  put_number(" ticks ", solved.ticks);
  put_number(" stack ", solved.stack);
  put("\nend\n");
  return 0;
}
