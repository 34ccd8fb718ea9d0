/* A hundred pushes of random grasps, made of whole numbers over powers of two, so that every machine
 * is given the same bits; what it answers goes into hashes. docs/embed/tables.md has their table. */
#include "device.h"

#define PUSHES 100
#define MOST_POINTS 7
#define MOST_FACETS 8
/* Three bodies and two actuators; under even pressure every point as a body and every driven one as an
 * actuator and a drive beside them. */
#define MOST_BODIES (3 + MOST_POINTS)
#define MOST_DRIVEN (2 + 6)
static double memory[LCPUSH_BYTES(REAL, MOST_BODIES, MOST_POINTS, MOST_FACETS, MOST_DRIVEN, MOST_DRIVEN) / sizeof(double) + 1];
static const lcpush_size size = {MOST_BODIES, MOST_POINTS, MOST_FACETS, MOST_DRIVEN, MOST_DRIVEN, 0};

/* Numerical Recipes' generator; its upper bits are the better ones. One draw a statement: C leaves open
 * which argument of a call comes first. */
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
  const int side = finger == 0 ? 1 : -1, x = between(-12, 12), y = between(-6, 6), far = between(1, 3);
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

/* A point that pushes nearly towards the middle; not along a facet, where float could only guess. */
static void place_pusher(void) {
  static const LCPUSH(body) blank;
  const int x = between(3, 13), y = between(3, 13), tilt = between(-1, 1), pace = between(4, 32);
  const int x_sign = 2 * up_to(1) - 1, y_sign = 2 * up_to(1) - 1, off = between(-16, 16), up = between(-4, 4);
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

static uint32_t hash_numbers(uint32_t hash, const REAL* numbers, int count) {
  int i;
  for (i = 0; i < count; ++i) hash = hash_real(hash, numbers[i]);
  return hash;
}

static uint32_t hash_answer(const LCPUSH(push) * push, lcpush_status status) {
  uint32_t hash = hash_bits(HASH_START, (uint32_t)status);
  REAL numbers[6];
  int i;
  hash = hash_bits(hash, (uint32_t)LCPUSH(pivots)(push));
  hash = hash_bits(hash, (uint32_t)LCPUSH(rounds)(push));
  hash = hash_real(hash, LCPUSH(residual)(push));
  LCPUSH(acceleration)(push, numbers);
  hash = hash_numbers(hash, numbers, 6);
  LCPUSH(wrench_of)(push, 2, numbers);
  hash = hash_numbers(hash, numbers, 6);
  for (i = 0; i < scene.actuator_count; ++i) hash = hash_real(hash, LCPUSH(closing_of)(push, i));
  for (i = 0; i < scene.point_count; ++i) {
    LCPUSH(contact) contact;
    LCPUSH(contact_at)(push, i, &contact);
    hash = hash_bits(hash, (uint32_t)contact.mode);
    hash = hash_real(hash, contact.normal_force);
    hash = hash_numbers(hash, contact.friction_force, 3);
    hash = hash_numbers(hash, contact.acceleration, 3);
  }
  return hash;
}

int main(void) {
  static const lcpush_pressure laws[3] = {LCPUSH_PAD, LCPUSH_RIGID, LCPUSH_EVEN};
  uint32_t all = HASH_START, solved = 0, pivots = 0;
  int k;
  for (k = 0; k < PUSHES; ++k) {
    LCPUSH(push)* const push = LCPUSH(make)(memory, sizeof memory, &size);
    lcpush_status status;
    uint32_t hash;
    if (push == NULL) return 1;
    make_grasp();
    scene.pressure = laws[k % 3];
    status = LCPUSH(describe)(push, &scene);
    if (status == LCPUSH_RUNNING) status = LCPUSH(solve)(push);
    hash = hash_answer(push, status);
    all = hash_bits(all, hash);
    if (status == LCPUSH_SOLVED) ++solved;
    pivots += (uint32_t)LCPUSH(pivots)(push);
    put_number("run ", (uint32_t)k);
    put(" status ");
    put(lcpush_status_text(status));
    put_number(" pivots ", (uint32_t)LCPUSH(pivots)(push));
    put_hex(" hash ", hash);
    put("\n");
  }
  put_number("run all solved ", solved);
  put_number(" pivots ", pivots);
  put_hex(" hash ", all);
  put("\nend\n");
  return 0;
}
