/* The C interface, compiled as C99 with -pedantic -Werror. Exit 0: all held. */
#include "slide.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int faults = 0;

static void check(int holds, const char* what, int line) {
  if (holds) return;
  printf("line %d: %s\n", line, what);
  ++faults;
}
#define CHECK(condition) check(condition, #condition, __LINE__)

SLIDE_SCENE(lcpush, double, slide_d);
SLIDE_SCENE(lcpushf, float, slide_f);

static const lcpush_size size = {3, 3, 4, 2, 2, 0};
static double memory_d[LCPUSH_BYTES(double, 3, 3, 4, 2, 2) / sizeof(double) + 1];
static double memory_f[LCPUSH_BYTES(float, 3, 3, 4, 2, 2) / sizeof(double) + 1];
static double sweep_memory[LCPUSH_SWEEP_BYTES(double, 3, 3, 4, 2, 2) / sizeof(double) + 1];

/* The slide whose pusher leaves: not what one expects of a pusher, so it takes pivots. */
static lcpush_scene leaving(lcpush_body bodies[3]) {
  lcpush_scene scene = slide_d;
  memcpy(bodies, slide_d_bodies, sizeof slide_d_bodies);
  bodies[2].acceleration[0] = -0.1;
  scene.bodies = bodies;
  return scene;
}

static lcpush_contact contact_at(const lcpush_push* push, int point) {
  lcpush_contact contact;
  lcpush_contact_at(push, point, &contact);
  return contact;
}

static int near(double x, double y, double tolerance) { return fabs(x - y) <= tolerance; }

static void solves_in_double(void) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  double a[6], wrench[6];
  CHECK(push != NULL);
  if (push == NULL) return;
  CHECK(lcpush_solve(push) == LCPUSH_BAD_INPUT && lcpush_why(push) == LCPUSH_NOT_DESCRIBED);
  CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  CHECK(lcpush_status_of(push) == LCPUSH_SOLVED);
  lcpush_acceleration(push, a);
  CHECK(near(a[0], 0.1, 1e-12) && near(a[1], 0, 1e-12) && near(a[5], 0, 1e-10));
  CHECK(contact_at(push, 2).body == 2 && near(contact_at(push, 2).normal_force, 20.02, 1e-9));
  CHECK(contact_at(push, 2).mode == LCPUSH_STICK);
  CHECK(near(contact_at(push, 0).normal_force, 20, 1e-9) &&
        near(contact_at(push, 0).friction_force[0], -10, 1e-9));
  CHECK(contact_at(push, 0).mode == LCPUSH_SLIDE);
  lcpush_wrench_of(push, 2, wrench);
  CHECK(near(wrench[0], 20.02, 1e-9));
  CHECK(near(lcpush_closing_of(push, 0), 0, 1e-9));
  CHECK(lcpush_residual(push) < 1e-10);
  CHECK(lcpush_pivots(push) == 0); /* as one expects */
  CHECK(contact_at(push, 99).normal_force == 0);
}

static void solves_in_float(void) {
  lcpushf_push* push = lcpushf_make(memory_f, sizeof memory_f, &size);
  lcpushf_contact contact;
  CHECK(push != NULL);
  if (push == NULL) return;
  CHECK(lcpushf_describe(push, &slide_f) == LCPUSH_RUNNING);
  CHECK(lcpushf_solve(push) == LCPUSH_SOLVED);
  lcpushf_contact_at(push, 2, &contact);
  CHECK(near(contact.normal_force, 20.02, 2e-3));
  CHECK(lcpushf_residual(push) < 1e-4f);
}

static void steps_as_it_solves(void) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  lcpush_contact whole, stepped;
  lcpush_body bodies[3];
  const lcpush_scene scene = leaving(bodies);
  int pivots, calls = 0;
  (void)lcpush_describe(push, &scene);
  (void)lcpush_solve(push);
  lcpush_contact_at(push, 0, &whole);
  pivots = lcpush_pivots(push);
  CHECK(pivots > 0);
  (void)lcpush_describe(push, &scene);
  while (lcpush_step(push, 1) == LCPUSH_RUNNING) ++calls;
  CHECK(calls + 1 >= pivots && calls < pivots + 40);
  CHECK(lcpush_pivots(push) == pivots);
  lcpush_contact_at(push, 0, &stepped);
  CHECK(memcmp(&whole, &stepped, sizeof whole) == 0);
}

static void obeys_commands(void) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  const double forces[2] = {30, 30};
  const double faster[3][6] = {{0}, {0}, {0.5, 0, 0, 0, 0, 0}};
  lcpush_body bodies[3];
  const lcpush_scene scene = leaving(bodies);
  CHECK(lcpush_command(push, forces, NULL) == LCPUSH_BAD_INPUT);
  (void)lcpush_describe(push, &slide_d);
  (void)lcpush_solve(push);
  CHECK(lcpush_command(push, forces, faster[0]) == LCPUSH_RUNNING);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  CHECK(near(contact_at(push, 2).normal_force, 30 + 0.2 * 0.5, 1e-9));
  lcpush_limit(push, 1);
  CHECK(lcpush_describe(push, &scene) == LCPUSH_RUNNING);
  CHECK(lcpush_solve(push) == LCPUSH_PIVOT_LIMIT && lcpush_pivots(push) == 1);
  CHECK(contact_at(push, 2).normal_force == 0);
}

