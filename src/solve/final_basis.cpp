#include "lcpush/desktop/final_basis.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "solve/contact_system.hpp"
#include "solve/noise.hpp"
#include "solve/rest_by_friction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lcpush::desktop {
namespace {

constexpr double strict = 1e-6; // of the scene's units: farther than this from a limit

enum class Regime {
  open,   ///< no force, moving apart
  smooth, ///< pressed, no friction
  stick,  ///< pressed, friction well inside its cone
  slide,  ///< pressed, friction on one generator
  tied,   ///< at the limit of two of these
};

struct Contact {
  Regime regime = Regime::tied;
  bool pressed = false;
  Vector6<double> force; // of a unit of lambda: with the friction that goes with it

  bool has_lambda() const { return pressed && regime != Regime::tied; }
};

class Study {
public:
  Study(const Assembly<double>& assembly, const Answer<double>& answer)
      : assembly_(assembly), scene_(assembly.scene()), layout_(assembly.layout()), answer_(answer) {
    const double fastest = std::max(1e-9 * layout_.scales.acceleration, fastest_contact(answer));
    margins_ = {strict * layout_.scales.force, strict * fastest};
  }

  /// What is tied keeps its force and its relative motion here, which is a part of what it might
  /// do.
  FinalBasis result() const {
    FinalBasis found;
    found.studied = true;
    ContactSystem system(assembly_);
    Index entry = 0;
    for (Index i = 0; i < layout_.points; ++i) {
      const Contact contact = classify(i, answer_.friction.data + entry);
      entry += layout_.cones[i].generators;
      if (contact.regime == Regime::tied) ++found.tied_contacts;
      add(i, contact, system);
    }
    const OpenDirections open = system.open_directions();
    found.motion_open = open.motion;
    found.wrench_open = open.wrench;
    return found;
  }

private:
  const Assembly<double>& assembly_;
  const Scene<double>& scene_;
  const Layout<double>& layout_;
  const Answer<double>& answer_;
  ContactMargins<double> margins_{};

  const Body<double>& body_of(Index i) const { return scene_.bodies[layout_.body[i]]; }

  void add(Index i, const Contact& contact, ContactSystem& system) const {
    if (contact.regime == Regime::open) return;
    const Vector6<double>& normal = assembly_.factored().wrenches[layout_.cones[i].force];
    if (contact.has_lambda())
      system.press(i, normal, contact.force);
    else
      system.stay(i, normal);
    const bool sticks = contact.regime == Regime::stick;
    if (!contact.pressed || !(sticks || contact.regime == Regime::tied)) return;
    for (const Vector6<double>& wrench : held_directions(i)) {
      system.stay(i, wrench);
      if (sticks) system.push(i, wrench);
    }
  }

  Contact classify(Index i, const double* beta) const {
    const ContactAnswer<double>& answer = answer_.contacts[i];
    const Body<double>& body = body_of(i);
    Contact contact;
    contact.force = assembly_.factored().wrenches[layout_.cones[i].force];
    const bool loaded = margins_.presses(answer);
    contact.pressed = loaded || body.bilateral;
    if (!contact.pressed) {
      contact.regime = margins_.opens(answer, body) ? Regime::open : Regime::tied;
    } else if (layout_.cones[i].generators == 0) {
      contact.regime = Regime::smooth;
    } else {
      contact.regime = loaded ? friction_regime(i, beta, contact) : Regime::tied;
    }
    return contact;
  }

  /// Stick, slide or tied; for slide the friction joins the contact's force column.
  Regime friction_regime(Index i, const double* beta, Contact& contact) const {
    const ContactAnswer<double>& answer = answer_.contacts[i];
    const ConeGroup<double>& cone = layout_.cones[i];
    const Body<double>& body = body_of(i);
    if (!(answer.slip > margins_.motion)) {
      std::vector<double> least(beta, beta + cone.generators); // of all that make this friction
      const Vector3<double> f = friction_of(body, answer);
      const double sum = body.torsion_radius > 0
                             ? std::accumulate(least.begin(), least.end(), 0.0)
                             : onto_neighbours(f[0], f[1], cone.generators, least.data());
      const double room = body.friction * std::abs(answer.normal_force) - sum;
      return room > margins_.force ? Regime::stick : Regime::tied;
    }
    Index active = -1;
    for (Index j = 0; j < cone.generators; ++j) {
      const Generator<double> d = generator(body, j, scene_.facets);
      const double w = answer.acceleration.dot(d.force) + answer.spin * d.torque + answer.slip;
      if (w > margins_.motion) continue;
      if (active >= 0) return Regime::tied; // between two generators
      active = j;
    }
    if (active < 0) return Regime::tied;
    const double sign = answer.normal_force < 0 ? -1 : 1;
    contact.force +=
        sign * body.friction * assembly_.factored().wrenches[cone.force + cone.normals + active];
    return Regime::slide;
  }

  /// Where point i cannot slide: along its face and, of a soft point, about its normal.
  std::vector<Vector6<double>> held_directions(Index i) const {
    const Body<double>& body = body_of(i);
    const Vector3<double> p = scene_.points[i] / layout_.scales.length;
    std::vector<Vector6<double>> held = {wrench_column<double>(p, body.tangent)};
    if (!body.in_plane) held.push_back(wrench_column<double>(p, cross(body.normal, body.tangent)));
    if (body.torsion_radius > 0) {
      held.emplace_back(Vector6<double>::Zero());
      held.back().tail<3>() = body.normal * (body.torsion_radius / layout_.scales.length);
    }
    return held;
  }
};

} // namespace

FinalBasis study_final_basis(const Assembly<double>& assembly, const Answer<double>& answer) {
  return Study(assembly, answer).result();
}

} // namespace lcpush::desktop
