#include "spread/spread_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "solve/noise.hpp"
#include "solve/word_settings.hpp"
#include "spread/settings.hpp"

namespace lcpush::desktop {
namespace {

SpreadVerdict verdict_on(const SpreadReport& report) {
  const double length = report.scales.length, force = same_force(report);
  for (Index k = 0; k < 6; ++k)
    if (!is_single(report.twist[k], same_acceleration(report) / (k < 3 ? 1 : length)))
      return SpreadVerdict::ambiguous;
  for (const ContactSpread& contact : report.contacts)
    if (!is_single(contact.normal, force) || !is_single(contact.tangential[0], force) ||
        !is_single(contact.tangential[1], force) || !is_single(contact.torsion, force * length))
      return SpreadVerdict::same_motion;
  return SpreadVerdict::unique;
}

} // namespace

SpreadReport begin_report(const LiteralProblem& problem, bool breaking) {
  SpreadReport report;
  report.breaking = breaking;
  report.scales = problem.layout().scales;
  report.noise = noise_below(problem.file(), report.scales, word_settings.rounding);
  if (breaking) report.noise.acceleration = word_settings.rounding;
  report.contacts.resize(static_cast<std::size_t>(problem.layout().points));
  for (Index b = 0; b < problem.scene().bodies.size; ++b)
    if (problem.scene().bodies[b].role == Role::pusher) report.pushers.push_back({b, {}});
  return report;
}

std::vector<Quantity> list_quantities(const LiteralProblem& problem, SpreadReport& report) {
  std::vector<Quantity> quantities;
  const Layout<double>& layout = problem.layout();
  const double force = layout.scales.force, length = layout.scales.length;
  const auto of = [&](Interval& bounds, double unit) {
    return Quantity{&bounds, Eigen::VectorXd::Zero(layout.size), false, unit, 0};
  };
  const auto add_normal = [&](Index i, Eigen::VectorXd& f) {
    for (Index k = 0; k < layout.cones[i].normals; ++k)
      f[layout.normal_index(i) + k] = k == 0 ? 1 : -1;
  };
  for (PusherSpread& pusher : report.pushers) {
    Quantity push = of(pusher.force, force);
    for (Index i = 0; i < layout.points; ++i)
      if (layout.body[i] == pusher.body) add_normal(i, push.f);
    quantities.push_back(push);
  }
  for (Index k = 0; k < problem.moving(); ++k) {
    const Index axis = problem.axis(k);
    Quantity twist = of(report.twist[axis], layout.scales.acceleration / (axis < 3 ? 1 : length));
    twist.f = problem.effects().row(k).transpose();
    twist.load = problem.load()[k];
    twist.is_motion = true;
    if (twist.f.norm() > 0) quantities.push_back(twist);
  }
  for (Index i = 0; i < layout.points; ++i) {
    const Body<double>& body = problem.scene().bodies[layout.body[i]];
    ContactSpread& spread = report.contacts[static_cast<std::size_t>(i)];
    Quantity normal = of(spread.normal, force);
    add_normal(i, normal.f);
    quantities.push_back(normal);
    if (layout.cones[i].generators == 0) continue;
    Quantity along = of(spread.tangential[0], force), across = of(spread.tangential[1], force);
    Quantity torsion = of(spread.torsion, force * length);
    for (Index j = 0; j < layout.cones[i].generators; ++j) {
      const Generator<double> d = generator(body, j, problem.scene().facets);
      along.f[layout.friction_index(i, j)] = d.force.dot(body.tangent);
      across.f[layout.friction_index(i, j)] = d.force.dot(cross(body.normal, body.tangent));
      torsion.f[layout.friction_index(i, j)] = d.torque / length;
    }
    quantities.push_back(along);
    if (!body.in_plane) quantities.push_back(across);
    if (body.torsion_radius > 0) quantities.push_back(torsion);
  }
  return quantities;
}

void include(const Answer<double>& answer, const Scene<double>& scene, SpreadReport& report) {
  for (Index k = 0; k < 6; ++k) report.twist[k].include(answer.acceleration[k]);
  include_forces(answer, scene, report);
}

void include_forces(const Answer<double>& answer, const Scene<double>& scene,
                    SpreadReport& report) {
  for (PusherSpread& pusher : report.pushers)
    pusher.force.include(normal_sum(answer, scene.bodies[pusher.body]));
  for (Index i = 0; i < answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = answer.contacts[i];
    const Body<double>& body = scene.bodies[contact.body];
    ContactSpread& spread = report.contacts[static_cast<std::size_t>(i)];
    spread.normal.include(contact.normal_force);
    spread.tangential[0].include(contact.friction_force.dot(body.tangent));
    spread.tangential[1].include(contact.friction_force.dot(cross(body.normal, body.tangent)));
    spread.torsion.include(contact.torsion);
  }
}

void conclude(double push, SpreadReport& report) {
  for (Index k = 0; k < 6; ++k) {
    const double lever = k < 3 ? 1 : report.scales.length;
    for (double* const x : {&report.twist[k].low, &report.twist[k].high}) {
      if (std::abs(*x) * lever <= report.noise.acceleration) *x = 0;
      if (std::isfinite(*x)) report.motion = std::max(report.motion, std::abs(*x) * lever);
    }
  }
  const auto let_be_zero = [](Interval& interval, double noise) {
    for (double* const x : {&interval.low, &interval.high})
      if (std::abs(*x) <= noise) *x = 0;
  };
  for (PusherSpread& pusher : report.pushers) let_be_zero(pusher.force, report.noise.force);
  for (ContactSpread& contact : report.contacts) {
    for (Interval* const force : {&contact.normal, contact.tangential, contact.tangential + 1})
      let_be_zero(*force, report.noise.force);
    let_be_zero(contact.torsion, report.noise.moment);
  }
  report.motion = std::max(report.motion, push);
  report.verdict = verdict_on(report);
}

bool is_wider(const SpreadReport& wider, const SpreadReport& than) {
  constexpr double counts = SpreadSettings::wider;
  const auto exceeds = [](const Interval& one, const Interval& two, double slack) {
    return one.low < two.low - slack || one.high > two.high + slack;
  };
  const double force = counts * than.scales.force;
  for (std::size_t k = 0; k < wider.pushers.size(); ++k)
    if (exceeds(wider.pushers[k].force, than.pushers[k].force, force)) return true;
  for (std::size_t i = 0; i < wider.contacts.size(); ++i)
    if (exceeds(wider.contacts[i].normal, than.contacts[i].normal, force)) return true;
  for (Index k = 0; k < 6; ++k) {
    const Interval& one = wider.twist[k];
    const double size = std::max(std::abs(one.low), std::abs(one.high));
    if (exceeds(one, than.twist[k], counts * std::max(size, than.scales.acceleration))) return true;
  }
  return false;
}

} // namespace lcpush::desktop
