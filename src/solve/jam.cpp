#include "lcpush/desktop/jam.hpp"

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/owned.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "solve/word_settings.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr double negligible = word_settings.component;

bool moves(const Body<double>& body) { return body.acceleration.norm() > 0; }

/// The scene with this body force-controlled along its normal.
SceneFile with_force(const SceneFile& file, Index body, double force) {
  SceneFile changed = file;
  Vector6<double> along = Vector6<double>::Zero();
  along.head<3>() = file.body(body).normal;
  changed.drives.push_back({body, static_cast<Index>(changed.actuators.size()), along});
  changed.actuators.push_back({force, 0});
  changed.actuator_names.push_back(file.body_name(body));
  return changed;
}

/// The direction in the body's face that is most across the force; in a planar scene, the one in
/// the plane. It does not tighten the squeeze.
Vector3<double> sideways(const Body<double>& body, const Vector3<double>& force, bool planar) {
  const Vector3<double> other = cross(body.normal, body.tangent);
  const auto wrong = [&](const Vector3<double>& direction) {
    return planar ? std::abs(direction[2]) : std::abs(direction.dot(force)) / force.norm();
  };
  const bool swap = wrong(other) < wrong(body.tangent) - negligible;
  const Vector3<double> side = swap ? other : body.tangent;
  return side.dot(force) > negligible * force.norm() ? Vector3<double>(-side) : side;
}

/// A motion as fast as the body's, across the force that it squeezes with and along its own face:
/// beside an oblique force, across the force alone might lead into the object.
Vector3<double> across(const Body<double>& body, const Vector3<double>& force, bool planar) {
  const auto along_face = [&](const Vector3<double>& x) {
    return Vector3<double>(x - x.dot(body.normal) * body.normal);
  };
  const Vector3<double> push = body.acceleration.head<3>(), drag = along_face(force);
  Vector3<double> side = along_face(push);
  if (drag.norm() > negligible * force.norm()) side -= side.dot(drag) / drag.squaredNorm() * drag;
  if (!(side.norm() > negligible * push.norm())) side = sideways(body, force, planar);
  return push.norm() * side.normalized();
}

void find_remedies(const SceneFile& file, const Assembly<double>& assembly,
                   const std::vector<Squeeze<double>>& bodies, const TryScene& solves, Jam& jam) {
  const double force =
      std::max(assembly.layout().scales.force, word_settings.least_remedy * file.object.mass);
  const auto add = [&](const std::string& text, const SceneFile& changed) {
    jam.remedies.push_back({text, solves != nullptr, solves != nullptr && solves(changed)});
  };
  for (const JamBody& squeezing : jam.bodies) {
    const Index b = squeezing.body;
    const Body<double>& body = file.body(b);
    const std::string name = file.body_name(b);
    if (!is_driven(file.view(), b))
      add(body.role == Role::finger
              ? name + " held by a force instead of fixed (grip_force)"
              : name + " pressing with a force instead of moving along its normal (normal_force)",
          with_force(file, b, force));
    const Vector3<double> push = body.acceleration.head<3>();
    if (!(squeezing.power > 0) || !(push.norm() > 0)) continue;
    const Vector3<double> side =
        across(body, bodies[static_cast<std::size_t>(b)].wrench.head<3>(), file.planar);
    if ((side - push).norm() <= negligible * push.norm()) continue; // as it moves already
    SceneFile changed = file;
    changed.bodies[static_cast<std::size_t>(b)].acceleration.head<3>() = side;
    add(name + " moving across the squeeze, for example with acceleration " +
            vector_text(side, word_settings.rounding * side.norm()),
        changed);
  }
}

/// Sums up what even pressure splits: there a body of the file is several of the scene.
std::vector<Squeeze<double>> by_file_body(const SceneFile& file, const Scene<double>& scene,
                                          const std::vector<Squeeze<double>>& parts) {
  std::vector<Squeeze<double>> bodies(file.bodies.size());
  for (Squeeze<double>& body : bodies) body.wrench.setZero();
  for (Index k = 0; k < scene.bodies.size; ++k) {
    const Squeeze<double>& part = parts[static_cast<std::size_t>(k)];
    Squeeze<double>& whole =
        bodies[static_cast<std::size_t>(file.body_of(scene.bodies[k].first_point))];
    whole.wrench += part.wrench;
    whole.normal += part.normal;
    whole.friction += part.friction;
    whole.power += part.power;
    whole.runs_away = whole.runs_away || part.runs_away;
  }
  return bodies;
}

/// The body's points with a normal force, also one that presses and pulls alike.
std::vector<std::string> pressed_points(const SceneFile& file, const Body<double>& body,
                                        const Layout<double>& layout, const double* v,
                                        double noise) {
  std::vector<std::string> points;
  for (const Index i : points_of(body)) {
    const ConeGroup<double>& cone = layout.cones[i];
    const double* forces = v + cone.variable;
    if (*std::max_element(forces, forces + cone.normals) > noise)
      points.push_back(point_name(file, i));
  }
  return points;
}

