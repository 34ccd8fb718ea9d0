#include <algorithm>

#include "lcpush/host/report.hpp"
#include "report_format.hpp"
#include "report_parts.hpp"

namespace lcpush::host {
namespace {

Scene<double> scene_of(const SceneFile& file) { return file.view(); }

/// Fingers come first.
bool has_pusher(const SceneFile& file) { return file.bodies.back().role == Role::pusher; }

/// "9.81 m/s^2 and 0 rad/s^2", without what rounding left of a zero.
std::string acceleration_text(const Vector6<double>& a, double length) {
  const double linear = a.head<3>().norm(), angular = a.tail<3>().norm();
  const double zero = 1e-9 * (linear + length * angular);
  return number(linear, zero) + " m/s^2 and " + number(angular, zero / length) + " rad/s^2";
}

std::string hold_line(const SceneFile& file, const HoldReport& hold) {
  const std::string label = "Before the push   ";
  if (file.bodies.front().role == Role::pusher) return label + "nothing grips the object.\n";
  if (!has_pusher(file)) return "Pusher            none: this is the grasp alone.\n";
  if (hold.status != Status::solved)
    return label + "not known: without the pusher the solve ended with \"" +
           status_text(hold.status) + "\".\n";
  if (hold.holds) return label + "the grasp holds the object.\n";
  return label + "the grasp does NOT hold the object: it accelerates at " +
         acceleration_text(hold.acceleration, hold.length) + ".\n";
}

std::string force_line(const char* label, const Vector3<double>& force, double zero) {
  const double size = force.norm();
  std::string text = std::string(label) + number(size, zero) + " N";
  if (size > zero) text += " along " + vector_text(force / size, 1e-9);
  return text + "\n";
}

std::string wrench_lines(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = scene_of(file);
  const double zero = 1e-9 * report.scales.force;
  std::string text;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    if (scene.bodies[b].role != Role::pusher) continue;
    const Vector6<double> wrench = body_wrench(scene, report.answer, scene.bodies[b]);
    std::string label = "Push by " + file.body_names[static_cast<std::size_t>(b)];
    label.resize(std::max<std::size_t>(label.size() + 1, 18), ' ');
    text += force_line(label.c_str(), wrench.head<3>(), zero);
    text += "                  moment about the centre of mass " +
            vector_text(wrench.tail<3>(), zero * report.scales.length) + " N m\n";
  }
  return text;
}

std::string motion_line(const SceneFile& file, const Motion<double>& motion, double length) {
  const Vector3<double> at = file.object.center_of_mass + motion.axis_point;
  const std::string axis = "about the axis " + vector_text(motion.axis, 1e-6) + " through " +
                           vector_text(at, 1e-9 * length) + " m";
  const std::string turning = number(motion.rotation) + " rad/s^2 " + axis;
  std::string verb;
  switch (motion.kind) {
  case MotionKind::rest: return "Motion            the object does not move in the grip.\n";
  case MotionKind::slide:
    return "Motion            slides: " + number(motion.translation) + " m/s^2 along " +
           vector_text(motion.direction, 1e-6) + "\n";
  case MotionKind::pivot: verb = "pivots in the grip: "; break;
  case MotionKind::roll: verb = "rolls on the surface that carries it: "; break;
  case MotionKind::turn: verb = "slides and turns: "; break;
  }
  std::string text = "Motion            " + verb + turning + "\n";
  if (std::abs(motion.pitch) > 1e-6 * length)
    text +=
        "                  advancing " + number(motion.pitch) + " m per rad along it (a screw)\n";
  return text;
}

std::string covers_words(Index covers) {
  return std::to_string(covers) + (covers == 1 ? " other cover" : " other covers");
}

/// `open` and `isolated`: what the final basis says.
std::string unique_words(Uniqueness unique, const PushReport& report, bool open, bool isolated) {
  const Index covers = report.covers_compared, tied = report.final_basis.tied_contacts;
  switch (unique) {
  case Uniqueness::yes: return "unique (proved: every normal force with friction is known)";
  case Uniqueness::no:
    return open ? "NOT unique: the final basis leaves it open"
                : "NOT unique: another cover leads to another answer";
  case Uniqueness::not_tested: return "not tested";
  case Uniqueness::none_other_found: break;
  }
  std::string text = "no other found";
  if (covers > 0) text += " under " + covers_words(covers);
  if (isolated) return text + (covers > 0 ? ", none next to it" : " next to it");
  if (report.final_basis.studied && tied > 0)
    text += "; " + std::to_string(tied) + (tied == 1 ? " contact is" : " contacts are") +
            " between two modes";
  return text;
}

std::string unique_lines(const SceneFile& file, const PushReport& report) {
  const FinalBasis& basis = report.final_basis;
  std::string text =
      "Answer            motion " +
      unique_words(report.unique_motion, report, basis.motion_open, basis.motion_isolated());
  if (has_pusher(file))
    text += ";\n                  push force " +
            unique_words(report.unique_wrench, report, basis.wrench_open, basis.wrench_isolated());
  return text + "\n";
}

const std::string next_line = "\n                  ";

/// "said: why", on two lines if it is long. What follows a semicolon is a line of its own.
std::string because(const std::string& said, std::string why) {
  const bool fits = said.size() + std::min(why.size(), why.find("; ")) <= 80;
  for (std::size_t at = why.find("; "); at != std::string::npos; at = why.find("; "))
    why.replace(at, 2, ";" + next_line);
  return said + (fits ? ": " : ":" + next_line) + why;
}

/// Which theorem covers the scene.
std::string theory_lines(const SceneFile& file, const PushReport& report) {
  const Statement exists = existence_statement(file, report.existence);
  std::string text =
      "Theory            " +
      because(exists.covered ? exists.statement : "no theorem promises an answer", exists.reason);
  if (report.status != Status::solved) return text + "\n";
  const Statement unique = uniqueness_statement(report);
  const std::string why = unique.reason.substr(0, unique.reason.find("; ")); // more stands above
  return text + ";" + next_line +
         because(unique.covered ? unique.statement : "no theorem says that it is the only one",
                 why) +
         "\n";
}

std::string contact_table(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = scene_of(file);
  const double zero_force = 1e-9 * report.scales.force;
  const double zero_motion = 1e-9 * report.scales.acceleration;
  std::vector<std::vector<std::string>> rows{
      {"contact", "mode", "normal N", "friction N", "along", "slip m/s^2", "opening m/s^2"}};
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    const Vector3<double>& n = scene.bodies[contact.body].normal;
    const double friction = contact.friction_force.norm(), opening = contact.acceleration.dot(n);
    rows.push_back(
        {point_name(file, i), mode_text(contact.mode), number(contact.normal_force, zero_force),
         number(friction, zero_force),
         friction > zero_force ? vector_text(contact.friction_force / friction, 1e-6) : "-",
         number((contact.acceleration - opening * n).norm(), zero_motion),
         number(opening, zero_motion)});
  }
  return table_text(rows);
}

