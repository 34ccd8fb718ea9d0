#include "solve/noise.hpp"

#include <algorithm>

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/laws.hpp"
#include "solve/word_settings.hpp"

namespace lcpush::desktop {
namespace {

/// What rounding leaves of the largest force, as a part of it.
double rounding_of_force() {
  const Tolerances<double> tolerances;
  return tolerances.residual * tolerances.noise;
}

/// N: what the actuator asks of its points.
double held_force(const Scene<double>& scene, Index actuator) {
  double reach = 0;
  for (const Drive<double>& drive : scene.drives)
    if (drive.actuator == actuator) reach = std::max(reach, drive_reach(scene, drive));
  return std::abs(scene.actuators[actuator].force) / (reach > 0 ? reach : 1.0);
}

/// N: F, or less where some load is small beside it.
double load_size(const SceneFile& file, const Scales<double>& scales) {
  const Scene<double> scene = file.view();
  double smallest = scales.force;
  const auto note = [&](double load) {
    if (load > 0) smallest = std::min(smallest, load);
  };
  note(file.object.mass * file.gravity.norm());
  note(file.object.wrench.head<3>().norm());
  note(file.object.wrench.tail<3>().norm() / scales.length);
  for (Index a = 0; a < scene.actuators.size; ++a) note(held_force(scene, a));
  return std::min(scales.force, smallest / word_settings.smallest_load);
}

} // namespace

Noise noise_below(const SceneFile& file, const Scales<double>& scales, double part) {
  const double force = std::max(rounding_of_force() * scales.force, part * load_size(file, scales));
  return {force, force * scales.length, force / file.object.mass, part * scales.length};
}

double fastest_contact(const Answer<double>& answer) {
  double fastest = 0;
  for (const ContactAnswer<double>& contact : answer.contacts)
    fastest = std::max(fastest, contact.acceleration.norm());
  return fastest;
}

void find_noise(const SceneFile& file, const Answer<double>& answer, RunReport& report) {
  report.noise = noise_below(file, report.scales, word_settings.rounding);
  report.brief_noise = noise_below(file, report.scales, word_settings.table);
  // Where nothing moves, the fastest is rounding's.
  report.brief_noise.acceleration =
      std::max(report.noise.acceleration, word_settings.table * fastest_contact(answer));
}

void clear_noise(const SceneFile& file, const Scales<double>& scales, const Noise& noise,
                 Answer<double>& answer) {
  const Scene<double> scene = file.view();
  if (size_of_twist(answer.acceleration, scales.length) <= noise.acceleration)
    answer.acceleration.setZero();
  for (Index i = 0; i < answer.contacts.size; ++i) {
    ContactAnswer<double>& contact = answer.contacts[i];
    const double spin = scene.bodies[contact.body].torsion_radius * std::abs(contact.spin);
    if (contact.acceleration.norm() + spin + clearance_of(scene, i) <= noise.acceleration)
      contact.mode = Mode::stick;
    if (contact.acceleration.norm() <= noise.acceleration) contact.acceleration.setZero();
  }
}

Index lost_actuator(const SceneFile& file, const Scales<double>& scales) {
  const Scene<double> scene = file.view();
  for (Index a = 0; a < scene.actuators.size; ++a) {
    const double force = held_force(scene, a);
    if (force > 0 && force <= rounding_of_force() * scales.force) return a;
  }
  return -1;
}

double lost_load(const SceneFile& file, const Scales<double>& scales, double residual) {
  const Vector6<double> w = laws::load(file.view(), {1.0, 1.0, 1.0});
  const double load = std::max(w.head<3>().norm(), w.tail<3>().norm() / scales.length);
  return load <= word_settings.load_digits * residual * scales.force ? load : 0;
}

bool is_too_slow(double push, const Scales<double>& scales, double beside) {
  const double least =
      scales.acceleration * std::max(word_settings.slowest_push * rounding_of_force(),
                                     word_settings.push_digits * beside);
  return push > 0 && !(push >= least);
}

} // namespace lcpush::desktop
