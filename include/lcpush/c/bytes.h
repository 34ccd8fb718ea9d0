/* Bounds on the sizes of what a push keeps in its memory, for the macros of lcpush.h; include that,
 * not this. src/c/c_interface.cpp asserts that they hold on the target at hand. */

#define LCPUSH_WORD_ sizeof(ptrdiff_t)
/* What alignment takes beside a float's on 32 bits: of doubles, where vectors of them may be
 * aligned by 16, and of 64 bits. */
#define LCPUSH_GAP_(real) (8 * (LCPUSH_WORD_ - 4) + 4 * (sizeof(real) - 4))
/* A push itself with its scene, a body, a drive, a contact's assembly, and its answer. */
#define LCPUSH_STATE_BYTES_(real) (342 * LCPUSH_WORD_ + 164 * sizeof(real) + 4 * LCPUSH_GAP_(real))
#define LCPUSH_BODY_BYTES_(real) (17 * sizeof(real) + 2 * LCPUSH_WORD_ + LCPUSH_GAP_(real))
#define LCPUSH_DRIVE_BYTES_(real) (6 * sizeof(real) + 2 * LCPUSH_WORD_ + LCPUSH_GAP_(real))
#define LCPUSH_POINT_BYTES_(real) (18 * sizeof(real) + 5 * LCPUSH_WORD_ + LCPUSH_GAP_(real))
#define LCPUSH_CONTACT_BYTES_(real) (11 * sizeof(real) + 2 * LCPUSH_WORD_ + LCPUSH_GAP_(real))

#define LCPUSH_COMMON_BYTES_(real, bodies, points, forces, actuators, drives)                      \
  (LCPUSH_STATE_BYTES_(real) + (bodies)*LCPUSH_BODY_BYTES_(real) +                                 \
   (drives)*LCPUSH_DRIVE_BYTES_(real) + (points)*LCPUSH_POINT_BYTES_(real) +                       \
   (points)*LCPUSH_CONTACT_BYTES_(real) + ((forces) - (points) + (actuators)) * sizeof(real) +     \
   (forces)*6 * sizeof(real) + ((forces) + (points) + (actuators)) * (2 * sizeof(real) + 2) +      \
   (forces) * ((drives) > 0 ? (drives) : 1) * (sizeof(real) + sizeof(int)) +                       \
   (actuators) * (6 * sizeof(real) + 2 * LCPUSH_WORD_) + 36 + 8 * LCPUSH_GAP_(real) +              \
   60 * (sizeof(real) - 4))

/* Exchanges that the structured basis has room for. */
#define LCPUSH_EXCHANGES_(n, points, actuators)                                                    \
  ((n) < (points) + 2 * (actuators) + 10 ? (n) + 1 : (points) + 2 * (actuators) + 10)

#define LCPUSH_PIVOTS_BYTES_(real, n, points, actuators, exchanges)                                \
  ((11 * (n) + 24 + 3 * (points) + 7 * (actuators) +                                               \
    ((points) < 24 ? 0 : 2 * (6 + (actuators)) * (6 + (actuators))) +                              \
    (exchanges) * ((exchanges) + 3)) *                                                             \
       sizeof(real) +                                                                              \
   (5 * (n) + 4 * (points) + (actuators) * ((points) + 2) + 2 + 2 * (exchanges)) * sizeof(short))

#define LCPUSH_SWEEPS_BYTES_(real, n, points, couplings, actuators)                                \
  ((11 * (n) + (couplings) + (6 + (actuators)) * (14 + (actuators))) * sizeof(real) +              \
   (4 * (n) + 1 + (couplings) + (actuators)) * sizeof(int) + (points)*LCPUSH_CONTACT_BYTES_(real))

/* A motion itself, and what it keeps of bodies, points, actuators, drives and unknowns; under even
 * pressure a point is a body too. */
#define LCPUSH_MOTION_BYTES_(real, bodies, points, actuators, drives, n)                           \
  (230 * LCPUSH_WORD_ + 250 * sizeof(real) + 1200 +                                                \
   (bodies) * (2 * LCPUSH_BODY_BYTES_(real) + 24 * sizeof(real) + 2 * LCPUSH_WORD_ + 16) +         \
   (points) * (LCPUSH_BODY_BYTES_(real) + 40 * sizeof(real) + 6 * LCPUSH_WORD_) +                  \
   (actuators)*8 * sizeof(real) + (drives)*2 * LCPUSH_DRIVE_BYTES_(real) + 2 * (n))
