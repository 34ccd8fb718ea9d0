/* What of lcpush.h is about the grasp before any push, once a precision; include lcpush.h, not
 * this. */

/* What a grasp holds, by statics: fingers alone, pushers left out, at rest. Locked fingers squeeze
 * with any force. */
typedef struct LCPUSH_NAME(held) {
  LCPUSH_REAL value;    /* what was asked for; infinite: without end */
  LCPUSH_REAL twist[6]; /* how the object moves where more gives way, or nothing holds it: [1; 1/m],
                           its largest part 1, angles times the farthest contact's distance; zeros
                           without end */
  int exchanges;        /* that it took */
} LCPUSH_NAME(held);

/* The least factor >= 0 on all grip forces with which the fingers hold the load, and the largest:
 * in between all do, and where the grip itself pushes the object along, a harder one may not.
 * SOLVED; DOES_NOT_HOLD: proved, no factor does; PIVOT_LIMIT: not known after so many `exchanges`
 * of the simplex method (random grasps mostly take 10 to 20); NUMERICAL_BREAKDOWN: a result failed
 * its proof; or BAD_INPUT with lcpush_why: NOT_DESCRIBED; or UNSUPPORTED where the scene's law is
 * not that any pressure will do: friction is LCPUSH_ROUND, or patches are LCPUSH_PAD: LCPUSH_RIGID
 * asks what the best pressure holds, LCPUSH_EVEN what an even one does. It uses the solver's
 * memory: answers and status stay, but a solve that is under way begins anew. Cost of an exchange:
 * O(m (points facets + m^2)) for m = 6 + actuators. */
lcpush_status LCPUSH_NAME(least_grip)(LCPUSH_NAME(push) * push, int exchanges,
                                      LCPUSH_NAME(held) * held);
lcpush_status LCPUSH_NAME(most_grip)(LCPUSH_NAME(push) * push, int exchanges,
                                     LCPUSH_NAME(held) * held);

/* The largest t >= 0 for which the grip as commanded holds the load and t times `wrench`, [N; N m]
 * at the centre of mass: a force f at a point p is [f; p x f], an acceleration a of the hand [-m a;
 * 0]. DOES_NOT_HOLD: not even the load. Otherwise as above; BAD_INPUT also for NOT_FINITE. */
lcpush_status LCPUSH_NAME(margin)(LCPUSH_NAME(push) * push, const LCPUSH_REAL wrench[6],
                                  int exchanges, LCPUSH_NAME(held) * held);
