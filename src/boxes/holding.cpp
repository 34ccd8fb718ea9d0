// [T.20] Is the load held for every value in a box? The loads and grips that friction can hold
// together are a convex set, which grows with friction: corners of least friction decide.
#include "boxes/box.hpp"
#include "boxes/settings.hpp"
#include "hold/pad_statics.hpp"
#include "lcpush/desktop/hold.hpp"
#include "solve/self_stress.hpp"
#include "solve/sentence.hpp"

#include <algorithm>
#include <array>

namespace lcpush::desktop {
namespace {

/// Keys in which the load and the grip are affine, and those that a grasp without a push knows not.
constexpr std::array load_keys = {"mass", "gravity",    "force",         "moment",
                                  "at",   "grip_force", "center_of_mass"};
constexpr std::array keys_of_pushes = {"velocity", "acceleration", "angular_velocity",    "about",
                                       "inertia",  "normal_force", "angular_acceleration"};
/// With which fingers `on` faces may move.
constexpr std::array sizes = {"box", "cylinder_radius", "sphere_radius", "cylinder_length"};

class HoldJudge {
public:
  explicit HoldJudge(const VariedScene& scene) : box_(scene), file_(scene.as_given()) {}

  BoxAnswer judge() {
    answer_ = box_.answer();
    find_obstacle();
    if (!obstacle_.empty() && box_.sides().empty()) return answer_;
    decide();
    if (obstacle_.empty()) find_margin();
    return answer_;
  }

private:
  void find_obstacle() {
    for (const BoxSide& side : box_.sides()) {
      const bool is_idle = side.role == Role::pusher || side.is_one_of(keys_of_pushes);
      counts_.push_back(!is_idle);
      for (BoxRange& range : answer_.box)
        for (const Parameter& parameter : side.parameters)
          if (range.path == parameter.path) range.counts = !is_idle;
      if (!is_idle && side.key != "friction" && !side.is_one_of(load_keys) &&
          !side.is_one_of(sizes))
        obstacle_ = "what is held is not known to be convex in " + side.parameters[0].path;
    }
    const SceneFile roughest = hand_at_rest(box_.scene_at(box_.corner(box_.corners() - 1)));
    if (!roughest.bodies.empty() && is_squeezed(roughest, GripStatics(roughest)))
      obstacle_ = "its contacts may squeeze it against each other, and nothing says how hard";
    if (file_.hand == Hand::locked)
      obstacle_ = "locked jaws press with what the load makes of their grip, which is not convex";
  }

  /// Which corners decide: of all numbers but frictions both ends, of those the lower.
  bool is_wanted(Box::Corner c) const {
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const bool is_high = (c >> k & 1U) != 0;
      if (!counts_[k] && is_high) return false;
      if (is_high && box_.sides()[k].key == "friction") return false;
    }
    return true;
  }

  /// Do no other numbers vary but friction and these?
  template <class Keys> bool varies_in(const Keys& keys) const {
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const BoxSide& side = box_.sides()[k];
      if (counts_[k] && side.key != "friction" && side.low < side.high && !side.is_one_of(keys))
        return false;
    }
    return true;
  }

  /// Does a number of the box move them, as that of a box with fingers `on` its faces?
  bool moves_fingers(const SceneFile& there) const {
    return hand_at_rest(file_).positions != hand_at_rest(there).positions;
  }

  static HoldStudy study(const SceneFile& file) {
    HoldQuestion question;
    question.grip_alone = true;
    return find_hold(file, question);
  }

  /// Forces that hold it, of pads those of which each point takes part: the convex set.
  static bool has_forces(const SceneFile& file) {
    const SceneFile hand = hand_at_rest(file);
    if (hand.bodies.empty()) return false;
    if (const GripStatics statics(hand); !statics.has_pads()) return has_point(statics);
    return has_point(PadStatics(hand, std::vector<bool>(hand.points.size(), true)));
  }

  static bool has_point(const GripStatics& statics) {
    const Index moves = statics.displacement().cols();
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(statics.rows(), moves + 1);
    if (moves > 0) D.leftCols(moves) = statics.displacement();
    StaticsProgram program(statics, D, moves, statics.load(1));
    return program.find_point() == StaticsProgram::Ending::found;
  }

  void decide() {
    bool is_proved = true, is_compared = true;
    std::optional<WorstGrip> worst;
    for (Box::Corner c = 0; c < box_.corners(); ++c) {
      if (!is_wanted(c)) continue;
      const std::vector<Rational> at = box_.corner(c);
      const SceneFile there = box_.scene_at(at);
      if (obstacle_.empty() && moves_fingers(there))
        obstacle_ = "the fingers' places are not the same in the whole box";
      const HoldStudy found = study(there);
      if (found.held && !*found.held) {
        answer_.verdict = BoxVerdict::may_slip;
        answer_.reason = "the grasp does not hold " + object_name(file_);
        box_.put_corner(at, answer_);
        decide_never();
        return;
      }
      is_proved = is_proved && found.held && has_forces(there);
      is_compared = is_compared && found.factor < no_limit; // a number, too
      if (found.factor > (worst ? worst->factor : 0))
        worst = WorstGrip{found.grip, found.factor, box_.named_values(at)};
    }
    answer_.reason = obstacle_;
    if (!obstacle_.empty()) return;
    if (is_proved) {
      answer_.verdict = BoxVerdict::always;
      if (is_compared) answer_.worst = std::move(worst);
    } else
      answer_.reason = "at a corner the law of pads has no rest in which every point presses, and "
                       "only those are known to be convex";
  }

  /// With the greatest friction. Of a weight between two jaws all depends on grip over mass: if
  /// that is too little for the most grip and the least mass, it is for all.
  void decide_never() {
    constexpr std::array<const char*, 0> nothing{};
    constexpr std::array weight = {"mass", "grip_force"};
    const bool is_weight = varies_in(weight) && file_.hand == Hand::parallel &&
                           file_.object.wrench.isZero(0) && !varies_in(nothing);
    if (!obstacle_.empty() || !(is_weight || varies_in(nothing))) return;
    std::vector<Rational> best;
    for (const BoxSide& side : box_.sides())
      best.push_back(side.key == "mass" ? side.low : side.high);
    const HoldStudy found = study(box_.scene_at(best));
    // What statics cannot hold no law holds; of pads' law it is not known to grow with friction.
    if (is_weight || !found.is_statics ? !(found.statics_factor > 1 + box_settings.holding)
                                       : found.held.value_or(true))
      return;
    answer_.verdict = BoxVerdict::never;
    answer_.corner.clear();
    answer_.corner_scene.clear();
  }

  bool holds(double margin) const {
    for (Box::Corner c = 0; c < box_.corners(); ++c)
      if (is_wanted(c) && !has_forces(box_.scene_at(box_.corner(c, Rational(margin)))))
        return false;
    return true;
  }

  void find_margin() {
    answer_.is_indifferent = std::find(counts_.begin(), counts_.end(), true) == counts_.end() &&
                             answer_.verdict == BoxVerdict::always;
    if (!box_.is_scaled(counts_)) return;
    answer_.margin = widest_margin([this](double e) { return holds(e); }, true);
  }

  const Box box_;
  const SceneFile file_;
  std::vector<bool> counts_; ///< of the sides: does holding depend on it?
  std::string obstacle_;
  BoxAnswer answer_;
};

} // namespace

BoxAnswer judge_hold(const VariedScene& scene) { return HoldJudge(scene).judge(); }

} // namespace lcpush::desktop
