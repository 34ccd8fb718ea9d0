// A scene's ranges as a box.
#pragma once

#include "lcpush/desktop/boxes.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// Numbers that vary together: one, or the grip force of both jaws.
struct BoxSide {
  std::vector<Parameter> parameters;
  Rational low, middle, high;
  std::string key;          ///< "friction", "ends", ..
  bool is_relative;         ///< a margin scales it: no place, and not 0 in the middle
  std::optional<Role> role; ///< of the body that it is a number of; of other tables none
  /// Of a side that moves its numbers together from where they are typed: by how much of it each.
  std::vector<Rational> slopes = {};
  Rational typed = 0; ///< where it leaves them there

  template <class Keys> bool is_one_of(const Keys& keys) const {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  }
  /// Its ends with a margin.
  Rational low_at(const Rational& margin) const;
  Rational high_at(const Rational& margin) const;
};

/// The load's.
bool is_load(const BoxSide& side);

class Box {
public:
  /// Of the scene's ranges, and of more sides.
  explicit Box(const VariedScene& scene, const std::vector<BoxSide>& more = {});

  const std::vector<BoxSide>& sides() const { return sides_; }
  /// Which of the corners: bit k for the upper end of side k.
  using Corner = std::size_t;
  Corner corners() const { return Corner{1} << sides_.size(); }

  /// A parameter of each number, in the order of the file; and their values.
  const std::vector<Parameter>& parameters() const { return parameters_; }
  std::vector<Rational> values(const std::vector<Rational>& of_sides) const;
  std::vector<Rational> corner(Corner corner, const std::optional<Rational>& margin = {}) const;
  SceneFile scene_at(const std::vector<Rational>& of_sides) const;
  SceneOf<Rational> exact_scene_at(const std::vector<Rational>& of_sides) const {
    return scene_.exactly_at(parameters_, values(of_sides));
  }
  std::vector<Rational> middle() const;
  /// Does a margin scale a number that counts?
  bool is_scaled(const std::vector<bool>& counts) const;

  /// The box and nothing known.
  BoxAnswer answer() const;
  std::vector<std::pair<std::string, double>>
  named_values(const std::vector<Rational>& of_sides) const;
  void put_corner(const std::vector<Rational>& of_sides, BoxAnswer& answer) const;

private:
  const VariedScene& scene_;
  std::vector<BoxSide> sides_;
  std::vector<Parameter> parameters_;
};

} // namespace lcpush::desktop
