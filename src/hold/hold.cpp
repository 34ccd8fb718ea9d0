#include "lcpush/desktop/hold.hpp"

#include <algorithm>
#include <cmath>

#include "hold/give_way.hpp"
#include "hold/holding_law.hpp"
#include "hold/load_set.hpp"
#include "hold/pad_statics.hpp"
#include "hold/settings.hpp"
#include "solve/grip_statics.hpp"
#include "solve/self_stress.hpp"

namespace lcpush::desktop {
namespace {

using Ending = StaticsProgram::Ending;

/// A unit of a disturbance as a wrench at the centre of mass. `at`: from there.
Vector6<double> unit_wrench(const SceneFile& file, Disturbance kind, const Vector3<double>& along,
                            const Vector3<double>& at) {
  Vector6<double> wrench = Vector6<double>::Zero();
  switch (kind) {
  case Disturbance::force: return wrench_column<double>(at, along);
  case Disturbance::moment: wrench.tail<3>() = along; return wrench;
  case Disturbance::acceleration: wrench.head<3>() = -file.object.mass * along; return wrench;
  }
  return wrench;
}

/// The questions of one hand at rest.
class HoldQuestions {
public:
  HoldQuestions(const SceneFile& hand, const PushOptions& options, HoldStudy& study)
      : hand_(hand), options_(options), study_(study), statics_(hand) {}

  /// Which grips hold?
  void find_grip() {
    const Eigen::VectorXd& grip = statics_.grip_column();
    StaticsProgram program(statics_, grip, 0, statics_.load(0));
    const Ending ending = program.find_point();
    if (ending == Ending::none) {
      study_.statics_factor = no_limit;
      study_.falls = read_motion(hand_, statics_, program.motion(), {});
    }
    if (ending == Ending::failed)
      study_.reason = "neither forces that carry the load were found nor a proof that none do";
    if (ending != Ending::found) return;
    const auto least = program.minimise(Eigen::VectorXd::Ones(1));
    if (least.ending != Ending::found) return;
    study_.statics_factor = std::max(0.0, least.value);
    study_.falls = read_motion(hand_, statics_, least.motion, program.contacts());
    if (const auto most = program.minimise(-Eigen::VectorXd::Ones(1)); most.ending == Ending::found)
      study_.statics_most = -most.value;
    rays_ = program.rays();
  }

  /// Are its bounds apart?
  static bool is_open(const StaticsProgram::Optimum& most) {
    return most.ending == Ending::found &&
           most.value - most.bound > hold_settings.told * std::abs(most.value);
  }

  static StaticsProgram::Optimum most_of(StaticsProgram& program) {
    if (program.find_point() != Ending::found) return {};
    return program.minimise(-Eigen::VectorXd::Ones(1));
  }

  /// The largest t of w + t d.
  HoldLimit limit(const HoldDirection& what, bool asks_law = true) {
    const Vector6<double> d = unit_wrench(hand_, what.kind, what.direction, at());
    HoldLimit found;
    if (const HoldLimit* const known = same_limit(what); known != nullptr && asks_law)
      return *known;
    if (const HoldLimit* const force = same_force(what); force != nullptr)
      found = over_mass(*force);
    found.what = what;
    if (!std::isnan(found.limit)) return found;
    Eigen::MatrixXd column = statics_.wrench_column(d);
    const double unit = column.cwiseAbs().maxCoeff();
    if (!(unit > 0)) return found; // a plane has no such load
    column /= unit;
    std::optional<StaticsProgram> program;
    StaticsProgram::Optimum most;
    // The rays that hold the load may be a corner of many, at which a program goes astray.
    for (const std::vector<ForceRay>& known : {rays_, std::vector<ForceRay>()})
      if (most.ending == Ending::failed || is_open(most))
        most = most_of(program.emplace(statics_, column, 1, statics_.load(1), known));
    if (most.ending == Ending::failed) return found;
    const double si = statics_.scales().force / unit;
    const auto told = [&](double t) { return t > statics_settings.closed ? t * si : 0; };
    found.statics = most.ending == Ending::unlimited ? no_limit : told(-most.value);
    found.lower = found.statics;
    found.upper =
        most.ending == Ending::unlimited ? no_limit : std::max(found.statics, told(-most.bound));
    if (most.ending == Ending::found)
      found.gives = read_motion(hand_, statics_, most.motion, program->contacts());
    found.limit = law_ ? law_->limit(d, found.statics, asks_law) : found.statics;
    if (law_) study_.may_bear_more = law_->may_bear_more();
    return found;
  }

