#include "lcpush/host/varied_scene.hpp"

#include "lcpush/host/input_error.hpp"
#include "lcpush/host/text_file.hpp"
#include "message.hpp"
#include "number_text.hpp"
#include "scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace lcpush::host {
namespace {

using Place = Parameter::Place;
using Kind = Parameter::Kind;

constexpr std::size_t most_scene_bytes = std::size_t{64} << 20U;
constexpr int root = -1;

/// Whole numbers that count something do not vary.
bool is_count(const std::string& key, const TomlValue& value) {
  if (key == "facets") return true;
  if (key != "points") return false;
  const auto* const list = std::get_if<TomlArray>(&value.data);
  return list == nullptr || list->empty() || !std::holds_alternative<TomlArray>(list->front().data);
}

std::string unit_of(const std::string& key) {
  static const std::map<std::string, std::string> units = {{"gravity", "m/s^2"},
                                                           {"mass", "kg"},
                                                           {"box", "m"},
                                                           {"cylinder_radius", "m"},
                                                           {"cylinder_length", "m"},
                                                           {"inertia", "kg m^2"},
                                                           {"center_of_mass", "m"},
                                                           {"center", "m"},
                                                           {"ends", "m"},
                                                           {"radius", "m"},
                                                           {"size", "m"},
                                                           {"points", "m"},
                                                           {"torsion_radius", "m"},
                                                           {"grip_force", "N"},
                                                           {"acceleration", "m/s^2"},
                                                           {"angular_acceleration", "rad/s^2"},
                                                           {"about", "m"},
                                                           {"normal_force", "N"},
                                                           {"force", "N"},
                                                           {"shift", "m"},
                                                           {"turn", "degrees"}};
  const auto found = units.find(key);
  return found == units.end() ? "" : found->second;
}

bool is_linear(const std::string& key) {
  for (const char* name :
       {"gravity", "grip_force", "acceleration", "angular_acceleration", "normal_force", "force"})
    if (key == name) return true;
  return false;
}

bool is_body(const std::string& section) { return section == "finger" || section == "pusher"; }

std::string indexed(const std::string& name, const std::vector<std::size_t>& indices) {
  std::string text = name;
  for (const std::size_t i : indices) text += "[" + std::to_string(i) + "]";
  return text;
}

TomlTable& table_at(TomlDocument& document, const Place& place) {
  if (place.section == root) return document.root;
  return document.sections[static_cast<std::size_t>(place.section)]
      .tables[static_cast<std::size_t>(place.table)];
}

TomlValue* value_of(TomlTable& table, const std::string& key) {
  for (TomlEntry& entry : table.entries)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

std::optional<double> number_in(const TomlValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data))
    return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value.data)) return *real;
  return std::nullopt;
}

void set(TomlValue& value, double number) {
  value.data = number;
  value.digits = shown(number);
}

TomlValue zeros(int line) {
  const TomlValue zero{line, std::int64_t{0}, "0"};
  return {line, TomlArray{zero, zero, zero}};
}

/// Adds `by` to coordinate `axis` of a point, or of every point of a list.
void shift(TomlValue& value, std::size_t axis, double by) {
  auto* const list = std::get_if<TomlArray>(&value.data);
  if (list == nullptr || list->empty()) return; // a count, or wrong: the builder says so
  if (std::holds_alternative<TomlArray>(list->front().data)) {
    for (TomlValue& point : *list) shift(point, axis, by);
  } else if (axis < list->size()) {
    if (const auto number = number_in((*list)[axis])) set((*list)[axis], *number + by);
  }
}

/// Turns the first two coordinates; multiples of 90 degrees exactly.
void turn(TomlValue& value, double degrees) {
  auto* const list = std::get_if<TomlArray>(&value.data);
  if (list == nullptr || list->size() != 3) return;
  const auto x = number_in((*list)[0]), y = number_in((*list)[1]);
  if (!x || !y) return;
  const double quarters = std::floor(degrees / 90 + 0.5), rest = degrees - 90 * quarters;
  const double radians = rest * (std::acos(-1.0) / 180);
  double c = std::cos(radians), s = std::sin(radians);
  for (int k = static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4)); k > 0; --k)
    std::tie(c, s) = std::pair(-s, c);
  set((*list)[0], c * *x - s * *y);
  set((*list)[1], s * *x + c * *y);
}

