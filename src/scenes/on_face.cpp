#include "scenes/on_face.hpp"

#include "lcpush/desktop/rational.hpp"
#include "scenes/table_reader.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
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

/// How far the two faces across `axis` are apart.
Rational extent(const TableReader& object, const TableReader& contact, Index axis) {
  if (object.has("box")) return object.vector3<Rational>("box", Sign::positive)[axis];
  if (object.has("sphere_radius")) { // where the axis leaves it: its face there is a point
    const bool has_offset =
        contact.has("center") && contact.numbers<Rational>("center", {2}, Sign::any) !=
                                     std::vector<Rational>(2, Rational(0));
    if (contact.text("shape") != "point" || has_offset)
      contact.fail("on",
                   "on a ball on places a \"point\" without an offset; give center and normal "
                   "instead");
    return Rational(2) * object.number<Rational>("sphere_radius", Sign::positive);
  }
  if (!object.has("cylinder_radius"))
    contact.fail("on", "on needs an [object] with a box, a cylinder or a ball; give center and "
                       "normal instead");
  const auto along =
      static_cast<Index>(object.has("axis") ? object.choice("axis", {"x", "y", "z"}) : 2);
  if (along != axis)
    contact.fail("on", "the cylinder's flat faces are \"+" + axis_name(along) + "\" and \"-" +
                           axis_name(along) + "\"; on its side, remove on and give normal and " +
                           (contact.text("shape") == "line" ? "ends = [[x, y, z], [x, y, z]]"
                                                            : "center = [x, y, z]"));
  return object.number<Rational>("cylinder_length", Sign::positive);
}

/// Of the key along: an axis in the face across `axis`.
Index axis_along(const TableReader& contact, Index axis) {
  const auto along = static_cast<Index>(contact.choice("along", {"x", "y", "z"}));
  if (along == axis)
    contact.fail("along", "along must lie in the face, " + quoted(axis_name(axis_beside(axis, 0))) +
                              " or " + quoted(axis_name(axis_beside(axis, 1))) + ", got " +
                              quoted(axis_name(axis)) + ", which is across it");
  return along;
}

/// The sides of a rectangle follow its tangent.
TomlValue typed_along(const TableReader& contact, Index axis, const std::string& shape) {
  if (shape != "rectangle")
    contact.fail("along", "along goes with the shapes \"line\" and \"rectangle\"; remove it");
  if (contact.has("tangent"))
    contact.fail("along", "along is the tangent of a rectangle; remove one of the two");
  Vector3<Rational> tangent = Vector3<Rational>::Zero();
  tangent[axis_along(contact, axis)] = Rational(1);
  return typed_vector(contact.line_of({"along"}), tangent);
}

/// Where an edge begins and ends along its axis, from the middle of the face: clipped to that.
std::pair<Rational, Rational> edge_on_face(const TableReader& object, const TableReader& contact,
                                           Index axis, Index along,
                                           const Vector3<Rational>& offset) {
  Rational half = Rational(0);
  if (object.has("box")) {
    half = object.vector3<Rational>("box", Sign::positive)[along] / Rational(2);
  } else {
    // The chord of a round end is irrational, but for a diameter.
    const Rational radius = object.number<Rational>("cylinder_radius", Sign::positive);
    if (offset[3 - axis - along] != Rational(0))
      contact.fail("center", "an edge on a cylinder's end goes through its middle; leave the other "
                             "offset 0, or give ends and normal instead of on");
    half = radius;
  }
  if (!contact.has("length")) {
    if (offset[along] != Rational(0))
      contact.fail("center", "without a length the edge is as long as the face along " +
                                 axis_name(along) + "; give a length, or leave this offset 0");
    return {-half, half};
  }
  const bool is_shifted =
      contact.has("shift") && contact.vector3<Rational>("shift") != Vector3<Rational>::Zero();
  if (is_shifted) { // what lies beside the face is cut off where it then stands
    const Rational reach = contact.number<Rational>("length", Sign::positive) / Rational(2);
    return {offset[along] - reach, offset[along] + reach};
  }
  const Rational reach = contact.number<Rational>("length", Sign::positive) / Rational(2);
  const Rational from = std::max(offset[along] - reach, -half),
                 to = std::min(offset[along] + reach, half);
  if (!(from < to))
    contact.fail("center", "this edge lies beside the face, which goes from " +
                               shown((-half).value()) + " to " + shown(half.value()) + " m along " +
                               axis_name(along));
  return {from, to};
}

