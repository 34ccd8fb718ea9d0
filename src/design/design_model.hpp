// [T.21] The margin of a design where some choices are open and the conditions are linear in each.
#pragma once

#include "boxes/sticking.hpp"
#include "design/design_space.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace lcpush::desktop {

class DesignModel {
public:
  /// Choices that are not open stay as in `at`.
  DesignModel(const DesignSpace& space, std::vector<bool> open, Values at);

  /// Why there is no such model, a clause; empty: there is.
  const std::string& obstacle() const { return model_.obstacle(); }
  bool depends_on(std::size_t choice) const;
  const Values& at() const { return at_; }

  double margin(const Values& values) const;
  /// By what share of the grip the load is held before the push, with this margin. It is most where
  /// the frictions and grips are; of a load that is chosen that is not known.
  double hold_room(const Values& values, double margin) const;
  bool chooses_load() const;
  /// What each condition has to spare with this margin, at the worst corner, N.
  std::array<double, 4> rooms(const Values& values, double margin) const;
  /// What happens where that margin is too much: "the box slips over wall along -y".
  std::string first_beyond(const Values& values, double margin) const;
  /// Cuts off of the choices between these what surely does not stick with this margin; false:
  /// nothing is left. A condition is linear in each choice; where it fails at one end of a choice
  /// in a corner of the box, it does up to the first of its roots, over the corners of the others.
  bool narrow(Values& low, Values& high, double margin) const;
  /// A look at all corners, in looks at one.
  std::size_t cost() const { return box_.corners(); }

private:
  /// Of a side of the box: its choice, none is < 0, and how far it is off.
  struct Side {
    int choice = -1;
    bool is_relative = false;
    double off = 0; ///< of what is not relative
  };
  std::vector<bool> open_;
  Values at_;
  VariedScene scene_;
  Box box_;
  PushModel model_;
  std::vector<Side> sides_;

  BoxEnds ends(const Values& values, double margin) const;
};

} // namespace lcpush::desktop
