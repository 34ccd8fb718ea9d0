/* How hard does a pusher press on a bar of 0.2 kg between two point fingers of 20 N? */
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

extern volatile float newtons;
volatile float newtons; /* what the controller hands on */

int main(void) {
  lcpushf_push* push = lcpushf_make(memory, sizeof memory, &size);
  lcpush_status status = LCPUSH_BAD_INPUT; /* no push: LCPUSH_BYTES is for fewer contacts than size */
  float wrench[6];
  int ticks = 0;
  if (push != NULL) {
    status = lcpushf_describe(push, &scene); /* lcpushf_why says what is wrong */
  }
  while (status == LCPUSH_RUNNING) { /* a control loop: four pivots a tick */
    status = lcpushf_step(push, 4);
    ++ticks;
  }
  if (status == LCPUSH_SOLVED) {
    lcpushf_wrench_of(push, 2, wrench);
    newtons = wrench[0];
#if __STDC_HOSTED__
    (void)printf("%.2f N after %d pivots in %d ticks\n", (double)newtons, lcpushf_pivots(push), ticks);
#endif
  } /* or lcpush_status_text(status) says why not */
  return (status == LCPUSH_SOLVED) ? 0 : 1;
}
