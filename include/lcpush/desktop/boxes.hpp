// What holds for every value in a box: numbers of a scene that are only known to lie in ranges
// (docs/theory/theory.md, [T.20]).
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "lcpush/desktop/varied_scene.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lcpush::desktop {

class JsonWriter;

enum class BoxVerdict {
  always,   ///< for every value in the box
  may_slip, ///< not at the corner that is given
  never,    ///< for no value in the box
  not_known,
};

/// As JSON spells it.
constexpr const char* box_verdict_text(BoxVerdict verdict) {
  constexpr const char* texts[] = {"always", "may_slip", "never", "not_known"};
  return texts[static_cast<int>(verdict)];
}

struct BoxRange {
  std::string path;
  double low, high;
  bool counts = true; ///< can the answer depend on it?
};

/// Where in a box the least grip that holds is the largest part of the grip.
struct WorstGrip {
  GripReport grip; ///< there
  double factor;   ///< the part
  std::vector<std::pair<std::string, double>> at;
};

struct BoxAnswer {
  BoxVerdict verdict = BoxVerdict::not_known;
  /// A clause: what happens at the corner, or why it is not known.
  std::string reason;
  /// The largest relative tolerance of all numbers of the box but places, which keep their ranges,
  /// for which the verdict is `always`; 0: none; no value: not known, or there is no largest one.
  std::optional<double> margin;
  bool is_indifferent = false; ///< there is no largest one: it does not depend on these numbers
  std::vector<BoxRange> box;
  std::vector<std::pair<std::string, double>> corner; ///< of may_slip
  std::optional<WorstGrip> worst; ///< of always, of grasps: of the corners; none: not known
  std::string corner_scene;       ///< the same as a scene file
};

/// The scene with what is only known to a tolerance in a range: "*.friction=10%" of what stands in
/// the file, "edge.friction=0.3:0.5", or "*.friction", whose margin alone is asked. Throws
/// InputError.
VariedScene with_tolerances(VariedScene scene, const std::vector<std::string>& tolerances);

/// Does the only pusher stick in this motion (none: the scene's own; see find_cone) for every value
/// of the scene's ranges? Throws InputError as find_cone does. Cost: 2^numbers.
BoxAnswer judge_push(const VariedScene& scene,
                     const std::optional<Vector6<double>>& twist = std::nullopt);
/// The proof of `always` of judge_push, as JSON: of the scene file's text. `obstacle`: why there is
/// none, a clause.
struct BoxCertificate {
  std::string json, obstacle;
};
BoxCertificate certify_box(const std::string& text, const VariedScene& scene,
                           const std::optional<Vector6<double>>& twist = std::nullopt);
/// Does the grasp hold before any push, for every value of the scene's ranges?
BoxAnswer judge_hold(const VariedScene& scene);

/// Are the contact modes of the scene's push certain: does its only pusher stick, or, where there
/// is none, the grasp hold, for every value? Of other pushes nothing is proved: not_known.
BoxAnswer judge_modes(const VariedScene& scene);

/// The answer before anything is known.
BoxAnswer unknown_box(const VariedScene& scene);

/// The scenes at the corners of its ranges, pushers with their least friction: a push that presses
/// sticks with more as well. With `margin`: of ranges so wide instead. Throws InputError for more
/// corners than a plan can look at.
std::vector<SceneFile> corner_scenes(const VariedScene& scene,
                                     const std::optional<double>& margin = std::nullopt);

/// The largest margin that holds, as those below it do, a little below; 0: none does.
double widest_margin(const std::function<bool(double margin)>& holds, bool is_quick = false);

/// verdict, margin, corner, box: members of an object.
void write_box(JsonWriter& json, const BoxAnswer& answer);
/// "; it would still if all of these numbers were 25.7 % off", or nothing.
std::string margin_words(const BoxAnswer& answer);
/// "This push", "sticks", "may slip"; and where it slips, "at the corner below".
std::string box_sentence(const BoxAnswer& answer, const std::string& subject,
                         const std::string& does, const std::string& fails,
                         const std::string& where);
/// Of judge_modes.
std::string modes_sentence(const SceneFile& file, const BoxAnswer& answer);
/// "at wall.friction = 0.1 and object.mass = 0.22".
std::string corner_words(const BoxAnswer& answer);
/// The sentence, and the numbers as a table.
std::string box_text(const SceneFile& middle, const BoxAnswer& answer, const std::string& subject,
                     const std::string& does, const std::string& fails);

} // namespace lcpush::desktop
