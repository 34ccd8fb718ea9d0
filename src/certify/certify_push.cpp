// Certificates of what solve and break say of a scene.
#include "lcpush/desktop/certify.hpp"

namespace lcpush::desktop {

std::optional<Certificate> certify_push(const std::string& text, const SceneFile& file,
                                        const PushReport& report) {
  if (report.status == Status::solved) return certify_answer(text, file, report.answer, 1);
  return certify_squeeze(text, file, report.ray);
}

std::optional<Certificate> certify_break(const std::string& text, const SceneFile& file, Push& push,
                                         Index pusher, const BreakReport& report) {
  if (report.status == Status::does_not_hold) return certify_cannot_hold(text, file);
  if (report.status != Status::solved) return certify_squeeze(text, file, report.ray);
  PushOptions again; // the answer at the small push; the search for others has overwritten it
  again.solver = report.solver;
  again.other_covers = 0;
  push.find_breaking(pusher, again);
  return certify_answer(text, file, push.last_answer(),
                        report.breaking.small_push / push_size(file.view()));
}

std::string uncertified_law(const SceneFile& file) {
  if (file.is_round)
    return "proves pyramids, whose directions are fractions: give the scene a number of facets";
  if (file.pressure == Pressure::even)
    return "proves the literal equations, which pressure = \"even\" replaces: use \"pad\" or "
           "\"rigid\"";
  return {};
}

} // namespace lcpush::desktop
