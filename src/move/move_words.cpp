#include "move/move_words.hpp"

#include "lcpush/desktop/naming.hpp"
#include "move/settings.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

using Settings = MoveSettings;

std::string degrees(double radians) {
  const std::string text = brief(degrees_a_radian * radians);
  return text + (text == "1" ? " degree" : " degrees");
}

/// Who presses hardest on the object.
struct Squeeze {
  std::vector<std::string> names;
  double force = 0; ///< N, the most
};
Squeeze squeeze_of(const SceneFile& file, const MotionFrame& frame) {
  Squeeze squeeze;
  squeeze.force = hardest(frame.bodies);
  for (std::size_t b = 0; b < frame.bodies.size(); ++b)
    if (frame.bodies[b].normal_force > squeeze.force / 2)
      squeeze.names.push_back(file.body_names[b]);
  return squeeze;
}

/// ": fulcrum and plunger press on it with 5.2e+07 N", in the last step.
std::string squeeze_words(const Squeeze& squeeze) {
  if (squeeze.names.empty()) return "";
  return ": " + listed(squeeze.names, "and") + (squeeze.names.size() == 1 ? " presses" : " press") +
         " on it with " + brief(squeeze.force) + " N";
}

/// "until fulcrum and plunger leave it no room": where steps are as short as they get, no shorter
/// one helps.
std::string leap_words(const MotionReport& report, const Squeeze& squeeze,
                       const std::string& after) {
  if (!report.error || squeeze.names.empty())
    return "until it would leap out of its place within one step of " + brief(report.tried) +
           " s, after " + after + squeeze_words(squeeze) +
           (report.error ? "" : "; a shorter --step may do");
  const bool is_one = squeeze.names.size() == 1;
  return "until " + listed(squeeze.names, "and") + (is_one ? " leaves" : " leave") +
         " it no room, after " + after + ": pressed with " + brief(squeeze.force) + " N";
}

/// "until left leaves its face, after 0.71 s".
std::string end_words(const SceneFile& file, const MotionReport& report) {
  const std::string after = brief(report.frames.back().time) + " s";
  const std::string body = report.body >= 0 ? file.body_name(report.body) : "";
  const Squeeze squeeze = squeeze_of(file, report.frames.back());
  switch (report.end) {
  case MoveEnd::time: return "in " + after;
  case MoveEnd::distance: return "and has then gone as far as was asked, after " + after;
  case MoveEnd::lost:
    return "until " + (body.empty() ? std::string("a finger") : body) +
           " loses hold of it, after " + after;
  case MoveEnd::inside: return "until " + body + " comes and stands inside it, after " + after;
  case MoveEnd::steps:
    return "as far as " + counted(report.solves, "solve") + " go, " + after +
           "; ask for a longer --step, a coarser --tolerance or less --time";
  case MoveEnd::stopped: return "until it was stopped, after " + after;
  case MoveEnd::leaps: return leap_words(report, squeeze, after);
  case MoveEnd::free: return "and has then gone on freely, after " + after;
  case MoveEnd::failed: break;
  }
  if (report.status == Status::ray)
    return "until it jams, after " + after +
           ": the contacts squeeze it, and no forces let it go on";
  const bool has_reason = report.reason != Reason::none;
  const char* why = has_reason ? reason_text(report.reason) : status_text(report.status);
  return "until a step has no answer (" + std::string(why) + "), after " + after +
         squeeze_words(squeeze);
}

const char* touch_verb(Touch from, Touch to) {
  switch (to) {
  case Touch::sticks: return from == Touch::slips ? "stops slipping" : "touches and sticks";
  case Touch::slips: return from == Touch::sticks ? "begins to slip" : "touches and slips";
  case Touch::parted: return from == Touch::away ? "comes" : "opens";
  case Touch::beside: return "leaves its face";
  case Touch::behind: return "comes round an edge";
  case Touch::no_line: return "stands on the side's end";
  case Touch::away: return "goes away";
  }
  return "";
}

/// Points of one body that do the same after the same step.
struct EventGroup {
  MotionEvent event; ///< of the first of them
  Index points = 1;
};

std::vector<EventGroup> grouped_events(const SceneFile& file, const MotionReport& report) {
  std::vector<EventGroup> groups;
  for (const MotionEvent& event : report.events) {
    const auto is_new = [&](const EventGroup& group) { return group.event.time != event.time; };
    const auto begin = std::find_if(groups.rbegin(), groups.rend(), is_new);
    const auto same = std::find_if(groups.rbegin(), begin, [&](const EventGroup& group) {
      return group.event.from == event.from && group.event.to == event.to &&
             file.body_of(group.event.point) == file.body_of(event.point);
    });
    if (same == begin)
      groups.push_back({event});
    else
      ++same->points;
  }
  return groups;
}