void put_on_face(const TableReader& object, const TableReader& contact, TomlTable& table) {
  const std::size_t face = contact.choice("on", face_names);
  const auto axis = static_cast<Index>(face / 2);
  const std::string x = axis_name(axis_beside(axis, 0)), y = axis_name(axis_beside(axis, 1));
  if (contact.has("frame") && contact.choice("frame", {"object", "scene"}) == 1)
    contact.fail("frame",
                 "on is a face of the object, wherever that is turned; remove frame, or on");
  const Rational apart = extent(object, contact, axis);
  if (contact.has("normal"))
    contact.fail("normal", "on = " + quoted(face_names[face]) +
                               " gives the normal, into that face; remove normal or on");
  const std::string shape = contact.is_text("shape") ? contact.text("shape") : "";
  if (shape == "points")
    contact.fail("on", "on places the center of a shape, and a \"points\" has none; give normal "
                       "instead of on");
  const TomlValue* const center = table.find("center");
  const auto* const list = center != nullptr ? std::get_if<TomlArray>(&center->data) : nullptr;
  if (list != nullptr && list->size() == 3)
    contact.fail("center", "beside on, center is an offset in the face, [along " + x + ", along " +
                               y + "]; give these two, or remove on and give normal");
  const int line = contact.line_of({"on"});
  const int place = std::max(line, contact.line_of({"center"})); // a center added: its table's
  const Rational side(face % 2 == 0 ? 1 : -1);
  Vector3<Rational> at = Vector3<Rational>::Zero(), normal = at;
  if (object.has("center_of_mass")) at = object.vector3<Rational>("center_of_mass");
  at[axis] += side * apart / Rational(2);
  normal[axis] = -side;
  Vector3<Rational> offset = Vector3<Rational>::Zero();
  if (center != nullptr) {
    const std::vector<Rational> two = contact.numbers<Rational>("center", {2}, Sign::any);
    for (std::size_t i = 0; i < 2; ++i) offset[axis_beside(axis, i)] = two[i];
  }
  std::vector<TomlEntry> places;
  if (shape == "line") {
    if (contact.has("ends"))
      contact.fail("ends",
                   "on a face along says the direction, and its ends are those of the face; "
                   "remove ends, or on and along");
    const Index along = axis_along(contact, axis);
    const auto [from, to] = edge_on_face(object, contact, axis, along, offset);
    offset[along] = Rational(0);
    Vector3<Rational> ends[2] = {at + offset, at + offset};
    ends[0][along] += from;
    ends[1][along] += to;
    places.push_back(
        {"ends", {place, TomlArray{typed_vector(place, ends[0]), typed_vector(place, ends[1])}}});
  } else {
    if (contact.has("length"))
      contact.fail("length", "length goes with the shape \"line\" on a face; remove it");
    if (contact.has("along")) places.push_back({"tangent", typed_along(contact, axis, shape)});
    places.push_back({"center", typed_vector(place, at + offset)});
  }
  places.push_back({"normal", typed_vector(line, normal)});
  const auto is_replaced = [](const TomlEntry& e) {
    return e.key == "on" || e.key == "center" || e.key == "along" || e.key == "length";
  };
  table.entries.erase(std::remove_if(table.entries.begin(), table.entries.end(), is_replaced),
                      table.entries.end());
  table.entries.insert(table.entries.end(), places.begin(), places.end());
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
    return is_body(section.name) &&
           std::any_of(section.tables.begin(), section.tables.end(),
                       [](const TomlTable& table) { return table.find("on") != nullptr; });
  });
}

bool are_all_on_faces(const TomlDocument& document) {
  return std::all_of(document.sections.begin(), document.sections.end(), [](const auto& section) {
    return !is_body(section.name) ||
           std::all_of(section.tables.begin(), section.tables.end(),
                       [](const TomlTable& table) { return table.find("on") != nullptr; });
  });
}

TomlDocument with_typed_places(TomlDocument document) {
  const TableReader object(document.file, document.find("object")->tables[0], "object",
                           schema_of("object"));
  for (TomlSection& section : document.sections) {
    if (!is_body(section.name)) continue;
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
