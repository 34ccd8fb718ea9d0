// For programs: JSON and CSV.
#include "formats/json_writer.hpp"
#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/naming.hpp"
#include "move/move_words.hpp"
#include "scenes/warnings_json.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

std::vector<double> row_by_row(const Matrix3<double>& R) {
  return {R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)};
}

std::string exact(double x) { return printed("%.17g", x); }
std::string exact(const std::optional<double>& x) { return x ? exact(*x) : ""; }
/// Each behind a comma.
template <int n> std::string exact(const Eigen::Matrix<double, n, 1>& list) {
  std::string text;
  for (Index k = 0; k < n; ++k) text += "," + exact(list[k]);
  return text;
}

/// Columns have come at the end, so that a reader by place finds the old ones where they were.
std::string csv_head(const SceneFile& file) {
  const auto points = static_cast<Index>(file.points.size());
  std::string text = "time,x,y,z,r11,r12,r13,r21,r22,r23,r31,r32,r33,vx,vy,vz,wx,wy,wz";
  for (const std::string& name : file.body_names)
    for (const char* part : {"fx", "fy", "fz", "mx", "my", "mz"}) text += "," + name + "." + part;
  for (Index i = 0; i < points; ++i)
    for (const char* part : {"mode", "gap", "normal"})
      text += "," + point_name(file, i) + "." + part;
  text += ",step";
  for (const std::string& name : file.body_names)
    text += "," + name + ".closing," + name + ".closing_speed";
  for (Index i = 0; i < points; ++i)
    for (const char* part : {"fx", "fy", "fz", "torsion"})
      text += "," + point_name(file, i) + "." + part;
  return text + "\n";
}

void write_frame(JsonWriter& json, const SceneFile& file, const MotionFrame& frame) {
  json.member("time", frame.time)
      .member("step", frame.step)
      .member("position", frame.pose.position)
      .member("rotation", row_by_row(frame.pose.rotation))
      .member("twist", frame.twist);
  std::size_t b = 0;
  json.objects("bodies", frame.bodies, [&](const BodyForce& body) {
    json.member("name", file.body_names[b++])
        .member("force", body.force)
        .member("moment", body.moment)
        .member("normal_force", body.normal_force)
        .member("closing", body.closing)
        .member("closing_speed", body.closing_speed);
  });
  Index i = 0;
  json.objects("contacts", frame.contacts, [&](const PointState& contact) {
    json.member("name", point_name(file, i++))
        .member("mode", touch_text(contact.touch))
        .member("gap", contact.gap)
        .member("normal_force", contact.normal_force)
        .member("friction_force", contact.friction_force)
        .member("torsion", contact.torsion)
        .member("velocity", contact.velocity);
  });
}

} // namespace

std::string move_json(const SceneFile& file, const MotionReport& report) {
  JsonWriter json;
  json.begin_object()
      .member("status", status_text(report.status))
      .member("end", move_end_text(report.end))
      .member("stopped", unless_empty(std::string(stop_text(report.stop))))
      .member("end_body", when(report.body >= 0,
                               report.body >= 0 ? file.body_name(report.body) : std::string()))
      .member("time", report.frames.back().time)
      .member("steps", report.steps)
      .member("step", std::vector<double>{report.shortest, report.longest})
      .member("tolerance", when(report.error.has_value(), report.tolerance))
      .member("error", report.error)
      .member("penetration", report.penetration)
      .member("pressed_gap", report.pressed_gap)
      .member("by_pyramids", report.by_pyramids);
  json.key("residual").begin_object().member("max", report.residual).end_object();
  json.objects("phases", report.phases, [&](const MotionPhase& phase) {
    constexpr const char* kinds[] = {"rest", "slide", "pivot", "roll", "turn"};
    json.member("motion", kinds[static_cast<int>(phase.kind)])
        .member("from", phase.from)
        .member("until", phase.until)
        .member("way", phase.path)
        .member("angle", phase.angle);
  });
  json.objects("events", report.events, [&](const MotionEvent& event) {
    json.member("time", event.time)
        .member("within", event.within)
        .member("contact", point_name(file, event.point))
        .member("from", touch_text(event.from))
        .member("to", touch_text(event.to));
  });
  json.objects("jumps", report.jumps, [&](const ForceJump& jump) {
    json.member("time", jump.time)
        .member("within", jump.within)
        .member("from", jump.from)
        .member("to", jump.to);
  });
  json.objects("frames", report.frames,
               [&](const MotionFrame& frame) { write_frame(json, file, frame); });
  write_warnings(json, motion_doubts(file, report));
  json.end_object();
  return json.text();
}

std::string move_csv(const SceneFile& file, const MotionReport& report) {
  std::string text = csv_head(file);
  for (const MotionFrame& frame : report.frames) {
    text += exact(frame.time) + exact(frame.pose.position);
    for (const double x : row_by_row(frame.pose.rotation)) text += "," + exact(x);
    text += exact(frame.twist);
    for (const BodyForce& body : frame.bodies) text += exact(body.force) + exact(body.moment);
    for (const PointState& contact : frame.contacts)
      text += "," + std::string(touch_text(contact.touch)) + "," + exact(contact.gap) + "," +
              exact(contact.normal_force);
    text += "," + exact(frame.step);
    for (const BodyForce& body : frame.bodies)
      text += "," + exact(body.closing) + "," + exact(body.closing_speed);
    for (const PointState& contact : frame.contacts)
      text += exact(contact.friction_force) + "," + exact(contact.torsion);
    text += "\n";
  }
  return text;
}

} // namespace lcpush::desktop
