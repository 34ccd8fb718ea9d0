// Several curves in one table.
#include <algorithm>
#include <cmath>

#include "sweep/settings.hpp"
#include "sweep/sweep_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// On the straight line of its segment, or at its step; nothing where neither is known.
std::optional<double> force_at(const Sweep& sweep, double value, Question question) {
  const auto is_here = [&](double from, double to) { return (value - from) * (value - to) <= 0; };
  for (const SweepSegment& segment : sweep.segments) {
    if (!is_here(segment.from, segment.to)) continue;
    if (!segment.at_from[question].has_force()) return std::nullopt;
    const double share = (value - segment.from) / (segment.to - segment.from);
    SweepValue here = segment.at_from;
    here.breaking.normal += share * (segment.at_to.breaking.normal - here.breaking.normal);
    here.push.force += share * (segment.at_to.push.force - here.push.force);
    return force_of(here, question);
  }
  const SweepPoint* nearest = nullptr;
  for (const SweepPoint& point : sweep.points)
    if (nearest == nullptr || std::abs(point.value - value) < std::abs(nearest->value - value))
      nearest = &point;
  const bool is_known = nearest != nullptr &&
                        are_one_place(sweep.variations[0], nearest->value, value) &&
                        nearest->at[question].has_force();
  return is_known ? std::optional(force_of(nearest->at, question)) : std::nullopt;
}

/// Evenly over the range: of samples those steps that come closest to it.
std::vector<double> shown_values(const Sweep& sweep) {
  std::vector<double> steps;
  for (const SweepPoint& point : sweep.points)
    if (!point.refined) steps.push_back(point.value);
  const Variation& variation = sweep.variations[0];
  if (steps.empty())
    for (Index k = 0; k < SweepSettings::rows_of_curves; ++k)
      steps.push_back(variation.from + (variation.to - variation.from) * static_cast<double>(k) /
                                           static_cast<double>(SweepSettings::rows_of_curves - 1));
  std::vector<double> values;
  for (const std::size_t k :
       evenly(steps.size(), static_cast<std::size_t>(SweepSettings::rows_of_curves)))
    values.push_back(steps[k]);
  return values;
}

} // namespace

std::string curves_table(const std::vector<SweepCurve>& curves) {
  const Sweep& first = curves.front().sweep;
  const Variation& variation = first.variations[0];
  bool all_break = true;
  double largest = 0;
  for (const SweepCurve& curve : curves)
    all_break = all_break && asked(curve.sweep) == Question::breaking;
  const Question question = all_break ? Question::breaking : Question::push;
  for (const SweepCurve& curve : curves)
    for_each_value(curve.sweep, [&](const SweepValue& at) {
      if (at[question].has_force()) largest = std::max(largest, std::abs(force_of(at, question)));
    });
  const std::vector<double> values = shown_values(first);
  bool is_numbered = false;
  const std::string table = fitted_table(3, [&](int digits, bool is_long) {
    is_numbered = !is_long;
    std::vector<std::vector<std::string>> rows{{is_long ? variation.parameter.path : ""}};
    for (std::size_t k = 0; k < curves.size(); ++k)
      rows[0].push_back(is_long ? curves[k].label : std::to_string(k + 1));
    for (const double value : values) {
      rows.push_back({value_text(variation, value)});
      for (const SweepCurve& curve : curves) {
        const auto force = force_at(curve.sweep, value, question);
        rows.back().push_back(force ? in_digits(told_force(*force, largest), digits) : "-");
      }
    }
    return rows;
  });
  std::string head = all_break ? "The breaking forces in N" : "The pushes in N";
  if (!variation.parameter.unit.empty())
    head += ", over " + variation.parameter.path + " in " + variation.parameter.unit;
  return head + (is_numbered ? ", the curves in the order above" : "") + ":\n\n" + table;
}

} // namespace lcpush::desktop