/* A limit interrupts: the same pivots as without, one a tick. And commands that change a little
 * every tick come to an end as well, or a gripper would never have an answer. */
static void goes_on_after_a_limit(void) {
  double forces[2] = {20, 20};
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  lcpush_body bodies[3];
  const lcpush_scene scene = leaving(bodies);
  lcpush_contact whole, stepped;
  int pivots, ticks, law;
  for (law = LCPUSH_PAD; law <= LCPUSH_RIGID; law += LCPUSH_RIGID) {
    lcpush_scene other = scene;
    other.pressure = law;
    lcpush_limit(push, 0);
    (void)lcpush_describe(push, &other);
    CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
    lcpush_contact_at(push, 0, &whole);
    pivots = lcpush_pivots(push);
    CHECK(pivots > 2);
    lcpush_limit(push, 1);
    (void)lcpush_describe(push, &other);
    for (ticks = 1; lcpush_solve(push) == LCPUSH_PIVOT_LIMIT && ticks < 99; ++ticks) {
      CHECK(lcpush_pivots(push) == ticks);
      CHECK(lcpush_command(push, forces, NULL) == LCPUSH_RUNNING); /* as it was */
    }
    lcpush_contact_at(push, 0, &stepped);
    CHECK(lcpush_status_of(push) == LCPUSH_SOLVED && lcpush_pivots(push) == pivots);
    CHECK(memcmp(&whole, &stepped, sizeof whole) == 0);
    (void)lcpush_describe(push, &other);
    for (ticks = 1; lcpush_solve(push) == LCPUSH_PIVOT_LIMIT && ticks < 99; ++ticks) {
      forces[0] = forces[1] = 20 + 0.01 * ticks;
      CHECK(lcpush_command(push, forces, NULL) == LCPUSH_RUNNING);
      lcpush_limit(push, pivots - 1);
    }
    CHECK(lcpush_status_of(push) == LCPUSH_SOLVED && ticks < 5);
    lcpush_contact_at(push, 1, &stepped);
    CHECK(near(stepped.normal_force, forces[1], 1e-9));
    forces[0] = forces[1] = 20;
  }
}

/* Whatever happens to later solves: the answer stays, its forces pressed by the grip as it is now,
 * and it is told how old and how wrong they are. */
static void keeps_the_last_answer(void) {
  const double wrong[2] = {NAN, 20}, none[2] = {0, 0}, one[2] = {0, 12};
  double forces[2] = {30, 30};
  const double backwards[3][6] = {{0}, {0}, {-0.1, 0, 0, 0, 0, 0}};
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  double wrench[6], exact;
  int k;
  CHECK(lcpush_age(push) == -1);
  (void)lcpush_describe(push, &slide_d);
  CHECK(lcpush_age(push) == -1 && lcpush_solve(push) == LCPUSH_SOLVED && lcpush_age(push) == 0);
  exact = lcpush_residual(push);
  for (k = 1; k < 4; ++k) { /* refused: they are as right as they were */
    CHECK(lcpush_command(push, wrong, NULL) == LCPUSH_BAD_INPUT && lcpush_age(push) == k);
    CHECK(lcpush_step(push, 1) == LCPUSH_SOLVED && lcpush_age(push) == k);
    CHECK(near(lcpush_residual(push), exact, 1e-9));
  }
  lcpush_limit(push, 1);
  for (k = 4; k < 7; ++k) { /* interrupted, again and again */
    forces[0] = 20 + k;
    CHECK(lcpush_command(push, forces, backwards[0]) == LCPUSH_RUNNING);
    CHECK(lcpush_age(push) == k && lcpush_residual(push) > 0.1);
    CHECK(lcpush_step(push, 1) == LCPUSH_RUNNING && lcpush_age(push) == k);
    lcpush_wrench_of(push, 2, wrench);
    CHECK(near(wrench[0], 0.5 * (forces[0] + forces[1]) + 0.02, 1e-9));
    CHECK(near(contact_at(push, 0).normal_force, forces[0], 1e-9) &&
          near(contact_at(push, 0).friction_force[0], -0.5 * forces[0], 1e-9));
    CHECK(near(lcpush_closing_of(push, 0), 0, 1e-9) && contact_at(push, 0).mode == LCPUSH_SLIDE);
  }
  CHECK(lcpush_solve(push) == LCPUSH_PIVOT_LIMIT && lcpush_age(push) == 7);
  CHECK(near(contact_at(push, 2).normal_force, 28.02, 1e-9) && contact_at(push, 2).body == 2);
  /* No grip, and one of one finger: where nothing pressed it presses evenly, and does not rub. */
  CHECK(lcpush_command(push, none, NULL) == LCPUSH_RUNNING);
  CHECK(contact_at(push, 0).normal_force == 0 && contact_at(push, 1).friction_force[0] == 0);
  CHECK(near(contact_at(push, 2).normal_force, 0.02, 1e-9));
  CHECK(lcpush_command(push, one, NULL) == LCPUSH_RUNNING && lcpush_age(push) == 9);
  CHECK(near(contact_at(push, 1).normal_force, 12, 1e-9) && contact_at(push, 0).normal_force == 0);
  CHECK(contact_at(push, 1).friction_force[0] == 0 && lcpush_residual(push) > 0.1);
  lcpush_limit(push, 0);
  CHECK(lcpush_command(push, forces, NULL) == LCPUSH_RUNNING && lcpush_age(push) == 10);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED && lcpush_age(push) == 0);
  CHECK(contact_at(push, 2).mode == LCPUSH_SEPARATE && lcpush_residual(push) < 1e-9);
  CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING && lcpush_age(push) == -1);
  CHECK(contact_at(push, 0).normal_force == 0); /* another scene's */
}

