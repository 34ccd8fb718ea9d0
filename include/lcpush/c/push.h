/* The part of lcpush.h that comes once a precision; include lcpush.h, not this. */

/* The object; the inertia about its centre of mass, row by row. */
typedef struct LCPUSH_NAME(object) {
  LCPUSH_REAL mass;       /* kg, > 0 */
  LCPUSH_REAL inertia[9]; /* kg m^2, symmetric positive definite */
  LCPUSH_REAL wrench[6];  /* applied beside the weight, [N; N m]; 0: nothing */
} LCPUSH_NAME(object);

/* A position, m from the centre of mass. */
typedef struct LCPUSH_NAME(point) {
  LCPUSH_REAL x, y, z;
} LCPUSH_NAME(point);

/* A rigid body that touches the object at points that share one normal. */
typedef struct LCPUSH_NAME(body) {
  lcpush_role role;
  LCPUSH_REAL normal[3];      /* from the body into the object; any length but 0 */
  LCPUSH_REAL tangent[3];     /* first friction direction; all 0: chosen from the normal */
  LCPUSH_REAL friction;       /* Coulomb's mu, >= 0 */
  LCPUSH_REAL torsion_radius; /* m; > 0 makes a single point a soft contact */
  int bilateral;              /* not 0: holds its normal motion, pulling if it must */
  int first_point, point_count;
  LCPUSH_REAL acceleration[6]; /* prescribed part of its twist, [m/s^2; rad/s^2] */
  LCPUSH_REAL preload; /* N; of a locked finger: what it pressed with before it stood still */
} LCPUSH_NAME(body);

/* A force-controlled degree of freedom of the hand. */
typedef struct LCPUSH_NAME(actuator) {
  LCPUSH_REAL force;   /* N, the force that it holds */
  LCPUSH_REAL inertia; /* kg, >= 0; 0: the force is held exactly */
} LCPUSH_NAME(actuator);

/* `actuator` moves `body` with `twist` per unit, positive = closing. */
typedef struct LCPUSH_NAME(drive) {
  int body, actuator;
  LCPUSH_REAL twist[6];
} LCPUSH_NAME(drive);

typedef struct LCPUSH_NAME(scene) {
  LCPUSH_NAME(object) object;
  LCPUSH_REAL gravity[3]; /* m/s^2 */
  int facets;             /* sides of a friction pyramid: even, 4..256; or LCPUSH_ROUND */
  lcpush_pressure pressure;
  int planar; /* not 0: motion, and friction at normals that lie in it, in the x-y plane only */
  const LCPUSH_NAME(body) * bodies;
  int body_count;
  const LCPUSH_NAME(point) * points; /* body by body */
  int point_count;
  const LCPUSH_NAME(actuator) * actuators;
  int actuator_count;
  const LCPUSH_NAME(drive) * drives;
  int drive_count;
  const LCPUSH_REAL*
      weights; /* a point: its share of its body's force, in proportion; NULL: equal */
} LCPUSH_NAME(scene);

/* What a contact point does. */
typedef struct LCPUSH_NAME(contact) {
  int body; /* of the scene */
  lcpush_mode mode;
  LCPUSH_REAL normal_force;      /* N, on the object; < 0 where a bilateral body pulls */
  LCPUSH_REAL friction_force[3]; /* N, on the object */
  LCPUSH_REAL torsion;           /* N m about the normal, soft contacts only */
  LCPUSH_REAL acceleration[3];   /* m/s^2, of the object's point relative to its body */
} LCPUSH_NAME(contact);

/* The push that just moves the object in the grip. */
typedef struct LCPUSH_NAME(breaking) {
  LCPUSH_REAL break_force; /* N, the pusher's normal forces */
  LCPUSH_REAL wrench[6];   /* the pusher's, [N; N m] */
  LCPUSH_REAL inertia[6];  /* what a push of 1 m/s^2 adds to it */
  LCPUSH_REAL twist[6];    /* the object's, per m/s^2 of push */
  LCPUSH_REAL rest[6];     /* the object's acceleration before the push */
  int breaks; /* 0: the object does not move, the pusher slides along, rests or leaves */
} LCPUSH_NAME(breaking);

typedef struct LCPUSH_NAME(push) LCPUSH_NAME(push);

/* A push in `memory`, which stays the caller's, aligned as a double, and must not move while the
 * push is used. NULL if `bytes` are too few for `size`, or that are more than 16383 unknowns,
 * 2047 points, or 8191 of anything. It is solved by Lemke's pivots. */
LCPUSH_NAME(push) * LCPUSH_NAME(make)(void* memory, size_t bytes, const lcpush_size* size);

/* The same, solved by sweeps of Gauss-Seidel: for patches of dozens of points. */
LCPUSH_NAME(push) *
    LCPUSH_NAME(make_for_sweeps)(void* memory, size_t bytes, const lcpush_size* size);