/// "wall (moves as prescribed) at wall.1".
std::string described(const SceneFile& file, const Jam& jam, const JamBody& squeezing) {
  const char* how = moves(file.body(squeezing.body)) ? " (moves as prescribed)" : " (fixed)";
  if (is_driven(file.view(), squeezing.body))
    how = jam.loads_actuators ? " (driven by a force)"
                              : " (driven by a force that the squeeze does not load)";
  return file.body_name(squeezing.body) + how + " at " + listed(squeezing.points, "and");
}

/// Who squeezes whom, without a full stop. Some body does, and some motion tightens it.
std::string who_squeezes(const SceneFile& file, const Jam& jam) {
  std::vector<std::string> movers, others;
  for (const JamBody& squeezing : jam.bodies)
    (squeezing.power > 0 ? movers : others).push_back(described(file, jam, squeezing));
  const std::string who = listed(movers, "and"), verb = movers.size() == 1 ? "squeezes" : "squeeze";
  if (!others.empty()) return who + " " + verb + " the object against " + listed(others, "and");
  if (movers.size() > 1) return who + " squeeze the object between them";
  // Forces of a single normal balance only if the plane takes what leans out of it.
  return file.planar ? who + " wedges the object against the plane that it is held in"
                     : who + " squeezes the object alone: check the scene";
}

/// What the squeeze is and what it proves.
std::vector<std::string> squeeze_sentences(const SceneFile& file, const Jam& jam) {
  const std::string no_proof = "These pivots found no answer; that is no proof that there is none.";
  const bool tightens = std::any_of(jam.bodies.begin(), jam.bodies.end(),
                                    [](const JamBody& body) { return body.power > 0; });
  if (!tightens) {
    std::vector<std::string> all;
    for (const JamBody& squeezing : jam.bodies) all.push_back(described(file, jam, squeezing));
    return {"The object is squeezed by " + listed(all, "and") +
                ": no prescribed motion tightens it, and nothing relieves it.",
            no_proof};
  }
  if (jam.no_answer)
    return {"A jam: " + who_squeezes(file, jam) + ", and nothing gives way.",
            "No friction takes part, so there is no answer: no force, however large, makes rigid "
            "bodies give way."};
  return {"It looks like a jam: " + who_squeezes(file, jam) + ".",
          jam.uses_friction ? "These pivots found no answer; friction takes part, so that is a "
                              "strong sign of a wedge but no proof that there is none."
                            : no_proof};
}

} // namespace

Jam explain_jam(const SceneFile& file, const Assembly<double>& assembly, const double* v,
                const TryScene& solves) {
  const Scene<double>& scene = assembly.scene();
  const Layout<double>& layout = assembly.layout();
  std::vector<Squeeze<double>> parts(static_cast<std::size_t>(scene.bodies.size));
  const RaySum<double> sum = read_ray(assembly, v, span_of(parts));
  const std::vector<Squeeze<double>> bodies = by_file_body(file, scene, parts);
  double largest = 0;
  for (const Squeeze<double>& body : bodies) largest = std::max(largest, body.normal);
  Jam jam;
  jam.no_answer = sum.proves_no_answer();
  jam.uses_friction = sum.friction > 0;
  jam.loads_actuators = sum.load > sum.noise;
  for (Index b = 0; b < static_cast<Index>(bodies.size()); ++b) {
    const Squeeze<double>& part = bodies[static_cast<std::size_t>(b)];
    if (part.runs_away) jam.running_away.push_back(file.body_name(b));
    if (!(part.normal > 0)) continue;
    const bool works = std::abs(part.power) > sum.noise * sum.motion;
    jam.bodies.push_back({b, part.normal / largest, works ? part.power / largest : 0.0,
                          pressed_points(file, file.body(b), layout, v, sum.noise)});
  }
  find_remedies(file, assembly, bodies, solves, jam);
  return jam;
}

std::vector<std::string> jam_findings(const SceneFile& file, const Jam& jam) {
  if (jam.bodies.empty()) {
    if (jam.running_away.empty()) return {"Nothing is pressed, and no actuator runs away."};
    return {"Nothing is pressed: the actuator of " + listed(jam.running_away, "and") +
            " closes without end, as no contact that it drives resists it. Give it an inertia, or "
            "a twist along the contact's normal."};
  }
  std::vector<std::string> sentences = squeeze_sentences(file, jam);
  if (!jam.running_away.empty())
    sentences.push_back("The actuator of " + listed(jam.running_away, "and") +
                        " closes without end.");
  if (!jam.remedies.empty()) sentences.push_back("What may free it:");
  return sentences;
}

std::vector<std::string> jam_remedies(const Jam& jam) {
  std::vector<std::string> sentences;
  for (const Remedy& remedy : jam.remedies) {
    const char* tried = remedy.works ? ": tried, it does" : ": tried, not by itself";
    sentences.push_back(remedy.text + (remedy.tried ? tried : ""));
  }
  return sentences;
}

std::vector<std::string> jam_sentences(const SceneFile& file, const Jam& jam) {
  std::vector<std::string> sentences = jam_findings(file, jam);
  for (const std::string& remedy : jam_remedies(jam)) sentences.push_back("- " + remedy);
  return sentences;
}

} // namespace lcpush::desktop
