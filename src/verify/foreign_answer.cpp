#include "lcpush/desktop/foreign_answer.hpp"

#include "formats/json_fields.hpp"
#include "lcpush/desktop/push.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"
#include "verify/settings.hpp"
#include "verify/verify_rows.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

/// "no body is called "wall"; there are left, right and edge"
std::string stranger(const std::string& name, const std::string& kind,
                     const std::vector<std::string>& known) {
  std::vector<std::string> told = known;
  if (told.size() > VerifySettings::told_names) {
    told.resize(VerifySettings::told_names - 1);
    told.push_back(std::to_string(known.size() - told.size()) + " more");
  }
  return "no " + kind + " is called " + quoted(name) + "; there " +
         (known.size() == 1 ? "is " : "are ") + listed(told, "and");
}

/// Where each entry of the file belongs: by name if all are named as the scene names them, and then
/// some may be left out; else by order. `fault` receives why it fits neither way.
std::vector<std::size_t> places(const std::vector<std::string>& given,
                                const std::vector<std::string>& known, const std::string& kind,
                                std::string& fault) {
  std::vector<std::size_t> by_name, by_order;
  for (const std::string& name : given) {
    const auto at =
        static_cast<std::size_t>(std::find(known.begin(), known.end(), name) - known.begin());
    const bool is_twice = std::count(by_name.begin(), by_name.end(), at) > 0;
    if (fault.empty() && !name.empty() && (at == known.size() || is_twice))
      fault = is_twice ? kind + " " + quoted(name) + " stands twice" : stranger(name, kind, known);
    by_order.push_back(by_order.size());
    if (at < known.size() && !is_twice) by_name.push_back(at);
  }
  if (by_name.size() == given.size() || !fault.empty()) return by_name;
  if (given.size() != known.size())
    fault = "not every " + kind + " has a name, and there are " + std::to_string(given.size()) +
            " instead of " + std::to_string(known.size());
  return by_order;
}

ForeignContact read_contact(const JsonFields& fields, const JsonValue& value) {
  ForeignContact contact;
  contact.name = fields.text(value, "name");
  contact.body = fields.text(value, "body");
  contact.normal_force = fields.number(value, "normal_force");
  contact.torsion = fields.number(value, "torsion");
  contact.spin = fields.number(value, "spin");
  contact.friction_force = fields.vector<3>(value, "friction_force");
  contact.acceleration = fields.vector<3>(value, "acceleration");
  contact.position = fields.vector<3>(value, "position");
  return contact;
}

void read_contacts(const JsonFields& fields, const JsonArray& array, const SceneFile& file,
                   double tolerance, ForeignAnswer& answer) {
  std::vector<ForeignContact> read;
  std::vector<std::string> given, known;
  for (const JsonValue& value : array) {
    read.push_back(read_contact(fields, value));
    given.push_back(read.back().name);
  }
  for (std::size_t i = 0; i < file.points.size(); ++i)
    known.push_back(point_name(file, static_cast<Index>(i)));
  const std::vector<std::size_t> place = places(given, known, "contact", answer.not_this_scene);
  if (!answer.not_this_scene.empty()) return;
  answer.contacts.resize(known.size());
  for (std::size_t k = 0; k < read.size(); ++k) answer.contacts[place[k]] = read[k];
  double size = 0;
  for (const auto* places : {&file.points, &file.positions})
    for (const Vector3<double>& p : *places) size = std::max(size, p.norm());
  const double near = std::max(VerifySettings::same_place, tolerance) * size;
  double off = 0;
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const ForeignContact& contact = answer.contacts[i];
    const std::string& body = file.body_name(file.body_of(static_cast<Index>(i)));
    if (!contact.body.empty() && contact.body != body) {
      answer.not_this_scene = "contact " + known[i] + " is of body " + quoted(contact.body) +
                              ", the scene's of " + quoted(body);
      return;
    }
    const double apart = contact.position ? (*contact.position - file.positions[i]).norm() : 0;
    if (apart <= off) continue;
    off = apart;
    farthest = i;
  }
  if (off <= near) return;
  answer.not_this_scene =
      "contact " + known[farthest] + " is at another place, " + in_digits(off, 3) +
      " m from the scene's" +
      (off <= VerifySettings::rounded * size ? "; if its places are rounded, --tolerance " +
                                                   next_tolerance(off / size) + " takes them"
                                             : "");
}

