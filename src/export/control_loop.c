
/* A tick's budget in pivots, and for how many ticks an answer serves: yours. */
enum { BUDGET = 2000, OLDEST = 3 };

/* One tick: new grip forces and motions of the scene's order, unless the last are still being
 * solved; what was solved last stands meanwhile. */
static lcpush_status tick(LCPUSH(push)* push, lcpush_status last, const REAL* forces, const REAL* accelerations) {
  if (last != LCPUSH_RUNNING) (void)LCPUSH(command)(push, forces, accelerations); /* refused: the one before stands */
  return LCPUSH(step)(push, BUDGET);
}

int main(void) {
  static REAL forces[ACTUATORS + 1], accelerations[6 * BODIES];
  LCPUSH(push)* push = LCPUSH(make)(memory, sizeof memory, &size);
  lcpush_status status = LCPUSH_BAD_INPUT; /* no push: more than the interface holds */
  int t, a, b, k;
  if (push != NULL) status = LCPUSH(describe)(push, &scene); /* lcpush_why says what is wrong */
  for (t = 1; t <= TICKS && status != LCPUSH_BAD_INPUT; ++t) {
    const REAL share = (REAL)t / (REAL)TICKS; /* your command instead: the push begins slowly */
    REAL wrench[6], twist[6];
    for (a = 0; a < ACTUATORS; ++a) forces[a] = actuators[a].force;
    for (b = 0; b < BODIES; ++b)
      for (k = 0; k < 6; ++k) accelerations[6 * b + k] = share * bodies[b].acceleration[k];
    status = tick(push, (t == 1) ? LCPUSH_SOLVED : status, forces, accelerations);
    if ((LCPUSH(age)(push) < 0) || (LCPUSH(age)(push) > OLDEST)) { /* nothing to go by: stop, in your way */
#if __STDC_HOSTED__
      (void)printf("tick %d: %s, and no answer that is new enough\n", t, lcpush_status_text(status));
#endif
      continue;
    }
    LCPUSH(acceleration)(push, twist);
#if __STDC_HOSTED__
    (void)printf("tick %d: %s, %d pivots, %d old; the object's acceleration", t, lcpush_status_text(status),
                 LCPUSH(pivots)(push), LCPUSH(age)(push));
    for (k = 0; k < 6; ++k) (void)printf(" %.6g", (double)twist[k]);
    (void)printf("\n");
#endif
    for (b = 0; b < BODIES; ++b) {
      LCPUSH(wrench_of)(push, b, wrench);
#if __STDC_HOSTED__
      (void)printf("  body %d: %.6g %.6g %.6g N, %.6g %.6g %.6g N m\n", b, (double)wrench[0], (double)wrench[1],
                   (double)wrench[2], (double)wrench[3], (double)wrench[4], (double)wrench[5]);
#endif
    }
  }
  return (status == LCPUSH_SOLVED) ? 0 : 1;
}
