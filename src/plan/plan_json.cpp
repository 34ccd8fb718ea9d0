#include "formats/json_writer.hpp"
#include "lcpush/desktop/plan.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "scenes/warnings_json.hpp"

namespace lcpush::desktop {
namespace {

std::vector<double> listed(const PlanarPose& pose) { return {pose.x, pose.y, pose.angle}; }

} // namespace

std::string plan_json(const SceneFile& file, const PlanReport& report) {
  const double force = named_grip(file).force;
  const bool is_replayed = !report.pushes.empty();
  JsonWriter json;
  json.begin_object()
      .member("found", report.found)
      .member("goal", listed(report.goal))
      .member("holds_start", report.holds_start)
      .member("holds_goal", report.holds_goal)
      .member("stopped", unless_empty(std::string(stop_text(report.stop))))
      .member("tried", report.tried)
      .member("nearest", listed(report.nearest))
      .member("cost", when(is_replayed, report.cost));
  json.objects("pushes", report.pushes, [&](const PlannedPush& push) {
    json.member("pusher", file.body_name(push.pusher))
        .member("kind", push.kind == PushKind::stick ? "stick" : "slip")
        .member("twist", push.twist)
        .member("time", push.end - push.begin)
        .member("begin", push.begin)
        .member("from", listed(push.from))
        .member("to", listed(push.to))
        .member("friction", push.friction)
        .member("reach", push.reach)
        .member("grip", push.grip * force);
  });
  json.key("replay").begin_object();
  json.member("end", when(is_replayed, move_end_text(report.replay.end)))
      .member("step", when(report.replay_step.has_value(), report.replay_step.value_or(0)))
      .member("position_error", when(is_replayed, report.position_error))
      .member("angle_error", when(is_replayed, report.angle_error))
      .member("steps", report.replay.steps)
      .end_object();
  json.member("scene", unless_empty(report.scene_text));
  write_warnings(json, check_scene(file));
  return json.end_object().text();
}

} // namespace lcpush::desktop
