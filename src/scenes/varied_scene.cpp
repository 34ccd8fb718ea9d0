#include "lcpush/desktop/varied_scene.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "scenes/on_face.hpp"
#include "scenes/scene_builder.hpp"
#include "scenes/scene_schema.hpp"
#include "scenes/scene_units.hpp"
#include "scenes/table_changes.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

#include <algorithm>
#include <utility>

namespace lcpush::desktop {
namespace {

using Place = Parameter::Place;
using Kind = Parameter::Kind;

constexpr int root = -1;

struct Named {
  Parameter parameter;
  std::string owner, rest; ///< "left" and "points[0][1]"; both as in the path
};

Parameter parameter_of(const Named& named) {
  Parameter parameter = named.parameter;
  parameter.owner = named.owner;
  parameter.path = named.owner.empty() ? named.rest : named.owner + "." + named.rest;
  return parameter;
}

void add_numbers(const TomlValue& value, Named& named, std::vector<Named>& list) {
  Place& place = named.parameter.places.front();
  if (const auto number = value.number()) {
    named.rest = place.key;
    for (const std::size_t i : place.indices) named.rest += "[" + std::to_string(i) + "]";
    named.parameter.value = *number;
    named.parameter.typed = value.digits;
    named.parameter.ends.clear();
    for (const TomlValue& end : value.range) named.parameter.ends.push_back(end.digits);
    list.push_back(named);
  } else if (const auto* array = std::get_if<TomlArray>(&value.data)) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      place.indices.push_back(i);
      add_numbers((*array)[i], named, list);
      place.indices.pop_back();
    }
  }
}

void add_table(const std::string& section, const TomlTable& table, const std::string& owner,
               Place place, std::vector<Named>& list) {
  for (const TomlEntry& entry : table.entries) {
    const Key& key = *key_called(section, entry.key);
    place.key = entry.key;
    Named named;
    named.owner = owner;
    named.parameter.places = {place};
    named.parameter.whole = is_count(entry);
    named.parameter.unit = named.parameter.whole ? "" : key.unit;
    named.parameter.linear = key.is_linear;
    if (entry.key == "facets" && !entry.value.number()) { // "round" can be made a number
      named.rest = entry.key;
      named.parameter.value = static_cast<double>(SceneFile{}.facets);
      list.push_back(named);
    }
    const std::size_t first = list.size();
    add_numbers(entry.value, named, list);
    for (std::size_t i = first; i < list.size() && entry.key == "center"; ++i)
      list[i].parameter.axis = axis_in_face(table, i - first).value_or(-1) + 1;
  }
}

void add_motions(const TomlTable& table, const std::string& owner, const Place& place,
                 std::vector<Named>& list) {
  const auto add = [&](Kind kind, const std::string& rest) {
    list.push_back({{"", kind, {place}, 0, "degrees"}, owner, rest});
  };
  add(Kind::tangent_turn, "tangent_turn");
  if (table.find("acceleration") != nullptr || table.find("velocity") != nullptr)
    add(Kind::turn, "turn");
}

