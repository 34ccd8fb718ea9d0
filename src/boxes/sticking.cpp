// The verdict on a sticking push over a box, and its margin.
#include "boxes/push_model.hpp"
#include "boxes/settings.hpp"
#include "cone/pusher_cone.hpp"
#include "lcpush/desktop/naming.hpp"
#include "solve/sentence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

class PushJudge {
public:
  PushJudge(const VariedScene& scene, const std::optional<Vector6<double>>& twist)
      : box_(scene), file_(scene.as_given()), model_(box_, twist) {}

  BoxAnswer judge() {
    answer_ = box_.answer();
    answer_.reason = model_.obstacle();
    if (!answer_.reason.empty()) return answer_;
    const Seen seen = look(std::nullopt);
    decide(seen);
    if (model_.has_load()) decide_holding();
    find_margin();
    return answer_;
  }

private:
  /// What the corners say.
  struct Seen {
    bool sticks = true;                 ///< surely, at each
    std::array<bool, 4> fails{};        ///< the same condition at each: it never sticks
    std::optional<Box::Corner> slips{}; ///< surely, and most
    std::size_t condition = 0;          ///< that fails most there
  };

  /// Numbers on which nothing depends stay at one end.
  bool is_wanted(Box::Corner c) const {
    for (std::size_t k = 0; k < box_.sides().size(); ++k)
      if (!model_.counts()[k] && (c >> k & 1U) != 0) return false;
    return true;
  }

  Seen look(const std::optional<Rational>& margin) const {
    Seen seen;
    seen.fails.fill(true);
    double worst = 0;
    for (Box::Corner c = 0; c < box_.corners(); ++c) {
      if (!is_wanted(c)) continue;
      const PushConditions<Interval> there = model_.exact_conditions(box_.corner(c, margin));
      for (std::size_t i = 0; i < there.values.size(); ++i) {
        seen.sticks = seen.sticks && there.values[i].low.sign() >= 0;
        const Rational most =
            i < 2 ? there.values[i].high : there.values[i].high + there.slack.high;
        seen.fails[i] = seen.fails[i] && most.sign() < 0;
        if (most.sign() >= 0 || !(most.value() / unit(i) < worst)) continue;
        worst = most.value() / unit(i);
        seen.slips = c;
        seen.condition = i;
      }
    }
    return seen;
  }

  /// Of a condition: moments are compared with forces at the pusher's width.
  double unit(std::size_t condition) const {
    const auto& points = file_.points;
    return condition < 2 ? 1
                         : (points[point(model_.last())] - points[point(model_.first())]).norm();
  }
  std::size_t point(Index i) const {
    return static_cast<std::size_t>(file_.body(model_.pusher()).first_point + i);
  }

  void decide(const Seen& seen) {
    if (std::find(seen.fails.begin(), seen.fails.end(), true) != seen.fails.end()) {
      answer_.verdict = BoxVerdict::never;
      answer_.reason = slip_words(seen.condition);
    } else if (seen.slips) {
      answer_.verdict = BoxVerdict::may_slip;
      answer_.reason = slip_words(seen.condition);
      box_.put_corner(box_.corner(*seen.slips), answer_);
    } else if (!seen.sticks) {
      answer_.reason = "it is on the verge of slipping at a corner, within what fractions can tell";
    } else if (!model_.presses()) {
      answer_.reason = "the pusher moves away, so that it may leave as well as stick";
    } else {
      answer_.verdict = BoxVerdict::always;
    }
  }

  std::string slip_words(std::size_t condition) const {
    const Body<double>& pusher = file_.body(model_.pusher());
    const Vector3<double> along = cross<double>(Vector3<double>::UnitZ(), pusher.normal);
    const std::string object = object_name(file_), name = file_.body_name(model_.pusher());
    if (condition < 2)
      return object + " slips over " + name + " along " +
             direction_text(Vector3<double>((condition == 0 ? -1 : 1) * along));
    const Index outer = condition == 2 ? model_.first() : model_.last();
    return object + " turns about " + point_name(file_, static_cast<Index>(point(outer))) +
           " off the rest of " + name;
  }

