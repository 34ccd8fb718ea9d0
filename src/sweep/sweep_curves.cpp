// What several sweeps that are shown together are called, and how many are too many.
#include "lcpush/desktop/sweep.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "scenes/parameter_words.hpp"
#include "sweep/sweep_words.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

bool is_among(const Parameter::Place& a, const std::vector<Parameter::Place>& places) {
  return std::any_of(places.begin(), places.end(), [&](const Parameter::Place& b) {
    return a.section == b.section && a.table == b.table && a.key == b.key && a.indices == b.indices;
  });
}

/// Values are given one after the other: those of `later` stand in all places of `earlier`.
bool is_overwritten(const Parameter& earlier, const Parameter& later) {
  return earlier.kind == later.kind && earlier.axis == later.axis &&
         std::all_of(earlier.places.begin(), earlier.places.end(),
                     [&](const Parameter::Place& place) { return is_among(place, later.places); });
}

} // namespace

void refuse_overwritten(const std::vector<SweepCurve>& curves) {
  for (const SweepCurve& curve : curves) {
    std::vector<Parameter> varied;
    if (curve.each) varied.push_back(curve.each->parameter);
    for (const Variation& variation : curve.sweep.variations) varied.push_back(variation.parameter);
    for (std::size_t later = 1; later < varied.size(); ++later)
      for (std::size_t earlier = 0; earlier < later; ++earlier)
        if (is_overwritten(varied[earlier], varied[later]))
          throw InputError(varied[earlier].path + " would change nothing: " + varied[later].path +
                           " is given its values after it");
  }
}

SweepCurve curve_at(const Variation& each, const std::string& scene, const std::string& mine) {
  const Parameter& parameter = each.parameter;
  const std::string label = parameter.path + " = " + shown(each.from) +
                            (parameter.unit.empty() ? "" : " " + parameter.unit);
  return {mine.empty() ? label : mine + ", " + label, scene, each, {}};
}

std::vector<SceneDoubt> doubts_at_ends(const VariedScene& scene, const Sweep& sweep) {
  const auto is_of_place = [](const SceneDoubt& found) {
    return found.doubt == Doubt::overhang || found.doubt == Doubt::outside_object ||
           found.doubt == Doubt::far_from_object;
  };
  std::vector<SceneDoubt> list;
  const std::vector<SceneDoubt> given = check_scene(scene.as_given());
  if (std::any_of(given.begin(), given.end(), is_of_place)) return list;
  const Sweep typed = in_typed_units(sweep);
  for (std::size_t k = 0; k < typed.variations.size(); ++k)
    for (double Variation::*const end : {&Variation::from, &Variation::to})
      for (SceneDoubt found :
           check_scene(scene.at({sweep.variations[k].parameter}, {sweep.variations[k].*end}))) {
        found.text = "at " + typed.variations[k].parameter.path + " = " +
                     with_unit(typed.variations[k], typed.variations[k].*end) + ", " + found.text;
        if (is_of_place(found)) list.push_back(std::move(found));
      }
  return list;
}

std::string sweep_title(const std::vector<SweepCurve>& curves) {
  const Sweep& sweep = curves.front().sweep;
  std::string over = parameter_words(sweep.variations[0].parameter);
  if (sweep.is_map()) over += " and " + parameter_words(sweep.variations[1].parameter);
  const bool same = std::all_of(curves.begin(), curves.end(), [&](const SweepCurve& curve) {
    return curve.scene == curves.front().scene;
  });
  return (same ? curves.front().scene + ": push" : "Push") + " by " + sweep.pusher + " over " +
         over;
}

std::string too_many_samples(double samples, const SceneFile& file) {
  const auto points = static_cast<double>(file.view().points.size);
  const double most = std::floor(limits::memory /
                                 (limits::bytes_a_sample + limits::bytes_a_sampled_point * points));
  if (samples <= most) return {};
  return printed("%.0f", samples) + " samples of this scene are more than the " +
         printed("%.0f", most) + " that fit into 1 GB";
}

} // namespace lcpush::desktop