std::string closing_lines(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = scene_of(file);
  std::string text;
  const auto add = [&](const std::string& name, double s) {
    if (std::abs(s) > 1e-9 * report.scales.acceleration)
      text += "  " + name + (s > 0 ? " closes at " : " is forced open at ") + number(std::abs(s)) +
              " m/s^2\n";
  };
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<double>& body = scene.bodies[b];
    if (scene.pressure != Pressure::even)
      add(file.body_names[static_cast<std::size_t>(b)], closing(report.answer, body));
    else
      for (Index k = body.first_point; k < body.first_point + body.point_count; ++k)
        add(point_name(file, k), report.answer.contacts[k].closing);
  }
  return text.empty() ? "" : "\nBodies whose actuators move them:\n" + text;
}

/// Soft points twist: their torque, and how fast they spin.
std::string torsion_lines(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = scene_of(file);
  const double zero = 1e-9 * report.scales.force * report.scales.length;
  std::string text;
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    if (!(scene.bodies[contact.body].torsion_radius > 0)) continue;
    text += "  " + point_name(file, i) + " twists the object with " +
            number(contact.torsion, zero) + " N m about its normal, against a spin of " +
            number(contact.spin, 1e-9 * report.scales.acceleration / report.scales.length) +
            " rad/s^2\n";
  }
  return text.empty() ? "" : "\nSoft contacts:\n" + text;
}

std::string run_line(const SceneFile& file, Solver solver, const PressureRun& run) {
  std::string text = solver == Solver::lemke    ? "Lemke: "
                     : solver == Solver::hybrid ? "Hybrid: "
                                                : "Gauss-Seidel: ";
  if (solver != Solver::lemke) text += std::to_string(run.sweeps) + " sweeps";
  if (solver == Solver::hybrid) text += " and ";
  if (solver != Solver::gauss_seidel) text += std::to_string(run.pivots) + " pivots";
  if (run.rounds > 0)
    text += " in " + std::to_string(run.rounds) + (run.rounds == 1 ? " round" : " rounds");
  if (run.cold_restarts > 0) text += ", " + std::to_string(run.cold_restarts) + " restarted cold";
  return text + "; pressure law " + pressure_name(file.pressure) + "; " +
         std::to_string(file.facets) + " facets.\n";
}