/// Each number that one path names, without those of `*`.
std::vector<Named> single_parameters(const TomlDocument& document) {
  std::vector<Named> list;
  add_table("", document.root, "", {root, 0, "", {}}, list);
  for (std::size_t s = 0; s < document.sections.size(); ++s) {
    const TomlSection& section = document.sections[s];
    for (std::size_t t = 0; t < section.tables.size(); ++t) {
      const TomlTable& table = section.tables[t];
      const std::string owner = table.name() != nullptr ? *table.name() : section.name;
      const Place place{static_cast<int>(s), static_cast<int>(t), "", {}};
      add_table(section.name, table, owner, place, list);
      if (is_body(section.name)) add_motions(table, owner, place, list);
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
    const Kind kind = list[i].parameter.kind;
    if (!of_body || (kind != Kind::number && kind != Kind::tangent_turn)) continue;
    const auto same = std::find_if(list.begin() + static_cast<std::ptrdiff_t>(singles), list.end(),
                                   [&](const Named& other) { return other.rest == list[i].rest; });
    if (same != list.end()) {
      same->parameter.places.push_back(place);
      continue;
    }
    list.push_back(list[i]);
    list.back().owner = "*";
  }
  for (Named& named : list) named.parameter = parameter_of(named);
  return list;
}

/// Vectors that are zero where a file leaves them out can vary as well, and the number of facets,
/// which then stands on no line.
void add_defaults(TomlDocument& document) {
  const auto add = [](TomlTable& table, const char* key) {
    const TomlValue zero{table.line, std::int64_t{0}, "0"};
    if (table.find(key) == nullptr)
      table.entries.push_back({key, {table.line, TomlArray{zero, zero, zero}}});
  };
  add(document.root, "gravity");
  if (document.root.find("facets") == nullptr)
    document.root.entries.push_back({"facets", {0, std::string("round")}});
  for (TomlSection& section : document.sections)
    for (TomlTable& table : section.tables) {
      if (section.name == "object")
        for (const char* key : {"center_of_mass", "force", "moment"}) add(table, key);
      if (is_body(section.name) && table.find("on") != nullptr && table.find("center") == nullptr)
        table.entries.push_back(
            {"center", {table.line, TomlArray(2, TomlValue{table.line, std::int64_t{0}, "0"})}});
      if (section.name == "pusher") {
        const bool has_speed =
            table.find("velocity") != nullptr || table.find("angular_velocity") != nullptr;
        add(table, has_speed ? "velocity" : "acceleration");
        add(table, has_speed ? "angular_velocity" : "angular_acceleration");
      }
      if (is_body(section.name)) add(table, "shift");
    }
}

/// What every owner has, an array's numbers as one.
std::string choices(const TomlDocument& document) {
  std::vector<std::pair<std::string, std::vector<std::string>>> owners;
  for (const Named& named : all_parameters(document)) {
    if (owners.empty() || owners.back().first != named.owner) owners.push_back({named.owner, {}});
    std::vector<std::string>& keys = owners.back().second;
    const std::size_t bracket = named.rest.find('[');
    const std::string key =
        bracket == std::string::npos ? named.rest : named.rest.substr(0, bracket) + "[..]";
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  }
  std::string text;
  for (const auto& [owner, keys] : owners)
    text += "\n" + wrapped("  " + (owner.empty() ? "" : owner + ".  ") + listed(keys, "and"));
  return text;
}

TomlTable& table_at(TomlDocument& document, const Place& place) {
  if (place.section == root) return document.root;
  return document.sections[static_cast<std::size_t>(place.section)]
      .tables[static_cast<std::size_t>(place.table)];
}

TomlValue& value_at(TomlDocument& document, const Place& place) {
  TomlValue* value = table_at(document, place).find(place.key);
  for (const std::size_t i : place.indices) value = &std::get<TomlArray>(value->data)[i];
  return *value;
}

TomlDocument exactly_changed(TomlDocument document, const std::vector<Parameter>& parameters,
                             const std::vector<Rational>& values) {
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (const Place& place : parameters[k].places)
      set_number(value_at(document, place), values[k]);
  return document;
}

bool operator==(const Place& a, const Place& b) {
  return a.section == b.section && a.table == b.table && a.key == b.key && a.indices == b.indices;
}

/// First the numbers, then what moves: a contact on a face is moved from where that then is.
TomlDocument changed(TomlDocument document, const std::vector<Parameter>& parameters,
                     const std::vector<double>& values) {
  bool turns = false, turns_tangent = false;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Parameter& parameter = parameters[k];
    turns = turns || parameter.kind != Kind::number;
    turns_tangent = turns_tangent || parameter.kind == Kind::tangent_turn;
    if (parameter.kind != Kind::number) continue;
    for (const Place& place : parameter.places)
      if (parameter.whole)
        set_count(value_at(document, place), values[k]);
      else
        set_number(value_at(document, place), values[k]);
  }
  if (!turns) return document;
  if (turns_tangent && has_contacts_on_faces(document))
    document = with_typed_places(std::move(document));
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (const Place& place : parameters[k].places) {
      TomlTable& table = table_at(document, place);
      if (parameters[k].kind == Kind::turn) turn_motion(table, values[k]);
      if (parameters[k].kind == Kind::tangent_turn) turn_tangent(table, values[k]);
    }
  return document;
}

SceneFile built(const TomlDocument& document, Hand hand, const std::vector<Parameter>& parameters,
                const std::vector<double>& values) {
  try {
    return build_scene<double>(document, hand);
  } catch (const InputError& error) {
    std::string where;
    for (std::size_t k = 0; k < parameters.size(); ++k)
      where += (k > 0 ? ", " : "") + parameters[k].path + " = " + shown(values[k]);
    throw InputError(std::string(error.what()) + (where.empty() ? "" : " (at " + where + ")"));
  }
}

} // namespace

