/* Bounds on the sizes of what a push keeps in its memory, for the macros of lcpush.h; include that,
 * not this. src/c/c_interface.cpp asserts that they hold on the target at hand. */

#define LCPUSH_WORD_ sizeof(ptrdiff_t)
/* What alignment takes beside a float's on 32 bits: of doubles, where vectors of them may be
 * aligned by 16, and of 64 bits. */
#define LCPUSH_GAP_(real) (8 * (LCPUSH_WORD_ - 4) + 4 * (sizeof(real) - 4))
/* A push itself, a body, a drive, a contact and what its assembly keeps. */
#define LCPUSH_STATE_BYTES_(real) (400 * LCPUSH_WORD_ + 152 * sizeof(real) + 2 * LCPUSH_GAP_(real))
#define LCPUSH_BODY_BYTES_(real) (17 * sizeof(real) + 2 * LCPUSH_WORD_ + LCPUSH_GAP_(real))
#define LCPUSH_DRIVE_BYTES_(real) (6 * sizeof(real) + 2 * LCPUSH_WORD_ + LCPUSH_GAP_(real))
#define LCPUSH_POINT_BYTES_(real) (30 * sizeof(real) + 3 * LCPUSH_WORD_ + LCPUSH_GAP_(real))

#define LCPUSH_COMMON_BYTES_(real, bodies, points, friction_forces, actuators, drives)             \
  (LCPUSH_STATE_BYTES_(real) + (bodies)*LCPUSH_BODY_BYTES_(real) * 2 +                             \
   (drives)*LCPUSH_DRIVE_BYTES_(real) * 2 + (points)*LCPUSH_POINT_BYTES_(real) +                   \
   (friction_forces)*6 * sizeof(real) +                                                            \
   ((friction_forces) + (points) + (actuators)) * (4 * sizeof(real) + 2) +                         \
   (friction_forces) * ((drives) > 0 ? (drives) : 1) * (sizeof(real) + sizeof(int)) +              \
   (actuators) * (8 * sizeof(real) + 2 * LCPUSH_WORD_) + 128 + 8 * LCPUSH_GAP_(real) +             \
   60 * (sizeof(real) - 4))

/* Exchanges that the structured basis has room for. */
#define LCPUSH_EXCHANGES_(n, points, actuators)                                                    \
  ((n) < (points) + 2 * (actuators) + 10 ? (n) + 1 : (points) + 2 * (actuators) + 10)

#define LCPUSH_PIVOTS_BYTES_(real, n, points, actuators, exchanges)                                \
  (((10 + (actuators)) * (n) + 24 + 5 * (points) + 7 * (actuators) +                               \
    ((points) < 24 ? 0 : 2 * (6 + (actuators)) * (6 + (actuators))) +                              \
    (exchanges) * ((exchanges) + 3)) *                                                             \
       sizeof(real) +                                                                              \
   (7 * (n) + 7 * (points) + 2 + 2 * (exchanges)) * sizeof(short))

#define LCPUSH_SWEEPS_BYTES_(real, n, couplings, actuators)                                        \
  ((10 * (n) + (couplings) + (6 + (actuators)) * (14 + (actuators))) * sizeof(real) +              \
   (4 * (n) + 1 + (couplings) + (actuators)) * sizeof(int))

/* A motion itself, and what it keeps of bodies, points, actuators, drives and unknowns; under even
 * pressure a point is a body too. */
#define LCPUSH_MOTION_BYTES_(real, bodies, points, actuators, drives, n)                           \
  (200 * LCPUSH_WORD_ + 220 * sizeof(real) + 900 +                                                 \
   (bodies) * (2 * LCPUSH_BODY_BYTES_(real) + 24 * sizeof(real) + 2 * LCPUSH_WORD_ + 16) +         \
   (points) * (LCPUSH_BODY_BYTES_(real) + 40 * sizeof(real) + 6 * LCPUSH_WORD_) +                  \
   (actuators)*8 * sizeof(real) + (drives)*2 * LCPUSH_DRIVE_BYTES_(real) + 2 * (n))