static void commands_go_on_from_the_last_basis(void) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  const double forces[2] = {22, 22};
  const double backwards[3][6] = {{0}, {0}, {-0.1, 0, 0, 0, 0, 0}};
  int cold;
  (void)lcpush_describe(push, &slide_d);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  cold = lcpush_pivots(push);
  (void)lcpush_command(push, forces, NULL);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED && lcpush_pivots(push) == 0);
  CHECK(near(contact_at(push, 2).normal_force, 22.02, 1e-9));
  /* The pusher leaves: another basis, found from this one. */
  (void)lcpush_command(push, NULL, backwards[0]);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED && lcpush_pivots(push) > 0);
  CHECK(contact_at(push, 2).mode == LCPUSH_SEPARATE);
  /* A scene is another story. */
  (void)lcpush_describe(push, &slide_d);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED && lcpush_pivots(push) == cold);
}

static void breaks_the_grasp(void) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  lcpush_breaking breaking;
  (void)lcpush_describe(push, &slide_d);
  CHECK(lcpush_break_grasp(push, 2, &breaking) == LCPUSH_SOLVED);
  CHECK(near(breaking.break_force, 20, 1e-6) && near(breaking.twist[0], 1, 1e-6));
  CHECK(near(breaking.inertia[0], 0.2, 1e-5));
  CHECK(lcpush_break_grasp(push, 7, &breaking) == LCPUSH_BAD_INPUT);
  CHECK(lcpush_why(push) == LCPUSH_BAD_INDEX);
}

/* Between two generators of eight a pyramid holds 2 mu F cos(22.5 degrees); a round cone all of it.
 */
static void friction_may_be_round(void) {
  static const lcpush_size most = {3, 3, 8, 2, 2, 0};
  static double memory[LCPUSH_BYTES(double, 3, 3, 8, 2, 2) / sizeof(double) + 1];
  static double memory_of_sweeps[LCPUSH_SWEEP_BYTES(double, 3, 3, 8, 2, 2) / sizeof(double) + 1];
  lcpush_push* pushes[2];
  lcpush_body bodies[3];
  lcpush_scene scene = slide_d;
  lcpush_breaking breaking;
  lcpush_held held;
  int i;
  pushes[0] = lcpush_make(memory, sizeof memory, &most);
  pushes[1] = lcpush_make_for_sweeps(memory_of_sweeps, sizeof memory_of_sweeps, &most);
  for (i = 0; i < 3; ++i) bodies[i] = slide_d.bodies[i];
  for (i = 0; i < 2; ++i) {
    bodies[i].tangent[0] = cos(atan(1) / 2);
    bodies[i].tangent[1] = sin(atan(1) / 2);
  }
  scene.bodies = bodies;
  for (i = 0; i < 2; ++i) {
    CHECK(pushes[i] != NULL);
    if (pushes[i] == NULL) return;
    scene.facets = 8;
    CHECK(lcpush_describe(pushes[i], &scene) == LCPUSH_RUNNING);
    CHECK(lcpush_solve(pushes[i]) == LCPUSH_SOLVED);
    CHECK(contact_at(pushes[i], 2).normal_force < 20);
    scene.facets = LCPUSH_ROUND;
    CHECK(lcpush_describe(pushes[i], &scene) == LCPUSH_RUNNING);
    CHECK(lcpush_solve(pushes[i]) == LCPUSH_SOLVED);
    CHECK(near(contact_at(pushes[i], 2).normal_force, 20.02, 1e-6));
  }
  CHECK(lcpush_break_grasp(pushes[0], 2, &breaking) == LCPUSH_SOLVED);
  CHECK(near(breaking.break_force, 20, 1e-6));
  CHECK(lcpush_least_grip(pushes[0], 99, &held) == LCPUSH_BAD_INPUT);
  CHECK(lcpush_why(pushes[0]) == LCPUSH_UNSUPPORTED);
  CHECK(strcmp(lcpush_status_text(LCPUSH_NOT_SETTLED), "not_settled") == 0);
}