VariedScene::VariedScene(TomlDocument document)
    : hand_(build_scene<double>(document).hand) { // as typed: complaints are about the file alone
  add_defaults(document);
  document_ = std::make_shared<const TomlDocument>(std::move(document));
}

VariedScene VariedScene::with_document(TomlDocument document) const {
  VariedScene scene = *this;
  scene.document_ = std::make_shared<const TomlDocument>(std::move(document));
  return scene;
}

VariedScene VariedScene::read(const std::string& path) {
  return parse(read_scene_text(path), scene_label(path));
}

VariedScene VariedScene::parse(std::string_view text, const std::string& file_name) {
  return VariedScene(parse_scene_tables(text, file_name));
}

void VariedScene::set(const std::string& key, const TomlValue& given) {
  TomlDocument document = *document_;
  if (TomlValue* const value = document.root.find(key); value != nullptr)
    *value = given;
  else
    document.root.entries.push_back({key, given});
  *this = VariedScene(std::move(document));
}

void VariedScene::set_pressure(const std::string& law) { set("pressure", {1, law}); }

void VariedScene::set_facets(std::optional<Index> facets) {
  if (facets)
    set("facets", {1, std::int64_t{*facets}, std::to_string(*facets)});
  else
    set("facets", {1, std::string("round")});
}

void VariedScene::set_planar() { set("planar", {1, true}); }

std::vector<std::string> VariedScene::paths() const {
  std::vector<std::string> paths;
  for (const Named& named : all_parameters(*document_)) paths.push_back(named.parameter.path);
  return paths;
}

Parameter VariedScene::find(const std::string& path) const {
  const std::vector<Named> all = all_parameters(*document_);
  for (const Named& named : all)
    if (named.parameter.path == path) return named.parameter;
  throw InputError(document_->file + ": nothing to vary is called " + quoted(path) +
                   suggestion(path, paths()) +
                   "; the numbers of this scene, vectors counted from [0]:" + choices(*document_));
}

SceneFile VariedScene::at(const std::vector<Parameter>& parameters,
                          const std::vector<double>& values) const {
  return built(changed(*document_, parameters, values), hand_, parameters, values);
}

SceneOf<Rational> VariedScene::exactly_at(const std::vector<Parameter>& parameters,
                                          const std::vector<Rational>& values) const {
  return build_scene<Rational>(exactly_changed(*document_, parameters, values), hand_);
}

std::string VariedScene::text_at(const std::vector<Parameter>& parameters,
                                 const std::vector<Rational>& values) const {
  return toml_text(exactly_changed(*document_, parameters, values));
}

std::vector<Parameter> VariedScene::ranges() const {
  std::vector<Parameter> list;
  for (const Named& named : single_parameters(*document_))
    if (!named.parameter.ends.empty()) list.push_back(parameter_of(named));
  return list;
}

std::vector<Parameter> VariedScene::singles(const std::string& path) const {
  const std::vector<Place> wanted = find(path).places;
  std::vector<Parameter> list;
  for (const Named& named : single_parameters(*document_)) {
    const Place& place = named.parameter.places.front();
    if (std::none_of(wanted.begin(), wanted.end(), [&](const Place& one) { return one == place; }))
      continue;
    list.push_back(parameter_of(named));
  }
  return list;
}

VariedScene VariedScene::with_ranges(const std::vector<Parameter>& parameters,
                                     const std::vector<std::pair<Rational, Rational>>& ends) const {
  TomlDocument document = *document_;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (const Place& place : parameters[k].places) {
      TomlValue& value = value_at(document, place);
      TomlValue low = value, high = value;
      set_number(low, ends[k].first);
      set_number(high, ends[k].second);
      set_number(value, (ends[k].first + ends[k].second) / Rational(2));
      value.range = {low, high};
    }
  VariedScene scene = with_document(std::move(document));
  (void)scene.as_given();
  return scene;
}

VariedScene VariedScene::with_only_pusher(const std::string& name) const {
  TomlDocument document = *document_;
  for (TomlSection& section : document.sections)
    if (section.name == "pusher")
      section.tables.erase(std::remove_if(section.tables.begin(), section.tables.end(),
                                          [&](const TomlTable& table) {
                                            return table.name() == nullptr || *table.name() != name;
                                          }),
                           section.tables.end());
  return with_document(std::move(document));
}

VariedScene VariedScene::with(const std::vector<Parameter>& parameters,
                              const std::vector<double>& values) const {
  VariedScene scene = with_document(changed(*document_, parameters, values));
  (void)built(*scene.document_, hand_, parameters, values);
  return scene;
}

} // namespace lcpush::desktop
