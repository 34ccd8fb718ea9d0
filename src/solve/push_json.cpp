#include <limits>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/report.hpp"
#include "solve/failure_words.hpp"

namespace lcpush::desktop {
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

void write_statement(JsonWriter& json, const char* key, const Statement& statement) {
  json.key(key).begin_object().member("covered", statement.covered);
  json.member("statement", statement.statement).member("reason", statement.reason()).end_object();
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
    json.member("closing_acceleration", is_driven(scene, b) ? mean_closing(answer, body) : unknown);
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

void write_jam(JsonWriter& json, const SceneFile& file, const Jam& jam) {
  json.key("jam").begin_object().key("words").begin_array();
  for (const std::string& sentence : jam_sentences(file, jam)) json.value(sentence);
  json.end_array().key("bodies").begin_array();
  for (const JamBody& body : jam.bodies)
    json.begin_object()
        .member("name", file.body_names[static_cast<std::size_t>(body.body)])
        .member("normal", body.normal)
        .member("power", body.power)
        .end_object();
  json.end_array().member("uses_friction", jam.uses_friction).key("remedies").begin_array();
  for (const Remedy& remedy : jam.remedies) {
    json.begin_object().member("text", remedy.text).key("works");
    if (remedy.tried)
      json.value(remedy.works);
    else
      json.value(nullptr);
    json.end_object();
  }
  json.end_array().end_object();
}

void write_holds(JsonWriter& json, const HoldReport& hold) {
  json.key("holds_without_push");
  if (hold.status == Status::solved)
    json.value(hold.holds);
  else
    json.value(nullptr);
}

/// KEY (N), KEY_factor and KEY_from.
void write_grip(JsonWriter& json, const std::string& key, const SmallestGrip& grip, double force) {
  const bool known = grip.is_known();
  json.member(key.c_str(), known ? grip.factor * force : unknown);
  json.member((key + "_factor").c_str(), known ? grip.factor : unknown);
  json.key((key + "_from").c_str());
  switch (grip.source) {
  case GripSource::statics: json.value("statics"); break;
  case GripSource::search: json.value("search"); break;
  case GripSource::no_grip: json.value("no_grip"); break;
  case GripSource::not_known:
  case GripSource::not_searched: json.value(nullptr); break;
  }
}

} // namespace

void write_failure(JsonWriter& json, const SceneFile& file, const RunReport& report) {
  json.member("reason", report.reason).key("ray");
  if (report.ray.empty()) {
    json.value(nullptr);
    return;
  }
  json.begin_array();
  for (const NamedValue& entry : report.ray)
    json.begin_object().member("name", entry.name).member("value", entry.value).end_object();
  json.end_array();
  write_jam(json, file, report.jam);
}

std::string solve_json(const SceneFile& file, const HoldReport& hold, const PushReport& report) {
  JsonWriter json;
  json.begin_object();
  json.member("status", status_text(report.status)).member("solver", solver_text(report.solver));
  json.member("pivots", report.run.pivots)
      .member("sweeps", report.run.sweeps)
      .member("rounds", report.run.rounds);
  write_holds(json, hold);
  write_statement(json, "existence", existence_statement(file, report.existence));
  if (report.status != Status::solved) {
    write_failure(json, file, report);
    return json.end_object().text();
  }
  write_statement(json, "uniqueness", uniqueness_statement(report));
  json.key("unique").begin_object();
  write_unique(json, "motion", report.unique_motion);
  write_unique(json, "wrench", report.unique_wrench);
  json.member("covers_compared", report.covers_compared);
  json.key("final_basis").begin_object().member("studied", report.final_basis.studied);
  json.member("tied_contacts", report.final_basis.tied_contacts);
  json.member("motion_open", report.final_basis.motion_open);
  json.member("wrench_open", report.final_basis.wrench_open).end_object();
  json.end_object();
  write_residual(json, report.residuals);
  json.key("object").begin_object();
  json.key("acceleration").numbers(report.answer.acceleration).end_object();
  write_contacts(json, file, report);
  write_bodies(json, file, report);
  return json.end_object().text();
}

std::string break_json(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  const bool solved = report.status == Status::solved;
  JsonWriter json;
  json.begin_object().member("status", status_text(report.status));
  write_holds(json, hold);
  write_grip(json, "smallest_grip", grip.alone, grip.force);
  json.key("holds_at_rest");
  if (solved || report.status == Status::does_not_hold)
    json.value(solved);
  else
    json.value(nullptr);
  write_grip(json, "smallest_grip_at_rest", grip.at_rest, grip.force);
  json.member("pusher", file.body_names[static_cast<std::size_t>(report.pusher)]);
  json.member("solver", solver_text(report.solver)).member("pivots", report.run.pivots);
  json.member("sweeps", report.run.sweeps).member("rounds", report.run.rounds);
  if (!solved) {
    write_failure(json, file, report);
    if (report.status == Status::does_not_hold) json.key("rest_acceleration").numbers(b.rest);
    return json.end_object().text();
  }
  json.member("break_force", b.break_force);
  json.key("force").numbers(b.force.data(), 3).key("moment").numbers(b.force.data() + 3, 3);
  json.key("inertia_force").numbers(b.inertia.data(), 3);
  json.key("twist").numbers(b.twist);
  json.member("valid_to", b.valid_to < 0 ? unknown : b.valid_to);
  json.member("line_error", b.line_error);
  json.key("unique").begin_object();
  write_unique(json, "motion", report.unique_motion);
  write_unique(json, "force", report.unique_force);
  json.end_object();
  write_residual(json, b.residuals);
  return json.end_object().text();
}

} // namespace lcpush::desktop