/* What the fingers hold is |x| + |y| <= 2 mu F; beside a push that is under way or solved, by the
 * memory of either solver. */
static void tells_what_the_fingers_hold(void) {
  static const double beside[6] = {2, 0, 0, 0, 0, 0}, harder[2] = {30, 30};
  static const float beside_f[6] = {2, 0, 0, 0, 0, 0};
  const double wrong[6] = {NAN, 0, 0, 0, 0, 0};
  lcpush_push* pushes[2];
  lcpushf_push* push_f = lcpushf_make(memory_f, sizeof memory_f, &size);
  lcpush_body bodies[3];
  lcpush_scene scene = leaving(bodies);
  lcpushf_scene scene_f = slide_f;
  lcpush_held held;
  lcpushf_held held_f;
  int i, pivots;
  scene.object.wrench[1] = scene_f.object.wrench[1] = -4;
  pushes[0] = lcpush_make(memory_d, sizeof memory_d, &size);
  pushes[1] = lcpush_make_for_sweeps(sweep_memory, sizeof sweep_memory, &size);
  for (i = 0; i < 2; ++i) {
    lcpush_push* const push = pushes[i];
    CHECK(lcpush_least_grip(push, 99, &held) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_why(push) == LCPUSH_NOT_DESCRIBED && held.value == 0);
    (void)lcpush_describe(push, &scene);
    CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
    pivots = lcpush_pivots(push);
    CHECK(lcpush_least_grip(push, 99, &held) == LCPUSH_SOLVED && near(held.value, 0.2, 1e-12));
    CHECK(held.twist[1] < 0 && held.exchanges > 0);
    CHECK(lcpush_most_grip(push, 99, &held) == LCPUSH_SOLVED && isinf(held.value));
    CHECK(lcpush_margin(push, beside, 99, &held) == LCPUSH_SOLVED && near(held.value, 8, 1e-9));
    CHECK(lcpush_margin(push, beside, 1, &held) == LCPUSH_PIVOT_LIMIT && held.exchanges == 1);
    held.value = 1;
    CHECK(lcpush_margin(push, wrong, 99, &held) == LCPUSH_BAD_INPUT && held.value == 0);
    CHECK(lcpush_why(push) == LCPUSH_NOT_FINITE);
    CHECK(lcpush_status_of(push) == LCPUSH_SOLVED && lcpush_age(push) == 0);
    CHECK(contact_at(push, 2).mode == LCPUSH_SEPARATE && lcpush_pivots(push) == pivots);
    CHECK(lcpush_command(push, harder, NULL) == LCPUSH_RUNNING);
    CHECK(lcpush_margin(push, beside, 99, &held) == LCPUSH_SOLVED && near(held.value, 13, 1e-9));
    CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  }
  /* A solve that is interrupted begins anew. */
  (void)lcpush_describe(pushes[0], &scene);
  lcpush_limit(pushes[0], 1);
  CHECK(lcpush_solve(pushes[0]) == LCPUSH_PIVOT_LIMIT);
  CHECK(lcpush_least_grip(pushes[0], 99, &held) == LCPUSH_SOLVED && near(held.value, 0.2, 1e-12));
  CHECK(lcpush_status_of(pushes[0]) == LCPUSH_RUNNING);
  lcpush_limit(pushes[0], 0);
  CHECK(lcpush_solve(pushes[0]) == LCPUSH_SOLVED);
  CHECK(contact_at(pushes[0], 2).mode == LCPUSH_SEPARATE);
  /* Heavier than the grip bears. */
  scene.object.wrench[1] = -21;
  (void)lcpush_describe(pushes[0], &scene);
  CHECK(lcpush_margin(pushes[0], beside, 99, &held) == LCPUSH_DOES_NOT_HOLD && held.twist[1] < 0);
  (void)lcpushf_describe(push_f, &scene_f);
  CHECK(lcpushf_least_grip(push_f, 99, &held_f) == LCPUSH_SOLVED && near(held_f.value, 0.2, 1e-6));
  CHECK(lcpushf_margin(push_f, beside_f, 99, &held_f) == LCPUSH_SOLVED);
  CHECK(near(held_f.value, 8, 1e-4));
}

static void sweeps_agree(void) {
  lcpush_push* push = lcpush_make_for_sweeps(sweep_memory, sizeof sweep_memory, &size);
  CHECK(push != NULL);
  if (push == NULL) return;
  (void)lcpush_describe(push, &slide_d);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  CHECK(lcpush_sweeps(push) > 0 && lcpush_pivots(push) == 0);
  CHECK(near(contact_at(push, 2).normal_force, 20.02, 1e-6));
}

