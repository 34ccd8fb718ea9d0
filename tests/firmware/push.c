/* Pushes solved on a microcontroller through the C interface, in one static block: scenes by every
 * method that they allow. Prints the bits of the answers and what they cost. */
#include "scenes.h"

/* bodies, points, facets, actuators, drives. A soft contact takes 5 g + 2 friction directions; under
 * even pressure driven patches are counted twice, as given and point by point. */
#define SQUEEZE (2, 2, 4, 1, 1)
#define SOFT (3, 3, 42, 2, 2)
#define SLIDE (3, 10, 8, 2, 2)
#define EVEN_SLIDE (12, 10, 8, 10, 10)
#define ROLLING (3, 6, 8, 1, 2)

#define BYTES(b, p, g, a, d) LCPUSH_BYTES(REAL, b, p, g, a, d)
#define SWEEP_BYTES(b, p, g, a, d) LCPUSH_SWEEP_BYTES(REAL, b, p, g, a, d)
#define EXPAND(call) call
#define COUNTS(b, p, g, a, d) {b, p, g, a, d, 0}
#define BY_PIVOTS(size) COUNTS size, BYTES size, LCPUSH(make)
#define BY_SWEEPS(size) COUNTS size, SWEEP_BYTES size, LCPUSH(make_for_sweeps)

/* Room for the largest. */
static union {
  double alignment;
  unsigned char soft[EXPAND(BYTES SOFT)];
  unsigned char even_slide[EXPAND(SWEEP_BYTES EVEN_SLIDE)];
} memory;

typedef enum action { SOLVE, STEP, BREAK, LIMIT } action;

typedef LCPUSH(push) * make(void* memory, size_t bytes, const lcpush_size* size);

typedef struct run {
  const char* name;
  const LCPUSH(scene) * scene;
  lcpush_pressure pressure;
  lcpush_size size;
  size_t bytes;
  make* makes;
  action action;
  int limit; /* of pivots */
} run;

static const run runs[] = {
    {"squeeze.rigid.pivots", &squeeze, LCPUSH_RIGID, BY_PIVOTS(SQUEEZE), SOLVE, 0},
    {"squeeze.rigid.sweeps", &squeeze, LCPUSH_RIGID, BY_SWEEPS(SQUEEZE), SOLVE, 0},
    {"squeeze.rigid.break", &squeeze, LCPUSH_RIGID, BY_PIVOTS(SQUEEZE), BREAK, 0},
    {"soft_fingers.pad.pivots", &soft_fingers, LCPUSH_PAD, BY_PIVOTS(SOFT), SOLVE, 0},
    {"soft_fingers.pad.sweeps", &soft_fingers, LCPUSH_PAD, BY_SWEEPS(SOFT), SOLVE, 0},
    {"soft_fingers.rigid.break", &soft_fingers, LCPUSH_RIGID, BY_PIVOTS(SOFT), BREAK, 0},
    {"straight_slide.rigid.pivots", &straight_slide, LCPUSH_RIGID, BY_PIVOTS(SLIDE), SOLVE, 0},
    {"straight_slide.rigid.steps", &straight_slide, LCPUSH_RIGID, BY_PIVOTS(SLIDE), STEP, 0},
    {"straight_slide.rigid.sweeps", &straight_slide, LCPUSH_RIGID, BY_SWEEPS(SLIDE), SOLVE, 0},
    {"straight_slide.rigid.break", &straight_slide, LCPUSH_RIGID, BY_PIVOTS(SLIDE), BREAK, 0},
    {"straight_slide.even.pivots", &straight_slide, LCPUSH_EVEN, BY_PIVOTS(EVEN_SLIDE), SOLVE, 0},
    {"straight_slide.even.sweeps", &straight_slide, LCPUSH_EVEN, BY_SWEEPS(EVEN_SLIDE), SOLVE, 0},
    {"straight_slide.even.break", &straight_slide, LCPUSH_EVEN, BY_PIVOTS(EVEN_SLIDE), BREAK, 0},
    {"straight_slide.pad.pivots", &straight_slide, LCPUSH_PAD, BY_PIVOTS(SLIDE), SOLVE, 0},
    {"straight_slide.pad.steps", &straight_slide, LCPUSH_PAD, BY_PIVOTS(SLIDE), STEP, 0},
    {"straight_slide.pad.break", &straight_slide, LCPUSH_PAD, BY_PIVOTS(SLIDE), BREAK, 0},
    {"rolling.rigid.pivots", &rolling, LCPUSH_RIGID, BY_PIVOTS(ROLLING), SOLVE, 0},
    {"rolling.rigid.sweeps", &rolling, LCPUSH_RIGID, BY_SWEEPS(ROLLING), SOLVE, 0},
    {"rolling.pad.pivots", &rolling, LCPUSH_PAD, BY_PIVOTS(ROLLING), SOLVE, 0},
    {"limit_10", &straight_slide, LCPUSH_RIGID, BY_PIVOTS(SLIDE), LIMIT, 10},
    {"limit_20", &straight_slide, LCPUSH_RIGID, BY_PIVOTS(SLIDE), LIMIT, 20},
    {"limit_40", &straight_slide, LCPUSH_RIGID, BY_PIVOTS(SLIDE), LIMIT, 40},
};

