#include "scenes/object_pose.hpp"

#include "lcpush/desktop/rational.hpp"
#include "scenes/exact_frame.hpp"
#include "scenes/table_reader.hpp"
#include "text/wording.hpp"

#include "lcpush/mechanics/model/contact.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lcpush::desktop {
namespace {

/// v turned back by a rotation, exactly: by (w, -axis) as a quaternion of any length.
class Rotation {
public:
  explicit Rotation(const TableReader& object) {
    if (!object.has("rotation")) return;
    const std::vector<Rational> given = object.numbers<Rational>("rotation", {4}, Sign::any);
    axis_ = {given[0], given[1], given[2]};
    const double length = as_doubles(axis_).norm(), half = std::tan(given[3].value() / 2);
    if (!(length > 0))
      object.fail("rotation", "rotation is [axis.., angle], and this axis is zero");
    // The tangent of the half angle, or its inverse, to 1e-18.
    if (std::abs(half) <= 1)
      axis_ *= simplest_near(Rational(half / length));
    else
      w_ = simplest_near(Rational(length / half));
  }

  Vector3<Rational> back(const Vector3<Rational>& v) const {
    const Vector3<Rational> across = cross<Rational>(axis_, v);
    const Rational square = w_ * w_ + axis_.dot(axis_);
    return v + (cross<Rational>(axis_, across) - w_ * across) * (Rational(2) / square);
  }

private:
  Rational w_ = 1;
  Vector3<Rational> axis_ = Vector3<Rational>::Zero();
};

/// Turns these vectors of the table, or lists of them, back.
void turn_back(const Rotation& rotation, const TableReader& table,
               const std::vector<const char*>& keys, TomlTable& turned) {
  for (const char* const key : keys) {
    TomlValue* const value = turned.find(key);
    const auto* const list = value != nullptr ? std::get_if<TomlArray>(&value->data) : nullptr;
    if (list == nullptr || list->empty()) continue; // its reader says what is wrong
    const auto typed = [&](const std::vector<Rational>& v) {
      return typed_vector(value->line, rotation.back({v[0], v[1], v[2]}));
    };
    if (!std::holds_alternative<TomlArray>(list->front().data)) {
      if (list->front().number() && list->size() == 3)
        *value = typed(table.numbers<Rational>(key, {3}, Sign::any));
      continue;
    }
    TomlArray rows;
    for (const auto& row : table.rows<Rational>(key, 3, list->size())) rows.push_back(typed(row));
    *value = {value->line, rows};
  }
}

} // namespace

std::optional<TomlValue> rotation_of_tilt(const TomlValue& tilt) {
  const auto* const text = std::get_if<std::string>(&tilt.data);
  const std::size_t about = text != nullptr ? text->find(" about ") : std::string::npos;
  if (about == std::string::npos) return std::nullopt;
  const std::string axis(trimmed(std::string_view(*text).substr(about + 7)));
  if (axis != "x" && axis != "y" && axis != "z") return std::nullopt;
  TomlArray rotation;
  for (const char* one : {"x", "y", "z"}) {
    const bool is_axis = axis == one;
    rotation.push_back({tilt.line, std::int64_t{is_axis ? 1 : 0}, is_axis ? "1" : "0"});
  }
  rotation.push_back({tilt.line, text->substr(0, about)});
  return TomlValue{tilt.line, rotation};
}

bool has_turned_object(const TomlDocument& document) {
  return document.find("object")->tables[0].find("rotation") != nullptr;
}

TomlDocument in_object_frame(TomlDocument document) {
  const TomlDocument given = document;
  const auto reader = [&given](const std::string& section, std::size_t i) {
    const TomlSection* const found = given.find(section);
    return TableReader(given.file, found != nullptr ? found->tables[i] : given.root,
                       found != nullptr ? table_label(*found, i) : "", schema_of(section));
  };
  const Rotation rotation(reader("object", 0));
  turn_back(rotation, reader("", 0), {"gravity"}, document.root);
  for (TomlSection& section : document.sections)
    for (std::size_t i = 0; i < section.tables.size(); ++i) {
      TomlTable& table = section.tables[i];
      if (section.name == "object") {
        turn_back(rotation, reader(section.name, i),
                  {"force", "moment", "velocity", "angular_velocity"}, table);
        table.entries.erase(std::remove_if(table.entries.begin(), table.entries.end(),
                                           [](const TomlEntry& e) { return e.key == "rotation"; }),
                            table.entries.end());
      }
      if (!is_body(section.name) || table.find("frame") == nullptr) continue;
      const TableReader body = reader(section.name, i);
      if (body.choice("frame", {"object", "scene"}) == 1)
        turn_back(rotation, body,
                  {"center", "ends", "points", "normal", "tangent", "shift", "about", "velocity",
                   "angular_velocity", "acceleration", "angular_acceleration"},
                  table);
    }
  return document;
}

} // namespace lcpush::desktop