static void even_pressure_spreads(void) {
  /* A line finger of two points, by their shares; the scene's bodies, actuators and drives are
   * counted as given and point by point. */
  static const lcpush_point points[4] = {
      {-0.01, 0, 0.005}, {0.01, 0, 0.005}, {0, 0, -0.005}, {-0.05, 0, 0}};
  static const lcpush_size even_size = {7, 4, 4, 5, 5, 0}, too_small = {6, 4, 4, 5, 5, 0};
  static const double harder[2] = {30, 30};
  static double memory[LCPUSH_BYTES(double, 7, 4, 4, 5, 5) / sizeof(double) + 1];
  lcpush_body bodies[3];
  lcpush_scene scene = slide_d;
  lcpush_push* push = lcpush_make(memory, sizeof memory, &even_size);
  double wrench[6];
  CHECK(push != NULL);
  if (push == NULL) return;
  memcpy(bodies, slide_d_bodies, sizeof bodies);
  bodies[0].point_count = 2;
  bodies[1].first_point = 2;
  bodies[2].first_point = 3;
  scene.bodies = bodies;
  scene.points = points;
  scene.point_count = 4;
  scene.pressure = LCPUSH_EVEN;
  scene.planar = 1;
  CHECK(lcpush_describe(push, &scene) == LCPUSH_RUNNING);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  CHECK(contact_at(push, 1).body == 0 && near(contact_at(push, 1).normal_force, 10, 1e-9));
  CHECK(contact_at(push, 3).body == 2 && near(contact_at(push, 3).normal_force, 20.02, 1e-9));
  lcpush_wrench_of(push, 0, wrench);
  CHECK(near(wrench[2], -20, 1e-9));
  CHECK(near(lcpush_closing_of(push, 0), 0, 1e-9));
  /* A command is about the bodies as given, which are spread again. */
  CHECK(lcpush_command(push, harder, NULL) == LCPUSH_RUNNING);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  lcpush_wrench_of(push, 0, wrench);
  CHECK(near(wrench[2], -30, 1e-9));
  CHECK(near(contact_at(push, 0).normal_force, 15, 1e-9));
  /* Points are pads of their own already: nothing is kept twice. */
  scene.bodies = slide_d_bodies;
  scene.points = slide_d_points;
  scene.point_count = 3;
  push = lcpush_make(memory, sizeof memory, &size);
  CHECK(lcpush_describe(push, &scene) == LCPUSH_RUNNING && lcpush_solve(push) == LCPUSH_SOLVED);
  CHECK(near(lcpush_closing_of(push, 1), 0, 1e-9));
  /* And patches are not spread where there is no room. */
  scene.bodies = bodies;
  scene.points = points;
  scene.point_count = 4;
  push = lcpush_make(memory, sizeof memory, &too_small);
  CHECK(lcpush_describe(push, &scene) == LCPUSH_BAD_INPUT);
  CHECK(lcpush_why(push) == LCPUSH_MEMORY_TOO_SMALL);
}

static void every_mistake_has_its_own_words(void) {
  static const struct {
    lcpush_mistake mistake;
    const char* word;
  } expected[] = {{LCPUSH_MEMORY_TOO_SMALL, "memory"}, {LCPUSH_NOT_FINITE, "finite"},
                  {LCPUSH_BAD_MASS, "mass"},           {LCPUSH_BAD_FACETS, "facets"},
                  {LCPUSH_BAD_DIRECTION, "tangent"},   {LCPUSH_BAD_FRICTION, "torsion"},
                  {LCPUSH_BAD_INDEX, "index"},         {LCPUSH_BAD_ACTUATOR, "drives nothing"},
                  {LCPUSH_UNSUPPORTED, "shares"},      {LCPUSH_NOTHING_MOVES, "pusher"},
                  {LCPUSH_NOT_DESCRIBED, "describe"},  {LCPUSH_BAD_WEIGHTS, "weights"}};
  size_t k;
  for (k = 0; k < sizeof expected / sizeof expected[0]; ++k)
    check(strstr(lcpush_mistake_text(expected[k].mistake), expected[k].word) != NULL,
          expected[k].word, __LINE__);
}

static void refuses(lcpush_scene scene, lcpush_mistake mistake, int line) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  check(lcpush_describe(push, &scene) == LCPUSH_BAD_INPUT, "refused", line);
  check(lcpush_why(push) == mistake, lcpush_mistake_text(lcpush_why(push)), line);
  check(strlen(lcpush_mistake_text(mistake)) > 10, "has words", line);
  check(lcpush_step(push, 1) == LCPUSH_BAD_INPUT, "does not solve", line);
}
#define REFUSES(mistake) refuses(scene, mistake, __LINE__)

