/* How hard does a pusher press on a bar of 0.2 kg between two point fingers of 20 N? A control loop
 * with a new command and a budget each tick, and what it does where there is no answer in time. */
#include <lcpush/lcpush.h>
#if __STDC_HOSTED__
#include <stdio.h>
#endif

/* At most: 3 bodies, 3 points, 4 facets, 2 actuators, 2 drives. */
static const lcpush_size size = {3, 3, 4, 2, 2, 0};
static double memory[(LCPUSH_BYTES(float, 3, 3, 4, 2, 2) / sizeof(double)) + 1u];

static const lcpushf_point points[3] = {{0, 0, 0.005f}, {0, 0, -0.005f}, {-0.05f, 0, 0}};
static const lcpushf_body bodies[3] = {
    {.role = LCPUSH_FINGER, .normal = {0, 0, -1}, .friction = 0.5f, .first_point = 0, .point_count = 1},
    {.role = LCPUSH_FINGER, .normal = {0, 0, 1}, .friction = 0.5f, .first_point = 1, .point_count = 1},
    {.role = LCPUSH_PUSHER, .normal = {1, 0, 0}, .first_point = 2, .point_count = 1,
     .acceleration = {0.1f, 0, 0, 0, 0, 0}}};
static const lcpushf_actuator actuators[2] = {{20, 0}, {20, 0}};
static const lcpushf_drive drives[2] = {{0, 0, {0, 0, -1, 0, 0, 0}}, {1, 1, {0, 0, 1, 0, 0, 0}}};
static const lcpushf_scene scene = {
    .object = {.mass = 0.2f, .inertia = {1e-4f, 0, 0, 0, 1e-4f, 0, 0, 0, 1e-4f}},
    .facets = 4, .pressure = LCPUSH_PAD,
    .bodies = bodies, .body_count = 3, .points = points, .point_count = 3,
    .actuators = actuators, .actuator_count = 2, .drives = drives, .drive_count = 2};

static const int budget = 2; /* pivots a tick */
static const int oldest = 3; /* ticks that an answer may be old */
static const int ticks = 8;

/* What the controller wants in a tick: a firmer grip, then the pusher back. Yours reads sensors. */
static void wanted(int tick, float forces[2], float accelerations[18]) {
  forces[0] = (tick < 3) ? 20.0f : 25.0f;
  forces[1] = forces[0];
  accelerations[12] = (tick < 5) ? 0.1f : -0.1f;
}

extern volatile float newtons;
volatile float newtons; /* what the controller hands on */

int main(void) {
  lcpushf_push* push = lcpushf_make(memory, sizeof memory, &size);
  lcpush_status status = LCPUSH_BAD_INPUT; /* no push: LCPUSH_BYTES is for fewer contacts than size */
  float forces[2] = {0};
  float accelerations[18] = {0};
  float wrench[6];
  int tick = 0;
  if (push != NULL) {
    status = lcpushf_describe(push, &scene); /* lcpushf_why says what is wrong */
  }
  while ((status != LCPUSH_BAD_INPUT) && (tick < ticks)) {
    wanted(tick, forces, accelerations);
    if ((status != LCPUSH_RUNNING) || (tick == 0)) { /* a solve that is under way ends first */
      (void)lcpushf_command(push, forces, accelerations); /* refused: the command before stands */
    }
    status = lcpushf_step(push, budget);
    if ((lcpushf_age(push) < 0) || (lcpushf_age(push) > oldest)) {
      newtons = 0.0f; /* nothing to go by: stop the push, in your robot's way */
    } else { /* this tick's answer, or the last one */
      lcpushf_wrench_of(push, 2, wrench);
      newtons = wrench[0];
    }
#if __STDC_HOSTED__
    (void)printf("tick %d: %s, %.2f N, %d old\n", tick, lcpush_status_text(status), (double)newtons,
                 lcpushf_age(push));
#endif
    ++tick;
  }
  return (status == LCPUSH_SOLVED) ? 0 : 1;
}
