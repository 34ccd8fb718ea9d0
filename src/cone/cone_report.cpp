// A motion cone in words, and as JSON.
#include "cone/cone_words.hpp"
#include "cone/settings.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/cone.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// "the box slips over wall along +y", "the box turns about wall.1".
std::string beyond_words(const SceneFile& file, const ConeReport& report) {
  const ConeReport::Verdict& verdict = *report.verdict;
  const std::string object = object_name(file) + " ";
  if (!report.is_single_place) return object + side_words(file, report.sides[verdict.nearest]);
  return object + "slips over " + file.body_name(report.pusher) + " along " +
         direction_text(report.edges[verdict.nearest].slips);
}

std::string grip_words(const SceneFile& file, double factor) {
  const GripReport grip = named_grip(file);
  return brief(factor * grip.force) + " N " + grip.of;
}

std::string verdict_fact(const SceneFile& file, const ConeReport& report) {
  const ConeReport::Verdict& verdict = *report.verdict;
  if (!verdict.grip)
    return "with no grip force does the pusher stick in this motion: what slips there does so "
           "however hard the fingers press";
  if (verdict.most_grip < report.holding_grip)
    return "this motion sticks with no grip force that holds " + object_name(file);
  const bool with_all = *verdict.grip <= report.holding_grip * (1 + cone_settings.noise);
  if (std::isfinite(verdict.most_grip))
    return "this motion sticks " +
           (with_all ? "up to " : "from " + grip_words(file, *verdict.grip) + " to ") +
           grip_words(file, verdict.most_grip);
  if (!verdict.sticks && !verdict.leaves && *verdict.grip < 1)
    return "this motion sticks with " + grip_words(file, *verdict.grip) +
           ", and not with the scene's";
  if (with_all)
    return report.holding_grip > 0
               ? "this motion sticks with every grip force that holds " + object_name(file)
               : "this motion sticks with every grip force";
  return "this motion sticks from " + grip_words(file, *verdict.grip) + " on";
}

/// In three digits, and nothing where rounding is all there is.
TableRows edge_rows(const SceneFile& file, const ConeReport& report, int digits) {
  TableRows rows{{"edge", "push N", "vx", "vy", "turn rad/m", "there presses"}};
  for (std::size_t k = 0; k < report.edges.size(); ++k) {
    const ConeReport::Edge& edge = report.edges[k];
    rows.push_back({std::to_string(k + 1), in_digits(edge.wrench.head<3>().norm(), digits),
                    in_digits(edge.twist[0], digits, cone_settings.noise),
                    in_digits(edge.twist[1], digits, cone_settings.noise),
                    in_digits(edge.twist[5], digits, cone_settings.noise / report.length),
                    edge_words(file, report, edge)});
  }
  return rows;
}

std::string sides_text(const SceneFile& file, const ConeReport& report) {
  std::string text;
  for (const ConeReport::Side& side : report.sides) {
    if (!text.empty()) text += "\n";
    text += std::to_string(side.from + 1) + " to " + std::to_string(side.to + 1) + ": " +
            (report.is_single_place ? "sticks between them"
                                    : object_name(file) + " " + side_words(file, side));
  }
  return text;
}

} // namespace

std::string edge_words(const SceneFile& file, const ConeReport& report,
                       const ConeReport::Edge& edge) {
  return (report.is_single_place ? file.body_name(report.pusher) : point_name(file, edge.point)) +
         ", to slip along " + direction_text(edge.slips);
}

std::string side_words(const SceneFile& file, const ConeReport::Side& side) {
  const std::string pusher = file.body_name(file.body_of(side.point));
  if (side.is_slip) return "slips over " + pusher + " along " + direction_text(side.slips);
  return "turns about " + point_name(file, side.point) + " and leaves the rest of " + pusher;
}

