/* What of lcpush.h is about motion, once a precision; include lcpush.h, not this. */

/* What a contact point did in the last step. */
typedef struct LCPUSH_NAME(touch) {
  int body;    /* of the scene */
  int present; /* 0: it was no contact; then only position and gap are told */
  lcpush_mode mode;
  LCPUSH_REAL gap;               /* m, at the step's end; < 0: that deep in its face */
  LCPUSH_REAL normal_force;      /* N, on the object, the step's mean */
  LCPUSH_REAL friction_force[3]; /* N, on the object */
  LCPUSH_REAL torsion;           /* N m about the normal, soft contacts only */
  LCPUSH_REAL velocity[3];       /* m/s, of the object's point relative to its body, at the end */
  LCPUSH_REAL position[3];       /* m, at the step's begin */
} LCPUSH_NAME(touch);

/* Bytes of further memory, aligned as a double, that a motion of the scene as described needs; 0
 * before lcpush_describe. LCPUSH_MOTION_BYTES is at least that. Cost: O(bodies drives). */
size_t LCPUSH_NAME(motion_bytes)(const LCPUSH_NAME(push) * push);

/* Begins a motion of the scene as described: at rest, every body at velocity 0, the hand's origin
 * in the object's centre of mass. `memory` stays the caller's and must not move; `ridings` says
 * for each body what rides on what, NULL: the bodies' points ride on the bodies. Planes have no
 * end. RUNNING; or BAD_INPUT with lcpush_why: NOT_DESCRIBED, MEMORY_TOO_SMALL, or UNSUPPORTED in a
 * push made for sweeps. Until the next lcpush_describe or lcpush_command, the push itself
 * is not there to be solved. */
lcpush_status LCPUSH_NAME(set_off)(LCPUSH_NAME(push) * push, void* memory, size_t bytes,
                                   const lcpush_riding* ridings);

/* The velocity of a body, a twist at the hand's origin that lasts until the next call; of
 * LCPUSH_OBJECT the twist at its centre of mass, now. Nothing if there is no motion. */
void LCPUSH_NAME(set_velocity)(LCPUSH_NAME(push) * push, int body, const LCPUSH_REAL twist[6]);

/* One step of h seconds, h > 0: solved as a push from the last step's basis, checked against every
 * law, and everything moves by the velocities at its end. SOLVED; or nothing has moved:
 * DOES_NOT_HOLD (a finger touches nothing any more), RAY (a jam), BAD_INPUT (no motion, h is no
 * time), or the solver's failure. lcpush_command between two steps changes grip forces. Cost: as
 * lcpush_solve, mostly a few pivots. */
lcpush_status LCPUSH_NAME(advance)(LCPUSH_NAME(push) * push, LCPUSH_REAL h);

/* Of a body or LCPUSH_OBJECT: a point x of it, where it was at the start, is at
 * position + rotation x, rotation row by row. For the object, position is its centre of mass.
 * Without a motion: no way, no turn. */
void LCPUSH_NAME(pose_of)(const LCPUSH_NAME(push) * push, int body, LCPUSH_REAL position[3],
                          LCPUSH_REAL rotation[9]);

/* The object's twist at its centre of mass, [m/s; rad/s]. */
void LCPUSH_NAME(velocity)(const LCPUSH_NAME(push) * push, LCPUSH_REAL out[6]);

/* How far an actuator has closed since the start, in its units. */
LCPUSH_REAL LCPUSH_NAME(closed_by)(const LCPUSH_NAME(push) * push, int actuator);

/* After a step that was solved; otherwise zeros. */
void LCPUSH_NAME(touch_at)(const LCPUSH_NAME(push) * push, int point, LCPUSH_NAME(touch) * out);

/* The largest scaled violation of any law by the last step, and its deepest penetration, m. */
LCPUSH_REAL LCPUSH_NAME(step_residual)(const LCPUSH_NAME(push) * push);
LCPUSH_REAL LCPUSH_NAME(penetration)(const LCPUSH_NAME(push) * push);