/// What one other cover has led to.
std::string break_unique_line(const BreakReport& report) {
  if (report.unique_force == Uniqueness::not_tested) return "";
  const bool same_force = report.unique_force != Uniqueness::no;
  const bool same_motion = report.unique_motion != Uniqueness::no;
  const std::string label = "Answer            ";
  if (same_force && same_motion) return label + "no other found under 1 other cover\n";
  return label + "NOT unique: another cover leads to another " +
         (same_motion  ? "force"
          : same_force ? "motion"
                       : "force and motion") +
         "\n";
}

} // namespace

std::string title_line(const SceneFile& file) {
  return file.title.empty() ? "" : file.title + "\n\n";
}

const char* pressure_name(Pressure pressure) {
  return pressure == Pressure::pad ? "pad" : pressure == Pressure::even ? "even" : "rigid";
}

std::string failure_text(const SceneFile& file, Status status, const std::string& reason,
                         const std::vector<NamedValue>& ray, const Jam& jam) {
  std::string text = std::string("NOT SOLVED (") + status_text(status) + "): " + reason + ".\n";
  if (!ray.empty()) {
    text += "\n";
    for (const std::string& sentence : jam_sentences(file, jam)) text += sentence + "\n";
    text += "\nThe ray, largest entry 1:\n";
  }
  for (const NamedValue& entry : ray) text += "  " + number(entry.value) + "  " + entry.name + "\n";
  return text;
}

std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report) {
  std::string text = title_line(file) + hold_line(file, hold);
  if (report.status != Status::solved) {
    return text + theory_lines(file, report) +
           failure_text(file, report.status, report.reason, report.ray, report.jam) + "\n" +
           run_line(file, report.solver, report.run);
  }
  text += wrench_lines(file, report) + motion_line(file, report.motion, report.scales.length);
  text += unique_lines(file, report) + theory_lines(file, report);
  if (file.pressure == Pressure::rigid)
    text += "                  (pressure = \"rigid\" leaves a patch's pressure open: one answer of "
            "a set)\n";
  if (file.pressure == Pressure::even && !file.planar)
    text += "                  (pressure = \"even\" cannot resist tilting: trust it where nothing "
            "tilts)\n";
  text += "\n" + contact_table(file, report) + torsion_lines(file, report);
  text += closing_lines(file, report);
  text += "\nLargest scaled residual " + residual_text(report.residuals.max()) +
          ", checked apart from the solver.\n" + run_line(file, report.solver, report.run);
  return text;
}

std::string break_text(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  const std::string pusher = file.body_names[static_cast<std::size_t>(report.pusher)];
  std::string text = title_line(file) + grip_text(hold_line(file, hold), hold, grip, report);
  if (report.status == Status::does_not_hold)
    return text + "DOES NOT HOLD: even with the pusher in place the object accelerates at " +
           acceleration_text(b.rest, report.scales.length) +
           " before it is pushed,\nso there is no force that just breaks the grasp.\n\n" +
           run_line(file, report.solver, report.run);
  if (report.status != Status::solved)
    return text + failure_text(file, report.status, report.reason, report.ray, report.jam) + "\n" +
           run_line(file, report.solver, report.run);
  const double zero = 1e-9 * report.scales.force;
  text += "Breaking force    " + number(b.break_force, zero) + " N, normal force of " + pusher +
          " when the object starts to move in the grip\n";
  text += force_line("Whole force       ", b.force.head<3>(), zero);
  text += "                  moment about the centre of mass " +
          vector_text(b.force.tail<3>(), zero * report.scales.length) + " N m\n";
  text += "Pushing faster    adds " + number(b.inertia_normal, 1e-9 * file.object.mass) +
          " N to the normal force per m/s^2 of the push\n";
  text += motion_line(file, report.motion, report.scales.length);
  if (report.motion.kind != MotionKind::rest)
    text += "                  per m/s^2 of the push\n";
  else if (b.break_force > zero)
    text += "                  The pusher slides past it, however weak the push.\n";
  else
    text += "                  The pusher only touches it, or moves away.\n";
  text += break_unique_line(report);
  if (b.valid_to > 0) text += "Valid up to       a push of " + number(b.valid_to) + " m/s^2\n";
  if (b.line_error > 1e-6)
    text += "Caution           a third, smaller push lies " + number(b.line_error) +
            " of the grip force off the line through two\n";
  return text + "\nLargest scaled residual " + residual_text(b.residuals.max()) +
         ", checked apart from the solver.\n" + run_line(file, report.solver, report.run);
}

} // namespace lcpush::host