static const run* now;
static LCPUSH(push) * push;
static LCPUSH(scene) scene;
static LCPUSH(breaking) breaking;
static lcpush_status status;

static void describe(void) { status = LCPUSH(describe)(push, &scene); }
static void solve(void) { status = LCPUSH(solve)(push); }
static void one_step(void) { status = LCPUSH(step)(push, 1); }
static void break_grasp(void) {
  status = LCPUSH(break_grasp)(push, scene.body_count - 1, &breaking);
}

/* All at once, or in steps: the dearest of them counts. */
static cost work(void) {
  cost most = {0, 0};
  if (now->action == BREAK) return measure(break_grasp);
  LCPUSH(limit)(push, now->limit);
  if (now->action != STEP) return measure(solve);
  while (status == LCPUSH_RUNNING) {
    const cost one = measure(one_step);
    if (one.ticks > most.ticks) most.ticks = one.ticks;
    if (one.stack > most.stack) most.stack = one.stack;
  }
  return most;
}

static uint32_t hash_numbers(uint32_t hash, const REAL* numbers, int count) {
  int i;
  for (i = 0; i < count; ++i) hash = hash_real(hash, numbers[i]);
  return hash;
}

/* Everything that the interface says about the answer. */
static uint32_t hash_answer(void) {
  uint32_t hash = HASH_START;
  REAL acceleration[6];
  int i;
  LCPUSH(acceleration)(push, acceleration);
  hash = hash_numbers(hash, acceleration, 6);
  for (i = 0; i < scene.point_count; ++i) {
    LCPUSH(contact) contact;
    LCPUSH(contact_at)(push, i, &contact);
    hash = hash_bits(hash, (uint32_t)contact.body);
    hash = hash_bits(hash, (uint32_t)contact.mode);
    hash = hash_real(hash, contact.normal_force);
    hash = hash_numbers(hash, contact.friction_force, 3);
    hash = hash_real(hash, contact.torsion);
    hash = hash_numbers(hash, contact.acceleration, 3);
  }
  for (i = 0; i < scene.actuator_count; ++i) hash = hash_real(hash, LCPUSH(closing_of)(push, i));
  hash = hash_real(hash, breaking.break_force);
  hash = hash_numbers(hash, breaking.wrench, 6);
  hash = hash_numbers(hash, breaking.inertia, 6);
  hash = hash_numbers(hash, breaking.twist, 6);
  return hash_numbers(hash, breaking.rest, 6);
}

/* What the pusher presses with, N. */
static REAL push_force(void) {
  const LCPUSH(body)* pusher = &scene.bodies[scene.body_count - 1];
  REAL sum = 0;
  int i;
  if (now->action == BREAK) return breaking.break_force;
  for (i = pusher->first_point; i < pusher->first_point + pusher->point_count; ++i) {
    LCPUSH(contact) contact;
    LCPUSH(contact_at)(push, i, &contact);
    sum += contact.normal_force;
  }
  return sum;
}

int main(void) {
  static const LCPUSH(breaking) unbroken;
  size_t k;
  for (k = 0; k < sizeof runs / sizeof runs[0]; ++k) {
    cost described, solved;
    now = &runs[k];
    scene = *now->scene;
    scene.pressure = now->pressure;
    breaking = unbroken;
    push = now->makes(&memory, now->bytes, &now->size);
    put("run ");
    put(now->name);
    if (push == NULL) {
      put(" memory_too_small yes\n");
      return 1;
    }
    described = measure(describe);
    solved = work();
    put(" status ");
    put(lcpush_status_text(status));
    put_number(" pivots ", (uint32_t)LCPUSH(pivots)(push));
    put_number(" sweeps ", (uint32_t)LCPUSH(sweeps)(push));
    put_number(" rounds ", (uint32_t)LCPUSH(rounds)(push));
    put_real(" residual ", LCPUSH(residual)(push));
    put_real(" force ", push_force());
    put_hex(" hash ", hash_answer());
    put_number(" bytes ", (uint32_t)now->bytes);
    put_number(" describe_ticks ", described.ticks);
    put_number(" describe_stack ", described.stack);
    put_number(" ticks ", solved.ticks);
    put_number(" stack ", solved.stack);
    put("\n");
  }
  put("end\n");
  return 0;
}
