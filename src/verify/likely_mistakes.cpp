#include "verify/likely_mistakes.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

/// All forces turned round, or friction alone, whose moments about the centre of mass are then not
/// known. Normal forces press then: who gives forces on the bodies has them with either sign.
ForeignAnswer turned(const SceneFile& file, ForeignAnswer answer, bool all) {
  const auto press = [&](std::optional<double>& force, std::size_t body) {
    if (all && force) force = file.bodies[body].bilateral ? -*force : std::abs(*force);
  };
  for (std::size_t i = 0; i < answer.contacts.size(); ++i) {
    ForeignContact& contact = answer.contacts[i];
    press(contact.normal_force, static_cast<std::size_t>(file.body_of(static_cast<Index>(i))));
    if (contact.friction_force) contact.friction_force = -*contact.friction_force;
    if (contact.torsion) contact.torsion = -*contact.torsion;
  }
  for (std::size_t b = 0; b < answer.bodies.size(); ++b) {
    ForeignBody& body = answer.bodies[b];
    const Vector3<double>& n = file.bodies[b].normal;
    press(body.normal_force, b);
    if (body.force)
      body.force = all ? -*body.force : Vector3<double>(2 * n.dot(*body.force) * n - *body.force);
    if (body.moment && all) body.moment = -*body.moment;
    if (!all) body.moment.reset();
  }
  return answer;
}

ForeignAnswer without_moments(ForeignAnswer answer) {
  for (ForeignBody& body : answer.bodies) body.moment.reset();
  return answer;
}

/// Is there a force in a contact plane?
bool has_friction(const SceneFile& file, const ForeignAnswer& given) {
  for (const ForeignContact& contact : given.contacts)
    if ((contact.friction_force && !contact.friction_force->isZero(0)) ||
        contact.torsion.value_or(0) != 0)
      return true;
  for (std::size_t b = 0; b < given.bodies.size(); ++b) {
    if (!given.bodies[b].force) continue;
    const Vector3<double>&f = *given.bodies[b].force, &n = file.bodies[b].normal;
    if ((f - n.dot(f) * n).norm() > VerifySettings::same_place * f.norm()) return true;
  }
  return false;
}

ForeignAnswer with_forces_times(ForeignAnswer answer, double factor) {
  const auto scale = [&](auto& number) {
    if (number) *number *= factor;
  };
  for (ForeignContact& contact : answer.contacts) {
    scale(contact.normal_force);
    scale(contact.friction_force);
    scale(contact.torsion);
  }
  for (ForeignBody& body : answer.bodies) {
    scale(body.force);
    scale(body.moment);
    scale(body.normal_force);
  }
  return answer;
}

ForeignAnswer with_moments_times(ForeignAnswer answer, double factor) {
  for (ForeignContact& contact : answer.contacts)
    if (contact.torsion) *contact.torsion *= factor;
  for (ForeignBody& body : answer.bodies)
    if (body.moment) *body.moment *= factor;
  return answer;
}

ForeignAnswer with_motion_times(ForeignAnswer answer, double factor) {
  if (answer.acceleration) answer.acceleration->head<3>() *= factor;
  return answer;
}

/// In other axes; `hand`: their determinant, 1 or -1: left hands turn moments round.
ForeignAnswer in_axes(const Matrix3<double>& R, double hand, ForeignAnswer answer) {
  for (ForeignContact& contact : answer.contacts)
    if (contact.friction_force) contact.friction_force = R * *contact.friction_force;
  for (ForeignBody& body : answer.bodies) {
    if (body.force) body.force = R * *body.force;
    if (body.moment) body.moment = hand * (R * *body.moment);
  }
  if (answer.acceleration)
    *answer.acceleration << R * answer.acceleration->head<3>(),
        hand * (R * answer.acceleration->tail<3>());
  return answer;
}

template <class Number> bool any_of(const ForeignAnswer& given, const Number& has) {
  return std::any_of(given.contacts.begin(), given.contacts.end(), has.first) ||
         std::any_of(given.bodies.begin(), given.bodies.end(), has.second);
}

} // namespace

std::vector<LikelyMistake> likely_mistakes(const SceneFile& file, const ForeignAnswer& given) {
  using C = const ForeignContact&;
  using B = const ForeignBody&;
  const bool has_vectors = any_of(given, std::pair([](C c) { return c.friction_force.has_value(); },
                                                   [](B b) { return b.force.has_value(); }));
  const bool has_forces =
      has_vectors || any_of(given, std::pair([](C c) { return c.normal_force.has_value(); },
                                             [](B b) { return b.normal_force.has_value(); }));
  const bool has_moments = any_of(given, std::pair([](C c) { return c.torsion.has_value(); },
                                                   [](B b) { return b.moment.has_value(); }));
  std::vector<LikelyMistake> list;
  const std::string on_bodies =
      "these are forces on the bodies; forces on the object are asked for";
  if (has_friction(file, given)) {
    list.push_back(
        {"With every friction force turned round", on_bodies, turned(file, given, false), true});
    if (has_moments) list.back().beside = without_moments(given);
  }
  if (has_forces)
    list.push_back({"With every force turned round", on_bodies, turned(file, given, true), true});
  const auto add = [&](bool is_given, const std::string& undone, const std::string& because,
                       ForeignAnswer answer) {
    if (is_given) list.push_back({undone, because, std::move(answer), false});
  };
  add(has_forces, "With every force times 9.80665",
      "these look like kilogram-force; newtons are asked for",
      with_forces_times(given, VerifySettings::kilogram_force));
  add(has_forces, "With every force divided by 1000",
      "these look like millinewtons; newtons are asked for",
      with_forces_times(given, 1 / VerifySettings::thousand));
  add(has_moments && has_forces, "With every moment divided by 1000",
      "these look like N mm; N m are asked for",
      with_moments_times(given, 1 / VerifySettings::thousand));
  if (has_moments && has_forces) list.back().is_of_moments = true;
  add(given.acceleration.has_value(), "With the acceleration divided by 1000",
      "it looks like mm/s^2; m/s^2 are asked for",
      with_motion_times(given, 1 / VerifySettings::thousand));
  for (int axis = 0; axis < 3; ++axis) {
    const std::string a(1, "xyz"[(axis + 1) % 3]), b(1, "xyz"[(axis + 2) % 3]),
        about(1, "xyz"[axis]);
    Matrix3<double> swap = Matrix3<double>::Identity();
    swap.col((axis + 1) % 3).swap(swap.col((axis + 2) % 3));
    add(has_vectors, "With " + a + " and " + b + " of every vector interchanged",
        "vectors are in the scene's axes", in_axes(swap, -1, given));
    for (const int sign : {1, -1}) {
      Matrix3<double> turn = swap;
      turn.col(sign > 0 ? (axis + 2) % 3 : (axis + 1) % 3) *= -1;
      add(has_vectors,
          std::string("With every vector turned by ") + (sign > 0 ? "" : "-") +
              "90 degrees about " + about,
          "vectors are in the scene's axes", in_axes(turn, 1, given));
    }
  }
  return list;
}

} // namespace lcpush::desktop