struct Named {
  Parameter parameter;
  std::string owner, rest; ///< "left" and "points[0][1]"; both as in the path
};

void add_numbers(const TomlValue& value, Named& named, const std::string& key,
                 std::vector<Named>& list) {
  Place& place = named.parameter.places.front();
  if (const auto number = number_in(value)) {
    named.rest = indexed(key, place.indices);
    named.parameter.value = *number;
    list.push_back(named);
  } else if (const auto* array = std::get_if<TomlArray>(&value.data)) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      place.indices.push_back(i);
      add_numbers((*array)[i], named, key, list);
      place.indices.pop_back();
    }
  }
}

void add_table(const TomlTable& table, const std::string& owner, int section, int index,
               std::vector<Named>& list) {
  for (const TomlEntry& entry : table.entries) {
    if (is_count(entry.key, entry.value)) continue;
    Named named;
    named.owner = owner;
    named.parameter.places = {{section, index, entry.key, {}}};
    named.parameter.unit = unit_of(entry.key);
    named.parameter.linear = is_linear(entry.key);
    add_numbers(entry.value, named, entry.key, list);
  }
}

void add_motions(const TomlTable& table, const std::string& owner, int section, int index,
                 std::vector<Named>& list) {
  Named named;
  named.owner = owner;
  named.parameter.places = {{section, index, "", {}}};
  named.parameter.kind = Kind::shift;
  named.parameter.unit = unit_of("shift");
  for (Index axis = 0; axis < 3; ++axis) {
    named.parameter.axis = axis;
    named.rest = "shift[" + std::to_string(axis) + "]";
    list.push_back(named);
  }
  if (!table.find("acceleration")) return;
  named.parameter.kind = Kind::turn;
  named.parameter.unit = unit_of("turn");
  named.rest = "turn";
  list.push_back(named);
}

/// Each number that one path names, without those of `*`.
std::vector<Named> single_parameters(const TomlDocument& document) {
  std::vector<Named> list;
  add_table(document.root, "", root, 0, list);
  for (std::size_t s = 0; s < document.sections.size(); ++s) {
    const TomlSection& section = document.sections[s];
    for (std::size_t t = 0; t < section.tables.size(); ++t) {
      const TomlTable& table = section.tables[t];
      const TomlValue* const value = table.find("name");
      const auto* const name = value ? std::get_if<std::string>(&value->data) : nullptr;
      const std::string owner = name != nullptr ? *name : section.name;
      add_table(table, owner, static_cast<int>(s), static_cast<int>(t), list);
      if (is_body(section.name))
        add_motions(table, owner, static_cast<int>(s), static_cast<int>(t), list);
    }
  }
  return list;
}

/// And those of `*`: the same number of every body that has it.
std::vector<Named> all_parameters(const TomlDocument& document) {
  std::vector<Named> list = single_parameters(document);
  const std::size_t singles = list.size();
  for (std::size_t i = 0; i < singles; ++i) {
    const Place& place = list[i].parameter.places.front();
    const bool of_body = place.section != root &&
                         is_body(document.sections[static_cast<std::size_t>(place.section)].name);
    if (!of_body || list[i].parameter.kind != Kind::number) continue;
    const auto same = std::find_if(list.begin() + static_cast<std::ptrdiff_t>(singles), list.end(),
                                   [&](const Named& other) { return other.rest == list[i].rest; });
    if (same != list.end()) {
      same->parameter.places.push_back(place);
      continue;
    }
    list.push_back(list[i]);
    list.back().owner = "*";
  }
  for (Named& named : list)
    named.parameter.path = named.owner.empty() ? named.rest : named.owner + "." + named.rest;
  return list;
}

} // namespace