std::string cone_sentence(const SceneFile& file, const ConeReport& report) {
  const std::string pusher = file.body_name(report.pusher);
  if (report.status != Status::solved)
    return "The grasp does not hold " + object_name(file) +
           " before it is pushed, so there is no motion cone: it takes " +
           brief(report.holding_grip) + " times the grip force.";
  if (!report.verdict)
    return pusher + " takes " + object_name(file) + " along without slipping inside " +
           counted(static_cast<Index>(report.edges.size()), "edge") +
           "; it does not move in this scene.";
  const ConeReport::Verdict& verdict = *report.verdict;
  if (verdict.leaves)
    return pusher + " presses nowhere in this motion: it leaves " + object_name(file) +
           (verdict.sticks ? ", or drags it along by friction; both obey the laws." : ".");
  const std::string angle = brief(std::abs(verdict.margin) * degrees_a_radian) + " degrees";
  if (verdict.sticks)
    return "The push of " + pusher + " sticks, and so does every push within " + angle +
           " of it; beyond, " + beyond_words(file, report) + ".";
  return "The push of " + pusher + " slips: it is " + angle +
         " outside the motions that stick; there " + beyond_words(file, report) + ".";
}

std::string cone_text(const SceneFile& file, const ConeReport& report, Telling telling) {
  std::string text = title_line(file) + cone_sentence(file, report) + "\n";
  if (report.status != Status::solved) return text;
  const bool is_full = telling == Telling::full;
  text += "\n" + table_text(edge_rows(file, report, is_full ? 9 : 4)) + "\n";
  std::vector<Fact> facts;
  if (report.verdict && !report.verdict->leaves)
    facts.push_back({"Grip", verdict_fact(file, report)});
  facts.push_back({"Beyond the sides", sides_text(file, report)});
  if (is_full) {
    Index twists = 0;
    for (const ConeReport::Side& side : report.sides)
      twists += static_cast<Index>(side.twists.size()) - 1;
    facts.push_back(
        {"Boundary", counted(twists, file.is_round ? "short arc" : "flat part") +
                         (file.is_round ? ", which stand for a curved one"
                                        : ", exact for pyramids of " + std::to_string(file.facets) +
                                              " facets")});
    facts.push_back(
        {"Angles", "between twists (vx, vy, turn times " + millimetres(report.length) + ")"});
  }
  return text + facts_text(facts);
}

std::string cone_json(const SceneFile& file, const ConeReport& report, const BoxAnswer* box) {
  const bool is_solved = report.status == Status::solved;
  const double force = named_grip(file).force;
  const auto& verdict = report.verdict;
  JsonWriter json;
  json.begin_object()
      .member("status", status_text(report.status))
      .member("pusher", file.body_name(report.pusher))
      .member("exact", !file.is_round)
      .member("single_place", when(is_solved, report.is_single_place))
      .member("length", report.length);
  json.objects("edges", report.edges, [&](const ConeReport::Edge& edge) {
    json.member("contact", point_name(file, edge.point))
        .member("twist", edge.twist)
        .member("wrench", edge.wrench)
        .member("slips", edge.slips);
  });
  json.objects("sides", report.sides, [&](const ConeReport::Side& side) {
    json.member("from", side.from)
        .member("to", side.to)
        .member("slips", when(side.is_slip, side.slips))
        .member("turns_about",
                when(!side.is_slip && !report.is_single_place, point_name(file, side.point)))
        .member("twists", side.twists);
  });
  json.member("holding_grip_factor", report.holding_grip)
      .member("twist", when(verdict.has_value(), verdict ? verdict->twist : Vector6<double>()))
      .member("sticks",
              when(verdict && !(verdict->leaves && verdict->sticks), verdict && verdict->sticks))
      .member("leaves", when(verdict.has_value(), verdict && verdict->leaves))
      .member(box != nullptr ? "angle_margin" : "margin",
              when(verdict.has_value(), verdict ? verdict->margin : 0))
      .member(report.is_single_place ? "nearest_edge" : "nearest_side",
              when(verdict.has_value(), verdict ? verdict->nearest : 0));
  const bool has_grip = verdict && verdict->grip;
  json.member("smallest_grip", when(has_grip, has_grip ? *verdict->grip * force : 0))
      .member("smallest_grip_factor", when(has_grip, has_grip ? *verdict->grip : 0))
      .member("largest_grip_factor", when(has_grip && std::isfinite(verdict->most_grip),
                                          has_grip ? verdict->most_grip : 0));
  if (box != nullptr) write_box(json, *box);
  write_warnings(json, check_scene(file));
  return json.end_object().text();
}

} // namespace lcpush::desktop
