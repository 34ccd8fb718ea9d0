#include "calls/request.hpp"

#include "lcpush/mechanics/solve/breaking.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"
#include "text/limits.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

Request::Request(const std::string& text, std::vector<std::string> keys)
    : root_(parse_json(text, name_)) {
  const JsonObject* const object = root_.as<JsonObject>();
  if (object == nullptr)
    fields_.refuse(root_, std::string("a question is a JSON object, got ") + root_.type());
  for (const auto& [key, value] : *object)
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      fields_.refuse(value, "no option is called " + quoted(key) + suggestion(key, keys) +
                                "; there are " + listed(keys, "and"));
}

std::string Request::text(const char* key, const char* otherwise) const {
  return find(key) == nullptr ? otherwise : text(key);
}

bool Request::flag(const char* key) const {
  const JsonValue* const value = find(key);
  if (value == nullptr) return false;
  if (value->as<bool>() == nullptr)
    refuse(key, std::string("must be true or false, got ") + value->type());
  return *value->as<bool>();
}

std::optional<double> Request::positive(const char* key) const {
  const std::optional<double> found = number(key);
  if (found && !(*found > 0)) refuse(key, "must be > 0, got " + shown(*found));
  return found;
}

std::optional<Index> Request::whole(const char* key, Index least, Index most) const {
  const std::optional<double> found = number(key);
  if (!found) return std::nullopt;
  const bool is_whole = *found == std::floor(*found);
  if (!is_whole || *found < static_cast<double>(least) || *found > static_cast<double>(most))
    refuse(key, "must be a whole number from " + std::to_string(least) + " to " +
                    std::to_string(most) + ", got " + shown(*found));
  return static_cast<Index>(*found);
}

std::optional<std::vector<double>> Request::numbers_or(const char* key, Index count,
                                                       double otherwise) const {
  const JsonValue* const value = find(key);
  if (value == nullptr) return std::nullopt;
  const JsonArray* const array = value->as<JsonArray>();
  if (array == nullptr || static_cast<Index>(array->size()) != count)
    refuse(key, "must be an array of " + std::to_string(count) + " numbers");
  std::vector<double> list;
  for (const JsonValue& entry : *array) {
    if (!entry.is_null() && entry.as<double>() == nullptr)
      fields_.refuse(entry, quoted(key) + " must hold numbers, or null for none");
    list.push_back(entry.is_null() ? otherwise : *entry.as<double>());
  }
  return list;
}

std::string Request::one_of(const char* key, const std::vector<std::string>& known) const {
  const std::string wanted = text(key, known.front().c_str());
  if (std::find(known.begin(), known.end(), wanted) == known.end())
    refuse(key, "must be " + listed(known, "or") + ", not " + quoted(wanted) +
                    suggestion(wanted, known));
  return wanted;
}

std::string Request::format(const std::vector<std::string>& known) const {
  return one_of("format", known);
}

Solver Request::solver() const {
  const std::string wanted = one_of("solver", {"lemke", "gauss-seidel", "hybrid"});
  return wanted == "lemke"    ? Solver::lemke
         : wanted == "hybrid" ? Solver::hybrid
                              : Solver::gauss_seidel;
}

SceneFile Request::scene(Strokes strokes) const {
  if (find("scene") == nullptr) refuse("scene", "is missing: the text of a scene file");
  SceneFile file = parse_scene(text("scene"), scene_name(), strokes);
  refuse_unknowns(*this, file, limits::unknowns_held, "solution fits into 1 GB");
  return file;
}

VariedScene Request::varied_scene() const {
  if (find("scene") == nullptr) refuse("scene", "is missing: the text of a scene file");
  VariedScene scene = VariedScene::parse(text("scene"), scene_name());
  if (find("pressure") != nullptr) scene.set_pressure(one_of("pressure", {"pad", "even", "rigid"}));
  return scene;
}

Index Request::pusher(const SceneFile& file) const {
  std::vector<std::string> names;
  Index pusher = -1;
  const std::string wanted = text("pusher");
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].role != Role::pusher) continue;
    names.push_back(file.body_names[b]);
    if (wanted.empty() || wanted == names.back()) pusher = static_cast<Index>(b);
  }
  if (names.empty())
    throw InputError(scene_name() + ": the scene has no [[pusher]]: nothing can break the grasp");
  if (wanted.empty() && names.size() > 1)
    refuse("pusher", "is needed, there are several: " + listed(names, "or"));
  if (pusher < 0)
    refuse("pusher", "names no pusher: " + quoted(wanted) + suggestion(wanted, names));
  return pusher;
}

void Request::refuse(const char* key, const std::string& message) const {
  const JsonValue* const value = find(key);
  fields_.refuse(value != nullptr ? *value : root_, quoted(key) + " " + message);
}

Telling told_as(const std::string& format) {
  return format == "full_text" ? Telling::full : Telling::brief;
}

std::vector<std::string> scene_keys(std::vector<std::string> own) {
  own.insert(own.begin(), {"scene", "file", "format"});
  return own;
}

void refuse_still(const Request& request, const SceneFile& file) {
  if (!(push_size(file.view()) > 0))
    throw InputError(request.scene_name() +
                     ": no body of the scene moves: give a pusher an acceleration");
}

void refuse_unknowns(const Request& request, const SceneFile& file, Index most, const char* what) {
  const Index unknowns = size_of(file.view()).unknowns();
  if (unknowns > most)
    throw InputError(request.scene_name() + ": the scene has " + std::to_string(unknowns) +
                     " unknowns, more than the " + std::to_string(most) + " whose " + what +
                     "; use fewer points or facets");
}

} // namespace lcpush::desktop
