// The forces and moments that are held beside the load, plane by plane.
#include "draw/markup.hpp"
#include "lcpush/desktop/hold.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

// In the picture's own units.
constexpr double panel = 240, radius = 78, top = 84, label_gap = 14, line = 14;
constexpr double clip = 1.15; // of the largest that is drawn: what is unlimited goes on beyond
constexpr const char* axis_names[] = {"x", "y", "z"};

/// What a section is drawn in: its largest reach, but no more than a few times its least.
double scale_of(const HoldSection& section) {
  constexpr double most_over_least = 6;
  double least = no_limit, most = 0;
  for (const double reach : section.reach) {
    if (reach > 0) least = std::min(least, reach);
    if (std::isfinite(reach)) most = std::max(most, reach);
  }
  return std::isfinite(least) ? std::min(most, most_over_least * least) : 0;
}

class SectionPainter {
public:
  explicit SectionPainter(const HoldSection& section)
      : section_(section), scale_(scale_of(section)) {}

  std::string elements() const {
    const char* const unit = section_.kind == Disturbance::force ? "N" : "N m";
    const std::string name = section_.kind == Disturbance::force ? "Force, " : "Moment, ";
    std::string text =
        text_element("strong", {line, top - 2 * line},
                     name + axis_names[section_.along] + " and " + axis_names[section_.across]);
    for (const bool across : {false, true}) {
      const Pixel tip = across ? Pixel(0, -1) : Pixel(1, 0);
      text +=
          arrow_element("axis", center() - radius * clip * tip, center() + radius * clip * tip) +
          text_element("quiet label", center() + (radius * clip + label_gap) * tip,
                       axis_names[across ? section_.across : section_.along], "middle");
    }
    if (!(scale_ > 0))
      return text + text_element("quiet", {line, 2 * top + panel / 2}, "Nothing is held, or all");
    std::vector<Pixel> corners;
    for (std::size_t k = 0; k < section_.reach.size(); ++k) corners.push_back(place(k));
    text += polygon_element("cone", corners) + circle_element("mark", center(), 4);
    const auto least = static_cast<std::size_t>(
        std::min_element(section_.reach.begin(), section_.reach.end()) - section_.reach.begin());
    const Pixel weakest = place(least);
    return text + line_element("limit", center(), weakest) +
           circle_element("mark slide", weakest, 5) +
           text_element("label", {panel / 2, top + 2 * radius * clip + 3 * line},
                        "least " + brief(section_.reach[least]) + " " + unit, "middle");
  }

private:
  const HoldSection& section_;
  double scale_;

  static Pixel center() { return {panel / 2, top + clip * radius + line}; }
  Pixel place(std::size_t k) const {
    const auto at = static_cast<Index>(k), steps = static_cast<Index>(section_.reach.size());
    const double reach = std::isnan(section_.reach[k]) ? 0 : section_.reach[k] / scale_;
    return center() + radius * std::min(reach, clip) *
                          Pixel(circle_cosine<double>(at, steps), -circle_sine<double>(at, steps));
  }
};

} // namespace

std::string hold_svg(const SceneFile& file, const HoldStudy& study) {
  const double height = top + 2 * clip * radius + 4 * line, bottom = 2 * height + 2 * line;
  Drawing drawing{"hold",
                  file.title.empty() ? "Held forces and moments" : file.title,
                  hold_answer(file, study) +
                      " Shaded: what is held beside the load, a force at one point above, a moment "
                      "below, in the planes of the scene's axes.",
                  3 * panel,
                  bottom,
                  ""};
  drawing.elements = text_element("strong", {line, 2 * line}, shortened(drawing.title, 80));
  for (std::size_t k = 0; k < study.sections.size(); ++k)
    drawing.elements += shifted(SectionPainter(study.sections[k]).elements(),
                                {panel * static_cast<double>(k % 3), k < 3 ? 0 : height});
  drawing.elements += text_element(
      "quiet", {line, bottom - line},
      study.sections.empty() ? "Not held: there is nothing to show."
                             : "Shaded: held beside the load, which is the dot. Stroke: the least "
                               "of the plane.");
  return svg_document(drawing);
}

} // namespace lcpush::desktop