VariedScene::VariedScene(TomlDocument document) : document_(std::move(document)) { add_zeros(); }

VariedScene VariedScene::read(const std::string& path) {
  return parse(read_text_file(path, most_scene_bytes), path);
}

VariedScene VariedScene::parse(std::string_view text, const std::string& file_name) {
  TomlDocument document = parse_toml(text, file_name);
  (void)SceneBuilder<double>(document).build(); // as typed: complaints are about the file alone
  return VariedScene(std::move(document));
}

void VariedScene::set_pressure(const std::string& law) {
  TomlValue* const value = value_of(document_.root, "pressure");
  if (value != nullptr)
    value->data = law;
  else
    document_.root.entries.push_back({"pressure", {document_.root.line, law, ""}});
  (void)SceneBuilder<double>(document_).build();
}

/// Vectors that are zero where a file leaves them out can vary as well.
void VariedScene::add_zeros() {
  const auto add = [](TomlTable& table, const char* key) {
    if (table.find(key) == nullptr) table.entries.push_back({key, zeros(table.line)});
  };
  add(document_.root, "gravity");
  for (TomlSection& section : document_.sections)
    for (TomlTable& table : section.tables) {
      if (section.name == "object") add(table, "center_of_mass");
      if (section.name != "pusher") continue;
      add(table, "acceleration");
      add(table, "angular_acceleration");
    }
}

std::vector<std::string> VariedScene::paths() const {
  std::vector<std::string> paths;
  for (const Named& named : all_parameters(document_)) paths.push_back(named.parameter.path);
  return paths;
}

/// What every owner has, an array's numbers as one.
std::string VariedScene::choices() const {
  std::vector<std::pair<std::string, std::vector<std::string>>> owners;
  for (const Named& named : all_parameters(document_)) {
    if (owners.empty() || owners.back().first != named.owner) owners.push_back({named.owner, {}});
    std::vector<std::string>& keys = owners.back().second;
    const std::size_t bracket = named.rest.find('[');
    const std::string key =
        bracket == std::string::npos ? named.rest : named.rest.substr(0, bracket) + "[..]";
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  }
  std::string text;
  for (const auto& [owner, keys] : owners)
    text += "\n  " + (owner.empty() ? "" : owner + ".  ") + listed(keys, "and");
  return text;
}

Parameter VariedScene::find(const std::string& path) const {
  const std::vector<Named> all = all_parameters(document_);
  for (const Named& named : all)
    if (named.parameter.path == path) return named.parameter;
  throw InputError(document_.file + ": nothing to vary is called " + quoted(path) +
                   suggestion(path, paths()) +
                   "; the numbers of this scene, vectors counted from [0]:" + choices());
}

SceneFile VariedScene::at(const std::vector<Parameter>& parameters,
                          const std::vector<double>& values) const {
  TomlDocument document = document_;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Parameter& parameter = parameters[k];
    for (const Place& place : parameter.places) {
      TomlTable& table = table_at(document, place);
      if (parameter.kind == Kind::turn) {
        turn(*value_of(table, "acceleration"), values[k]);
      } else if (parameter.kind == Kind::shift) {
        for (const char* key : {"center", "ends", "points"})
          if (TomlValue* const value = value_of(table, key))
            shift(*value, static_cast<std::size_t>(parameter.axis), values[k]);
      } else {
        TomlValue* value = value_of(table, place.key);
        for (const std::size_t i : place.indices) value = &std::get<TomlArray>(value->data)[i];
        set(*value, values[k]);
      }
    }
  }
  try {
    return SceneBuilder<double>(document).build();
  } catch (const InputError& error) {
    std::string where;
    for (std::size_t k = 0; k < parameters.size(); ++k)
      where += (k > 0 ? ", " : "") + parameters[k].path + " = " + shown(values[k]);
    throw InputError(std::string(error.what()) + (where.empty() ? "" : " (at " + where + ")"));
  }
}

} // namespace lcpush::host
