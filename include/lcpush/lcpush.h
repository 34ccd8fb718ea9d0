/* lcpush for C99: what happens when a grasped object is pushed against its environment.
 *
 * The caller owns the memory: LCPUSH_BYTES says how much, lcpush_make cuts a push out of it.
 * Nothing is allocated, nothing is hidden in globals, nothing is printed; same input, same bits.
 * Every function comes twice: lcpush_... on double, lcpushf_... on float (with types of the same
 * prefix).
 *
 *     static double memory[LCPUSH_BYTES(double, 3, 3, 4, 2, 2) / sizeof(double) + 1];
 *     lcpush_push* push = lcpush_make(memory, sizeof memory, &size);
 *     lcpush_describe(push, &scene);
 *     lcpush_step(push, 20);                              in a control loop: pivots a tick; the
 *     if (lcpush_age(push) >= 0)                          answers are those of the last solve that
 *       lcpush_contact_at(push, 0, &contact);             ended, so many ticks ago
 *     if (lcpush_status_of(push) != LCPUSH_RUNNING)
 *       lcpush_command(push, forces, motions);            new grip forces and accelerations
 *
 * SI units; positions from the object's centre of mass; scene axes, fixed to the hand. A twist is
 * [linear ; angular] and a wrench [force ; moment], both at the centre of mass. Push, size and
 * scene belong to one thread at a time.
 */
#ifndef LCPUSH_H
#define LCPUSH_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Enumerations are ints, whatever a compiler makes of an enum: structs have one layout. */

/* How a call ended; the order is that of lcpush::Status. */
typedef int lcpush_status;
enum {
  LCPUSH_RUNNING,             /* not finished: step again */
  LCPUSH_SOLVED,              /* an answer was found and passed the check of every law */
  LCPUSH_DOES_NOT_HOLD,       /* break: the object moves before it is pushed */
  LCPUSH_RAY,                 /* no answer by this model: most often a jam */
  LCPUSH_PIVOT_LIMIT,         /* the allowed number of pivots was used up */
  LCPUSH_SWEEP_LIMIT,         /* the allowed number of sweeps was used up */
  LCPUSH_STAGNATED,           /* the sweeps make no more progress */
  LCPUSH_NUMERICAL_BREAKDOWN, /* an answer or a ray was reached, but it fails its check */
  LCPUSH_BAD_INPUT,           /* see lcpush_mistake_text */
  LCPUSH_NOT_SETTLED          /* LCPUSH_ROUND: slips turn from round to round without end. Pivots
                                 then leave an answer over pyramids of 8 facets, of age 0, and the
                                 residual says what that misses of round friction */
};

/* What is wrong with the input. */
typedef int lcpush_mistake;
enum {
  LCPUSH_NO_MISTAKE,
  LCPUSH_MEMORY_TOO_SMALL, /* more than lcpush_size says, or than the bytes given hold */
  LCPUSH_NOT_FINITE,       /* a number is NaN or infinite, or so large that its fourth
                              power is */
  LCPUSH_BAD_MASS,         /* mass <= 0, or an inertia that is not positive definite */
  LCPUSH_BAD_FACETS,       /* not even, or outside of 4..256 */
  LCPUSH_BAD_DIRECTION,    /* a zero normal, or a tangent along it */
  LCPUSH_BAD_FRICTION,     /* friction, torsion radius or preload < 0 */
  LCPUSH_BAD_INDEX,        /* a body without points, or an index outside of its array */
  LCPUSH_BAD_ACTUATOR,     /* force or inertia < 0, or nothing that it drives */
  LCPUSH_UNSUPPORTED,      /* a soft contact of several points; even with a shared actuator or a
                              preload; a preload on a driven body; a role, pressure or riding that
                              there is not */
  LCPUSH_NOTHING_MOVES,    /* break: no pusher has an acceleration */
  LCPUSH_NOT_DESCRIBED,    /* lcpush_describe was not called, or has never succeeded */
  LCPUSH_BAD_WEIGHTS,      /* a weight <= 0 */
  LCPUSH_BAD_AIMS          /* not this interface's */
};

