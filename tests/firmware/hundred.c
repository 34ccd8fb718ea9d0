/* What a hundred pushes of random grasps answer goes into hashes. docs/embed/tables.md has their
 * table. */
#include "random_grasps.h"

#define PUSHES 100

static uint32_t hash_numbers(uint32_t hash, const REAL* numbers, int count) {
  int i;
  for (i = 0; i < count; ++i) hash = hash_real(hash, numbers[i]);
  return hash;
}

static uint32_t hash_answer(const LCPUSH(push) * push, lcpush_status status) {
  uint32_t hash = hash_bits(HASH_START, (uint32_t)status);
  REAL numbers[6];
  int i;
  hash = hash_bits(hash, (uint32_t)LCPUSH(pivots)(push));
  hash = hash_bits(hash, (uint32_t)LCPUSH(rounds)(push));
  hash = hash_real(hash, LCPUSH(residual)(push));
  LCPUSH(acceleration)(push, numbers);
  hash = hash_numbers(hash, numbers, 6);
  LCPUSH(wrench_of)(push, 2, numbers);
  hash = hash_numbers(hash, numbers, 6);
  for (i = 0; i < scene.actuator_count; ++i) hash = hash_real(hash, LCPUSH(closing_of)(push, i));
  for (i = 0; i < scene.point_count; ++i) {
    LCPUSH(contact) contact;
    LCPUSH(contact_at)(push, i, &contact);
    hash = hash_bits(hash, (uint32_t)contact.mode);
    hash = hash_real(hash, contact.normal_force);
    hash = hash_numbers(hash, contact.friction_force, 3);
    hash = hash_numbers(hash, contact.acceleration, 3);
  }
  return hash;
}

int main(void) {
  static const lcpush_pressure laws[3] = {LCPUSH_PAD, LCPUSH_RIGID, LCPUSH_EVEN};
  uint32_t all = HASH_START, solved = 0, pivots = 0;
  int k;
  for (k = 0; k < PUSHES; ++k) {
    LCPUSH(push)* const push = LCPUSH(make)(memory, sizeof memory, &size);
    lcpush_status status;
    uint32_t hash;
    if (push == NULL) return 1;
    make_grasp();
    scene.pressure = laws[k % 3];
    status = LCPUSH(describe)(push, &scene);
    if (status == LCPUSH_RUNNING) status = LCPUSH(solve)(push);
    hash = hash_answer(push, status);
    all = hash_bits(all, hash);
    if (status == LCPUSH_SOLVED) ++solved;
    pivots += (uint32_t)LCPUSH(pivots)(push);
    put_number("run ", (uint32_t)k);
    put(" status ");
    put(lcpush_status_text(status));
    put_number(" pivots ", (uint32_t)LCPUSH(pivots)(push));
    put_hex(" hash ", hash);
    put("\n");
  }
  put_number("run all solved ", solved);
  put_number(" pivots ", pivots);
  put_hex(" hash ", all);
  put("\nend\n");
  return 0;
}
