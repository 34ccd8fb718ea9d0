#include "formats/json_writer.hpp"
#include "lcpush/mechanics/model/round_distance.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

void write_residual(JsonWriter& json, const Residuals<double>& r) {
  json.key("residual").begin_object();
  json.member("max", r.max()).member("newton", r.newton).member("normal", r.normal);
  json.member("cone", r.cone).member("dissipation", r.dissipation).member("grip", r.grip);
  json.member("rigidity", r.rigidity).member("pusher", r.pusher).end_object();
}

std::optional<bool> settled(Uniqueness unique) {
  return when(unique == Uniqueness::yes || unique == Uniqueness::no, unique == Uniqueness::yes);
}

/// `off`: N, how far the answer is from round friction; of a break not known.
void write_friction(JsonWriter& json, const SceneFile& file, const RunReport& report,
                    std::optional<double> off) {
  const bool round = report.friction == FrictionLaw::round || !file.has_cones();
  json.key("friction").begin_object().member("law", round ? "round" : "pyramids");
  json.member("facets", when(!round, file.facets));
  json.member("settled", report.friction != FrictionLaw::pyramids_instead);
  json.member("may_be_off", off).end_object();
}

void write_contacts(JsonWriter& json, const SceneFile& file, const PushReport& report) {
  json.objects("contacts", report.answer.contacts.size, [&](Index i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    json.member("name", point_name(file, i)).member("body", file.body_name(contact.body));
    json.member("position", file.positions[static_cast<std::size_t>(i)]);
    json.member("normal_force", contact.normal_force);
    json.member("friction_force", contact.friction_force);
    json.member("torsion", contact.torsion).member("spin", contact.spin);
    json.member("acceleration", contact.acceleration).member("mode", mode_text(contact.mode));
  });
}

void write_statement(JsonWriter& json, const char* key, const Statement& statement) {
  const bool covered = !statement.text.empty();
  json.key(key).begin_object().member("covered", covered);
  json.member("statement", covered ? statement.text : "none");
  json.member("reason", joined(statement.reasons, "; ")).end_object();
}

const char* role_name(const Scene<double>& scene, Index body) {
  if (scene.bodies[body].role == Role::pusher) return "pusher";
  return is_driven(scene, body) ? "finger" : "stop";
}

/// One number a body; under even pressure each point closes by itself.
void write_closing(JsonWriter& json, const Scene<double>& scene, const Answer<double>& answer,
                   Index b) {
  const Body<double>& body = scene.bodies[b];
  json.key("closing_acceleration");
  if (!is_driven(scene, b) || scene.pressure != Pressure::even) {
    json.value(when(is_driven(scene, b), mean_closing(answer, body)));
    return;
  }
  std::vector<double> each;
  for (const Index i : points_of(body)) each.push_back(answer.contacts[i].closing_acceleration);
  json.value(each);
}

void write_bodies(JsonWriter& json, const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  json.objects("bodies", scene.bodies.size, [&](Index b) {
    const Body<double>& body = scene.bodies[b];
    const Vector6<double> wrench = body_wrench(scene, report.answer, body);
    json.member("name", file.body_name(b)).member("role", role_name(scene, b));
    json.member("force", wrench.head<3>()).member("moment", wrench.tail<3>());
    json.member("normal_force", normal_sum(report.answer, body));
    write_closing(json, scene, report.answer, b);
  });
}

void write_sensitivity(JsonWriter& json, const SceneFile& file,
                       const std::vector<Sensitivity>& sensitivity) {
  json.objects("sensitivity", sensitivity, [&](const Sensitivity& by) {
    const bool known = by.reason.empty();
    json.member("number", by.number).member("value", by.value);
    json.member("reason", unless_empty(by.reason));
    json.member("range", when(known && !by.is_curved, std::vector{by.from, by.to}));
    json.member("acceleration", when(known, by.acceleration));
    json.objects("pushers", by.pushers, [&](const Sensitivity::OfPusher& pusher) {
      json.member("name", file.body_name(pusher.body)).member("force", pusher.force);
      json.member("normal_force", pusher.normal_force);
    });
  });
}

void write_jam(JsonWriter& json, const SceneFile& file, const Jam& jam) {
  json.key("jam").begin_object();
  json.list("words", jam_sentences(file, jam), [&](const auto& sentence) { json.value(sentence); });
  json.objects("bodies", jam.bodies, [&](const JamBody& body) {
    json.member("name", file.body_name(body.body)).member("normal", body.normal);
    json.member("power", body.power);
  });
  json.member("uses_friction", jam.uses_friction);
  json.objects("remedies", jam.remedies, [&](const Remedy& remedy) {
    json.member("text", remedy.text).member("works", when(remedy.tried, remedy.works));
  });
  json.end_object();
}