  /// What its pads can hold, without asking their law.
  HoldSection section(Disturbance kind, Index along) {
    HoldSection found{kind, along, (along + 1) % 3, {}};
    const bool has_surfaces = law_ && law_->surfaces().points.size() > hand_.points.size();
    const Index steps = has_surfaces ? hold_settings.pad_steps : hold_settings.section_steps;
    for (Index k = 0; k < steps; ++k) {
      Vector3<double> direction = Vector3<double>::Zero();
      direction[along] = circle_cosine<double>(k, steps);
      direction[found.across] = circle_sine<double>(k, steps);
      found.reach.push_back(limit({kind, direction}, false).limit);
    }
    return found;
  }

  /// Of the law's work, what the next limits may use.
  void allow(double part) {
    if (law_) law_->allow(part);
  }

  /// The direction of a kind in which the least is held.
  HoldLimit weakest(Disturbance kind) {
    // Forces at the centre of mass are accelerations backwards.
    const bool is_force = kind == Disturbance::acceleration && at().isZero(0);
    const HoldLimit& force = study_.weakest[0];
    HoldLimit found{{kind, Vector3<double>::Zero() - force.what.direction}};
    double lower = force.lower / hand_.object.mass;
    if (!is_force) {
      const auto near = nearest(statics_, kind, at(), distance);
      if (!near) return HoldLimit{{kind, Vector3<double>::Zero()}};
      found.what.direction = near->direction;
      lower = near->lower * statics_.scales().force * unit_of(kind);
    }
    found = limit(found.what);
    lower = std::min(lower, found.statics);
    double upper = found.statics;
    // Of statics; where the law holds less it may be weakest elsewhere.
    std::vector<HoldLimit> others = study_.limits;
    if (pads_ && !is_force)
      if (const auto near = nearest(*pads_, kind, at(), distance))
        others.push_back(limit({kind, near->direction}));
    for (const HoldLimit& other : others)
      if (other.what.kind == kind) {
        upper = std::min(upper, other.statics);
        if (other.limit < (1 - hold_settings.same) * found.limit) found = other;
      }
    // Of all directions, not of this one.
    found.lower = std::min(lower, upper);
    found.upper = upper;
    return found;
  }

  /// By how much gravity may turn, in any direction: by statics, or where pads that all touch bear
  /// less, by those if their law agrees.
  double tilt() {
    const std::optional<Tilt> all = tilt_of(statics_);
    if (!all) return unknown_number;
    const std::optional<Tilt> of_pads = pads_ ? tilt_of(*pads_) : std::nullopt;
    if (!of_pads || !(of_pads->angle < all->angle)) return all->angle;
    const double angle = std::min(pi(), (1 + hold_settings.beyond) * of_pads->angle);
    const Vector3<double> down = hand_.gravity.normalized();
    const Vector3<double> aside =
        (of_pads->towards - of_pads->towards.dot(down) * down).normalized();
    const Vector3<double> more =
        hand_.gravity.norm() * ((std::cos(angle) - 1) * down + std::sin(angle) * aside);
    // Not known: all that is sure is that statics allows no more.
    Vector6<double> turned = Vector6<double>::Zero();
    turned.head<3>() = hand_.object.mass * more;
    return law_->holds(1, turned) == false ? of_pads->angle : all->angle;
  }

  /// By the scene's law: which grips hold, and does the scene's own?
  void find_law() {
    is_squeezed_ = is_squeezed(hand_, statics_);
    study_.is_statics = !statics_.has_pads() && !is_squeezed_;
    study_.factor = study_.statics_factor;
    study_.most = study_.statics_most;
    const double slack = statics_settings.carries;
    const bool may_hold = study_.factor <= 1 + slack && study_.most >= 1 - slack;
    if (!std::isnan(study_.factor)) study_.held = may_hold;
    if (study_.is_statics && study_.held.value_or(false)) {
      Push push(hand_);
      if (const HoldReport rest = push.holds_without_push(options_);
          rest.status == Status::solved && !rest.holds)
        study_.other = rest;
    }
    if (study_.is_statics || !(study_.factor < no_limit)) return;
    law_.emplace(hand_, options_, statics_, is_squeezed_);
    pads_.emplace(law_->surfaces(), std::vector<bool>(law_->surfaces().points.size(), true));
    study_.held = law_->holds_now();
    if (!study_.held) study_.reason = "the law of pads has no answer at rest that was found";
    if (study_.grip.force == 0) return;
    study_.factor = law_->least_grip(study_.statics_factor);
    study_.most = law_->most_grip(study_.statics_most);
  }

