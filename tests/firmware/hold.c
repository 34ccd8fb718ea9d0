/* What the fingers of the shipped scenes hold before any push: the least and the largest grip, and how
 * much of a force, in the memory of a push. Prints the bits of the answers and what they cost. */
#include "scenes.h"

/* Of all: under even pressure patches count as given and point by point, and a soft contact takes
 * 5 g + 2 friction directions. */
static const lcpush_size size = {12, 10, 14, 10, 10, 0};
static double memory[LCPUSH_BYTES(REAL, 12, 10, 14, 10, 10) / sizeof(double) + 1];

typedef struct run {
  const char* name;
  const LCPUSH(scene) * scene;
  lcpush_pressure pressure;
  REAL beside[6]; /* the wrench whose multiple is asked for */
  int exchanges;  /* at most */
} run;

static const run runs[] = {
    {"straight_slide.rigid", &straight_slide, LCPUSH_RIGID, {0, -1, 0, 0, 0, 0}, 99},
    {"straight_slide.even", &straight_slide, LCPUSH_EVEN, {0, -1, 0, 0, 0, R(0.01)}, 99},
    {"straight_slide.pad", &straight_slide, LCPUSH_PAD, {0, -1, 0, 0, 0, 0}, 99},
    {"straight_slide.limit", &straight_slide, LCPUSH_RIGID, {0, -1, 0, 0, 0, 0}, 3},
    {"soft_fingers.pad", &soft_fingers, LCPUSH_PAD, {1, 1, 0, 0, R(0.1), 0}, 99},
    {"rolling.rigid", &rolling, LCPUSH_RIGID, {1, 2, 3, 0, 0, 0}, 99},
    {"squeeze.rigid", &squeeze, LCPUSH_RIGID, {0, 1, 0, 0, 0, 0}, 99},
};

static const run* now;
static LCPUSH(push) * push;
static LCPUSH(held) held;
static lcpush_status status;

static void least_grip(void) { status = LCPUSH(least_grip)(push, now->exchanges, &held); }
static void most_grip(void) { status = LCPUSH(most_grip)(push, now->exchanges, &held); }
static void margin(void) { status = LCPUSH(margin)(push, now->beside, now->exchanges, &held); }

static void report(const char* what, void (*work)(void)) {
  const cost took = measure(work);
  uint32_t hash = HASH_START;
  int i;
  for (i = 0; i < 6; ++i) hash = hash_real(hash, held.twist[i]);
  put("run ");
  put(now->name);
  put(what);
  put(" status ");
  put(lcpush_status_text(status));
  put_number(" exchanges ", (uint32_t)held.exchanges);
  put_real(" value ", held.value);
  put_hex(" hash ", hash);
  put_number(" ticks ", took.ticks);
  put_number(" stack ", took.stack);
  put("\n");
}

int main(void) {
  size_t k;
  for (k = 0; k < sizeof runs / sizeof runs[0]; ++k) {
    LCPUSH(scene) scene;
    now = &runs[k];
    scene = *now->scene;
    scene.pressure = now->pressure;
    push = LCPUSH(make)(memory, sizeof memory, &size);
    if (push == NULL || LCPUSH(describe)(push, &scene) != LCPUSH_RUNNING) return 1;
    report(".least_grip", least_grip);
    report(".most_grip", most_grip);
    report(".margin", margin);
  }
  put("end\n");
  return 0;
}
