// The verdict on a sticking push over a box, and its margin.
#include "boxes/sticking.hpp"
#include "boxes/settings.hpp"
#include "cone/pusher_cone.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "solve/sentence.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

/// As they are typed.
std::vector<Rational> exact(const std::vector<double>& of_sides) {
  std::vector<Rational> values;
  for (const double value : of_sides) values.push_back(*Rational::parse(shown(value)));
  return values;
}

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
        if (most.sign() >= 0 || !(most.value() / model_.unit(i) < worst)) continue;
        worst = most.value() / model_.unit(i);
        seen.slips = c;
        seen.condition = i;
      }
    }
    return seen;
  }

  void decide(const Seen& seen) {
    if (std::find(seen.fails.begin(), seen.fails.end(), true) != seen.fails.end()) {
      answer_.verdict = BoxVerdict::never;
      answer_.reason = model_.presses()
                           ? slip_words(file_, model_, seen.condition)
                           : "the pusher presses nowhere, and leaves " + object_name(file_);
    } else if (seen.slips) {
      answer_.verdict = BoxVerdict::may_slip;
      answer_.reason = slip_words(file_, model_, seen.condition);
      box_.put_corner(box_.corner(*seen.slips), answer_);
    } else if (!seen.sticks) {
      answer_.reason = "it is on the verge of slipping at a corner, within what fractions can tell";
    } else if (!model_.presses()) {
      answer_.reason = "the pusher moves away, so that it may leave as well as stick";
    } else {
      answer_.verdict = BoxVerdict::always;
    }
  }

  BoxEnds ends(const std::optional<double>& margin) const {
    BoxEnds ends;
    for (const BoxSide& side : box_.sides()) {
      const double middle = side.middle.value(), off = std::abs(middle) * margin.value_or(0);
      const bool is_scaled = margin && side.is_relative;
      ends.low.push_back(is_scaled ? middle - off : side.low.value());
      ends.high.push_back(is_scaled ? middle + off : side.high.value());
    }
    return ends;
  }

  void decide_holding() {
    if (answer_.verdict == BoxVerdict::never) return;
    std::vector<double> worst;
    const double share = holding_share(box_, model_, ends(std::nullopt), worst);
    if (share < 1 - box_settings.holding) return;
    const bool falls = share > 1 + box_settings.holding;
    if (!falls && answer_.verdict != BoxVerdict::always) return;
    answer_.verdict = falls ? BoxVerdict::may_slip : BoxVerdict::not_known;
    answer_.reason = falls
                         ? falls_words(file_)
                         : "the grasp hardly holds " + object_name(file_) + " before it is pushed";
    answer_.corner.clear();
    if (falls) box_.put_corner(exact(worst), answer_);
  }

  /// The boxes of growing margins lie in each other: there is one largest. It is looked for with
  /// rounding, and what is a little smaller proved without.
  void find_margin() {
    const auto& counts = model_.counts();
    answer_.is_indifferent = std::find(counts.begin(), counts.end(), true) == counts.end() &&
                             answer_.verdict == BoxVerdict::always;
    if (!box_.is_scaled(counts)) return;
    const double margin = sticking_margin(box_, model_, [this](double e) { return ends(e); });
    const Seen seen = look(Rational(margin));
    if (seen.sticks && model_.presses())
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

std::string falls_words(const SceneFile& file) {
  return "the grasp does not hold " + object_name(file) + " before it is pushed";
}

std::string slip_words(const SceneFile& file, const PushModel& model, std::size_t condition) {
  const Body<double>& pusher = file.body(model.pusher());
  const Vector3<double> along = cross<double>(Vector3<double>::UnitZ(), pusher.normal);
  const std::string object = object_name(file), name = file.body_name(model.pusher());
  if (condition < 2)
    return object + " slips over " + name + " along " +
           direction_text(Vector3<double>((condition == 0 ? -1 : 1) * along));
  const Index outer = pusher.first_point + (condition == 2 ? model.first() : model.last());
  return object + " turns about " + point_name(file, outer) + " and leaves the rest of " + name;
}

/// The share is convex in each number of the load, and falls with friction and grip.
double holding_share(const Box& box, const PushModel& model, const BoxEnds& ends,
                     std::vector<double>& worst) {
  double most = 0;
  for (Box::Corner c = 0; c < box.corners(); ++c) {
    bool is_wanted = true;
    std::vector<double> at = ends.low;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if ((c >> k & 1U) == 0) continue;
      is_wanted =
          is_wanted && model.counts()[k] && is_load(box.sides()[k]) && ends.low[k] < ends.high[k];
      at[k] = ends.high[k];
    }
    if (!is_wanted) continue;
    const SceneFile there = box.scene_at(exact(at));
    const double length = planar_reach(there);
    const Vector3<double> load = planar_load(there, length);
    if (load.isZero(0)) continue;
    const LimitSurface grip(GripPoints(there), length);
    const double share =
        grip.is_solid() ? grip.share_of(load) : std::numeric_limits<double>::infinity();
    if (!(share > most)) continue;
    most = share;
    worst = at;
  }
  return most;
}

double sticking_margin(const Box& box, const PushModel& model,
                       const std::function<BoxEnds(double margin)>& ends) {
  const double margin = widest_margin([&](double e) {
    const BoxEnds there = ends(e);
    const std::array<double, 4> rooms = model.rooms(there.low, there.high);
    return *std::min_element(rooms.begin(), rooms.end()) >= 0;
  });
  std::vector<double> worst;
  const auto holds = [&](double e) {
    return !model.has_load() ||
           holding_share(box, model, ends(e), worst) < 1 - box_settings.holding;
  };
  if (holds(margin)) return margin;
  return widest_margin([&](double part) { return holds(part * margin); }, true) * margin;
}

BoxAnswer judge_push(const VariedScene& scene, const std::optional<Vector6<double>>& twist) {
  const SceneFile file = scene.as_given();
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b)
    if (file.body(b).role == Role::pusher) refuse_no_cone(file, b);
  refuse_single_place(file, LimitSurface(GripPoints(file), planar_reach(file)));
  return PushJudge(scene, twist).judge();
}

BoxAnswer judge_modes(const VariedScene& scene) {
  const SceneFile file = scene.as_given();
  const auto pushers =
      std::count_if(file.bodies.begin(), file.bodies.end(),
                    [](const Body<double>& body) { return body.role == Role::pusher; });
  if (pushers == 0) return judge_hold(scene);
  BoxAnswer answer = unknown_box(scene);
  answer.reason = "contact modes are proved alone of one pusher that sticks in a plane (planar = "
                  "true), beside fingers that press across it";
  if (pushers > 1 || !file.planar) return answer;
  if (is_driven(file.view(), static_cast<Index>(file.bodies.size()) - 1)) // pushers come last
    answer.reason = "the pusher's force is given, and contact modes are proved of a given motion";
  try {
    return judge_push(scene);
  } catch (const InputError&) {
    return answer;
  }
}

} // namespace lcpush::desktop