  /// What a load beyond a limit that is told does, and one that is not held.
  void find_falls() {
    const auto look = [&](double factor, const Vector6<double>& more, GiveWay& gives) {
      SceneFile there = with_grip(hand_, factor);
      there.object.wrench += more;
      if (const std::optional<GiveWay> fall = read_fall(there, options_)) gives = *fall;
    };
    if (!study_.held.value_or(false)) {
      const bool is_known = study_.factor > 0 && study_.factor < no_limit;
      return look(is_known ? (1 - hold_settings.beyond) * study_.factor : 1,
                  Vector6<double>::Zero(), study_.falls);
    }
    const auto beyond = [&](HoldLimit& limit) {
      if (limit.limit > 0 && limit.limit < no_limit)
        look(1,
             (1 + hold_settings.beyond) * limit.limit *
                 unit_wrench(hand_, limit.what.kind, limit.what.direction, at()),
             limit.gives);
    };
    for (std::size_t k = 0; k < study_.limits.size(); ++k) {
      const auto kind = static_cast<std::size_t>(study_.limits[k].what.kind);
      const bool is_weak =
          study_.limits[k].limit <= (1 + hold_settings.told) * study_.weakest[kind].limit;
      if (k >= asked_first_ || (is_weak && kind < 2)) beyond(study_.limits[k]);
    }
    for (std::size_t kind = 0; kind < 2; ++kind) beyond(study_.weakest[kind]);
  }

private:
  static constexpr std::size_t asked_first_ = 18; ///< of the limits: those along axes come first
  const SceneFile& hand_;
  const PushOptions& options_;
  HoldStudy& study_;
  GripStatics statics_;
  std::optional<HoldingLaw> law_;  ///< where it is another than statics
  std::optional<PadStatics> pads_; ///< then of its surfaces, all of which touch
  std::vector<ForceRay> rays_;     ///< with which the load is held
  bool is_squeezed_ = false;       ///< statics holds what it likes: the law alone decides

  static double distance(const Vector3<double>&, double height) { return height; }
  struct Tilt {
    double angle;            ///< rad
    Vector3<double> towards; ///< gravity turns to it from straight down
  };
  std::optional<Tilt> tilt_of(const GripStatics& statics) {
    const double weight = hand_.object.mass * hand_.gravity.norm() / statics.scales().force;
    if (!(weight > 0) || is_squeezed_) return std::nullopt;
    const Vector3<double> down = hand_.gravity.normalized();
    const auto near = nearest(
        statics, Disturbance::force, Vector3<double>::Zero(),
        [&](const Vector3<double>& normal, double height) {
          const double cosine = std::clamp(normal.dot(down), -1.0, 1.0);
          const double reach = (height + weight * cosine) / weight;
          return reach >= 1 ? pi() : std::acos(cosine) - std::acos(std::max(reach, -1.0));
        },
        hold_settings.beside * weight);
    if (!near) return std::nullopt;
    // What statics alone says is so much; where pads have their law it is at most so much.
    const bool is_closed = near->upper - near->lower <= hold_settings.same * near->upper;
    const bool is_upper = is_closed || !study_.is_statics;
    return Tilt{std::max(0.0, is_upper ? near->upper : near->lower), near->direction};
  }
  static double pi() { return std::acos(-1.0); }
  Vector3<double> at() const { return study_.at - hand_.object.center_of_mass; }
  /// The one that is known already.
  const HoldLimit* same_limit(const HoldDirection& what) const {
    for (const HoldLimit& known : study_.limits)
      if (known.what.kind == what.kind && known.what.direction == what.direction &&
          !std::isnan(known.limit))
        return &known;
    return nullptr;
  }
  /// An acceleration is a force at the centre of mass, backwards: the one that is known.
  const HoldLimit* same_force(const HoldDirection& what) const {
    if (what.kind != Disturbance::acceleration || !at().isZero(0)) return nullptr;
    for (const HoldLimit& known : study_.limits)
      if (known.what.kind == Disturbance::force && known.what.direction == -what.direction)
        return &known;
    const HoldLimit& weakest = study_.weakest[0];
    return weakest.what.direction == -what.direction ? &weakest : nullptr;
  }
  HoldLimit over_mass(HoldLimit limit) const {
    for (double* const part : {&limit.limit, &limit.statics, &limit.lower, &limit.upper})
      *part /= hand_.object.mass;
    return limit;
  }
  /// SI value of a disturbance over the scene's force.
  double unit_of(Disturbance kind) const {
    return kind == Disturbance::force    ? 1
           : kind == Disturbance::moment ? statics_.scales().length
                                         : 1 / hand_.object.mass;
  }

