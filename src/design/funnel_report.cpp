// What an edge aligns, in words and as JSON.
#include <cmath>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/funnel.hpp"
#include "lcpush/desktop/naming.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// Places that are rounding are 0.
std::string place(double x) { return millimetres(std::abs(x) < 1e-9 ? 0 : x); }

std::string degrees(double angle) { return brief(angle * degrees_a_radian, 1e-9); }

/// "within 2 mm along the push, 3 mm along the edge and 10 degrees"
std::string box_text(const EdgePose& box) {
  std::vector<std::string> sides;
  if (box[0] > 0) sides.push_back(millimetres(box[0]) + " along the push");
  if (box[1] > 0) sides.push_back(millimetres(box[1]) + " along the edge");
  if (box[2] > 0) sides.push_back(degrees(box[2]) + " degrees");
  return "within " + listed(sides, "and");
}

std::string pose_text(const EdgePose& pose) {
  return millimetres(pose[0]) + ", " + millimetres(pose[1]) + " and " + degrees(pose[2]) +
         " degrees";
}

/// One that does not end flush; first of those of which that is known.
const FlushPush* first_lost(const FunnelReport& report) {
  const FlushPush* lost = nullptr;
  for (const FlushPush& push : report.pushes)
    if (!push.is_flush &&
        (lost == nullptr || (lost->status != Status::solved && push.status == Status::solved)))
      lost = &push;
  return lost;
}

std::string answer(const SceneFile& file, const FunnelReport& report) {
  const std::string edge = file.body_name(report.pusher), object = object_name(file);
  if (!report.stays)
    return "Flush with " + edge + " " + object + " does not stay so: it turns off " + edge +
           " again, from whatever pose it comes.";
  const FlushPush* const lost = first_lost(report);
  if (lost == nullptr)
    return "From every pose tried " + box_text(report.box) + " " + object + " ends flush with " +
           edge + "; " + edge + " goes " + millimetres(report.way) + " for that.";
  if (lost->status == Status::solved)
    return "Not every pose " + box_text(report.box) + " ends flush with " + edge + ": from " +
           pose_text(lost->begin) + " " + object + " does not.";
  return "It is not known whether " + object + " ends flush with " + edge + " from " +
         pose_text(lost->begin) + ": " +
         (lost->status == Status::running
              ? "it turns too slowly to tell"
              : "a step has no answer (" + std::string(status_text(lost->status)) + ")") +
         ".";
}

/// What is left of the box, beside what it was.
std::string left_text(const FunnelReport& report) {
  std::string text = place(report.along_from) + " to " + place(report.along_until) +
                     " along the edge, 0 mm along the push, 0 degrees";
  const double before = 2 * report.box[1];
  if (before > 0)
    text += "; along the edge " + brief((report.along_until - report.along_from) / before) +
            " times what it was";
  return text;
}

Fact goal_fact(const FunnelReport& report, const EdgePose& goal) {
  std::string text = "the edge stops " + millimetres(goal[0]) + " beyond its place in the scene; ";
  if (goal[0] < report.stop)
    text += "not all are flush there, but only from " + millimetres(report.stop) +
            " on: let the object begin farther back";
  else {
    const double drifts = report.drift * (goal[0] - report.stop) - goal[1];
    text += "the object is then " + place(report.along_from + drifts) + " to " +
            place(report.along_until + drifts) + " beside the goal, along the edge";
  }
  return {"Goal", text};
}

} // namespace

std::string funnel_text(const SceneFile& file, const FunnelReport& report,
                        const std::optional<EdgePose>& goal) {
  const std::string range = "from " + degrees(report.from) + " to " + degrees(report.until) +
                            " degrees, in the middle of the box";
  std::vector<Fact> facts{{"Turns to it", !report.stays                ? "not known from where"
                                          : report.is_capture_known    ? range
                                          : report.from < report.until ? "at least " + range
                                                                       : "not known from where"}};
  if (report.is_flush) {
    facts.push_back({"All flush", "with the edge " + millimetres(report.stop) +
                                      " beyond its place in the scene"});
    facts.push_back({"Then left", left_text(report)});
    if (report.drift != 0)
      facts.push_back({"It drifts",
                       millimetres(report.drift) + " along the edge for each m that this goes on"});
    if (goal) facts.push_back(goal_fact(report, *goal));
  }
  facts.push_back({"Tried", counted(static_cast<Index>(report.pushes.size()), "pose") +
                                ": corners of the box, and between them"});
  return title_line(file) + answer(file, report) + "\n\n" + facts_text(facts);
}

std::string funnel_json(const SceneFile& file, const FunnelReport& report) {
  JsonWriter json;
  json.begin_object()
      .member("flush", report.is_flush)
      .member("pusher", file.body_name(report.pusher))
      .member("capture", std::vector<double>{report.from, report.until})
      .member("capture_known", report.is_capture_known)
      .member("stays", report.stays)
      .member("drift", report.drift)
      .member("way", when(report.is_flush, report.way))
      .member("stop", when(report.is_flush, report.stop));
  json.member("along",
              when(report.is_flush, std::vector<double>{report.along_from, report.along_until}));
  json.objects("pushes", report.pushes, [&](const FlushPush& push) {
    json.member("begin", push.begin)
        .member("flush", push.is_flush)
        .member("status", status_text(push.status))
        .member("contact", push.contact)
        .member("way", when(push.is_flush, push.way))
        .member("along", when(push.is_flush, push.along));
  });
  return json.end_object().text();
}

} // namespace lcpush::desktop
