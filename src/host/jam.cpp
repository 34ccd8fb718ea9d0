#include "lcpush/host/jam.hpp"

#include <algorithm>
#include <cmath>

#include "lcpush/host/push.hpp"
#include "message.hpp"
#include "report_format.hpp"

namespace lcpush::host {
namespace {

constexpr double noise = 1e-9; // of a ray's largest entry

std::string name_of_body(const SceneFile& file, Index body) {
  return file.body_names[static_cast<std::size_t>(body)];
}

Index file_body(const SceneFile& file, Index point) {
  Index b = 0;
  while (point >= file.bodies[static_cast<std::size_t>(b)].first_point +
                      file.bodies[static_cast<std::size_t>(b)].point_count)
    ++b;
  return b;
}

bool moves(const Body<double>& body) { return body.acceleration.norm() > 0; }

bool solves(const SceneFile& changed) {
  Push push(changed);
  PushOptions options;
  options.other_covers = 0;
  options.explain_jams = false;
  return push.solve(options).status == Status::solved;
}

/// The scene with this body force-controlled along its normal.
SceneFile with_force(const SceneFile& file, Index body, double force) {
  SceneFile changed = file;
  Vector6<double> along = Vector6<double>::Zero();
  along.head<3>() = file.bodies[static_cast<std::size_t>(body)].normal;
  changed.drives.push_back({body, static_cast<Index>(changed.actuators.size()), along});
  changed.actuators.push_back({force, 0});
  changed.actuator_names.push_back(name_of_body(file, body));
  return changed;
}

/// A motion as fast as the body's, across the force that it squeezes with.
Vector3<double> across(const Body<double>& body, const Vector3<double>& force) {
  const Vector3<double> push = body.acceleration.head<3>(), along = force.normalized();
  const Vector3<double> rest = push - push.dot(along) * along;
  const bool has_rest = rest.norm() > 1e-6 * push.norm();
  const Vector3<double> side = has_rest ? rest : body.tangent - body.tangent.dot(along) * along;
  return side.norm() > 0 ? Vector3<double>(push.norm() * side.normalized()) : side;
}

void find_remedies(const SceneFile& file, const Assembly<double>& assembly,
                   const std::vector<Squeeze<double>>& bodies, bool try_them, Jam& jam) {
  const double force = std::max(assembly.layout().scales.force, 1e-3 * file.object.mass);
  const auto add = [&](const std::string& text, const SceneFile& changed) {
    jam.remedies.push_back({text, try_them, try_them && solves(changed)});
  };
  for (const JamBody& squeezing : jam.bodies) {
    const Index b = squeezing.body;
    const Body<double>& body = file.bodies[static_cast<std::size_t>(b)];
    const std::string name = name_of_body(file, b);
    if (!is_driven(file.view(), b))
      add(body.role == Role::finger ? name + " held by a force instead of fixed (grip_force)"
                                    : name + " pressing with a force instead of moving along its "
                                             "normal (normal_force)",
          with_force(file, b, force));
    const Vector3<double> side = across(body, bodies[static_cast<std::size_t>(b)].wrench.head<3>());
    if (!(squeezing.power > 0) || !(body.acceleration.head<3>().norm() > 0) || side.isZero(0))
      continue;
    SceneFile changed = file;
    changed.bodies[static_cast<std::size_t>(b)].acceleration.head<3>() = side;
    add(name + " moving across the squeeze, for example with acceleration " +
            vector_text(side, 1e-9 * side.norm()),
        changed);
  }
}

} // namespace

Jam explain_jam(const SceneFile& file, const Assembly<double>& assembly, const double* v,
                bool try_remedies) {
  const Scene<double>& scene = assembly.scene();
  std::vector<Squeeze<double>> parts(static_cast<std::size_t>(scene.bodies.size));
  read_ray(assembly, v, {parts.data(), scene.bodies.size});
  // Under even pressure a body of the file is several of the scene.
  std::vector<Squeeze<double>> bodies(file.bodies.size());
  for (Squeeze<double>& body : bodies) body.wrench.setZero();
  for (Index k = 0; k < scene.bodies.size; ++k) {
    const Squeeze<double>& part = parts[static_cast<std::size_t>(k)];
    Squeeze<double>& whole =
        bodies[static_cast<std::size_t>(file_body(file, scene.bodies[k].first_point))];
    whole.wrench += part.wrench;
    whole.normal += part.normal;
    whole.friction += part.friction;
    whole.power += part.power;
    whole.runs_away = whole.runs_away || part.runs_away;
  }
  double largest = 0;
  for (const Squeeze<double>& body : bodies) largest = std::max(largest, body.normal);
  Jam jam;
  for (Index b = 0; b < static_cast<Index>(bodies.size()); ++b) {
    const Squeeze<double>& part = bodies[static_cast<std::size_t>(b)];
    if (part.runs_away) jam.running_away.push_back(name_of_body(file, b));
    if (!(part.normal > noise * largest)) continue;
    JamBody squeezing{b, part.normal / largest, part.power / largest, {}};
    const Body<double>& body = file.bodies[static_cast<std::size_t>(b)];
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
      if (std::abs(assembly.layout().cones[i].normal_force(v)) > noise * largest)
        squeezing.points.push_back(point_name(file, i));
    jam.uses_friction = jam.uses_friction || part.friction > noise * largest;
    jam.bodies.push_back(squeezing);
  }
  find_remedies(file, assembly, bodies, try_remedies, jam);
  return jam;
}

std::vector<std::string> jam_sentences(const SceneFile& file, const Jam& jam) {
  if (jam.bodies.empty()) {
    if (jam.running_away.empty()) return {"Nothing is pressed, and no actuator runs away."};
    return {
        "Nothing is pressed: the actuator of " + listed(jam.running_away, "and") +
        " closes without end, as no contact that it drives resists it. Give it an inertia, or a "
        "twist along the contact's normal."};
  }
  std::vector<std::string> movers, others, sentences;
  for (const JamBody& squeezing : jam.bodies) {
    const Body<double>& body = file.bodies[static_cast<std::size_t>(squeezing.body)];
    const std::string how = is_driven(file.view(), squeezing.body)
                                ? " (driven by a force that the squeeze does not load)"
                            : moves(body) ? " (moves as prescribed)"
                                          : " (fixed)";
    const std::string who =
        name_of_body(file, squeezing.body) + how + " at " + listed(squeezing.points, "and");
    (squeezing.power > 0 ? movers : others).push_back(who);
  }
  if (others.empty())
    sentences.push_back("A jam: " + listed(movers, "and") +
                        " squeeze the object between them, and nothing gives way.");
  else
    sentences.push_back("A jam: " + listed(movers, "and") +
                        (movers.size() == 1 ? " squeezes" : " squeeze") + " the object against " +
                        listed(others, "and") + ", and nothing gives way.");
  sentences.push_back(
      jam.uses_friction
          ? "Friction takes part in the squeeze: a strong sign of a wedge, but no proof that there "
            "is no answer."
          : "No friction takes part, so there is no answer: no force, however large, makes rigid "
            "bodies give way.");
  if (!jam.running_away.empty())
    sentences.push_back("The actuator of " + listed(jam.running_away, "and") +
                        " closes without end.");
  if (!jam.remedies.empty()) sentences.push_back("What would free it:");
  for (const Remedy& remedy : jam.remedies)
    sentences.push_back("- " + remedy.text +
                        (!remedy.tried  ? ""
                         : remedy.works ? ": tried, it does"
                                        : ": tried, not by itself"));
  return sentences;
}

} // namespace lcpush::host