std::string event_words(const SceneFile& file, const EventGroup& group) {
  const MotionEvent& event = group.event;
  const Index b = file.body_of(event.point), all = file.body(b).point_count;
  const std::string verb = touch_verb(event.from, event.to);
  if (group.points == all) return file.body_name(b) + " " + verb;
  if (group.points == 1) return point_name(file, event.point) + " " + verb;
  return file.body_name(b) + " " + verb + " at " + std::to_string(group.points) + " of its " +
         std::to_string(all) + " points";
}

/// Who touched the object and, when it ends, does so nowhere: "From 0.976 s on edge touches it no
/// more."; who is lost is in the sentence before.
std::string parted_words(const SceneFile& file, const MotionReport& report) {
  std::vector<double> since(file.bodies.size(), -1);
  for (const MotionEvent& event : report.events)
    if (is_touching(event.from) && !is_touching(event.to))
      since[static_cast<std::size_t>(file.body_of(event.point))] = event.time;
  std::vector<std::pair<double, std::vector<std::string>>> groups;
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    bool touches = false, is_away = false;
    for (const Index i : points_of(file.body(b))) {
      const Touch touch = report.frames.back().contacts[static_cast<std::size_t>(i)].touch;
      touches = touches || is_touching(touch);
      is_away = is_away || touch == Touch::away;
    }
    const double time = since[static_cast<std::size_t>(b)];
    if (touches || is_away || time < 0 || b == report.body) continue;
    if (groups.empty() || brief(groups.back().first) != brief(time)) groups.push_back({time, {}});
    groups.back().second.push_back(file.body_name(b));
  }
  std::string text;
  for (const auto& [time, names] : groups)
    text += " From " + brief(time) + " s on " + listed(names, "and") +
            (names.size() == 1 ? " touches it no more." : " touch it no more.");
  return text;
}

} // namespace

Vector3<double> push_force(const SceneFile& file, const std::vector<BodyForce>& bodies) {
  Vector3<double> force = Vector3<double>::Zero();
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (file.bodies[b].role == Role::pusher) force += bodies[b].force;
  return force;
}

double hardest(const std::vector<BodyForce>& bodies) {
  double most = 0;
  for (const BodyForce& body : bodies) most = std::max(most, body.normal_force);
  return most;
}

std::vector<SceneDoubt> motion_doubts(const SceneFile& file, const MotionReport& report) {
  std::vector<SceneDoubt> doubts = check_scene(file);
  if (file.shape.kind != ObjectShape::Kind::unknown || !file.faces.empty()) return doubts;
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    if (file.strokes[static_cast<std::size_t>(b)].rides_on_object) continue;
    const auto goes_over = [&](const MotionFrame& frame) {
      const auto i = static_cast<std::size_t>(file.body(b).first_point);
      const PointState& point = frame.contacts[i];
      const Matrix3<double>& R = frame.pose.rotation;
      const Vector3<double> at = point.position - file.object.center_of_mass - frame.pose.position;
      const double slid = (R.transpose() * at - file.points[i]).norm();
      const Matrix3<double> beside =
          frame.body_poses[static_cast<std::size_t>(b)].rotation.transpose() * R;
      const double tilted = (beside * file.body(b).normal - file.body(b).normal).norm();
      return is_touching(point.touch) &&
             std::max(slid / object_size(file), tilted) > Settings::over_surface;
    };
    if (std::none_of(report.frames.begin(), report.frames.end(), goes_over)) continue;
    doubts.push_back({Doubt::unknown_shape, file.lines.file, file.lines.object,
                      "object: its shape is not known: " + file.body_name(b) +
                          " slides or rolls on it as on a plane without end; give box, "
                          "cylinder_radius with cylinder_length, sphere_radius, or its [[face]]s"});
    break;
  }
  return doubts;
}

