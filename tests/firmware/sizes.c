/* One grasp at several sizes, for the table in docs/embed/tables.md: two fingers of k points each and
 * a straight edge that pushes off the middle. */
#include "device.h"

#define MOST_POINTS 10
#define MOST_FACETS 8
static double memory[LCPUSH_BYTES(REAL, 3, MOST_POINTS, MOST_FACETS, 2, 2) / sizeof(double) + 1];

static const REAL ring[4][2] = {{R(0.005), 0}, {R(-0.005), 0}, {0, R(0.005)}, {0, R(-0.005)}};
static const LCPUSH(point) edge[2] = {{R(-0.05), R(-0.01), 0}, {R(-0.05), R(0.02), 0}};
static const LCPUSH(actuator) actuators[2] = {{20, 0}, {20, 0}};
static const LCPUSH(drive) drives[2] = {{0, 0, {0, 0, -1, 0, 0, 0}}, {1, 1, {0, 0, 1, 0, 0, 0}}};

static LCPUSH(point) points[MOST_POINTS];
static LCPUSH(body) bodies[3];
static LCPUSH(scene) scene;

/* Copied from flash, so that nothing has to be in .data. */
static const LCPUSH(body) bodies_in_flash[3] = {
    {LCPUSH_FINGER, {0, 0, -1}, {1, 0, 0}, R(0.5), 0, 0, 0, 0, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_FINGER, {0, 0, 1}, {1, 0, 0}, R(0.5), 0, 0, 0, 0, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_PUSHER, {1, 0, 0}, {0, 1, 0}, R(0.3), 0, 0, 0, 2, {R(0.1), 0, 0, 0, 0, 0}, 0}};
static const LCPUSH(scene) scene_in_flash = {{R(0.2), BOX(0.2, 0.1, 0.03, 0.01), {0}},
                              {0, R(-9.81), 0},
                              4,
                              LCPUSH_RIGID,
                              0,
                              bodies,
                              3,
                              points,
                              0,
                              actuators,
                              2,
                              drives,
                              2,
                              0};

/* Fingers of k points: the first of the ring, or one in the middle. */
static void place(int k) {
  int finger, i;
  scene = scene_in_flash;
  for (i = 0; i < 3; ++i) bodies[i] = bodies_in_flash[i];
  for (finger = 0; finger < 2; ++finger) {
    bodies[finger].first_point = finger * k;
    bodies[finger].point_count = k;
    for (i = 0; i < k; ++i) {
      LCPUSH(point)* const point = &points[finger * k + i];
      point->x = k > 1 ? ring[i][0] : 0;
      point->y = k > 1 ? ring[i][1] : 0;
      point->z = finger == 0 ? R(0.005) : R(-0.005);
    }
  }
  bodies[2].first_point = 2 * k;
  points[2 * k] = edge[0];
  points[2 * k + 1] = edge[1];
  scene.point_count = 2 * k + 2;
}

static LCPUSH(push) * push;
static lcpush_status status;
static void describe(void) { status = LCPUSH(describe)(push, &scene); }
static void solve(void) { status = LCPUSH(solve)(push); }

typedef enum solver { PIVOTS, SWEEPS } solver;
static const char* const solvers[2] = {"pivots", "sweeps"};
static const char* const laws[3] = {"pad", "even", "rigid"}; /* in lcpush_pressure's order */

static void report(int k, int facets, lcpush_pressure law, solver by) {
  const int p = 2 * k + 2;
  const lcpush_size size = {3, p, facets, 2, 2, 0};
  const uint32_t bytes = (uint32_t)(by == PIVOTS ? LCPUSH_BYTES(REAL, 3, p, facets, 2, 2)
                                                 : LCPUSH_SWEEP_BYTES(REAL, 3, p, facets, 2, 2));
  cost described, solved;
  place(k);
  scene.facets = facets;
  scene.pressure = law;
  push = (by == PIVOTS ? LCPUSH(make) : LCPUSH(make_for_sweeps))(memory, bytes, &size);
  if (push == NULL) return;
  described = measure(describe);
  solved = measure(solve);
  put_number("run p", (uint32_t)p);
  put_number(".g", (uint32_t)facets);
  put(".");
  put(laws[law]);
  put(".");
  put(solvers[by]);
  put(" status ");
  put(lcpush_status_text(status));
  put_number(" unknowns ", (uint32_t)LCPUSH_UNKNOWNS(p, facets, 2));
  put_number(" bytes ", bytes);
  put_number(" steps ", (uint32_t)(LCPUSH(pivots)(push) + LCPUSH(sweeps)(push)));
  put_number(" describe_ticks ", described.ticks);
  put_number(" describe_stack ", described.stack);
  put_number(" ticks ", solved.ticks);
  put_number(" stack ", solved.stack);
  put("\n");
}

int main(void) {
  static const int fingers[3] = {1, 2, 4};
  int i, facets;
  for (facets = 4; facets <= MOST_FACETS; facets += 4)
    for (i = 0; i < 3; ++i) {
      report(fingers[i], facets, LCPUSH_RIGID, PIVOTS);
      report(fingers[i], facets, LCPUSH_PAD, PIVOTS);
      report(fingers[i], facets, LCPUSH_RIGID, SWEEPS);
    }
  put("end\n");
  return 0;
}
