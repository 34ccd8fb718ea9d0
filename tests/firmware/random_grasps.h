/* Pushes of random grasps, made of whole numbers over powers of two, so that every machine is given
 * the same bits. make_grasp() makes the next one. */
#ifndef RANDOM_GRASPS_H
#define RANDOM_GRASPS_H

#include "device.h"

#define MOST_POINTS 7
#define MOST_FACETS 8
/* Three bodies and two actuators; under even pressure every point as a body and every driven one as
 * an actuator and a drive beside them. */
#define MOST_BODIES (3 + MOST_POINTS)
#define MOST_DRIVEN (2 + 6)
static double
    memory[LCPUSH_BYTES(REAL, MOST_BODIES, MOST_POINTS, MOST_FACETS, MOST_DRIVEN, MOST_DRIVEN) /
               sizeof(double) +
           1];
static const lcpush_size size = {MOST_BODIES, MOST_POINTS, MOST_FACETS,
                                 MOST_DRIVEN, MOST_DRIVEN, 0};

/* Numerical Recipes' generator; its upper bits are the better ones. One draw a statement: C leaves
 * open which argument of a call comes first. */
static uint32_t seed = 19;
static int up_to(int most) {
  seed = seed * 1664525u + 1013904223u;
  return (int)((seed >> 8) % (uint32_t)(most + 1));
}
static int between(int least, int most) { return least + up_to(most - least); }
/* `whole` over a power of two: exact. */
static REAL over(int whole, int power_of_two) { return R(whole) / R(power_of_two); }

static LCPUSH(point) points[MOST_POINTS];
static LCPUSH(body) bodies[3];
static LCPUSH(actuator) actuators[2];
static LCPUSH(drive) drives[2];
static LCPUSH(scene) scene;
static REAL weights[MOST_POINTS];

static void set3(REAL out[3], REAL x, REAL y, REAL z) {
  out[0] = x;
  out[1] = y;
  out[2] = z;
}

static void place_finger(int finger) {
  static const int ring[3][2] = {{4, 0}, {-2, 3}, {-2, -3}};
  static const LCPUSH(body) blank;
  LCPUSH(body)* const body = &bodies[finger];
  const int side = finger == 0 ? 1 : -1, x = between(-12, 12), y = between(-6, 6),
            far = between(1, 3);
  const int slant_x = between(-2, 2), slant_y = between(-2, 2);
  int k;
  *body = blank;
  body->role = LCPUSH_FINGER;
  set3(body->normal, R(slant_x), R(slant_y), R(-16 * side));
  body->friction = over(between(4, 14), 16);
  body->first_point = scene.point_count;
  body->point_count = between(1, 3);
  for (k = 0; k < body->point_count; ++k) {
    LCPUSH(point)* const point = &points[scene.point_count++];
    point->x = over(x + far * ring[k][0], 1024);
    point->y = over(y + far * ring[k][1], 1024);
    point->z = over(8 * side, 1024);
  }
  actuators[finger].force = R(between(8, 40));
  actuators[finger].inertia = over(up_to(3), 64);
  drives[finger].body = drives[finger].actuator = finger;
  for (k = 0; k < 6; ++k) drives[finger].twist[k] = R(k == 2 ? -side : 0);
}

/* A point that pushes nearly towards the middle; not along a facet, where float could only guess.
 */
static void place_pusher(void) {
  static const LCPUSH(body) blank;
  const int x = between(3, 13), y = between(3, 13), tilt = between(-1, 1), pace = between(4, 32);
  const int x_sign = 2 * up_to(1) - 1, y_sign = 2 * up_to(1) - 1, off = between(-16, 16),
            up = between(-4, 4);
  LCPUSH(body)* const body = &bodies[2];
  LCPUSH(point)* const point = &points[scene.point_count];
  *body = blank;
  body->role = LCPUSH_PUSHER;
  set3(body->normal, R(x * x_sign), R(y * y_sign), R(tilt));
  body->friction = over(up_to(8), 16);
  body->first_point = scene.point_count++;
  body->point_count = 1;
  set3(body->acceleration, over(pace * x * x_sign, 512), over(pace * y * y_sign, 512), 0);
  point->x = over(-4 * x * x_sign + off, 1024);
  point->y = over(-4 * y * y_sign - off, 1024);
  point->z = over(up, 1024);
}

static void make_grasp(void) {
  static const LCPUSH(scene) blank;
  int k;
  scene = blank;
  scene.object.mass = over(between(8, 64), 128);
  for (k = 0; k < 9; k += 4) scene.object.inertia[k] = over(between(8, 31), 65536);
  scene.object.inertia[1] = scene.object.inertia[3] = over(between(-3, 3), 65536);
  set3(scene.gravity, 0, over(up_to(1) * -157, 16), 0);
  scene.facets = 4 + 2 * up_to(2);
  for (k = 0; k < 2; ++k) place_finger(k);
  place_pusher();
  for (k = 0; k < scene.point_count; ++k) weights[k] = R(between(1, 4));
  if (up_to(3) == 0) scene.weights = weights;
  scene.bodies = bodies;
  scene.body_count = 3;
  scene.points = points;
  scene.actuators = actuators;
  scene.actuator_count = 2;
  scene.drives = drives;
  scene.drive_count = 2;
}

#endif