  /// The load's largest share of what the grip holds alone, over the corners: it is convex in each
  /// number of the load, and falls with friction and grip.
  double holding_share(const std::optional<Rational>& margin, Box::Corner& worst) const {
    double most = 0;
    for (Box::Corner c = 0; c < box_.corners(); ++c) {
      bool is_least = is_wanted(c);
      for (std::size_t k = 0; k < box_.sides().size(); ++k) {
        const BoxSide& side = box_.sides()[k];
        const bool is_load = side.key == "mass" || side.key == "gravity" || side.key == "force" ||
                             side.key == "moment";
        is_least = is_least && (is_load || (c >> k & 1U) == 0);
      }
      if (!is_least) continue;
      const SceneFile there = box_.scene_at(box_.corner(c, margin));
      const double length = planar_reach(there);
      const Vector3<double> load = planar_load(there, length);
      if (load.isZero(0)) continue;
      const LimitSurface grip(GripPoints(there), length);
      const double share =
          grip.is_solid() ? grip.share_of(load) : std::numeric_limits<double>::infinity();
      if (!(share > most)) continue;
      most = share;
      worst = c;
    }
    return most;
  }

  void decide_holding() {
    if (answer_.verdict == BoxVerdict::never) return;
    Box::Corner worst = 0;
    const double share = holding_share(std::nullopt, worst);
    if (share < 1 - box_settings.holding) return;
    const bool falls = share > 1 + box_settings.holding;
    if (!falls && answer_.verdict != BoxVerdict::always) return;
    answer_.verdict = falls ? BoxVerdict::may_slip : BoxVerdict::not_known;
    answer_.reason = "the grasp " + std::string(falls ? "does not hold " : "hardly holds ") +
                     object_name(file_) + " before it is pushed";
    answer_.corner.clear();
    if (falls) box_.put_corner(box_.corner(worst), answer_);
  }

  bool sticks(double margin) const {
    for (Box::Corner c = 0; c < box_.corners(); ++c) {
      if (!is_wanted(c)) continue;
      std::vector<double> at;
      for (std::size_t k = 0; k < box_.sides().size(); ++k) {
        const BoxSide& side = box_.sides()[k];
        const bool is_high = (c >> k & 1U) != 0;
        const double middle = side.middle.value();
        at.push_back(!side.is_relative ? (is_high ? side.high : side.low).value()
                                       : middle + (is_high ? 1 : -1) * std::abs(middle) * margin);
      }
      for (const double value : model_.conditions(at).values)
        if (value < 0) return false;
    }
    return true;
  }

  /// The boxes of growing margins lie in each other: there is one largest. It is looked for with
  /// rounding, and what is a little smaller proved without.
  void find_margin() {
    const auto& counts = model_.counts();
    answer_.is_indifferent = std::find(counts.begin(), counts.end(), true) == counts.end() &&
                             answer_.verdict == BoxVerdict::always;
    if (!box_.is_scaled(counts)) return;
    double margin = widest_margin([this](double e) { return sticks(e); });
    Box::Corner worst = 0;
    const auto holds = [&](double e) {
      return !model_.has_load() || holding_share(Rational(e), worst) < 1 - box_settings.holding;
    };
    if (!holds(margin))
      margin = widest_margin([&](double part) { return holds(part * margin); }, true) * margin;
    const Seen seen = look(Rational(margin));
    if (seen.sticks && model_.presses() && holds(margin))
      answer_.margin = margin;
    else if (seen.slips || answer_.verdict == BoxVerdict::never)
      answer_.margin = 0;
  }

  const Box box_;
  const SceneFile file_;
  const PushModel model_;
  BoxAnswer answer_;
};

} // namespace

BoxAnswer judge_push(const VariedScene& scene, const std::optional<Vector6<double>>& twist) {
  const SceneFile file = scene.as_given();
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b)
    if (file.body(b).role == Role::pusher) refuse_no_cone(file, b);
  refuse_single_place(file, LimitSurface(GripPoints(file), planar_reach(file)));
  return PushJudge(scene, twist).judge();
}

} // namespace lcpush::desktop
