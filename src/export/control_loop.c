
/* One tick: new grip forces and motions of the scene's order; a bounded number of pivots a step. */
static lcpush_status tick(LCPUSH(push)* push, const REAL* forces, const REAL* accelerations) {
  lcpush_status status = LCPUSH(command)(push, forces, accelerations);
  while (status == LCPUSH_RUNNING) status = LCPUSH(step)(push, 8); /* other work goes between */
  return status;
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
    status = tick(push, forces, accelerations);
    LCPUSH(acceleration)(push, twist);
#if __STDC_HOSTED__
    (void)printf("tick %d: %s, %d pivots; the object's acceleration", t, lcpush_status_text(status), LCPUSH(pivots)(push));
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
