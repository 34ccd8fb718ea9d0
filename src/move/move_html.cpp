// One page that plays a motion: every moment is drawn here, the page shows one of them.
#include "lcpush/desktop/move.hpp"

#include "draw/page_style.hpp"
#include "draw/plot_parts.hpp"
#include "draw/plot_svg.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/version.hpp"
#include "move/motion_painter.hpp"
#include "move/move_script.hpp"
#include "move/move_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr std::size_t most_moments = 151, most_marks = 8;
constexpr double least_between = 0.03; // of the time: marks nearer than that are one

std::string moments(const MotionPainter& painter, const MotionReport& report,
                    const std::vector<std::size_t>& shown) {
  std::string text;
  for (const std::size_t k : shown)
    text += std::string("<g class=\"moment") + (k == shown.back() ? " shown" : "") + "\">\n" +
            painter.moment(report.frames[k]) + "</g>\n";
  return text;
}

std::string frames_json(const SceneFile& file, const MotionReport& report,
                        const std::vector<std::size_t>& shown) {
  constexpr const char* verbs[] = {
      "stick",           "slip",    "are open", "are beside their face", "are behind an edge",
      "stand on an end", "are away"};
  const double last = report.frames.back().time;
  JsonWriter json;
  json.begin_array();
  for (const std::size_t k : shown) {
    const MotionFrame& frame = report.frames[k];
    std::vector<std::string> cells;
    for (std::size_t b = 0; b < file.bodies.size(); ++b) {
      const std::vector<BodyForce>& forces = forces_beside(report, k);
      const BodyForce body = forces.empty() ? BodyForce{} : forces[b];
      const double square = body.force.squaredNorm() - body.normal_force * body.normal_force;
      cells.push_back(forces.empty() ? "-" : brief(body.normal_force));
      cells.push_back(forces.empty() ? "-" : brief(std::sqrt(std::max(square, 0.0))));
      cells.push_back(k == 0 ? "-" : listed(touch_words(file, frame, b, verbs, true), "and"));
    }
    const double share = last > 0 ? frame.time / last : 0;
    json.begin_object()
        .member("clock", printed("%.3f s", frame.time))
        .member("place", pose_words(file, frame))
        .member("left",
                100 * (plot::left + share * (plot::width - plot::left - plot::right)) / plot::width)
        .member("cells", cells)
        .end_object();
  }
  std::string text = json.end_array().text();
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c"); // no name ends the script
  return text;
}

std::string force_plot(const SceneFile& file, const MotionReport& report) {
  if (report.frames.size() < 3) return "";
  Plot plot;
  plot.title = "Force of the pushers on the object";
  plot.x_label = "time, s";
  plot.x_to = report.frames.back().time;
  PlotLine line{"push force", {{}}};
  for (std::size_t k = 1; k < report.frames.size(); ++k)
    line.pieces[0].emplace_back(report.frames[k].time,
                                push_force(file, report.frames[k].bodies).norm());
  plot.panels.push_back({"N", {line}});
  for (const EventLine& event : event_lines(file, report)) {
    const bool is_near =
        !plot.marks.empty() && event.time - plot.marks.back().x < least_between * plot.x_to;
    if (!is_near && plot.marks.size() == most_marks) break;
    if (is_near)
      plot.marks.back().text += ", " + event.words;
    else
      plot.marks.push_back({event.time, brief(event.time) + " s", event.words});
  }
  plot.description = "The force against time.";
  // Margins and paddings in per cent are of the width, whatever the height.
  const auto [top, bottom] = first_axes(plot);
  const std::string place = "margin-top:" + printed("%.3f", 100 * top) +
                            "%;padding-bottom:" + printed("%.3f", 100 * (bottom - top)) + "%";
  return "<h2 id=\"push\">Push force against time</h2>\n<div class=\"over\">" +
         plot_image(plot_svg(plot), "The pushers' force on the object against time.") +
         "<span class=\"cursor\" id=\"cursor\" style=\"" + place +
         "\" aria-hidden=\"true\"></span></div>\n";
}

std::string now_table(const SceneFile& file) {
  std::string text =
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Forces and contacts "
      "now\">\n<table id=\"now\">\n<thead><tr><th scope=\"col\">body</th><th scope=\"col\">normal "
      "N</th><th scope=\"col\">friction N</th><th scope=\"col\">its points</th></tr></thead>\n"
      "<tbody>\n";
  for (const std::string& name : file.body_names)
    text += "<tr><th scope=\"row\">" + escaped(name) + "</th><td></td><td></td><td></td></tr>\n";
  return text + "</tbody>\n</table>\n</div>\n";
}

std::string controls(std::size_t count) {
  return "<div class=\"player\" id=\"controls\" hidden=\"hidden\">\n<button type=\"button\" "
         "id=\"play\">Play</button>\n<input type=\"range\" id=\"time\" min=\"0\" max=\"" +
         std::to_string(count - 1) + "\" value=\"" + std::to_string(count - 1) +
         "\" aria-label=\"Time\"/>\n<output id=\"clock\" for=\"time\"></output>\n</div>\n"
         "<p class=\"aside\"><span id=\"place\"></span></p>\n"
         "<p class=\"aside\">Space plays, the arrow keys step. Squares stick, triangles slip, "
         "rings are open; solid arrows press, dashed ones are friction; the line is the way of "
         "the centre of mass.</p>\n";
}

std::string events_list(const SceneFile& file, const MotionReport& report) {
  constexpr std::size_t most = 60;
  const std::vector<EventLine> events = event_lines(file, report);
  if (events.empty()) return "";
  std::string text = "<h2>Events</h2>\n<ul>\n";
  for (std::size_t k = 0; k < std::min(events.size(), most); ++k)
    text += "<li>" + escaped(brief(events[k].time) + " s: " + events[k].words) + "</li>\n";
  if (events.size() > most) text += "<li>" + std::to_string(events.size() - most) + " more</li>\n";
  return text + "</ul>\n";
}

} // namespace

std::string move_html(const SceneFile& file, const MotionReport& report) {
  const MotionPainter painter(file, report);
  const std::vector<std::size_t> shown = spread_out(report.frames.size(), most_moments);
  const std::string title = escaped(file.title.empty() ? "A motion without a title" : file.title);
  const std::string sentence = move_sentence(file, report);
  const Drawing drawing{"move",
                        "The object on its way",
                        sentence + " Seen in " + painter.axes() + ".",
                        MotionPainter::width,
                        MotionPainter::height,
                        painter.surroundings() + painter.ghosts({0}) +
                            moments(painter, report, shown) + painter.path()};
  std::string checks;
  for (const SceneDoubt& doubt : motion_doubts(file, report))
    if (doubt.doubt == Doubt::unknown_shape)
      checks += "<p class=\"aside\">Check: " + escaped(doubt_text(doubt)) + "</p>\n";
  return page_head(title, player_style, "; script-src 'unsafe-inline'") + "<p class=\"lead\">" +
         escaped(sentence) + "</p>\n" + checks + "<div class=\"stage\">\n" + svg_element(drawing) +
         controls(shown.size()) + now_table(file) + "</div>\n" + force_plot(file, report) +
         events_list(file, report) +
         "</main>\n<footer>\n<p>SI units, the scene's axes, the gripper's frame. " +
         escaped(step_words(report, true)) + ". Written by lcpush " + version_text +
         ".</p>\n</footer>\n<script type=\"application/json\" id=\"frames\">" +
         frames_json(file, report, shown) + "</script>\n<script>" + player_script +
         "</script>\n</body>\n</html>\n";
}

} // namespace lcpush::desktop
