// What each contact does, as rows of a table and as sentences.
#include <algorithm>

#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "solve/told_force.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {

std::vector<std::vector<std::string>> brief_contact_rows(const SceneFile& file,
                                                         const PushReport& report) {
  const Scene<double> scene = file.view();
  const auto digits = [](double x, double zero) { return brief(std::abs(x) <= zero ? 0 : x); };
  double fastest = 0, widest = 0;
  for (const ContactAnswer<double>& contact : report.answer.contacts) {
    fastest = std::max(fastest, contact.acceleration.norm());
    widest = std::max(widest, contact.acceleration.dot(scene.bodies[contact.body].normal));
  }
  // Where nothing moves, the fastest is rounding's.
  const double told = told_force(file, report.scales);
  const double zero_motion = std::max(1e-6 * fastest, 1e-9 * told / file.object.mass);
  const double zero_force = shown_as_nothing(file, report.scales);
  const bool opens = widest > zero_motion;
  std::vector<std::vector<std::string>> rows{
      {"contact", "does", "normal N", "friction N", "along", "slip m/s^2"}};
  if (opens) rows.front().emplace_back("opening m/s^2");
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    const Vector3<double>& n = scene.bodies[contact.body].normal;
    const double friction = contact.friction_force.norm(), opening = contact.acceleration.dot(n);
    const bool rubs = friction > zero_force;
    rows.push_back({point_name(file, i), mode_verb(contact.mode),
                    digits(contact.normal_force, zero_force), digits(friction, zero_force),
                    rubs ? direction_text(contact.friction_force / friction) : "-",
                    digits((contact.acceleration - opening * n).norm(), zero_motion)});
    if (opens) rows.back().push_back(digits(opening, zero_motion));
  }
  return rows;
}

std::vector<std::vector<std::string>> contact_rows(const SceneFile& file,
                                                   const PushReport& report) {
  const Scene<double> scene = file.view();
  const double zero_force = 1e-9 * told_force(file, report.scales);
  const double zero_motion = zero_force / file.object.mass;
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
  return rows;
}

std::vector<std::string> closing_sentences(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  const double zero_motion = 1e-9 * told_force(file, report.scales) / file.object.mass;
  std::vector<std::string> list;
  const auto add = [&](const std::string& name, double s) {
    if (std::abs(s) > zero_motion)
      list.push_back(name + (s > 0 ? " closes at " : " is forced open at ") + number(std::abs(s)) +
                     " m/s^2");
  };
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<double>& body = scene.bodies[b];
    if (scene.pressure != Pressure::even)
      add(file.body_name(b), mean_closing(report.answer, body));
    else
      for (const Index i : points_of(body))
        add(point_name(file, i), report.answer.contacts[i].closing_acceleration);
  }
  return list;
}

std::vector<std::string> torsion_sentences(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  const double zero = 1e-9 * report.scales.force * report.scales.length;
  std::vector<std::string> list;
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    if (!(scene.bodies[contact.body].torsion_radius > 0)) continue;
    list.push_back(point_name(file, i) + " twists the object with " +
                   number(contact.torsion, zero) + " N m about its normal, against a spin of " +
                   number(contact.spin, 1e-9 * report.scales.acceleration / report.scales.length) +
                   " rad/s^2");
  }
  return list;
}

} // namespace lcpush::desktop