static void refuses_nonsense(void) {
  lcpush_scene scene = slide_d;
  lcpush_body bodies[3];
  lcpush_actuator actuators[2] = {{20, 0}, {-1, 0}};
  lcpush_drive drives[2];
  memcpy(drives, slide_d_drives, sizeof drives);
  scene.object.mass = 0;
  REFUSES(LCPUSH_BAD_MASS);
  scene.object.mass = NAN;
  REFUSES(LCPUSH_NOT_FINITE);
  scene = slide_d;
  scene.object.inertia[4] = -1;
  REFUSES(LCPUSH_BAD_MASS);
  scene = slide_d;
  scene.facets = 5;
  REFUSES(LCPUSH_BAD_FACETS);
  scene.facets = 8; /* more than the size says */
  REFUSES(LCPUSH_MEMORY_TOO_SMALL);
  scene = slide_d;
  scene.point_count = 4;
  REFUSES(LCPUSH_MEMORY_TOO_SMALL);
  scene = slide_d;
  scene.pressure = 9;
  REFUSES(LCPUSH_UNSUPPORTED);
  scene.pressure = -1;
  REFUSES(LCPUSH_UNSUPPORTED);
  scene = slide_d;
  scene.bodies = bodies;
  memcpy(bodies, slide_d_bodies, sizeof bodies);
  bodies[1].normal[2] = 0;
  REFUSES(LCPUSH_BAD_DIRECTION);
  memcpy(bodies, slide_d_bodies, sizeof bodies);
  bodies[1].tangent[0] = 0;
  bodies[1].tangent[2] = 1; /* along the normal */
  REFUSES(LCPUSH_BAD_DIRECTION);
  memcpy(bodies, slide_d_bodies, sizeof bodies);
  bodies[1].friction = -0.5;
  REFUSES(LCPUSH_BAD_FRICTION);
  memcpy(bodies, slide_d_bodies, sizeof bodies);
  bodies[1].role = 2;
  REFUSES(LCPUSH_UNSUPPORTED);
  memcpy(bodies, slide_d_bodies, sizeof bodies);
  bodies[2].first_point = 1;
  REFUSES(LCPUSH_BAD_INDEX);
  scene = slide_d;
  scene.actuators = actuators;
  REFUSES(LCPUSH_BAD_ACTUATOR);
  scene = slide_d;
  scene.drives = drives;
  drives[1].actuator = 2;
  REFUSES(LCPUSH_BAD_INDEX);
}

/* What is no number, or so large that it overflows later, wherever it stands. */
static void refuses_what_is_not_finite(void) {
  static const float wrong[4] = {NAN, INFINITY, -INFINITY, 1e30F};
  lcpushf_push* push = lcpushf_make(memory_f, sizeof memory_f, &size);
  lcpushf_body bodies[3];
  lcpushf_point points[3];
  lcpushf_actuator actuators[2];
  lcpushf_drive drives[2];
  lcpushf_scene scene = slide_f;
  float* const numbers[] = {&scene.object.mass,       &scene.object.wrench[4],
                            &scene.gravity[1],        &points[1].z,
                            &bodies[0].friction,      &bodies[1].tangent[0],
                            &bodies[0].tangent[1],    &bodies[2].acceleration[5],
                            &bodies[2].preload,       &actuators[1].force,
                            &actuators[0].inertia,    &drives[1].twist[2],
                            &bodies[1].torsion_radius};
  size_t k;
  scene.bodies = bodies;
  scene.points = points;
  scene.actuators = actuators;
  scene.drives = drives;
  memcpy(bodies, slide_f_bodies, sizeof bodies);
  memcpy(points, slide_f_points, sizeof points);
  memcpy(actuators, slide_f_actuators, sizeof actuators);
  memcpy(drives, slide_f_drives, sizeof drives);
  for (k = 0; k < 4 * sizeof numbers / sizeof numbers[0]; ++k) {
    float* const number = numbers[k / 4];
    const float right = *number;
    const int is_direction = k / 4 == 5 || k / 4 == 6; /* of any length */
    *number = wrong[k % 4];
    if (!is_direction || k % 4 < 3) {
      check(lcpushf_describe(push, &scene) == LCPUSH_BAD_INPUT, "refused", (int)k);
      check(lcpushf_why(push) == LCPUSH_NOT_FINITE, lcpush_mistake_text(lcpushf_why(push)), (int)k);
    }
    *number = right;
  }
  CHECK(lcpushf_describe(push, &scene) == LCPUSH_RUNNING);
}

