#include "boxes/push_model.hpp"

#include "boxes/settings.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace lcpush::desktop {
namespace {

/// Keys in which all that matters is affine, and keys that do not matter unless they change what
/// does: places of contacts `on` faces grow or shrink with the object, all the way or not at all.
constexpr std::array affine_keys = {"friction", "grip_force", "mass", "gravity", "force", "moment",
                                    "shift",    "center",     "ends", "points",  "length"};
constexpr std::array idle_keys = {"inertia",       "box",
                                  "sphere_radius", "cylinder_radius",
                                  "velocity",      "cylinder_length",
                                  "acceleration",  "angular_velocity",
                                  "about",         "angular_acceleration"};

void append(std::vector<Rational>& list, const Vector3<Rational>& v) {
  list.insert(list.end(), {v[0], v[1], v[2]});
}

/// What a finger presses with.
Rational normal_force(const SceneOf<Rational>& file, Index b) {
  const Scene<Rational> scene = file.view();
  Rational force = file.body(b).preload;
  for (const Drive<Rational>& drive : file.drives)
    if (drive.body == b) {
      const Rational speed = closing_speed(scene, file.body(b), drive);
      if (speed.sign() > 0)
        force += file.actuators[static_cast<std::size_t>(drive.actuator)].force /
                 (speed * Rational(drive_count(scene, drive.actuator)));
    }
  return force;
}

/// The resistance of a point to a motion (u_x, u_y, omega), for a limit of 1: (f_x, f_y) and the
/// torque of friction about z.
using PointResistance = std::array<Interval, 3>;

PointResistance round_resistance(const PointResistance& u, const Rational& radius) {
  const Interval turn = Interval(radius) * u[2];
  const Interval speed = root(u[0] * u[0] + u[1] * u[1] + turn * turn);
  if (speed.low.sign() <= 0) { // a point that may stand still resists with whatever it can
    const Interval any(-1, 1);
    return {any, any, Interval(radius) * any};
  }
  return {u[0] / speed, u[1] / speed, Interval(radius) * turn / speed};
}

/// Of the pyramid's generators those with the most power, as far as that can be told.
PointResistance pyramid_resistance(const PointResistance& u, const SceneOf<Rational>& file,
                                   const Body<Rational>& body) {
  const bool is_exact = file.facets == 4 && body.tangent.squaredNorm() == Rational(1) &&
                        !(body.torsion_radius > Rational(0));
  const Rational off = is_exact ? Rational(0) : Rational(box_settings.rounded);
  std::vector<PointResistance> all;
  std::vector<Interval> powers;
  const Index count =
      body.torsion_radius > Rational(0) ? soft_generators(file.facets) : file.facets;
  for (Index k = 0; k < count; ++k) {
    const Generator<Rational> d = generator(body, k, file.facets);
    all.push_back({about(d.force[0], off), about(d.force[1], off),
                   about(d.torque * body.normal[2], off * body.torsion_radius)});
    powers.push_back(all.back()[0] * u[0] + all.back()[1] * u[1] + all.back()[2] * u[2]);
  }
  const auto most = std::max_element(powers.begin(), powers.end(),
                                     [](const auto& a, const auto& b) { return a.low < b.low; });
  PointResistance best = all[static_cast<std::size_t>(most - powers.begin())];
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; powers[k].high >= most->low && i < 3; ++i)
      best[i] = hull(best[i], all[k][i]);
  return best;
}

double middle(const Interval& x) { return (x.low.value() + x.high.value()) / 2; }

} // namespace

PushModel::PushModel(const Box& box, const std::optional<Vector6<double>>& twist) : box_(box) {
  const SceneOf<Rational> scene = box.exact_scene_at(box.middle());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    fingers_ += scene.bodies[b].role == Role::finger ? 1 : 0;
    if (scene.bodies[b].role == Role::pusher) pusher_ = static_cast<Index>(b);
  }
  const Body<Rational>& pusher = scene.body(pusher_);
  points_ = pusher.point_count;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index axis = i < 2 ? static_cast<Index>(i) : 5;
    twist_[i] = twist ? *Rational::parse(shown((*twist)[axis])) : pusher.acceleration[axis];
  }
  const Rational largest = std::max({abs(twist_[0]), abs(twist_[1]), abs(twist_[2])});
  if (largest.sign() == 0) obstacle_ = "the pusher does not move; give --twist";
  int power = 0; // directions count alone
  (void)std::frexp(largest.value(), &power);
  for (Rational& x : twist_) x *= Rational(std::ldexp(1.0, -power));
  const Rational cut =
      pusher.normal.squaredNorm() == Rational(1) ? Rational(0) : Rational(box_settings.cut_normal);
  fixed_.normal = {about(pusher.normal[0], cut), about(pusher.normal[1], cut)};
  find_slopes(scene, twist.has_value());
  if (obstacle_.empty()) find_resistance(scene);
  if (obstacle_.empty()) find_places();
  fixed_.slack = spread_;
  for (const auto& r : fixed_.resists)
    rounded_fixed_.resists.push_back({middle(r[0]), middle(r[1]), middle(r[2])});
  rounded_fixed_.normal = {middle(fixed_.normal[0]), middle(fixed_.normal[1])};
  rounded_fixed_.slack = spread_.value();
  if (last_ != first_) width_ = middle(standing(middle_, last_, first_).along);
}

