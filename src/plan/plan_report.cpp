// A plan in words, and as JSON.
#include "formats/json_writer.hpp"
#include "lcpush/desktop/plan.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

std::string place_words(const PlanarPose& pose) {
  return "(" + brief(millimetres_a_metre * pose.x) + ", " + brief(millimetres_a_metre * pose.y) +
         ") mm and " + brief(degrees_a_radian * pose.angle) + " degrees";
}

/// "east slides it 30 mm along (-1, 0) and turns it by 5 degrees".
std::string push_words(const SceneFile& file, const PlannedPush& push) {
  const double way = std::hypot(push.to.x - push.from.x, push.to.y - push.from.y);
  const double turn = degrees_a_radian * (push.to.angle - push.from.angle);
  const std::string turning = " turns it by " + brief(turn) + " degrees";
  if (!(way > 1e-9)) return file.body_name(push.pusher) + turning;
  return file.body_name(push.pusher) + " takes it " + millimetres(way) + " along (" +
         brief((push.to.x - push.from.x) / way) + ", " + brief((push.to.y - push.from.y) / way) +
         ") and" + turning;
}

std::string plan_sentence(const SceneFile& file, const PlanReport& report) {
  const std::string goal = place_words(report.goal);
  const std::string object = object_name(file);
  if (!report.holds_start)
    return "The grasp does not hold " + object + " before it is pushed" +
           (report.box ? ", for some of the values in its ranges" : "") +
           ", so there is no plan; `lcpush hold` says which grip would.";
  if (!report.holds_goal)
    return "No plan leads to " + goal + ": there the grip would not hold " + object +
           ", for want of force, or as a finger would press beside it. --to is in m and rad.";
  if (report.pushes.empty() && report.found)
    return "No push is needed: " + object_name(file) + " is as near to " + goal +
           " as a plan has to bring it.";
  if (report.pushes.empty())
    return "No plan was found that takes " + object_name(file) + " to " + goal + ": of " +
           counted(report.tried, "place") + " tried on the way, the nearest that pushes reach is " +
           place_words(report.nearest) + ".";
  if (!report.found)
    return "A plan of " + std::to_string(report.pushes.size()) +
           " pushes was found, but its replay ends at " + place_words(report.nearest) +
           ", not at " + goal + ".";
  std::string text = "To take " + object_name(file) + " to " + goal + ": ";
  for (std::size_t k = 0; k < report.pushes.size(); ++k)
    text += (k == 0                          ? ""
             : k + 1 == report.pushes.size() ? ", then "
                                             : ", ") +
            push_words(file, report.pushes[k]);
  return text + ".";
}

constexpr double unseen = 1e-6; ///< mm, degrees, of friction: rounding's

} // namespace

std::string plan_text(const SceneFile& file, const PlanReport& report, bool verbose) {
  std::string text = title_line(file) + plan_sentence(file, report) + "\n";
  if (report.box && report.found)
    text += "Every push sticks for every value in the ranges" + margin_words(*report.box) + ".\n";
  if (report.pushes.empty()) return text;
  const GripReport grip = named_grip(file);
  const int digits = verbose ? 9 : 4;
  TableRows rows{
      {"push", "from s", "to s", "x mm", "y mm", "turn deg", "friction", "reach mm", "grip N"}};
  for (const PlannedPush& push : report.pushes)
    rows.push_back({file.body_name(push.pusher), in_digits(push.begin, digits),
                    in_digits(push.end, digits),
                    in_digits(millimetres_a_metre * push.to.x, digits, unseen),
                    in_digits(millimetres_a_metre * push.to.y, digits, unseen),
                    in_digits(degrees_a_radian * push.to.angle, digits, unseen),
                    in_digits(push.friction, digits, unseen),
                    in_digits(millimetres_a_metre * push.reach, digits, unseen),
                    in_digits(push.grip * grip.force, digits)});
  text += "\n" + table_text(rows) + "\n";
  std::vector<Fact> facts{
      {"Columns", "where each push ends; and what it takes to stick all the way: friction of the "
                  "pusher, how far from its middle it has to press, grip " +
                      grip.of},
      {"Replay", "by `move" + (report.replay_step ? " --step " + number(*report.replay_step) : "") +
                     "`, ends " +
                     in_digits(millimetres_a_metre * report.position_error, 3, unseen) +
                     " mm and " + in_digits(degrees_a_radian * report.angle_error, 3, unseen) +
                     " degrees from there"}};
  if (verbose)
    facts.push_back({"Cost", millimetres(report.cost) + ": way, turns at the object's size, and " +
                                 millimetres(change_of_pusher) + " a change of pusher"});
  return text + facts_text(facts);
}

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
  if (report.box) write_box(json, *report.box);
  write_warnings(json, check_scene(file));
  return json.end_object().text();
}

} // namespace lcpush::desktop
