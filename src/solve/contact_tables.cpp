// What each contact does, as rows of a table and as sentences.
#include <algorithm>

#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "solve/word_settings.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {

namespace {

/// What the points of a body do, from the first on.
struct ContactLine {
  std::string name;
  std::string does;
  double normal = 0; ///< N, the sum
  Vector3<double> friction = Vector3<double>::Zero();
  double slip = 0, opening = 0; ///< m/s^2, the fastest
};

double opening_of(const Body<double>& body, const ContactAnswer<double>& point) {
  return point.acceleration.dot(body.normal);
}

void add(const Body<double>& body, const ContactAnswer<double>& point, ContactLine& contact) {
  const double opening = opening_of(body, point);
  contact.normal += point.normal_force;
  contact.friction += point.friction_force;
  contact.slip = std::max(contact.slip, (point.acceleration - opening * body.normal).norm());
  contact.opening = std::max(contact.opening, opening);
}

std::vector<ContactLine> each_point(const SceneFile& file, const PushReport& report) {
  std::vector<ContactLine> list;
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& point = report.answer.contacts[i];
    ContactLine contact{point_name(file, i), mode_text(point.mode)};
    add(file.body(point.body), point, contact);
    contact.opening = opening_of(file.body(point.body), point);
    list.push_back(contact);
  }
  return list;
}

std::vector<ContactLine> each_body(const SceneFile& file, const PushReport& report) {
  std::vector<ContactLine> list;
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    ContactLine contact{file.body_name(b), modes_text(report.answer, file.body(b))};
    for (const Index i : points_of(file.body(b)))
      add(file.body(b), report.answer.contacts[i], contact);
    list.push_back(contact);
  }
  return list;
}

std::string digits(double x, double zero, Telling telling) {
  return telling == Telling::full ? number(x, zero) : brief(x, zero);
}

} // namespace

TableRows contact_rows(const SceneFile& file, const PushReport& report, Telling telling) {
  const bool is_full = telling == Telling::full;
  const Noise& noise = is_full ? report.noise : report.brief_noise;
  const std::vector<ContactLine> contacts =
      is_full ? each_point(file, report) : each_body(file, report);
  TableRows rows{
      {"contact", is_full ? "mode" : "does", "normal N", "friction N", "along", "slip m/s^2"}};
  if (is_full) rows.front().emplace_back("opening m/s^2");
  for (const ContactLine& contact : contacts) {
    const double friction = contact.friction.norm();
    std::string along = "-";
    if (friction > noise.force)
      along = is_full ? vector_text(contact.friction / friction, word_settings.component)
                      : direction_text(contact.friction / friction);
    rows.push_back({contact.name, contact.does, digits(contact.normal, noise.force, telling),
                    digits(friction, noise.force, telling), along,
                    digits(contact.slip, noise.acceleration, telling)});
    if (is_full) rows.back().push_back(digits(contact.opening, noise.acceleration, telling));
  }
  return rows;
}

std::vector<std::string> closing_sentences(const SceneFile& file, const PushReport& report,
                                           Telling telling) {
  const Scene<double> scene = file.view();
  std::vector<std::string> list;
  const auto add = [&](const std::string& name, double s) {
    if (std::abs(s) > report.noise.acceleration)
      list.push_back(name + (s > 0 ? " closes at " : " is forced open at ") +
                     digits(std::abs(s), 0, telling) + " m/s^2");
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

std::vector<std::string> torsion_sentences(const SceneFile& file, const PushReport& report,
                                           Telling telling) {
  std::vector<std::string> list;
  for (Index i = 0; i < report.answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = report.answer.contacts[i];
    if (file.body(contact.body).torsion_radius > 0)
      list.push_back(
          point_name(file, i) + " twists the object with " +
          digits(contact.torsion, report.noise.moment, telling) +
          " N m about its normal, against a spin of " +
          digits(contact.spin, report.noise.acceleration / report.scales.length, telling) +
          " rad/s^2");
  }
  return list;
}

} // namespace lcpush::desktop