PushModel::Numbers PushModel::numbers(const SceneOf<Rational>& scene) const {
  Numbers list;
  for (std::size_t b = 0; b < fingers_; ++b) list.push_back(scene.bodies[b].friction);
  for (std::size_t b = 0; b < fingers_; ++b)
    list.push_back(normal_force(scene, static_cast<Index>(b)));
  const Vector6<Rational>& w = scene.object.wrench;
  list.insert(list.end(), {scene.object.mass, scene.gravity[0], scene.gravity[1], w[0], w[1], w[5],
                           scene.body(pusher_).friction});
  for (const Index i : points_of(scene.body(pusher_)))
    for (Index axis = 0; axis < 2; ++axis)
      list.push_back(scene.points[static_cast<std::size_t>(i)][axis]);
  return list;
}

void PushModel::refuse(const BoxSide& side) {
  obstacle_ = "whether it sticks is no multi-affine function of " + side.parameters[0].path;
}

/// What reaches beyond the object's box is cut to it, from some overhang on: no affine function of
/// a place. The overhang is convex, so none at the corners is none in between.
void PushModel::refuse_cuts() {
  constexpr std::array place_keys = {"shift", "center", "ends", "points", "length"};
  const auto& sides = box_.sides();
  if (std::none_of(sides.begin(), sides.end(),
                   [&](const BoxSide& side) { return side.is_one_of(place_keys); }))
    return;
  for (Box::Corner c = 0; c < box_.corners(); ++c) {
    bool is_wanted = true;
    for (std::size_t k = 0; k < sides.size(); ++k)
      is_wanted = is_wanted && (sides[k].is_one_of(place_keys) || (c >> k & 1U) == 0);
    if (!is_wanted) continue;
    for (const double overhang : box_.scene_at(box_.corner(c)).overhang)
      if (overhang > 0)
        obstacle_ = "the pusher reaches beyond the object, where it is cut to what touches";
  }
}

/// What has to stay.
PushModel::Numbers PushModel::fixed(const SceneOf<Rational>& scene, bool has_twist) const {
  Numbers list;
  for (const Body<Rational>& body : scene.bodies) {
    append(list, body.normal);
    if (body.role == Role::pusher) continue;
    append(list, body.tangent);
    list.push_back(body.torsion_radius);
    for (const Index i : points_of(body)) {
      append(list, scene.points[static_cast<std::size_t>(i)]);
      list.push_back(scene.weights[static_cast<std::size_t>(i)]);
    }
  }
  const Vector6<Rational>& own = scene.body(pusher_).acceleration;
  if (!has_twist) list.insert(list.end(), own.data(), own.data() + own.size());
  return list;
}

