// What several sweeps that are shown together are called, and how many are too many.
#include "lcpush/desktop/sweep.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

SweepCurve curve_at(const Variation& each, const std::string& scene, const std::string& mine) {
  const Parameter& parameter = each.parameter;
  const std::string label = parameter.path + " = " + shown(each.from) +
                            (parameter.unit.empty() ? "" : " " + parameter.unit);
  return {mine.empty() ? label : mine + ", " + label, scene, each, {}};
}

std::string sweep_title(const std::vector<SweepCurve>& curves) {
  const Sweep& sweep = curves.front().sweep;
  std::string over = sweep.variations[0].parameter.path;
  if (sweep.is_map()) over += " and " + sweep.variations[1].parameter.path;
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