  /// Of a kind's set of held loads, in the scene's force. The nearest plane is no farther than the
  /// set reaches along an axis; what is farther does not matter.
  std::optional<NearestBoundary> nearest(const GripStatics& statics, Disturbance kind,
                                         const Vector3<double>& at, const Nearness& nearness,
                                         double least_size = 0) {
    Eigen::MatrixXd columns(statics.rows(), 3);
    for (Index k = 0; k < 3; ++k)
      columns.col(k) = statics.wrench_column(
          unit_of(kind) * unit_wrench(hand_, kind, Vector3<double>(Vector3<double>::Unit(k)), at));
    const std::vector<ForceRay> rays = &statics == &statics_ ? rays_ : std::vector<ForceRay>();
    const std::optional<double> reach = LoadSet(statics, columns, rays).least_along_axes();
    if (!reach) return std::nullopt;
    const double size =
        std::max({hold_settings.beside * *reach, least_size, statics_settings.flat});
    return LoadSet(statics, columns, rays, size).nearest(nearness);
  }
};

} // namespace

std::vector<Press> presses_of(const SceneFile& file) {
  std::vector<Press> list;
  for (const Drive<double>& drive : file.drives)
    if (file.body(drive.body).role == Role::pusher)
      list.push_back({drive.body, file.actuators[static_cast<std::size_t>(drive.actuator)].force});
  return list;
}

HoldStudy find_hold(const SceneFile& file, const HoldQuestion& question,
                    const PushOptions& options) {
  HoldStudy study;
  SceneFile hand = hand_at_rest(file);
  study.presses = question.presses;
  for (const Press& press : question.presses ? presses_of(file) : std::vector<Press>()) {
    const Body<double>& body = file.body(press.body);
    Vector3<double> middle = Vector3<double>::Zero();
    for (const Index i : points_of(body))
      middle += file.points[static_cast<std::size_t>(i)] / static_cast<double>(body.point_count);
    hand.object.wrench += wrench_column<double>(middle, press.force * body.normal);
  }
  study.at = question.at.value_or(file.object.center_of_mass);
  study.grip = named_grip(file);
  for (std::size_t k = 0; k < 3; ++k) study.weakest[k].what.kind = static_cast<Disturbance>(k);
  std::vector<HoldDirection> directions;
  for (const Disturbance kind :
       {Disturbance::force, Disturbance::moment, Disturbance::acceleration})
    for (Index axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0})
        directions.push_back(
            {kind, Vector3<double>::Zero() + sign * Vector3<double>(Vector3<double>::Unit(axis))});
  directions.insert(directions.end(), question.directions.begin(), question.directions.end());
  if (hand.bodies.empty()) {
    study.held = laws::load(file.view(), Scales<double>{1, 1, 1}).isZero(0);
    study.reason = "no finger holds it, and pushers are left out";
    return study;
  }
  HoldQuestions asked(hand, options, study);
  asked.find_grip();
  asked.find_law();
  if (question.grip_alone) return study;
  const bool holds = study.held.value_or(false);
  for (const HoldDirection& direction : directions) study.limits.push_back({direction});
  const std::size_t axes = directions.size() - question.directions.size();
  for (std::size_t k = 0; holds && k < directions.size(); ++k) {
    asked.allow(k < axes ? 1 : hold_settings.asked_share);
    study.limits[k] = asked.limit(directions[k]);
  }
  asked.allow(1);
  if (!holds) {
    asked.find_falls();
    return study;
  }
  for (HoldLimit& weakest : study.weakest) weakest = asked.weakest(weakest.what.kind);
  asked.find_falls();
  study.tilt = asked.tilt();
  for (const Disturbance kind : {Disturbance::force, Disturbance::moment})
    for (Index along = 0; question.with_sections && along < 3; ++along)
      study.sections.push_back(asked.section(kind, along));
  if (const double g = hand.gravity.norm(); g > 0)
    study.added_mass = asked.limit({Disturbance::force, hand.gravity / g}).limit / g;
  return study;
}

} // namespace lcpush::desktop
