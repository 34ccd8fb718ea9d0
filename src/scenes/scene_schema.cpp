#include "scenes/scene_schema.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

struct Section {
  std::string name;
  bool is_array; ///< [[name]], as often as one likes
  Schema keys;
};

/// The keys of every body, and those of its kind.
Schema body_keys(const Schema& own) {
  Schema keys = {
      {"name", "\"left\""},
      {"friction", "0.5"},
      {"torsion_radius", "0.002", "m"},
      {"shape", "\"disc\""},
      {"center", "[0, 0, 0.005]", "m"},
      {"ends", "[[-0.05, -0.015, 0], [-0.05, 0.015, 0]]", "m"},
      {"radius", "0.005", "m"},
      {"size", "[0.01, 0.02]", "m"},
      {"points", "[[0, 0, 0], [0.01, 0, 0]]", "m"},
      {"weights", "[1, 2]  # shares of the patch's force"},
      {"normal", "[0, 0, -1]  # into the object"},
      {"on", "\"+z\""},
      {"frame", "\"scene\""},
      {"along", "\"y\""},
      {"length", "0.03", "m"},
      {"tangent", "[1, 0, 0]"},
      {"points_on", "\"object\""},
      {"shift", "[0, 0.001, 0]", "m"},
  };
  keys.insert(keys.end(), own.begin(), own.end());
  return keys;
}

const std::vector<Section>& sections() {
  static const std::vector<Section> list = {
      {"",
       false,
       {{"title", "\"Straight slide\""},
        {"gravity", "[0, -9.81, 0]", "m/s^2", true},
        {"facets", "\"round\""},
        {"pressure", "\"pad\""},
        {"planar", "false"}}},
      {"object",
       false,
       {{"mass", "0.2", "kg"},
        {"box", "[0.1, 0.03, 0.01]", "m"},
        {"cylinder_radius", "0.02", "m"},
        {"cylinder_length", "0.1", "m"},
        {"axis", "\"z\""},
        {"sphere_radius", "0.02", "m"},
        {"inertia", "[1e-4, 2e-4, 2e-4]", "kg m^2"},
        {"center_of_mass", "[0, 0, 0]", "m"},
        {"force", "[0, -2, 0]", "N", true},
        {"moment", "[0, 0, 0.1]", "N m", true},
        {"at", "[0.05, 0, 0]", "m"},
        {"rotation", "[0, 0, 1, \"20 deg\"]", "rad"},
        {"velocity", "[0.1, 0, 0]", "m/s"},
        {"angular_velocity", "[0, 0, 1]", "rad/s"},
        {"tilt", "\"20 deg about z\""}}},
      {"gripper", false, {{"jaws", "\"parallel\""}}},
      {"finger", true, body_keys({{"grip_force", "20", "N", true}})},
      {"pusher", true,
       body_keys({{"acceleration", "[0.1, 0, 0]", "m/s^2", true},
                  {"angular_acceleration", "[0, 0, 1]", "rad/s^2", true},
                  {"velocity", "[0.01, 0, 0]", "m/s", true},
                  {"angular_velocity", "[0, 0, 1]", "rad/s", true},
                  {"about", "[0, 0, 0]", "m"},
                  {"from", "0.5", "s"},
                  {"until", "2", "s"},
                  {"follow", "\"unilateral\""},
                  {"normal_force", "5", "N", true}})},
      {"actuator",
       true,
       {{"name", "\"tendon\""},
        {"bodies", "[\"left\", \"right\"]"},
        {"twists", "[[1, 0, 0, 0, 0, 0]]  # linear at the scene's origin, angular"},
        {"force", "20", "N", true, "N m"},
        {"acceleration", "0.1", "m/s^2", true, "rad/s^2"},
        {"inertia", "0.05", "kg", false, "kg m^2"}}},
      {"face", true, {{"corners", "[[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]]", "m"}}},
  };
  return list;
}

/// nullptr if there is none.
const Section* section_called(const std::string& name) {
  for (const Section& section : sections())
    if (section.name == name) return &section;
  return nullptr;
}

/// Words of other trades and programs for keys.
struct Synonym {
  const char *said, *meant, *note = "";
};
constexpr Synonym synonyms[] = {
    {"mu", "friction"},
    {"coefficient", "friction"},
    {"weight", "mass"},
    {"position", "center"},
    {"location", "center"},
    {"at", "center"},
    {"face", "on"},
    {"speed", "velocity"},
    {"start", "from"},
    {"begin", "from"},
    {"end", "until"},
    {"to", "until"},
    {"vertices", "corners"},
    {"motion", "acceleration"},
    {"com", "center_of_mass"},
    {"dimensions", "box"},
    {"shape", "box"},
    {"size", "box"},
    {"diameter", "radius", ", half of it"},
    {"cylinder_diameter", "cylinder_radius", ", half of it"},
    {"sphere_diameter", "sphere_radius", ", half of it"},
};

} // namespace

const Schema& schema_of(const std::string& section) { return section_called(section)->keys; }

const Key* key_called(const std::string& section, const std::string& name) {
  for (const Key& key : schema_of(section))
    if (key.name == name) return &key;
  return nullptr;
}

std::string key_hint(const Schema& schema, const std::string& word) {
  std::vector<std::string> known, tables;
  for (const Key& key : schema) known.push_back(key.name);
  for (const Synonym& synonym : synonyms)
    if (word == synonym.said && std::find(known.begin(), known.end(), synonym.meant) != known.end())
      return std::string(" (did you mean \"") + synonym.meant + "\"" + synonym.note + "?)";
  if (std::string near = suggestion(word, known); !near.empty()) return near;
  if (key_called("", word) != nullptr) return "; it stands at the top, before the first table";
  for (const Section& section : sections())
    if (key_called(section.name, word) != nullptr)
      tables.push_back(section.is_array ? "[[" + section.name + "]]" : "[" + section.name + "]");
  return tables.empty() ? "; the keys here are " + listed(known, "and")
                        : "; it goes with " + listed(tables, "or");
}

void check_sections(const TomlDocument& document) {
  for (const TomlSection& section : document.sections) {
    const std::string& name = section.name;
    const int line = section.tables.front().line;
    const Section* const known = name.empty() ? nullptr : section_called(name);
    if (known == nullptr) {
      std::vector<std::string> names;
      for (const Section& one : sections())
        if (!one.name.empty()) names.push_back(one.name);
      const std::string hint = suggestion(name, names);
      throw InputError(document.file, line,
                       "unknown table " + quoted(name) +
                           (hint.empty() ? "; the tables are " + listed(names, "and") : hint));
    }
    if (section.is_array && !known->is_array)
      throw InputError(document.file, line, "there is only one " + name + "; write [" + name + "]");
    if (known->is_array && !section.is_array)
      throw InputError(document.file, line,
                       "there may be several; write [[" + name + "]] instead of [" + name + "]");
  }
  if (!document.find("object"))
    throw InputError(document.file, 1,
                     document.sections.empty() && document.root.entries.empty()
                         ? "there is nothing in it; `lcpush new box` writes a scene to start from"
                         : "missing the table [object]; add [object] with mass and box, for "
                           "example");
}

} // namespace lcpush::desktop