typedef int lcpush_role, lcpush_pressure, lcpush_mode, lcpush_riding;
enum { LCPUSH_FINGER, LCPUSH_PUSHER };
enum { LCPUSH_PAD, LCPUSH_EVEN, LCPUSH_RIGID };
enum { LCPUSH_STICK, LCPUSH_SLIDE, LCPUSH_SEPARATE };
/* In a motion: a body's points ride on the body and press on the object's faces, or the object's
 * points ride on the object and press on the body's plane. */
enum { LCPUSH_ON_BODY, LCPUSH_ON_OBJECT };
/* As a scene's facets: friction is round. It takes the memory of 8 facets. */
#define LCPUSH_ROUND (-8)
/* Where a body is asked for: the object. */
#define LCPUSH_OBJECT (-1)

/* Constant text, never NULL; of what is none of them "unknown", of no mistake "". */
const char* lcpush_status_text(lcpush_status status);
const char* lcpush_mistake_text(lcpush_mistake mistake);
const char* lcpush_mode_text(lcpush_mode mode);

/* The most that a push will have to hold. `facets` is g, 8 of LCPUSH_ROUND; a soft contact
 * (torsion_radius > 0) takes 5 g + 2. Under even pressure a scene with driven patches is kept
 * twice, once with every driven point as a body with an actuator and a drive of its own: count the
 * bodies, actuators and drives of both. */
typedef struct lcpush_size {
  int bodies, points, facets, actuators, drives;
  int pulls; /* points of bilateral bodies */
} lcpush_size;

/* Unknowns n: a normal, g frictions and a slip a point, and a closing an actuator. */
#define LCPUSH_UNKNOWNS(points, facets, actuators) ((points) * ((facets) + 2) + (actuators))

/* Bytes of memory, aligned as a double, that lcpush_make needs for `real` (double or float) without
 * pulls; a constant expression. O(points facets): 3 bodies, 10 points, 8 facets and 2 actuators are
 * 17 KB in float. At most 16383 unknowns and 2047 points. */
#define LCPUSH_BYTES(real, bodies, points, facets, actuators, drives)                              \
  (LCPUSH_COMMON_BYTES_(real, (size_t)(bodies), (size_t)(points),                                  \
                        (size_t)(points) * ((size_t)(facets) + 1), (size_t)(actuators),            \
                        (size_t)(drives)) +                                                        \
   LCPUSH_PIVOTS_BYTES_(real, (size_t)LCPUSH_UNKNOWNS(points, facets, actuators),                  \
                        (size_t)(points), (size_t)(actuators),                                     \
                        LCPUSH_EXCHANGES_((size_t)LCPUSH_UNKNOWNS(points, facets, actuators),      \
                                          (size_t)(points), (size_t)(actuators))))

/* The same for lcpush_make_for_sweeps. */
#define LCPUSH_SWEEP_BYTES(real, bodies, points, facets, actuators, drives)                        \
  (LCPUSH_COMMON_BYTES_(real, (size_t)(bodies), (size_t)(points),                                  \
                        (size_t)(points) * ((size_t)(facets) + 1), (size_t)(actuators),            \
                        (size_t)(drives)) +                                                        \
   LCPUSH_SWEEPS_BYTES_(                                                                           \
       real, (size_t)LCPUSH_UNKNOWNS(points, facets, actuators), (size_t)(points),                 \
       (size_t)(points) * ((size_t)(facets) + 1) * ((drives) > 0 ? (size_t)(drives) : 1),          \
       (size_t)(actuators)))

/* Bytes that lcpush_set_off needs at most, beside the push's own. */
#define LCPUSH_MOTION_BYTES(real, bodies, points, facets, actuators, drives)                       \
  LCPUSH_MOTION_BYTES_(real, (size_t)(bodies), (size_t)(points), (size_t)(actuators),              \
                       (size_t)(drives), (size_t)LCPUSH_UNKNOWNS(points, facets, actuators))

#include "lcpush/c/bytes.h"

#define LCPUSH_REAL double
#define LCPUSH_NAME(name) lcpush_##name
#include "lcpush/c/push.h"
#undef LCPUSH_REAL
#undef LCPUSH_NAME

#define LCPUSH_REAL float
#define LCPUSH_NAME(name) lcpushf_##name
#include "lcpush/c/push.h"
#undef LCPUSH_REAL
#undef LCPUSH_NAME

#ifdef __cplusplus
}
#endif
#endif
