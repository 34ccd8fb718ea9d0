// The functions of lcpush.h for one precision; included by c_interface.cpp once for each.

struct LCPUSH_NAME(push) : lcpush::c::CPush<LCPUSH_REAL> {
  using CPush::CPush;
};

LCPUSH_NAME(push) * LCPUSH_NAME(make)(void* memory, size_t bytes, const lcpush_size* size) {
  return lcpush::c::make<lcpush::c::CPivotPush<LCPUSH_NAME(push)>>(memory, bytes, size);
}
LCPUSH_NAME(push) *
    LCPUSH_NAME(make_for_sweeps)(void* memory, size_t bytes, const lcpush_size* size) {
  return lcpush::c::make<lcpush::c::CSweepPush<LCPUSH_NAME(push)>>(memory, bytes, size);
}

lcpush_status LCPUSH_NAME(describe)(LCPUSH_NAME(push) * push, const LCPUSH_NAME(scene) * scene) {
  return lcpush::c::as_c(lcpush::c::describe(*push, *scene));
}

lcpush_status LCPUSH_NAME(command)(LCPUSH_NAME(push) * push, const LCPUSH_REAL* forces,
                                   const LCPUSH_REAL* accelerations) {
  return lcpush::c::as_c(lcpush::c::command(*push, forces, accelerations));
}

lcpush_status LCPUSH_NAME(step)(LCPUSH_NAME(push) * push, int pivots) {
  return lcpush::c::as_c(push->step(pivots));
}

lcpush_status LCPUSH_NAME(step_within)(LCPUSH_NAME(push) * push, unsigned work) {
  return lcpush::c::as_c(push->step_within(work));
}

unsigned LCPUSH_NAME(work)(const LCPUSH_NAME(push) * push) { return push->work(); }

lcpush_status LCPUSH_NAME(solve)(LCPUSH_NAME(push) * push) {
  return lcpush::c::as_c(push->solve());
}

lcpush_status LCPUSH_NAME(break_grasp)(LCPUSH_NAME(push) * push, int pusher,
                                       LCPUSH_NAME(breaking) * out) {
  lcpush::Breaking<LCPUSH_REAL> breaking;
  using Pivots = lcpush::c::CPivotPush<LCPUSH_NAME(push)>;
  const lcpush::Status status =
      push->break_grasp(pusher, breaking, [&](const auto& body, auto& breaks) {
        return static_cast<Pivots*>(push)->break_grasp(body, breaks);
      });
  out->break_force = breaking.break_force;
  lcpush::c::write(breaking.force, out->wrench);
  lcpush::c::write(breaking.inertia, out->inertia);
  lcpush::c::write(breaking.twist, out->twist);
  lcpush::c::write(breaking.rest, out->rest);
  out->breaks = breaking.breaks ? 1 : 0;
  return lcpush::c::as_c(status);
}

void LCPUSH_NAME(limit)(LCPUSH_NAME(push) * push, int pivots) { push->limit(pivots); }

void LCPUSH_NAME(acceleration)(const LCPUSH_NAME(push) * push, LCPUSH_REAL out[6]) {
  for (int i = 0; i < 6; ++i) out[i] = push->has_answer() ? push->answer().acceleration[i] : 0;
}

void LCPUSH_NAME(contact_at)(const LCPUSH_NAME(push) * push, int point,
                             LCPUSH_NAME(contact) * out) {
  *out = LCPUSH_NAME(contact)();
  if (!push->has_answer() || point < 0 || point >= push->scene().points.size) return;
  const lcpush::ContactAnswer<LCPUSH_REAL>& contact = push->answer().contacts[point];
  out->body = static_cast<int>(lcpush::c::described_body(*push, point));
  out->mode = static_cast<lcpush_mode>(contact.mode);
  out->normal_force = contact.normal_force;
  lcpush::c::write(contact.friction_force, out->friction_force);
  out->torsion = contact.torsion;
  lcpush::c::write(contact.acceleration, out->acceleration);
}

void LCPUSH_NAME(wrench_of)(const LCPUSH_NAME(push) * push, int body, LCPUSH_REAL out[6]) {
  lcpush::c::write(lcpush::c::wrench_of(*push, body), out);
}

LCPUSH_REAL LCPUSH_NAME(closing_of)(const LCPUSH_NAME(push) * push, int actuator) {
  return lcpush::c::closing_of(*push, actuator);
}

LCPUSH_REAL LCPUSH_NAME(residual)(const LCPUSH_NAME(push) * push) { return push->residual(); }

int LCPUSH_NAME(age)(const LCPUSH_NAME(push) * push) { return static_cast<int>(push->age()); }

lcpush_status LCPUSH_NAME(status_of)(const LCPUSH_NAME(push) * push) {
  return lcpush::c::as_c(push->status());
}
lcpush_mistake LCPUSH_NAME(why)(const LCPUSH_NAME(push) * push) {
  return static_cast<lcpush_mistake>(push->mistake());
}
int LCPUSH_NAME(pivots)(const LCPUSH_NAME(push) * push) {
  return static_cast<int>(push->run().pivots);
}
int LCPUSH_NAME(sweeps)(const LCPUSH_NAME(push) * push) {
  return static_cast<int>(push->run().sweeps);
}
int LCPUSH_NAME(rounds)(const LCPUSH_NAME(push) * push) {
  return static_cast<int>(push->run().rounds);
}
