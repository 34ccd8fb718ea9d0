#include "scenes/scene_schema.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "scenes/scene_patch.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <string>

namespace lcpush::desktop {
namespace {

Schema joined(Schema first, const Schema& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Schema common_body_schema() {
  return joined({{"name", "name = \"left\""},
                 {"friction", "friction = 0.5"},
                 {"torsion_radius", "torsion_radius = 0.002  # m"}},
                patch_schema());
}

} // namespace

const Schema& root_schema() {
  static const Schema schema = {
      {"title", "title = \"Straight slide\""},
      {"gravity", "gravity = [0, -9.81, 0]  # m/s^2"},
      {"facets", "facets = 8"},
      {"pressure", "pressure = \"pad\""},
      {"planar", "planar = false"},
  };
  return schema;
}

const Schema& gripper_schema() {
  static const Schema schema = {{"jaws", "jaws = \"parallel\""}};
  return schema;
}

const Schema& actuator_schema() {
  static const Schema schema = {
      {"name", "name = \"tendon\""},
      {"bodies", "bodies = [\"left\", \"right\"]"},
      {"twists", "twists = [[1, 0, 0, 0, 0, 0]]  # linear at the scene's origin, angular"},
      {"force", "force = 20  # N"},
      {"acceleration", "acceleration = 0.1  # m/s^2"},
      {"inertia", "inertia = 0.05  # kg"},
  };
  return schema;
}

const Schema& body_schema(Role role) {
  static const Schema finger =
      joined(common_body_schema(), {{"grip_force", "grip_force = 20  # N"}});
  static const Schema pusher =
      joined(common_body_schema(),
             {{"acceleration", "acceleration = [0.1, 0, 0]  # m/s^2"},
              {"angular_acceleration", "angular_acceleration = [0, 0, 1]  # rad/s^2"},
              {"about", "about = [0, 0, 0]  # m"},
              {"follow", "follow = \"unilateral\""},
              {"normal_force", "normal_force = 5  # N"}});
  return role == Role::finger ? finger : pusher;
}

void check_sections(const TomlDocument& document) {
  const std::vector<std::string> singles = {"object", "gripper"};
  const std::vector<std::string> arrays = {"finger", "pusher", "actuator"};
  const auto contains = [](const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  for (const TomlSection& section : document.sections) {
    const std::string& name = section.name;
    const int line = section.tables.front().line;
    if (contains(singles, name) && section.is_array)
      throw InputError(document.file, line, "there is only one " + name + "; write [" + name + "]");
    if (contains(arrays, name) && !section.is_array)
      throw InputError(document.file, line,
                       "there may be several; write [[" + name + "]] instead of [" + name + "]");
    if (contains(singles, name) || contains(arrays, name)) continue;
    std::vector<std::string> known = singles;
    known.insert(known.end(), arrays.begin(), arrays.end());
    const std::string hint = suggestion(name, known);
    throw InputError(document.file, line,
                     "unknown table " + quoted(name) +
                         (hint.empty() ? "; the tables are " + listed(known, "and") : hint));
  }
  if (!document.find("object"))
    throw InputError(document.file, 1,
                     "missing the table [object]; add [object] with mass and box, for example");
}

} // namespace lcpush::desktop