/* Copies and checks the scene, which may go away afterwards, and assembles its equations; the last
 * answer is forgotten. RUNNING (ready to solve), or BAD_INPUT with lcpush_why: then scene and
 * answer are still those of before. The same holds for every other call that says BAD_INPUT. Cost:
 * O(forces drives). */
lcpush_status LCPUSH_NAME(describe)(LCPUSH_NAME(push) * push, const LCPUSH_NAME(scene) * scene);

/* New grip forces and prescribed accelerations for the same contacts: for control loops. A force an
 * actuator, six numbers of acceleration a body, in the scene's order; either may be NULL: as they
 * were. The solve starts where the last one ended, most often a few pivots away. Where several
 * forces or motions obey the laws, it stays with the last ones: lcpush_describe forgets them. A
 * solve that is under way ends; the new one begins at its basis, mostly nearer to the end. Only a
 * command that changes nothing lets it go on. */
lcpush_status LCPUSH_NAME(command)(LCPUSH_NAME(push) * push, const LCPUSH_REAL* forces,
                                   const LCPUSH_REAL* accelerations);

/* At most `pivots` steps of one pivot each, the first call after describe or command starts and the
 * next ones go on; a push made for sweeps solves all at once. RUNNING, or how the solve ended. With
 * pivots <= 0 it says so and does nothing. Cost of a step: O(n) and
 * O(points^2). At the end of a round of the pad law, or when a basis is factored afresh, O(n) and
 * O(points^3). */
lcpush_status LCPUSH_NAME(step)(LCPUSH_NAME(push) * push, int pivots);

/* Steps of one pivot each until they have done so much `work`; the last may go beyond it, by a
 * round's end or a basis factored afresh at most. Counted alike on every machine, so that a run can
 * be repeated; docs/embed/tables.md says what a unit costs on yours. */
lcpush_status LCPUSH_NAME(step_within)(LCPUSH_NAME(push) * push, unsigned work);

/* The work of all steps so far, modulo 2^32; 0 of a push made for sweeps. */
unsigned LCPUSH_NAME(work)(const LCPUSH_NAME(push) * push);

/* Steps to the end. */
lcpush_status LCPUSH_NAME(solve)(LCPUSH_NAME(push) * push);

/* The force that breaks the grasp, of body `pusher`. SOLVED, DOES_NOT_HOLD or a failure. The
 * contacts are then those of a small push. */
lcpush_status LCPUSH_NAME(break_grasp)(LCPUSH_NAME(push) * push, int pusher,
                                       LCPUSH_NAME(breaking) * breaking);

/* The most pivots a solve may take before it says PIVOT_LIMIT; 0, the default: each run's own limit
 * alone. The next lcpush_step or lcpush_solve goes on where it was interrupted, for as many again.
 */
void LCPUSH_NAME(limit)(LCPUSH_NAME(push) * push, int pivots);

/* The last answer: of the last solve that ended in SOLVED, or in NOT_SETTLED with an answer over
 * pyramids, or of lcpush_break_grasp, since lcpush_describe. It stays while a later solve is under
 * way, has failed or was refused; but a command that changes grip forces scales its forces body by
 * body: those of driven bodies to the new grip, those of the others towards balance, all of them
 * within their friction cones. Motion and modes stay. Where several actuators drive a body, the
 * grip of the last of them is kept. Zeros where there is no answer. */
void LCPUSH_NAME(acceleration)(const LCPUSH_NAME(push) * push, LCPUSH_REAL out[6]);
void LCPUSH_NAME(contact_at)(const LCPUSH_NAME(push) * push, int point, LCPUSH_NAME(contact) * out);
void LCPUSH_NAME(wrench_of)(const LCPUSH_NAME(push) * push, int body, LCPUSH_REAL out[6]);
LCPUSH_REAL LCPUSH_NAME(closing_of)(const LCPUSH_NAME(push) * push, int actuator);

/* How many ticks old it is: 0 right after SOLVED, or NOT_SETTLED with an answer; -1: there is none.
 * A tick is a command, taken or refused, with the steps that follow, or without a command each step
 * that ends without an answer. */
int LCPUSH_NAME(age)(const LCPUSH_NAME(push) * push);

/* By how much it violates the laws of the scene as last commanded, at most and scaled, by a check
 * that shares nothing with the solver. Cost at an age > 0: O(forces). */
LCPUSH_REAL LCPUSH_NAME(residual)(const LCPUSH_NAME(push) * push);

lcpush_status LCPUSH_NAME(status_of)(const LCPUSH_NAME(push) * push);
lcpush_mistake LCPUSH_NAME(why)(const LCPUSH_NAME(push) * push); /* after BAD_INPUT */
int LCPUSH_NAME(pivots)(const LCPUSH_NAME(push) * push);
int LCPUSH_NAME(sweeps)(const LCPUSH_NAME(push) * push);
int LCPUSH_NAME(rounds)(const LCPUSH_NAME(push) * push); /* of the pad law */

#include "lcpush/c/hold.h"
#include "lcpush/c/motion.h"
