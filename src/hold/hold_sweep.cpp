// The least grip along a number of the scene.
#include "draw/plot_svg.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/hold.hpp"
#include "lcpush/desktop/varied_scene.hpp"
#include "scenes/parameter_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

double least_force(const HoldStudy& study) {
  return study.factor < no_limit ? study.factor * study.grip.force : unknown_number;
}

const char* verdict(const HoldStudy& study) {
  return !study.held ? "may fall" : *study.held ? "is held" : "falls";
}

/// Where the verdict changes: between two samples, in words.
std::string change_sentence(const HoldSweep& sweep) {
  if (sweep.studies.empty()) return "It was stopped before anything was known.";
  const std::string path = sweep.variation.parameter.path, unit = sweep.variation.parameter.unit;
  std::string text = "As " + path + " goes from " + brief(sweep.values.front()) + " to " +
                     brief(sweep.values.back()) + (unit.empty() ? "" : " " + unit) +
                     ", the object " + verdict(sweep.studies.front());
  for (std::size_t k = 1; k < sweep.studies.size(); ++k)
    if (sweep.studies[k].held != sweep.studies[k - 1].held)
      text += std::string(", then ") + verdict(sweep.studies[k]) + " from between " +
              brief(sweep.values[k - 1]) + " and " + brief(sweep.values[k]) + " on";
  return text + ".";
}

} // namespace

HoldSweep sweep_hold(const VariedScene& scene, const Variation& variation, bool presses,
                     Index steps, const StopCheck& stop) {
  HoldSweep sweep{variation, {}, {}};
  HoldQuestion question;
  question.grip_alone = true;
  question.presses = presses;
  for (Index k = 0; k < steps; ++k) {
    if (stop && (sweep.stop = stop(1)) != Stop::none) break;
    const double share = static_cast<double>(k) / static_cast<double>(steps - 1);
    const double value = variation.from + share * (variation.to - variation.from);
    sweep.studies.push_back(find_hold(scene.at({variation.parameter}, {value}), question));
    sweep.values.push_back(value);
  }
  return sweep;
}

std::string hold_sweep_text(const HoldSweep& sweep) {
  constexpr std::size_t most_rows = 11;
  const std::size_t count = sweep.values.size(), rows_shown = std::min(count, most_rows);
  TableRows rows{{parameter_label(sweep.variation.parameter), "", "least grip N", "margin"}};
  for (std::size_t row = 0; row < rows_shown; ++row) {
    const std::size_t k = rows_shown > 1 ? row * (count - 1) / (rows_shown - 1) : 0;
    const HoldStudy& study = sweep.studies[k];
    const double force = least_force(study), margin = study.margin();
    rows.push_back({brief(sweep.values[k]), verdict(study), std::isnan(force) ? "-" : brief(force),
                    std::isnan(margin) ? "-" : brief(margin)});
  }
  return change_sentence(sweep) + "\n\n" + table_text(rows, 2);
}

std::string hold_sweep_csv(const HoldSweep& sweep) {
  std::string text = sweep.variation.parameter.path + ",held,least_grip,factor,margin\n";
  const auto cell = [](double value) { return std::isfinite(value) ? shown(value) : ""; };
  for (std::size_t k = 0; k < sweep.values.size(); ++k) {
    const HoldStudy& study = sweep.studies[k];
    text += shown(sweep.values[k]) + "," + (study.held ? *study.held ? "true" : "false" : "") +
            "," + cell(least_force(study)) + "," + cell(study.factor) + "," + cell(study.margin()) +
            "\n";
  }
  return text;
}

std::string hold_sweep_json(const HoldSweep& sweep) {
  JsonWriter json;
  json.begin_object()
      .member("parameter", sweep.variation.parameter.path)
      .member("unit", sweep.variation.parameter.unit)
      .member("stopped", sweep.stop != Stop::none);
  json.objects("points", sweep.values, [&](const double& value) {
    const HoldStudy& study = sweep.studies[static_cast<std::size_t>(&value - sweep.values.data())];
    json.member("value", value).member("held", study.held).member("least_grip", least_force(study));
    json.member("factor", study.factor).member("margin", study.margin());
  });
  return json.end_object().text();
}

std::string hold_sweep_svg(const HoldSweep& sweep) {
  const std::string what = sweep.of_margin ? "margin of the grip" : "least grip, N";
  PlotLine line{what, {{}}};
  for (std::size_t k = 0; k < sweep.values.size(); ++k) {
    const HoldStudy& study = sweep.studies[k];
    const double y = sweep.of_margin ? study.margin() : least_force(study);
    if (!std::isfinite(y))
      line.pieces.emplace_back();
    else
      line.pieces.back().emplace_back(sweep.values[k], y);
  }
  Plot plot;
  plot.title = (sweep.of_margin ? "Margin over " : "Least grip over ") +
               parameter_words(sweep.variation.parameter);
  plot.description = change_sentence(sweep);
  plot.x_label = parameter_label(sweep.variation.parameter);
  plot.x_from = std::min(sweep.variation.from, sweep.variation.to);
  plot.x_to = std::max(sweep.variation.from, sweep.variation.to);
  plot.panels.push_back({what, {line}});
  return plot_svg(plot);
}

} // namespace lcpush::desktop