void read_bodies(const JsonFields& fields, const JsonArray& array, const SceneFile& file,
                 ForeignAnswer& answer) {
  std::vector<std::string> given;
  for (const JsonValue& value : array) given.push_back(fields.text(value, "name"));
  const std::vector<std::size_t> place =
      places(given, file.body_names, "body", answer.not_this_scene);
  if (!answer.not_this_scene.empty()) return;
  answer.bodies.resize(file.bodies.size());
  for (std::size_t k = 0; k < array.size(); ++k) {
    ForeignBody& body = answer.bodies[place[k]];
    body.force = fields.vector<3>(array[k], "force");
    body.moment = fields.vector<3>(array[k], "moment");
    body.normal_force = fields.number(array[k], "normal_force");
    const JsonValue* const closing = array[k].find("closing_acceleration");
    if (closing == nullptr) continue;
    if (closing->as<JsonArray>() == nullptr)
      body.closing = {*fields.number(array[k], "closing_acceleration")};
    else if (const auto list = fields.numbers(array[k], "closing_acceleration", -1))
      body.closing = *list;
  }
}

/// {"law": "pyramids", "facets": g}; none: another law, or not said.
std::optional<Index> read_facets(const JsonFields& fields, const JsonValue& friction) {
  if (friction.as<JsonObject>() == nullptr)
    fields.refuse(friction, std::string("\"friction\" must be an object, got ") + friction.type());
  const std::optional<double> facets = fields.number(friction, "facets");
  if (!facets) return std::nullopt;
  for (Index g = VerifySettings::fewest_facets; g <= VerifySettings::most_facets; g += 2)
    if (*facets == static_cast<double>(g)) return g;
  fields.refuse(friction, "facets must be an even number from 4 to 256");
}

bool says_something(const ForeignAnswer& answer) {
  const auto says_body = [](const ForeignBody& b) {
    return b.force || b.moment || b.normal_force || !b.closing.empty();
  };
  const auto says_contact = [](const ForeignContact& c) {
    return c.normal_force || c.friction_force || c.acceleration || c.torsion;
  };
  return answer.acceleration || !answer.closing.empty() ||
         std::any_of(answer.bodies.begin(), answer.bodies.end(), says_body) ||
         std::any_of(answer.contacts.begin(), answer.contacts.end(), says_contact);
}

} // namespace

ForeignAnswer parse_foreign_answer(std::string_view text, const std::string& file_name,
                                   const SceneFile& file, double tolerance) {
  const JsonValue root = parse_json(text, file_name);
  const JsonFields fields(file_name);
  if (root.as<JsonObject>() == nullptr)
    fields.refuse(root, std::string("an answer is a JSON object, got ") + root.type());
  ForeignAnswer answer;
  answer.file = file_name;
  answer.status = fields.text(root, "status");
  answer.break_force = fields.number(root, "break_force");
  answer.pusher = fields.text(root, "pusher");
  if (const JsonValue* const friction = root.find("friction"))
    answer.facets = read_facets(fields, *friction);
  if (const JsonValue* const object = root.find("object")) {
    if (object->as<JsonObject>() == nullptr)
      fields.refuse(*object, std::string("\"object\" must be an object, got ") + object->type());
    answer.acceleration = fields.vector<6>(*object, "acceleration");
  }
  const Index actuators = EvenScene(file.view()).scene.actuators.size;
  if (const auto closing = fields.numbers(root, "closing", actuators)) answer.closing = *closing;
  if (const JsonArray* const contacts = fields.objects(root, "contacts"))
    read_contacts(fields, *contacts, file, tolerance, answer);
  const JsonArray* const bodies = fields.objects(root, "bodies");
  if (bodies != nullptr && answer.not_this_scene.empty())
    read_bodies(fields, *bodies, file, answer);
  if (!answer.not_this_scene.empty()) return answer;
  if (answer.break_force && says_something(answer))
    fields.refuse(root, "\"break_force\" is of another moment than the rest: verify one of them");
  if (!answer.break_force && !says_something(answer))
    fields.refuse(root,
                  "nothing to verify: give \"object\": {\"acceleration\": [6 numbers]}, "
                  "\"bodies\": [{\"name\": .., \"force\": [..], \"moment\": [..]}, ..], "
                  "\"contacts\": [{\"normal_force\": .., \"friction_force\": [..]}, ..] or "
                  "\"break_force\"" +
                      (answer.status.empty() ? std::string()
                                             : ", not only \"status\": " + quoted(answer.status)));
  return answer;
}

} // namespace lcpush::desktop