void PushModel::find_slopes(const SceneOf<Rational>& scene, bool has_twist) {
  middle_ = numbers(scene);
  const Numbers stays = fixed(scene, has_twist);
  const auto change = [&](std::size_t k, const Rational& step) {
    std::vector<Rational> beside = box_.middle();
    beside[k] += step;
    const SceneOf<Rational> there = box_.exact_scene_at(beside);
    if (fixed(there, has_twist) != stays) refuse(box_.sides()[k]);
    Numbers numbers = this->numbers(there);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] -= middle_[i];
    return numbers;
  };
  const auto is_zero = [](const Numbers& numbers) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [](const Rational& x) { return x.sign() == 0; });
  };
  for (std::size_t k = 0; k < box_.sides().size(); ++k) {
    const BoxSide& side = box_.sides()[k];
    Numbers slope(middle_.size(), Rational(0));
    if (side.is_one_of(affine_keys)) {
      const Rational step = side.low < side.high ? side.high - side.middle : side.middle;
      if (step.sign() != 0) slope = change(k, step);
      for (Rational& x : slope) x = x.sign() == 0 ? x : x / step;
    } else if (!side.is_one_of(idle_keys) || !is_zero(change(k, side.low - side.middle)) ||
               !is_zero(change(k, side.high - side.middle))) {
      refuse(side);
    }
    counts_.push_back(!is_zero(slope));
    for (std::size_t i = at(gravity_x); i < at(friction); ++i)
      has_load_ = has_load_ || slope[i].sign() != 0;
    slopes_.push_back(std::move(slope));
  }
  for (std::size_t i = at(gravity_x); i < at(friction); ++i)
    has_load_ = has_load_ || middle_[i].sign() != 0;
  refuse_cuts();
  for (const Rational& x : middle_) rounded_middle_.push_back(x.value());
  for (std::size_t k = 0; k < slopes_.size(); ++k) {
    rounded_slopes_.push_back({box_.sides()[k].middle.value(), {}});
    for (std::size_t i = 0; i < middle_.size(); ++i)
      if (slopes_[k][i].sign() != 0)
        rounded_slopes_.back().list.emplace_back(i, slopes_[k][i].value());
  }
}

void PushModel::find_resistance(const SceneOf<Rational>& scene) {
  for (std::size_t b = 0; b < fingers_; ++b) {
    const Body<Rational>& body = scene.bodies[b];
    const Vector3<Rational>& n = body.normal;
    const std::string label = "the points of finger " + quoted(scene.body_names[b]) + " ";
    if (n[0].sign() != 0 || n[1].sign() != 0)
      obstacle_ = quoted(scene.body_names[b]) + " does not press exactly along z";
    const bool is_rounded =
        std::any_of(scene.inexact.begin(), scene.inexact.end(), [&](const std::string& sentence) {
          return sentence.find(label) != std::string::npos;
        });
    std::array<Interval, 3> sum;
    for (const Index i : points_of(body)) {
      const Vector3<Rational>& p = scene.points[static_cast<std::size_t>(i)];
      const Rational off =
          is_rounded ? Rational(box_settings.rounded) * (abs(p[0]) + abs(p[1]) + abs(p[2]))
                     : Rational(0);
      const Interval x = about(p[0], off), y = about(p[1], off), turn = twist_[2];
      const PointResistance u = {Interval(twist_[0]) - turn * y, Interval(twist_[1]) + turn * x,
                                 turn};
      const PointResistance r = scene.is_round ? round_resistance(u, body.torsion_radius)
                                               : pyramid_resistance(u, scene, body);
      const Interval weight = scene.weights[static_cast<std::size_t>(i)];
      sum[0] = shortened(sum[0] + weight * r[0]);
      sum[1] = shortened(sum[1] + weight * r[1]);
      sum[2] = shortened(sum[2] + weight * (x * r[1] - y * r[0] + r[2]));
    }
    fixed_.resists.push_back(sum);
  }
}

PushModel::Standing PushModel::standing(const Numbers& numbers, Index point, Index beside) const {
  const auto number = [&](Index i, std::size_t axis) {
    return numbers[at(first_point) + 2 * static_cast<std::size_t>(i) + axis];
  };
  Rational x = number(point, 0), y = number(point, 1);
  if (beside >= 0) {
    x -= number(beside, 0);
    y -= number(beside, 1);
  }
  return {Interval(y) * fixed_.normal[0] - Interval(x) * fixed_.normal[1],
          Interval(x) * fixed_.normal[0] + Interval(y) * fixed_.normal[1]};
}

Rational PushModel::least(const std::function<Interval(const Numbers& numbers)>& linear) const {
  Rational least = linear(middle_).low;
  for (std::size_t k = 0; k < slopes_.size(); ++k) {
    const Interval slope = linear(slopes_[k]);
    least -=
        std::max(abs(slope.low), abs(slope.high)) * (box_.sides()[k].high - box_.sides()[k].middle);
  }
  return least;
}

