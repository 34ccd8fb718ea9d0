#include "solve/less_friction.hpp"

#include <algorithm>

#include "solve/self_stress.hpp"
#include "solve/settings.hpp"

namespace lcpush::desktop {

bool LessFriction::sticks(const Answer<double>& answer) const {
  for (Index i = 0; i < answer.contacts.size; ++i)
    if (answer.contacts[i].mode == Mode::slide &&
        std::count(bodies.begin(), bodies.end(), file.body_of(i)) > 0)
      return false;
  return true;
}

std::optional<LessFriction> with_less_friction(const SceneFile& file, const Answer<double>& answer,
                                               double part) {
  std::vector<bool> presses(file.bodies.size()), slips(file.bodies.size());
  // An answer of a hand alone stands where there is room for its pushers' contacts, too.
  for (Index i = 0; i < std::min(answer.contacts.size, file.view().points.size); ++i) {
    const auto b = static_cast<std::size_t>(file.body_of(i));
    presses[b] = presses[b] || answer.contacts[i].normal_force > 0;
    slips[b] = slips[b] || answer.contacts[i].mode == Mode::slide;
  }
  LessFriction less{file, {}};
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    const auto at = static_cast<std::size_t>(b);
    if (!presses[at] || slips[at] || !(file.bodies[at].friction > 0)) continue;
    less.file.bodies[at].friction *= part;
    less.bodies.push_back(b);
  }
  return less.bodies.empty() ? std::nullopt : std::optional(std::move(less));
}

std::optional<LessFriction> with_hardly_any_friction(const SceneFile& file,
                                                     const Answer<double>& answer) {
  if (file.pressure != Pressure::pad || file.hand == Hand::locked) return std::nullopt;
  auto less = with_less_friction(file, answer, SolveSettings().less_friction[0]);
  if (less && has_self_stress(GripStatics(less->file))) return std::nullopt;
  return less;
}

} // namespace lcpush::desktop
