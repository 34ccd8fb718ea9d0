#include "scenes/on_face.hpp"

#include "lcpush/desktop/rational.hpp"
#include "scenes/table_reader.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace lcpush::desktop {
namespace {

const std::vector<std::string> face_names = {"+x", "-x", "+y", "-y", "+z", "-z"};

std::string axis_name(Index axis) { return std::string(1, "xyz"[axis]); }

/// Along the two axes of the face, in their order.
Index axis_beside(Index axis, std::size_t i) {
  const auto k = static_cast<Index>(i);
  return k < axis ? k : k + 1;
}

TomlValue typed(int line, const Vector3<Rational>& vector) {
  TomlArray list;
  for (Index i = 0; i < 3; ++i) list.push_back({line, vector[i].value(), vector[i].text()});
  return {line, list};
}

/// How far the two faces across `axis` are apart.
Rational extent(const TableReader& object, const TableReader& contact, Index axis) {
  if (object.has("box")) return object.vector3<Rational>("box", Sign::positive)[axis];
  if (!object.has("cylinder_radius"))
    contact.fail("on", "on needs an [object] with a box or a cylinder; give center and normal "
                       "instead");
  const auto along =
      static_cast<Index>(object.has("axis") ? object.choice("axis", {"x", "y", "z"}) : 2);
  if (along != axis)
    contact.fail("on", "the cylinder's flat faces are \"+" + axis_name(along) + "\" and \"-" +
                           axis_name(along) + "\"; on its side, give center and normal");
  return object.number<Rational>("cylinder_length", Sign::positive);
}

void put_on_face(const TableReader& object, const TableReader& contact, TomlTable& table) {
  const std::size_t face = contact.choice("on", face_names);
  const auto axis = static_cast<Index>(face / 2);
  const std::string x = axis_name(axis_beside(axis, 0)), y = axis_name(axis_beside(axis, 1));
  if (contact.has("normal"))
    contact.fail("normal", "on = " + quoted(face_names[face]) +
                               " gives the normal, into that face; remove normal or on");
  const std::string shape = contact.is_text("shape") ? contact.text("shape") : "";
  if (shape == "line" || shape == "points")
    contact.fail("on", "on places the center of a shape, and a " + quoted(shape) +
                           " has none; give normal instead of on");
  const TomlValue* const center = table.find("center");
  const auto* const list = center != nullptr ? std::get_if<TomlArray>(&center->data) : nullptr;
  if (list != nullptr && list->size() == 3)
    contact.fail("center", "beside on, center is an offset in the face, [along " + x + ", along " +
                               y + "]; give these two, or remove on and give normal");
  const int line = contact.line_of({"on"}), place = contact.line_of({"center", "on"});
  const Rational side(face % 2 == 0 ? 1 : -1);
  Vector3<Rational> at = Vector3<Rational>::Zero(), normal = at;
  if (object.has("center_of_mass")) at = object.vector3<Rational>("center_of_mass");
  at[axis] += side * extent(object, contact, axis) / Rational(2);
  normal[axis] = -side;
  if (center != nullptr) {
    const std::vector<Rational> offset = contact.numbers<Rational>("center", {2}, Sign::any);
    for (std::size_t i = 0; i < 2; ++i) at[axis_beside(axis, i)] += offset[i];
  }
  const auto is_replaced = [](const TomlEntry& e) { return e.key == "on" || e.key == "center"; };
  table.entries.erase(std::remove_if(table.entries.begin(), table.entries.end(), is_replaced),
                      table.entries.end());
  table.entries.push_back({"center", typed(place, at)});
  table.entries.push_back({"normal", typed(line, normal)});
}

} // namespace

std::optional<int> axis_in_face(const TomlTable& table, std::size_t i) {
  const TomlValue* const on = table.find("on");
  const auto* const name = on != nullptr ? std::get_if<std::string>(&on->data) : nullptr;
  const auto face =
      name != nullptr ? std::find(face_names.begin(), face_names.end(), *name) : face_names.end();
  if (face == face_names.end()) return std::nullopt;
  return static_cast<int>(axis_beside((face - face_names.begin()) / 2, i));
}

bool has_contacts_on_faces(const TomlDocument& document) {
  return std::any_of(document.sections.begin(), document.sections.end(), [](const auto& section) {
    return (section.name == "finger" || section.name == "pusher") &&
           std::any_of(section.tables.begin(), section.tables.end(),
                       [](const TomlTable& table) { return table.find("on") != nullptr; });
  });
}

TomlDocument with_typed_places(TomlDocument document) {
  const TableReader object(document.file, document.find("object")->tables[0], "object",
                           schema_of("object"));
  for (TomlSection& section : document.sections) {
    if (section.name != "finger" && section.name != "pusher") continue;
    for (std::size_t i = 0; i < section.tables.size(); ++i) {
      TomlTable& table = section.tables[i];
      if (table.find("on") == nullptr) continue;
      const std::string label = table_label(section, i);
      put_on_face(object, TableReader(document.file, table, label, schema_of(section.name)), table);
    }
  }
  return document;
}

} // namespace lcpush::desktop
