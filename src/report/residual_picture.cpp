// How well each law holds, on a logarithmic scale.
#include <algorithm>
#include <cmath>

#include "lcpush/lcp/tolerances.hpp"
#include "report/pictures.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {

std::vector<LawRow> law_rows(Residuals<double> r) {
  return {{"Newton", "T.1", r.newton},
          {"normal", "T.2", r.normal},
          {"dissipation", "T.3", r.dissipation},
          {"friction cone", "T.4", r.cone},
          {"grip force", "T.5", r.grip},
          {"patch rigidity", "T.6", r.rigidity},
          {"pusher moves as told", "T.2", r.pusher}};
}

Drawing residual_picture(const Residuals<double>& residuals) {
  constexpr double left = 166, right = 404, top = 30, row_height = 24;
  constexpr double lowest = -18, highest = -6; // powers of ten
  const auto at = [&](double x) {
    const double power = x > 0 ? std::log10(x) : lowest;
    return left +
           (std::clamp(power, lowest, highest) - lowest) / (highest - lowest) * (right - left);
  };
  const double tolerance = Tolerances<double>().residual;
  const std::vector<LawRow> rows = law_rows(residuals);
  const double bottom = top + row_height * static_cast<double>(rows.size());
  Drawing drawing{"residuals", "The largest scaled residual of each law", "", 420, bottom + 44, ""};
  drawing.description =
      "Bars on a logarithmic scale; the tolerance is " + residual_text(tolerance) + ".";
  for (double power = lowest; power <= highest; power += 3) {
    const double x = at(std::pow(10, power));
    drawing.elements += line_element("grid", {x, top - 4}, {x, bottom}) +
                        text_element("quiet", {x, bottom + 16}, "1e" + number(power), "middle");
  }
  double y = top;
  for (const LawRow& row : rows) {
    const bool holds = row.residual <= tolerance;
    const double end = std::isnan(row.residual) ? right : at(row.residual);
    drawing.elements += text_element("", {left - 8, y + 15}, row.name, "end");
    if (end > left)
      drawing.elements +=
          polygon_element(holds ? "bar" : "bar broken",
                          {{left, y + 4}, {end, y + 4}, {end, y + 18}, {left, y + 18}});
    else
      drawing.elements += text_element("quiet", {left + 4, y + 15}, "0");
    drawing.description +=
        " " + row.name + " " + residual_text(row.residual) + (holds ? "." : ", which is too much.");
    y += row_height;
  }
  const double limit = at(tolerance);
  drawing.elements += line_element("limit", {limit, top - 8}, {limit, bottom});
  drawing.elements +=
      text_element("", {limit, top - 13}, "tolerance " + residual_text(tolerance), "middle");
  return drawing;
}

} // namespace lcpush::desktop
