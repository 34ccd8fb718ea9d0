// The functions of lcpush/c/motion.h for one precision; included by c_interface.cpp once for each.

size_t LCPUSH_NAME(motion_bytes)(const LCPUSH_NAME(push) * push) {
  return push->given().bodies.size == 0
             ? 0
             : static_cast<size_t>(lcpush::c::bytes_of_motion(push->as_given()));
}

lcpush_status LCPUSH_NAME(set_off)(LCPUSH_NAME(push) * push, void* memory, size_t bytes,
                                   const lcpush_riding* ridings) {
  using namespace lcpush;
  for (Index b = 0; ridings != nullptr && b < push->given().bodies.size; ++b)
    if (ridings[b] != LCPUSH_ON_BODY && ridings[b] != LCPUSH_ON_OBJECT)
      return c::as_c(push->refuse(Mistake::unsupported));
  const Index length = memory == nullptr ? 0 : static_cast<Index>(bytes);
  const Status status = push->set_off(Arena(static_cast<unsigned char*>(memory), length));
  for (Index b = 0; push->motion() != nullptr && b < push->motion()->touching.size; ++b) {
    const bool on_object = ridings != nullptr && ridings[b] == LCPUSH_ON_OBJECT;
    push->motion()->touching[b].riding = on_object ? Riding::on_object : Riding::on_body;
  }
  return c::as_c(status);
}

void LCPUSH_NAME(set_velocity)(LCPUSH_NAME(push) * push, int body, const LCPUSH_REAL twist[6]) {
  const Eigen::Map<const lcpush::Vector6<LCPUSH_REAL>> velocity(twist);
  if (push->motion() == nullptr || body >= push->given().bodies.size) return;
  if (body == LCPUSH_OBJECT) push->motion()->motion.velocity() = velocity;
  if (body >= 0) push->motion()->motion.prescribed(body) = velocity;
}

lcpush_status LCPUSH_NAME(advance)(LCPUSH_NAME(push) * push, LCPUSH_REAL h) {
  return lcpush::c::as_c(push->advance(h));
}

void LCPUSH_NAME(pose_of)(const LCPUSH_NAME(push) * push, int body, LCPUSH_REAL position[3],
                          LCPUSH_REAL rotation[9]) {
  lcpush::Pose<LCPUSH_REAL> pose;
  const auto* const moving = push->motion();
  if (moving != nullptr && body == LCPUSH_OBJECT) pose = moving->motion.pose();
  if (moving != nullptr && body >= 0 && body < push->given().bodies.size)
    pose = moving->motion.pose_of(body);
  lcpush::c::write(pose.position, position);
  for (int i = 0; i < 9; ++i) rotation[i] = pose.rotation(i / 3, i % 3);
}

void LCPUSH_NAME(velocity)(const LCPUSH_NAME(push) * push, LCPUSH_REAL out[6]) {
  for (int i = 0; i < 6; ++i)
    out[i] = push->motion() == nullptr ? 0 : push->motion()->motion.velocity()[i];
}

LCPUSH_REAL LCPUSH_NAME(closed_by)(const LCPUSH_NAME(push) * push, int actuator) {
  if (push->motion() == nullptr || actuator < 0 || actuator >= push->given().actuators.size)
    return 0;
  return push->motion()->motion.closing(actuator);
}

void LCPUSH_NAME(touch_at)(const LCPUSH_NAME(push) * push, int point, LCPUSH_NAME(touch) * out) {
  *out = LCPUSH_NAME(touch)();
  if (push->motion() == nullptr || push->status() != lcpush::Status::solved || point < 0 ||
      point >= push->scene().points.size)
    return;
  const lcpush::StepContact<LCPUSH_REAL>& touch = push->motion()->motion.contact(point);
  out->body = static_cast<int>(lcpush::c::described_body(*push, point));
  out->present = touch.absence == lcpush::Absence::none ? 1 : 0;
  out->mode = static_cast<lcpush_mode>(touch.mode);
  out->gap = touch.gap;
  out->normal_force = touch.normal_force;
  lcpush::c::write(touch.friction_force, out->friction_force);
  out->torsion = touch.torsion;
  lcpush::c::write(touch.velocity, out->velocity);
  lcpush::c::write(touch.position, out->position);
}

LCPUSH_REAL LCPUSH_NAME(step_residual)(const LCPUSH_NAME(push) * push) {
  return push->motion() == nullptr ? 0 : push->motion()->motion.run().residual;
}
LCPUSH_REAL LCPUSH_NAME(penetration)(const LCPUSH_NAME(push) * push) {
  return push->motion() == nullptr ? 0 : push->motion()->motion.run().penetration;
}