/* Whatever is refused leaves the scene and its answer. */
static void refusals_change_nothing(void) {
  const double forces[3][2] = {{20, NAN}, {1e200, 20}, {20, -1}}, harder[2] = {30, 30};
  const double motions[2][18] = {{0, 0, NAN}, {[17] = INFINITY}};
  const lcpush_riding ridings[3] = {LCPUSH_ON_BODY, 7, LCPUSH_ON_BODY};
  lcpush_push* pushes[2];
  lcpush_breaking breaking;
  int i, k;
  pushes[0] = lcpush_make(memory_d, sizeof memory_d, &size);
  pushes[1] = lcpush_make_for_sweeps(sweep_memory, sizeof sweep_memory, &size);
  for (i = 0; i < 2; ++i) {
    lcpush_push* const push = pushes[i];
    lcpush_scene scene = slide_d;
    lcpush_body bodies[3];
    double wrench[6];
    CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING);
    CHECK(lcpush_step(push, 0) == LCPUSH_RUNNING && lcpush_step(push, -1) == LCPUSH_RUNNING);
    CHECK(lcpush_sweeps(push) == 0);
    CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
    for (k = 0; k < 3; ++k) CHECK(lcpush_command(push, forces[k], NULL) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_why(push) == LCPUSH_BAD_ACTUATOR);
    for (k = 0; k < 2; ++k) CHECK(lcpush_command(push, harder, motions[k]) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_why(push) == LCPUSH_NOT_FINITE);
    CHECK(lcpush_break_grasp(push, 7, &breaking) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_break_grasp(push, -1, &breaking) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_why(push) == LCPUSH_BAD_INDEX);
    CHECK(lcpush_advance(push, 0.01) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_set_off(push, NULL, 0, NULL) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_set_off(push, NULL, 0, ridings) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_why(push) == LCPUSH_UNSUPPORTED);
    scene.bodies = bodies; /* other bodies, and something else wrong with each scene */
    memcpy(bodies, slide_d_bodies, sizeof bodies);
    bodies[0].friction = 0.1;
    bodies[2].acceleration[0] = 3;
    for (k = 0; k < 4; ++k) {
      scene.object.mass = k == 0 ? NAN : 3;
      scene.facets = k == 1 ? 8 : 4;
      scene.drive_count = k == 2 ? 1 : 2;
      bodies[1].role = k == 3 ? 9 : LCPUSH_FINGER;
      CHECK(lcpush_describe(push, &scene) == LCPUSH_BAD_INPUT);
    }
    CHECK(lcpush_status_of(push) == LCPUSH_SOLVED && lcpush_solve(push) == LCPUSH_SOLVED);
    lcpush_wrench_of(push, 2, wrench);
    CHECK(near(wrench[0], 20.02, 1e-6));
    CHECK(lcpush_command(push, harder, NULL) == LCPUSH_RUNNING); /* it is the same scene */
    CHECK(lcpush_describe(push, &scene) == LCPUSH_BAD_INPUT);
    CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
    CHECK(near(contact_at(push, 2).normal_force, 30.02, 1e-6));
  }
}

/* Numbers of anything whose bytes no size_t counts. */
static void refuses_sizes_that_overflow(void) {
  static const lcpush_size sizes[] = {
      {1 << 28, 3, 4, 2, 2, 0},       {3, 1 << 28, 4, 2, 2, 0},       {3, 3, 1 << 28, 2, 2, 0},
      {3, 3, 4, 1 << 28, 2, 0},       {3, 3, 4, 2, 1 << 28, 0},       {3, 3, 4, 2, 2, 1 << 28},
      {3, 1 << 16, 1 << 16, 2, 2, 0}, {3, 1 << 11, 4, 2, 1 << 18, 0}, {3, 3, 4, 1 << 13, 2, 0}};
  size_t k;
  for (k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
    CHECK(lcpush_make(memory_d, sizeof memory_d, &sizes[k]) == NULL);
    CHECK(lcpush_make_for_sweeps(sweep_memory, sizeof sweep_memory, &sizes[k]) == NULL);
    CHECK(lcpushf_make(memory_f, sizeof memory_f, &sizes[k]) == NULL);
  }
}

static void wants_enough_memory(void) {
  const lcpush_size negative = {3, -3, 4, 2, 2, 0};
  CHECK(lcpush_make(NULL, 100000, &size) == NULL);
  CHECK(lcpush_make(memory_d, 100, &size) == NULL);
  CHECK(lcpush_make(memory_d, sizeof memory_d / 2, &size) == NULL);
  CHECK(lcpush_make(memory_d, sizeof memory_d, &negative) == NULL);
}

static double motion_memory[LCPUSH_MOTION_BYTES(double, 3, 3, 4, 2, 2) / sizeof(double) + 1];

static void moves_on(void) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  lcpushf_push* in_float = lcpushf_make(memory_f, sizeof memory_f, &size);
  const double velocity[6] = {0.01, 0, 0, 0, 0, 0};
  const float slowly[6] = {0.01F, 0, 0, 0, 0, 0};
  double position[3], rotation[9], twist[6];
  float place[3], turn[9];
  lcpush_touch touch;
  int k;
  if (push == NULL || in_float == NULL) return;
  CHECK(lcpush_advance(push, 0.01) == LCPUSH_BAD_INPUT);
  CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING);
  CHECK(lcpush_advance(push, 0.01) == LCPUSH_BAD_INPUT && lcpush_why(push) == LCPUSH_NOT_DESCRIBED);
  CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING);
  CHECK(lcpush_motion_bytes(push) <= sizeof motion_memory);
  CHECK(lcpush_set_off(push, motion_memory, 100, NULL) == LCPUSH_BAD_INPUT);
  CHECK(lcpush_why(push) == LCPUSH_MEMORY_TOO_SMALL);
  CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING);
  CHECK(lcpush_set_off(push, motion_memory, sizeof motion_memory, NULL) == LCPUSH_RUNNING);
  lcpush_set_velocity(push, 2, velocity);
  for (k = 0; k < 100; ++k) CHECK(lcpush_advance(push, 0.01) == LCPUSH_SOLVED);
  lcpush_pose_of(push, LCPUSH_OBJECT, position, rotation);
  CHECK(near(position[0], 0.01, 1e-12) && near(position[1], 0, 1e-12) && rotation[0] == 1);
  lcpush_pose_of(push, 2, position, rotation);
  CHECK(near(position[0], 0.01, 1e-12));
  lcpush_velocity(push, twist);
  CHECK(near(twist[0], 0.01, 1e-12));
  lcpush_touch_at(push, 2, &touch);
  CHECK(touch.present && touch.body == 2 && near(touch.normal_force, 20, 1e-6));
  CHECK(near(touch.gap, 0, 1e-9) && lcpush_penetration(push) <= 1e-9);
  lcpush_touch_at(push, 0, &touch);
  CHECK(touch.mode == LCPUSH_SLIDE && near(touch.velocity[0], 0.01, 1e-9));
  CHECK(lcpush_step_residual(push) <= 1e-9 && near(lcpush_closed_by(push, 0), 0, 1e-9));
  CHECK(lcpush_advance(push, 0) == LCPUSH_BAD_INPUT);
  CHECK(lcpush_solve(push) == LCPUSH_BAD_INPUT);
  CHECK(lcpushf_describe(in_float, &slide_f) == LCPUSH_RUNNING);
  CHECK(lcpushf_set_off(in_float, motion_memory, sizeof motion_memory, NULL) == LCPUSH_RUNNING);
  lcpushf_set_velocity(in_float, 2, slowly);
  for (k = 0; k < 100; ++k) CHECK(lcpushf_advance(in_float, 0.01F) == LCPUSH_SOLVED);
  lcpushf_pose_of(in_float, LCPUSH_OBJECT, place, turn);
  CHECK(near(place[0], 0.01, 1e-5) && near(place[1], 0, 1e-5));
}

