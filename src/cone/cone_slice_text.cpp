// A cut through a motion cone in words, as JSON and as a picture.
#include "cone/settings.hpp"
#include "draw/plot_svg.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/cone.hpp"
#include "lcpush/desktop/naming.hpp"
#include "scenes/parameter_words.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

const char* range_words(const ConeSlice::Range& range) {
  if (range.status != Status::solved) return "no breaking force";
  if (!range.breaks) return "object stays";
  return range.sticks ? "sticks" : "slips";
}

bool is_sliver(const ConeSlice& slice, const ConeSlice::Range& range) {
  return !slice.is_exact &&
         std::abs(range.to - range.from) <
             cone_settings.sliver * std::abs(slice.variation.to - slice.variation.from);
}

std::string slice_sentence(const SceneFile& file, const ConeSlice& slice) {
  const std::string& path = slice.variation.parameter.path;
  std::vector<std::pair<double, double>> pieces;
  bool goes_on = false, at_given = false;
  const double given = slice.variation.parameter.value;
  for (const ConeSlice::Range& range : slice.ranges) {
    if (is_sliver(slice, range)) {
      const double width = std::abs(range.to - range.from);
      at_given = at_given || (range.sticks && std::abs(given - range.from) <= 2 * width);
      continue;
    }
    if (range.sticks && goes_on)
      pieces.back().second = range.to;
    else if (range.sticks)
      pieces.emplace_back(range.from, range.to);
    goes_on = range.sticks;
  }
  std::vector<std::string> sticking;
  for (const auto& [from, to] : pieces) sticking.push_back(brief(from) + " to " + brief(to));
  const std::string unit = slice.variation.parameter.unit;
  return file.body_name(slice.pusher) +
         (sticking.empty() && at_given ? " sticks for " + path + " of " + brief(given) + " alone"
          : sticking.empty()           ? " sticks nowhere"
                                       : " sticks for " + path + " of " + listed(sticking, "and") +
                                   (unit.empty() ? "" : " " + unit)) +
         ".";
}

} // namespace

/// "4 points of left and edge", of few their names.
static std::string changing_words(const SceneFile& file, const std::vector<Index>& points) {
  std::vector<std::string> names, bodies;
  for (const Index i : points) {
    names.push_back(point_name(file, i));
    const std::string& body = file.body_name(file.body_of(i));
    if (bodies.empty() || bodies.back() != body) bodies.push_back(body);
  }
  return names.size() > 3 ? std::to_string(names.size()) + " points of " + listed(bodies, "and")
                          : joined(names, " ");
}

std::string slice_text(const SceneFile& file, const ConeSlice& slice) {
  std::string text = title_line(file) + slice_sentence(file, slice) + "\n\n";
  TableRows rows{{"from", "to", "there", "push N", "to N", "then changes"}};
  for (const ConeSlice::Range& range : slice.ranges) {
    const bool is_solved = range.status == Status::solved && range.breaks;
    const auto push = [&](const ConeSlice::End& end) {
      return is_solved ? in_digits(end.wrench.head<3>().norm(), 4) : std::string("-");
    };
    rows.push_back({number(range.from), number(range.to),
                    is_sliver(slice, range) ? "noise" : range_words(range), push(range.at_from),
                    push(range.at_to), changing_words(file, range.changing)});
  }
  return text + table_text(rows) + "\n" +
         facts_text({{"Ends", slice.is_exact ? "exact, by parametric pivots"
                                             : "by bisection, as finely as the answers settle"}});
}

std::string slice_json(const SceneFile& file, const ConeSlice& slice) {
  JsonWriter json;
  json.begin_object()
      .member("pusher", file.body_name(slice.pusher))
      .member("vary", slice.variation.parameter.path)
      .member("exact", slice.is_exact)
      .member("stopped", unless_empty(std::string(stop_text(slice.stop))));
  json.objects("ranges", slice.ranges, [&](const ConeSlice::Range& range) {
    json.member("from", range.from)
        .member("to", range.to)
        .member("status", status_text(range.status))
        .member("breaks", when(range.status == Status::solved, range.breaks))
        .member("sticks", when(range.status == Status::solved, range.sticks));
    const auto end = [&](const char* key, const ConeSlice::End& there) {
      json.key(key).begin_object();
      json.member("twist", there.twist).member("wrench", there.wrench).end_object();
    };
    if (range.status == Status::solved) {
      end("at_from", range.at_from);
      end("at_to", range.at_to);
    } else {
      json.member("at_from", nullptr).member("at_to", nullptr);
    }
    json.list("changing", range.changing, [&](Index i) { json.value(point_name(file, i)); });
  });
  write_warnings(json, check_scene(file));
  return json.end_object().text();
}

std::string slice_svg(const SceneFile& file, const ConeSlice& slice) {
  const Parameter& parameter = slice.variation.parameter;
  Plot plot;
  plot.title = file.title.empty() ? "A cut through the motion cone" : file.title;
  plot.description = slice_sentence(file, slice);
  plot.x_label = parameter_label(parameter);
  plot.x_from = slice.variation.from;
  plot.x_to = slice.variation.to;
  PlotLine sticks, slips;
  sticks.label = file.body_name(slice.pusher) + " sticks";
  slips.label = "it slips";
  slips.colour = 1;
  std::size_t next = 0;
  for (const ConeSlice::Range& range : slice.ranges) {
    std::vector<std::pair<double, double>> piece;
    const double up = range.to > range.from ? 1 : -1;
    for (; next < slice.forces.size() && up * (range.to - slice.forces[next].first) >= 0; ++next) {
      piece.push_back(slice.forces[next]);
      // The other side of this end begins with the same value.
      if (piece.size() > 1 && slice.forces[next].first == range.to) {
        ++next;
        break;
      }
    }
    if (range.status == Status::solved && range.breaks)
      (range.sticks ? sticks : slips).pieces.push_back(std::move(piece));
  }
  PlotPanel panel;
  panel.y_label = "push that breaks the grasp, N";
  for (PlotLine* line : {&sticks, &slips})
    if (!line->pieces.empty()) panel.lines.push_back(std::move(*line));
  plot.panels.push_back(std::move(panel));
  return plot_svg(plot);
}

} // namespace lcpush::desktop