/// Its outer points, whether they stay so, how far the points are off a plane, and which press.
void PushModel::find_places() {
  for (Index i = 1; i < points_; ++i) {
    if (standing(middle_, i, first_).along.high.sign() < 0) first_ = i;
    if (standing(middle_, i, last_).along.low.sign() > 0) last_ = i;
  }
  if (!(standing(middle_, last_, first_).along.low.sign() > 0))
    obstacle_ = "the pusher presses at one place, where the object turns as it may";
  const Interval closing =
      Interval(twist_[0]) * fixed_.normal[0] + Interval(twist_[1]) * fixed_.normal[1];
  for (Index i = 0; i < points_; ++i) {
    const auto along = [&](Index a, Index b) {
      return least([&](const Numbers& numbers) { return standing(numbers, a, b).along; });
    };
    const auto off = [&](Index a, Index b) {
      return abs(least([&](const Numbers& numbers) { return standing(numbers, a, b).off; }));
    };
    if (obstacle_.empty() && (along(i, first_).sign() < 0 || along(last_, i).sign() < 0))
      obstacle_ = "the pusher's outer points change places within the ranges";
    for (const Index outer : {first_, last_})
      spread_ = std::max({spread_, off(i, outer), off(outer, i)});
    presses_ = presses_ || (closing.low + least([&](const Numbers& numbers) {
                              return Interval(-twist_[2]) * standing(numbers, i).along;
                            })).sign() > 0;
  }
}

PushModel::Numbers PushModel::numbers_at(const std::vector<Rational>& of_sides) const {
  Numbers numbers = middle_;
  for (std::size_t k = 0; k < slopes_.size(); ++k) {
    const Rational step = of_sides[k] - box_.sides()[k].middle;
    if (!counts_[k] || step.sign() == 0) continue;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (slopes_[k][i].sign() != 0) numbers[i] += slopes_[k][i] * step;
  }
  return numbers;
}

/// w = sum_b mu_b F_b R_b - m g - f at the centre of mass; M = h f_t - moment is the sum of the
/// points' s times their normal forces, with h where an outer point stands along n.
template <class T, class Number>
PushConditions<T> PushModel::conditions_of(const std::vector<Number>& numbers,
                                           const Fixed<T>& fixed) const {
  const auto number = [&](std::size_t i) { return T(numbers[i]); };
  const T m = number(at(mass));
  T w[3] = {T(0) - m * number(at(gravity_x)) - number(at(force_x)),
            T(0) - m * number(at(gravity_y)) - number(at(force_y)), T(0) - number(at(moment))};
  for (std::size_t b = 0; b < fingers_; ++b) {
    const T limit = number(b) * number(fingers_ + b);
    for (std::size_t i = 0; i < 3; ++i) w[i] = w[i] + limit * fixed.resists[b][i];
  }
  const T nx = fixed.normal[0], ny = fixed.normal[1], mu = number(at(friction));
  const T pressed = w[0] * nx + w[1] * ny, dragged = w[1] * nx - w[0] * ny;
  const auto beyond = [&](Index i) { // M - s f_n
    const std::size_t x = at(first_point) + 2 * static_cast<std::size_t>(i);
    const T h = number(x) * nx + number(x + 1) * ny, s = number(x + 1) * nx - number(x) * ny;
    return h * dragged - w[2] - s * pressed;
  };
  return {{mu * pressed - dragged, mu * pressed + dragged, beyond(first_), T(0) - beyond(last_)},
          fixed.slack * mu * pressed};
}

PushConditions<Interval> PushModel::exact_conditions(const std::vector<Rational>& of_sides) const {
  return conditions_of(numbers_at(of_sides), fixed_);
}

PushConditions<double> PushModel::conditions(const std::vector<double>& of_sides) const {
  std::vector<double> numbers = rounded_middle_;
  for (std::size_t k = 0; k < rounded_slopes_.size(); ++k)
    for (const auto& [i, slope] : rounded_slopes_[k].list)
      numbers[i] += slope * (of_sides[k] - rounded_slopes_[k].middle);
  return conditions_of(numbers, rounded_fixed_);
}

std::array<double, 4> PushModel::rooms(const std::vector<double>& low,
                                       const std::vector<double>& high) const {
  std::array<double, 4> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (Box::Corner c = 0; c < box_.corners(); ++c) {
    bool is_wanted = true;
    std::vector<double> at = low;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if ((c >> k & 1U) == 0) continue;
      is_wanted = is_wanted && counts_[k] && low[k] < high[k];
      at[k] = high[k];
    }
    if (!is_wanted) continue;
    const std::array<double, 4> values = conditions(at).values;
    for (std::size_t i = 0; i < least.size(); ++i)
      least[i] = std::min(least[i], values[i] / unit(i));
  }
  return least;
}

} // namespace lcpush::desktop
