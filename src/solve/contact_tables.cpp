// What each contact does, as rows of a table and as sentences.
#include <algorithm>

#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "solve/word_settings.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {

TableRows contact_rows(const SceneFile& file, const PushReport& report, Telling telling) {
  const Scene<double> scene = file.view();
  const bool is_full = telling == Telling::full;
  const Noise& noise = is_full ? report.noise : report.brief_noise;
  const auto digits = [&](double x, double zero) {
    return is_full ? number(x, zero) : brief(x, zero);
  };
  const auto opening_of = [&](const ContactAnswer<double>& contact) {
    return contact.acceleration.dot(scene.bodies[contact.body].normal);
  };
  const bool opens =
      is_full || std::any_of(report.answer.contacts.begin(), report.answer.contacts.end(),
                             [&](const auto& c) { return opening_of(c) > noise.acceleration; });
  TableRows rows{
      {"contact", is_full ? "mode" : "does", "normal N", "friction N", "along", "slip m/s^2"}};
  if (opens) rows.front().emplace_back("opening m/s^2");
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    const Vector3<double>& n = scene.bodies[contact.body].normal;
    const double friction = contact.friction_force.norm(), opening = opening_of(contact);
    std::string along = "-";
    if (friction > noise.force)
      along = is_full ? vector_text(contact.friction_force / friction, word_settings.component)
                      : direction_text(contact.friction_force / friction);
    rows.push_back({point_name(file, i),
                    is_full ? mode_text(contact.mode) : mode_verb(contact.mode),
                    digits(contact.normal_force, noise.force), digits(friction, noise.force), along,
                    digits((contact.acceleration - opening * n).norm(), noise.acceleration)});
    if (opens) rows.back().push_back(digits(opening, noise.acceleration));
  }
  return rows;
}

std::vector<std::string> closing_sentences(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  std::vector<std::string> list;
  const auto add = [&](const std::string& name, double s) {
    if (std::abs(s) > report.noise.acceleration)
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
  std::vector<std::string> list;
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    if (file.body(contact.body).torsion_radius > 0)
      list.push_back(point_name(file, i) + " twists the object with " +
                     number(contact.torsion, report.noise.moment) +
                     " N m about its normal, against a spin of " +
                     number(contact.spin, report.noise.acceleration / report.scales.length) +
                     " rad/s^2");
  }
  return list;
}

} // namespace lcpush::desktop