void write_holds(JsonWriter& json, const SceneFile& file, const HoldReport& hold) {
  write_warnings(json, check_scene(file));
  json.member("hand", hand_text(file.hand));
  json.member("holds_without_push", when(hold.status == Status::solved, hold.holds));
}

std::optional<std::string> source_name(GripSource source) {
  switch (source) {
  case GripSource::statics: return "statics";
  case GripSource::search: return "search";
  case GripSource::no_grip: return "no_grip";
  case GripSource::not_known:
  case GripSource::not_searched: break;
  }
  return std::nullopt;
}

/// KEY (N), KEY_factor and KEY_from.
void write_grip(JsonWriter& json, const std::string& key, const SmallestGrip& grip, double force) {
  json.member(key, when(grip.is_known(), grip.certain * force));
  json.member(key + "_factor", when(grip.is_known(), grip.certain));
  json.member(key + "_from", source_name(grip.source));
}

} // namespace

void write_failure(JsonWriter& json, const SceneFile& file, const RunReport& report) {
  json.member("reason", report.reason);
  if (report.ray.empty()) {
    json.member("ray", nullptr);
    return;
  }
  json.objects("ray", report.ray, [&](const NamedValue& entry) {
    json.member("name", entry.name).member("value", entry.value);
  });
  write_jam(json, file, report.jam);
}

std::string solve_json(const SceneFile& file, const HoldReport& hold, const PushReport& report) {
  JsonWriter json;
  json.begin_object();
  json.member("status", status_text(report.status)).member("solver", solver_text(report.solver));
  json.member("pivots", report.run.pivots).member("sweeps", report.run.sweeps);
  json.member("rounds", report.run.rounds);
  write_holds(json, file, hold);
  write_statement(json, "existence", existence_statement(file, report.existence));
  if (report.status != Status::solved) {
    write_failure(json, file, report);
    return json.end_object().text();
  }
  write_statement(json, "uniqueness", uniqueness_statement(report));
  json.key("unique").begin_object().member("motion", settled(report.unique_motion));
  json.member("wrench", settled(report.unique_wrench));
  json.member("paths_compared", report.paths_compared);
  json.key("final_basis").begin_object().member("studied", report.final_basis.studied);
  json.member("tied_contacts", report.final_basis.tied_contacts);
  json.member("motion_open", report.final_basis.motion_open);
  json.member("wrench_open", report.final_basis.wrench_open).end_object().end_object();
  write_residual(json, report.residuals);
  const Scene<double> scene = file.view();
  const double off = RoundDistance<double>(scene, report.scales, report.answer).worst().distance;
  json.member("off_round_cone", off);
  write_friction(json, file, report, off * report.scales.force);
  json.key("object").begin_object();
  json.member("acceleration", report.answer.acceleration).end_object();
  write_contacts(json, file, report);
  write_bodies(json, file, report);
  if (!report.sensitivity.empty()) write_sensitivity(json, file, report.sensitivity);
  return json.end_object().text();
}

std::string break_json(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  const bool solved = report.status == Status::solved;
  JsonWriter json;
  json.begin_object().member("status", status_text(report.status));
  write_holds(json, file, hold);
  write_grip(json, "smallest_grip", grip.alone, grip.force);
  json.member("holds_at_rest", when(solved || report.status == Status::does_not_hold, solved));
  write_grip(json, "smallest_grip_at_rest", grip.at_rest, grip.force);
  json.member("pusher", file.body_name(report.pusher));
  json.member("solver", solver_text(report.solver)).member("pivots", report.run.pivots);
  json.member("sweeps", report.run.sweeps).member("rounds", report.run.rounds);
  if (!solved) {
    write_failure(json, file, report);
    if (report.status == Status::does_not_hold) json.member("rest_acceleration", b.rest);
    return json.end_object().text();
  }
  write_friction(json, file, report, std::nullopt);
  json.member("breaks", b.breaks).member("break_force", when(b.breaks, b.break_force));
  json.member("force", b.force.head<3>()).member("moment", b.force.tail<3>());
  json.member("inertia_force", b.inertia.head<3>()).member("twist", b.twist);
  json.objects("closings", report.closings, [&](const NamedValue& closing) {
    json.member("name", closing.name).member("value", closing.value);
  });
  json.member("valid_to", when(!(b.valid_to < 0), b.valid_to)).member("line_error", b.line_error);
  json.key("unique").begin_object().member("motion", settled(report.unique_motion));
  json.member("force", settled(report.unique_force)).end_object();
  json.objects("others", report.others, [&](const OtherBreak& other) {
    json.member("break_force", other.break_force).member("force", other.force);
    json.member("twist", other.twist);
  });
  write_residual(json, b.residuals);
  return json.end_object().text();
}

} // namespace lcpush::desktop
