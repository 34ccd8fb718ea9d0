/* What a control loop costs: the straight slide of ten points and eight facets, first from a cold
 * start, then under a hundred commands that change grip and push a little, in ticks of a few pivots,
 * and as a motion. */
#include "scenes.h"

static double memory[LCPUSH_BYTES(REAL, 3, 10, 8, 2, 2) / sizeof(double) + 1];
static double motion_memory[LCPUSH_MOTION_BYTES(REAL, 3, 10, 8, 2, 2) / sizeof(double) + 1];
static const char* const laws[3] = {"pad", "even", "rigid"}; /* in lcpush_pressure's order */

static LCPUSH(push) * push;
static LCPUSH(scene) scene;
static lcpush_status status;
static REAL forces[2], accelerations[18]; /* of two fingers and the pusher */
static int pivots_a_tick;

static void describe(void) { status = LCPUSH(describe)(push, &scene); }
static void command(void) {
  LCPUSH(command)(push, forces, accelerations);
  status = LCPUSH(solve)(push);
}
static void tick(void) { status = LCPUSH(step)(push, pivots_a_tick); }
static void advance(void) { status = LCPUSH(advance)(push, R(0.001)); }

static void take_larger(cost* most, cost one) {
  if (one.ticks > most->ticks) most->ticks = one.ticks;
  if (one.stack > most->stack) most->stack = one.stack;
}

static void report(lcpush_pressure law, const char* what, int which, cost most, int count) {
  put("run ");
  put(laws[law]);
  put(".");
  put(what);
  put_number(".", (uint32_t)which);
  put(" status ");
  put(lcpush_status_text(status));
  put_number(" count ", (uint32_t)count);
  put_real(" residual ", LCPUSH(residual)(push));
  put_number(" ticks ", most.ticks);
  put_number(" stack ", most.stack);
  put("\n");
}

/* -1, 0 or 1 of a hundredth, by a generator that is the same everywhere. */
static REAL nudge(void) {
  static uint32_t state;
  state = state * 1664525u + 1013904223u;
  return (REAL)((int)((state >> 16) % 3u) - 1) * R(0.01);
}

/* The dearest command by the pivots that it took: none, at most five, more. */
static void commands(lcpush_pressure law) {
  static const int pivots[3] = {0, 5, 1000};
  cost most[3] = {{0, 0}, {0, 0}, {0, 0}};
  int counts[3] = {0, 0, 0}, k, i;
  forces[0] = forces[1] = 20;
  accelerations[12] = R(0.1);
  describe();
  command();
  for (k = 0; k < 100; ++k) {
    cost one;
    int took;
    forces[0] *= 1 + nudge();
    forces[1] = forces[0];
    accelerations[12] *= 1 + nudge();
    accelerations[13] += 2 * nudge(); /* the push turns by up to 11 degrees */
    accelerations[17] += 20 * nudge();
    one = measure(command);
    if (status != LCPUSH_SOLVED) break;
    took = LCPUSH(pivots)(push);
    for (i = 0; i < 3 && took > pivots[i]; ++i) continue;
    ++counts[i];
    take_larger(&most[i], one);
  }
  for (i = 0; i < 3; ++i) report(law, "command", pivots[i], most[i], counts[i]);
}

static void ticks(lcpush_pressure law) {
  static const int pivots[3] = {1, 4, 16};
  int i;
  for (i = 0; i < 3; ++i) {
    cost most = {0, 0};
    int count = 0;
    describe();
    pivots_a_tick = pivots[i];
    for (; status == LCPUSH_RUNNING; ++count) take_larger(&most, measure(tick));
    report(law, "tick", pivots[i], most, count);
  }
}

static void motion(lcpush_pressure law) {
  static const REAL forwards[6] = {R(0.02), 0, 0, 0, 0, 0};
  cost most = {0, 0};
  int k;
  describe();
  if (LCPUSH(set_off)(push, motion_memory, sizeof motion_memory, 0) != LCPUSH_RUNNING) return;
  LCPUSH(set_velocity)(push, 2, forwards);
  advance(); /* the first is cold */
  for (k = 0; k < 20 && status == LCPUSH_SOLVED; ++k) take_larger(&most, measure(advance));
  report(law, "advance", 0, most, k);
}

int main(void) {
  static const lcpush_size size = {3, 10, 8, 2, 2, 0};
  static const lcpush_pressure pressures[2] = {LCPUSH_PAD, LCPUSH_RIGID};
  int i;
  for (i = 0; i < 2; ++i) {
    scene = straight_slide;
    scene.pressure = pressures[i];
    push = LCPUSH(make)(memory, sizeof memory, &size);
    if (push == NULL) return 1;
    commands(scene.pressure);
    ticks(scene.pressure);
    motion(scene.pressure);
  }
  put("end\n");
  return 0;
}
