#include <limits>

#include "lcpush/host/json.hpp"
#include "lcpush/host/report.hpp"

namespace lcpush::host {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); // printed as null

void write_residual(JsonWriter& json, const Residuals<double>& r) {
  json.key("residual").begin_object();
  json.member("max", r.max()).member("newton", r.newton).member("normal", r.normal);
  json.member("cone", r.cone).member("dissipation", r.dissipation).member("grip", r.grip);
  json.member("rigidity", r.rigidity).member("pusher", r.pusher).end_object();
}

void write_unique(JsonWriter& json, const char* key, Uniqueness unique) {
  json.key(key);
  if (unique == Uniqueness::yes)
    json.value(true);
  else if (unique == Uniqueness::no)
    json.value(false);
  else
    json.value(nullptr);
}

void write_contacts(JsonWriter& json, const SceneFile& file, const PushReport& report) {
  json.key("contacts").begin_array();
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    json.begin_object().member("name", point_name(file, i));
    json.member("body", file.body_names[static_cast<std::size_t>(contact.body)]);
    json.key("position").numbers(file.positions[static_cast<std::size_t>(i)]);
    json.member("normal_force", contact.normal_force);
    json.key("friction_force").numbers(contact.friction_force);
    json.member("torsion", contact.torsion).member("spin", contact.spin);
    json.key("acceleration").numbers(contact.acceleration);
    json.member("mode", mode_text(contact.mode)).end_object();
  }
  json.end_array();
}

const char* role_name(const Scene<double>& scene, Index body) {
  if (scene.bodies[body].role == Role::pusher) return "pusher";
  return is_driven(scene, body) ? "finger" : "stop";
}

/// One number a body; under even pressure each point closes by itself.
void write_closing(JsonWriter& json, const Scene<double>& scene, const Answer<double>& answer,
                   Index b) {
  const Body<double>& body = scene.bodies[b];
  if (!is_driven(scene, b) || scene.pressure != Pressure::even) {
    json.member("closing_acceleration", is_driven(scene, b) ? closing(answer, body) : unknown);
    return;
  }
  std::vector<double> each;
  for (Index k = 0; k < body.point_count; ++k)
    each.push_back(answer.contacts[body.first_point + k].closing);
  json.key("closing_acceleration").numbers(each.data(), body.point_count);
}

void write_bodies(JsonWriter& json, const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  json.key("bodies").begin_array();
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Vector6<double> wrench = body_wrench(scene, report.answer, scene.bodies[b]);
    json.begin_object().member("name", file.body_names[static_cast<std::size_t>(b)]);
    json.member("role", role_name(scene, b));
    json.key("force").numbers(wrench.data(), 3).key("moment").numbers(wrench.data() + 3, 3);
    json.member("normal_force", normal_sum(report.answer, scene.bodies[b]));
    write_closing(json, scene, report.answer, b);
    json.end_object();
  }
  json.end_array();
}

void write_failure(JsonWriter& json, const std::string& reason,
                   const std::vector<NamedValue>& ray) {
  json.member("reason", reason).key("ray");
  if (ray.empty()) {
    json.value(nullptr);
    return;
  }
  json.begin_array();
  for (const NamedValue& entry : ray)
    json.begin_object().member("name", entry.name).member("value", entry.value).end_object();
  json.end_array();
}

void write_holds(JsonWriter& json, const HoldReport& hold) {
  json.key("holds_without_push");
  if (hold.status == Status::solved)
    json.value(hold.holds);
  else
    json.value(nullptr);
}

} // namespace

std::string solve_json(const SceneFile& file, const HoldReport& hold, const PushReport& report) {
  JsonWriter json;
  json.begin_object();
  json.member("status", status_text(report.status)).member("solver", "lemke");
  json.member("pivots", report.run.pivots).member("sweeps", 0).member("rounds", report.run.rounds);
  write_holds(json, hold);
  if (report.status != Status::solved) {
    write_failure(json, report.reason, report.ray);
    return json.end_object().text();
  }
  json.key("unique").begin_object();
  write_unique(json, "motion", report.unique_motion);
  write_unique(json, "wrench", report.unique_wrench);
  json.end_object();
  write_residual(json, report.residuals);
  json.key("object").begin_object();
  json.key("acceleration").numbers(report.answer.acceleration).end_object();
  write_contacts(json, file, report);
  write_bodies(json, file, report);
  return json.end_object().text();
}

std::string break_json(const SceneFile& file, const HoldReport& hold, const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  const bool solved = report.status == Status::solved;
  JsonWriter json;
  json.begin_object().member("status", status_text(report.status));
  write_holds(json, hold);
  json.member("smallest_grip", nullptr);
  json.member("pusher", file.body_names[static_cast<std::size_t>(report.pusher)]);
  json.member("pivots", report.run.pivots).member("rounds", report.run.rounds);
  if (!solved) {
    write_failure(json, report.reason, report.ray);
    if (report.status == Status::does_not_hold) json.key("rest_acceleration").numbers(b.rest);
    return json.end_object().text();
  }
  json.member("break_force", b.break_force);
  json.key("force").numbers(b.force.data(), 3).key("moment").numbers(b.force.data() + 3, 3);
  json.key("inertia_force").numbers(b.inertia.data(), 3);
  json.key("twist").numbers(b.twist);
  json.member("valid_to", b.valid_to < 0 ? unknown : b.valid_to);
  json.member("line_error", b.line_error);
  write_residual(json, b.residuals);
  return json.end_object().text();
}

} // namespace lcpush::host
