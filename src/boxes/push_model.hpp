// [T.20] A sticking planar push over a box: four conditions, each linear in every number by itself.
#pragma once

#include "boxes/box.hpp"
#include "boxes/interval.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lcpush::desktop {

/// The pusher sticks where none of them is negative: mu f_n - f_t, mu f_n + f_t, and how far inside
/// its outer points its force acts, times f_n: M - s_first f_n, s_last f_n - M. It slips where one
/// is less than - slack, of the last two: its points may not lie quite in a plane across its
/// normal.
template <class T> struct PushConditions {
  std::array<T, 4> values;
  T slack;
};

class PushModel {
public:
  /// For one twist of the object; none: the pusher's own.
  PushModel(const Box& box, const std::optional<Vector6<double>>& twist);

  /// Why it is no such push, a clause; empty: it is one.
  const std::string& obstacle() const { return obstacle_; }
  /// m, between the outer points: what a moment is compared with forces at. Of friction 1.
  double unit(std::size_t condition) const { return condition < 2 ? 1 : width_; }
  /// Of the sides, those on which it depends.
  const std::vector<bool>& counts() const { return counts_; }
  Index pusher() const { return pusher_; }
  /// Of the motion in the plane (v_x, v_y, omega), a factor left out.
  const std::array<Rational, 3>& direction() const { return twist_; }
  /// The outer points of the pusher, along z x n.
  Index first() const { return first_; }
  Index last() const { return last_; }
  /// Is there a load beside what the fingers resist, somewhere in the box?
  bool has_load() const { return has_load_; }

  PushConditions<Interval> exact_conditions(const std::vector<Rational>& of_sides) const;
  PushConditions<double> conditions(const std::vector<double>& of_sides) const;
  /// With rounding: how much each condition has to spare, N, at the corner between `low` and `high`
  /// where that is least; < 0: it fails.
  std::array<double, 4> rooms(const std::vector<double>& low,
                              const std::vector<double>& high) const;
  /// Does the motion press some point of the pusher into the object, in the whole box?
  bool presses() const { return presses_; }

private:
  using Numbers = std::vector<Rational>;
  /// What the numbers of a box may change: each is affine in them, and they are in `Numbers` in
  /// this order, friction and force first, finger by finger.
  enum Place { mass, gravity_x, gravity_y, force_x, force_y, moment, friction, first_point };

  const Box& box_;
  std::string obstacle_;
  std::vector<bool> counts_;
  Index pusher_ = -1, first_ = 0, last_ = 0, points_ = 0;
  std::size_t fingers_ = 0;
  bool has_load_ = false, presses_ = false;
  Rational spread_ = 0; ///< of the pusher's points along its normal
  Numbers middle_;
  std::vector<Numbers> slopes_; ///< a side
  /// What stays: the resistance of fingers of normal force and friction 1, and the pusher's normal.
  template <class T> struct Fixed {
    std::vector<std::array<T, 3>> resists;
    std::array<T, 2> normal;
    T slack;
  };
  Fixed<Interval> fixed_;
  Fixed<double> rounded_fixed_;
  double width_ = 1; ///< m, between the outer points
  std::array<Rational, 3> twist_;
  std::vector<double> rounded_middle_;
  /// Of a side: where the slopes begin, and those that are not 0.
  struct Slopes {
    double middle;
    std::vector<std::pair<std::size_t, double>> list;
  };
  std::vector<Slopes> rounded_slopes_;

  std::size_t at(Place place) const { return 2 * fingers_ + static_cast<std::size_t>(place); }
  void refuse(const BoxSide& side);
  void refuse_cuts();
  void find_slopes(const SceneOf<Rational>& scene, bool has_twist);
  void find_resistance(const SceneOf<Rational>& scene);
  void find_places();
  Numbers numbers(const SceneOf<Rational>& scene) const;
  Numbers fixed(const SceneOf<Rational>& scene, bool has_twist) const;
  Numbers numbers_at(const std::vector<Rational>& of_sides) const;
  /// Where a point of the pusher stands along z x n, and along n; and two beside each other.
  struct Standing {
    Interval along, off;
  };
  Standing standing(const Numbers& numbers, Index point, Index beside = -1) const;
  /// The least in the box of what is linear in places.
  Rational least(const std::function<Interval(const Numbers& numbers)>& linear) const;
  template <class T, class Number>
  PushConditions<T> conditions_of(const std::vector<Number>& numbers, const Fixed<T>& fixed) const;
};

} // namespace lcpush::desktop