/* Steps of a motion write where the push had its equations: a command after one makes them anew. */
static void commands_between_steps(void) {
  lcpush_push* push = lcpush_make(memory_d, sizeof memory_d, &size);
  const double forces[2] = {15, 15}, velocity[6] = {0.1, 0, 0, 0, 0, 0};
  const double aside[3][6] = {{0}, {0}, {0.1, 0.3, 0, 0, 0, 1}};
  double stepped[6], fresh[6];
  int k;
  CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING);
  CHECK(lcpush_set_off(push, motion_memory, sizeof motion_memory, NULL) == LCPUSH_RUNNING);
  lcpush_set_velocity(push, 2, velocity);
  for (k = 0; k < 3; ++k) {
    CHECK(lcpush_advance(push, 0.01) == LCPUSH_SOLVED);
    CHECK(lcpush_command(push, forces, aside[0]) == LCPUSH_RUNNING);
  }
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  lcpush_acceleration(push, stepped);
  CHECK(lcpush_describe(push, &slide_d) == LCPUSH_RUNNING);
  CHECK(lcpush_command(push, forces, aside[0]) == LCPUSH_RUNNING);
  CHECK(lcpush_solve(push) == LCPUSH_SOLVED);
  lcpush_acceleration(push, fresh);
  for (k = 0; k < 6; ++k) CHECK(stepped[k] == fresh[k]);
}

/* Pivots number their unknowns by 16 bits, 1638 points of 8 facets are 16382 unknowns, and contacts
 * by 12, without a sign. */
static void refuses_more_unknowns_than_it_can_number(void) {
  const lcpush_size largest = {3, 1638, 8, 2, 2, 0}, too_large = {3, 1639, 8, 2, 2, 0};
  const lcpush_size too_many = {3, 2048, 4, 2, 2, 0};
  const size_t bytes = LCPUSH_BYTES(float, 3, 2048, 4, 2, 2);
  void* memory = malloc(bytes);
  CHECK(memory != NULL);
  if (memory == NULL) return;
  CHECK(lcpushf_make(memory, bytes, &largest) != NULL);
  CHECK(lcpushf_make(memory, bytes, &too_large) == NULL);
  CHECK(lcpushf_make(memory, bytes, &too_many) == NULL);
  free(memory);
}

int main(void) {
  solves_in_double();
  solves_in_float();
  steps_as_it_solves();
  obeys_commands();
  goes_on_after_a_limit();
  keeps_the_last_answer();
  commands_go_on_from_the_last_basis();
  breaks_the_grasp();
  tells_what_the_fingers_hold();
  sweeps_agree();
  refuses_nonsense();
  refuses_what_is_not_finite();
  refusals_change_nothing();
  refuses_sizes_that_overflow();
  wants_enough_memory();
  friction_may_be_round();
  even_pressure_spreads();
  refuses_more_unknowns_than_it_can_number();
  every_mistake_has_its_own_words();
  moves_on();
  commands_between_steps();
  CHECK(strcmp(lcpush_status_text(LCPUSH_RAY), "ray") == 0);
  CHECK(strcmp(lcpush_mode_text(LCPUSH_SLIDE), "slide") == 0);
  CHECK(strcmp(lcpush_mode_text(99), "unknown") == 0 &&
        strcmp(lcpush_status_text(-1), "unknown") == 0);
  if (faults == 0)
    printf("the C interface holds; %u bytes in double, %u in float\n", (unsigned)sizeof memory_d,
           (unsigned)sizeof memory_f);
  return faults == 0 ? 0 : 1;
}
