#include "sweep/sweep_quantity.hpp"

#include <cmath>

#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

using Kind = SweepQuantity::Kind;

} // namespace

const SweepAnswer& answer_of(const SweepQuantity& quantity, const SweepValue& at) {
  const bool breaks = quantity.kind == Kind::break_force || quantity.kind == Kind::break_twist;
  return breaks ? at.breaking : at.push;
}

bool is_force(const SweepQuantity& quantity) {
  return quantity.kind != Kind::twist && quantity.kind != Kind::break_twist;
}

double value_of(const SweepQuantity& quantity, const SweepValue& at) {
  switch (quantity.kind) {
  case Kind::break_force: return at.breaking.normal;
  case Kind::force: return at.push.force.norm();
  case Kind::force_component: return at.push.force[quantity.component];
  case Kind::twist: return at.push.twist[quantity.component];
  case Kind::break_twist: return at.breaking.twist[quantity.component];
  }
  return 0;
}

std::string words_of(const SweepQuantity& quantity) {
  const Index k = quantity.component;
  const std::string axis = std::string(k < 3 ? " along " : " about ") + "xyz"[k % 3];
  switch (quantity.kind) {
  case Kind::break_force: return "breaking force (normal)";
  case Kind::force: return "push as prescribed (size)";
  case Kind::force_component: return "push" + axis;
  case Kind::twist: return "acceleration" + axis;
  case Kind::break_twist: return "motion at breaking" + axis;
  }
  return {};
}

std::string axis_label(const SweepQuantity& quantity) {
  return words_of(quantity) + (quantity.unit().empty() ? "" : ", " + quantity.unit());
}

std::string SweepQuantity::name() const {
  constexpr const char* names[] = {"break_force", "force", "force", "twist", "break_twist"};
  const bool is_whole = kind == Kind::break_force || kind == Kind::force;
  return names[static_cast<int>(kind)] + (is_whole ? "" : "[" + std::to_string(component) + "]");
}

std::string SweepQuantity::unit() const {
  if (is_force(*this)) return "N";
  if (kind == Kind::twist) return component < 3 ? "m/s^2" : "rad/s^2";
  return component < 3 ? "" : "rad/m";
}

SweepQuantity sweep_quantity(const std::string& name) {
  std::vector<SweepQuantity> all = {{Kind::break_force, 0}, {Kind::force, 0}};
  for (Index k = 0; k < 3; ++k) all.push_back({Kind::force_component, k});
  for (Index k = 0; k < 6; ++k) all.push_back({Kind::twist, k});
  for (Index k = 0; k < 6; ++k) all.push_back({Kind::break_twist, k});
  std::vector<std::string> names;
  for (const SweepQuantity& quantity : all) {
    names.push_back(quantity.name());
    if (quantity.name() == name) return quantity;
  }
  throw InputError("nothing to show is called " + quoted(name) + suggestion(name, names) +
                   "; there are break_force, force, force[0] to force[2], twist[0] to twist[5] and "
                   "break_twist[0] to break_twist[5]");
}

} // namespace lcpush::desktop
