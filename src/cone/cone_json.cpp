#include "formats/json_writer.hpp"
#include "lcpush/desktop/cone.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "scenes/warnings_json.hpp"

namespace lcpush::desktop {

std::string cone_json(const SceneFile& file, const ConeReport& report) {
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
      .member("margin", when(verdict.has_value(), verdict ? verdict->margin : 0))
      .member(report.is_single_place ? "nearest_edge" : "nearest_side",
              when(verdict.has_value(), verdict ? verdict->nearest : 0));
  const bool has_grip = verdict && verdict->grip;
  json.member("smallest_grip", when(has_grip, has_grip ? *verdict->grip * force : 0))
      .member("smallest_grip_factor", when(has_grip, has_grip ? *verdict->grip : 0));
  write_warnings(json, check_scene(file));
  return json.end_object().text();
}

} // namespace lcpush::desktop