std::string phase_words(const SceneFile& file, const MotionPhase& phase) {
  const double angle = phase.turn.norm(), path = phase.along.norm();
  const double turned = object_size(file) / 2 * phase.angle;
  const std::string about = phase.turn.norm() > 0 ? " " + turn_phrase(phase.turn.normalized()) : "";
  const bool goes = path > Settings::worth_a_word * (phase.path + turned);
  const std::string along =
      goes ? " along " + direction_text(phase.along.normalized()) : std::string();
  const std::string goes_words = goes ? " and goes " + millimetres(path) + along : std::string();
  const bool returns = angle < Settings::to_and_fro * phase.angle;
  const auto turned_by = [&](const std::string& verb) {
    return returns ? verb + " to and fro, by " + degrees(angle) + about + " in the end"
                   : verb + " " + degrees(angle) + about;
  };
  switch (phase.kind) {
  case MotionKind::rest: return "stays for " + brief(phase.until - phase.from) + " s";
  case MotionKind::slide: return "slides " + millimetres(path) + along;
  case MotionKind::pivot: return turned_by("pivots");
  case MotionKind::roll: return turned_by(rolling_verb(file)) + goes_words;
  case MotionKind::turn: break;
  }
  return turned_by("turns") + goes_words;
}

std::string move_sentence(const SceneFile& file, const MotionReport& report) {
  std::vector<std::string> parts;
  for (const MotionPhase& phase : report.phases) parts.push_back(phase_words(file, phase));
  std::string name = object_name(file);
  name[0] = 'T';
  const bool rests = report.phases.size() == 1 && report.phases[0].kind == MotionKind::rest;
  const std::string what = parts.empty() || rests ? "does not move" : joined(parts, ", then ");
  const bool is_long = parts.size() > 1 || report.end != MoveEnd::time;
  return name + " " + what + (is_long ? ", " : " ") + end_words(file, report) + "." +
         parted_words(file, report);
}

std::vector<EventLine> event_lines(const SceneFile& file, const MotionReport& report) {
  std::vector<EventLine> lines;
  for (const EventGroup& group : grouped_events(file, report))
    lines.push_back({group.event.time, group.event.within, event_words(file, group)});
  for (const ForceJump& jump : report.jumps)
    lines.push_back({jump.time, jump.within,
                     std::string("the push ") + (jump.to < jump.from ? "falls" : "rises") +
                         " from " + brief(jump.from) + " to " + brief(jump.to) + " N"});
  std::stable_sort(lines.begin(), lines.end(),
                   [](const EventLine& a, const EventLine& b) { return a.time < b.time; });
  return lines;
}

std::vector<std::string> touch_words(const SceneFile& file, const MotionFrame& frame, std::size_t b,
                                     const char* const (&words)[7], bool counts_all) {
  Index counts[7] = {};
  for (const Index i : points_of(file.bodies[b]))
    ++counts[static_cast<std::size_t>(frame.contacts[static_cast<std::size_t>(i)].touch)];
  std::vector<std::string> parts;
  for (std::size_t t = 0; t < 7; ++t)
    if (counts[t] == file.bodies[b].point_count && !counts_all)
      parts.emplace_back(words[t]);
    else if (counts[t] > 0)
      parts.push_back(std::to_string(counts[t]) + " " + words[t]);
  return parts;
}

std::string step_words(const MotionReport& report, bool verbose) {
  std::string text = counted(report.steps, "step");
  if (verbose || !report.error)
    text += " of " +
            (report.shortest == report.longest
                 ? brief(report.longest)
                 : brief(report.shortest) + " to " + brief(report.longest)) +
            " s";
  if (report.error) text += ", together within about " + millimetres(*report.error);
  if (report.error && verbose) text += " (tolerance " + millimetres(report.tolerance) + ")";
  const bool is_exact = report.residual <= Settings::exact;
  if (verbose || !is_exact)
    text += "; laws within " + (is_exact ? std::string("1e-9") : residual_text(report.residual));
  if (report.penetration > Settings::exact)
    text += ", deepest point inside its face " + millimetres(report.penetration);
  else if (verbose)
    text += ", no point inside its face";
  if (report.pressed_gap > Settings::seen_gap)
    text += ", the largest gap across which one presses " + millimetres(report.pressed_gap);
  if (report.by_pyramids > 0)
    text += "; round friction did not settle in " + counted(report.by_pyramids, "solve") +
            ", where pyramids of 8 facets answer";
  return text;
}

std::string pose_words(const SceneFile& file, const MotionFrame& frame) {
  const Vector3<double>&way = frame.pose.position, &turn = frame.turn;
  const double path = way.norm(), turned = object_size(file) / 2 * turn.norm();
  std::vector<std::string> parts;
  const double least = Settings::unmoved * object_size(file);
  if (path > std::max(Settings::worth_a_word * turned, least))
    parts.push_back(millimetres(path) + " along " + direction_text(way / path));
  if (turned > std::max(Settings::worth_a_word * path, least))
    parts.push_back("turned by " + degrees(turn.norm()) + " " + turn_phrase(turn.normalized()));
  return parts.empty() ? "where it was" : joined(parts, ", ");
}

} // namespace lcpush::desktop
