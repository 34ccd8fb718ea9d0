#include "solve/less_friction.hpp"

#include <algorithm>

#include "solve/noise.hpp"
#include "solve/self_stress.hpp"
#include "solve/settings.hpp"
#include "solve/word_settings.hpp"

namespace lcpush::desktop {

namespace {

/// Rounding and what is left of pads' compliance are no slip.
bool slips_at(const ContactAnswer<double>& contact, double still) {
  return contact.mode == Mode::slide && contact.acceleration.norm() > still;
}

} // namespace

bool LessFriction::sticks(const Answer<double>& answer) const {
  for (Index i = 0; i < answer.contacts.size; ++i)
    if (slips_at(answer.contacts[i], still) &&
        std::count(bodies.begin(), bodies.end(), file.body_of(i)) > 0)
      return false;
  return true;
}

std::optional<LessFriction> with_less_friction(const SceneFile& file, const Answer<double>& answer,
                                               double part, const Scales<double>& scales) {
  const double still = noise_below(file, scales, word_settings.rounding).acceleration;
  std::vector<bool> presses(file.bodies.size()), slips(file.bodies.size());
  // An answer of a hand alone stands where there is room for its pushers' contacts, too.
  for (Index i = 0; i < std::min(answer.contacts.size, file.view().points.size); ++i) {
    const auto b = static_cast<std::size_t>(file.body_of(i));
    presses[b] = presses[b] || answer.contacts[i].normal_force > 0;
    slips[b] = slips[b] || slips_at(answer.contacts[i], still);
  }
  LessFriction less{file, {}, still};
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    const auto at = static_cast<std::size_t>(b);
    if (!presses[at] || slips[at] || !(file.bodies[at].friction > 0)) continue;
    less.file.bodies[at].friction *= part;
    less.bodies.push_back(b);
  }
  return less.bodies.empty() ? std::nullopt : std::optional(std::move(less));
}

std::optional<LessFriction> with_hardly_any_friction(const SceneFile& file,
                                                     const Answer<double>& answer,
                                                     const Scales<double>& scales) {
  if (file.pressure != Pressure::pad || file.hand == Hand::locked) return std::nullopt;
  auto less = with_less_friction(file, answer, SolveSettings().less_friction[0], scales);
  if (less && has_self_stress(GripStatics(less->file))) return std::nullopt;
  return less;
}

} // namespace lcpush::desktop
