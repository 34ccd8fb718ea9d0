// The functions of lcpush/c/hold.h for one precision; included by c_interface.cpp once for each.

lcpush_status LCPUSH_NAME(least_grip)(LCPUSH_NAME(push) * push, int exchanges,
                                      LCPUSH_NAME(held) * held) {
  return lcpush::c::hold(*push, *held, [=](auto& hand) { return hand.least_grip(exchanges); });
}
lcpush_status LCPUSH_NAME(most_grip)(LCPUSH_NAME(push) * push, int exchanges,
                                     LCPUSH_NAME(held) * held) {
  return lcpush::c::hold(*push, *held, [=](auto& hand) { return hand.most_grip(exchanges); });
}

lcpush_status LCPUSH_NAME(margin)(LCPUSH_NAME(push) * push, const LCPUSH_REAL wrench[6],
                                  int exchanges, LCPUSH_NAME(held) * held) {
  *held = LCPUSH_NAME(held)();
  lcpush::Vector6<LCPUSH_REAL> beside;
  lcpush::c::read(wrench, beside);
  for (int i = 0; i < 6; ++i)
    if (!push->is_finite(wrench[i]))
      return lcpush::c::as_c(push->refuse(lcpush::Mistake::not_finite));
  return lcpush::c::hold(*push, *held, [&](auto& hand) { return hand.margin(beside, exchanges); });
}
