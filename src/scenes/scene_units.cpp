#include "scenes/scene_units.hpp"

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/rational.hpp"
#include "scenes/object_pose.hpp"
#include "scenes/scene_ranges.hpp"
#include "scenes/scene_schema.hpp"
#include "scenes/table_reader.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace lcpush::desktop {
namespace {

/// 10^power of `si`, the unit of bare numbers; degrees are pi / 180 rad.
struct Unit {
  const char *name, *si;
  int power = 0;
};
constexpr Unit units[] = {
    {"kg", "kg"},
    {"g", "kg", -3},
    {"m", "m"},
    {"cm", "m", -2},
    {"mm", "m", -3},
    {"um", "m", -6},
    {"N", "N"},
    {"mN", "N", -3},
    {"kN", "N", 3},
    {"N m", "N m"},
    {"N mm", "N m", -3},
    {"s", "s"},
    {"ms", "s", -3},
    {"rad", "rad"},
    {"deg", "rad"},
    {"deg", "degrees"},
    {"m/s", "m/s"},
    {"cm/s", "m/s", -2},
    {"mm/s", "m/s", -3},
    {"rad/s", "rad/s"},
    {"deg/s", "rad/s"},
    {"m/s^2", "m/s^2"},
    {"cm/s^2", "m/s^2", -2},
    {"mm/s^2", "m/s^2", -3},
    {"rad/s^2", "rad/s^2"},
    {"deg/s^2", "rad/s^2"},
    {"kg m^2", "kg m^2"},
};

struct Meaning {
  const char *name, *meaning;
};
constexpr Meaning dimensions[] = {
    {"kg", "a mass"},
    {"m", "a length"},
    {"N", "a force"},
    {"N m", "a moment"},
    {"s", "a time"},
    {"rad", "an angle"},
    {"degrees", "an angle"},
    {"m/s", "a speed"},
    {"rad/s", "an angular velocity"},
    {"m/s^2", "an acceleration"},
    {"rad/s^2", "an angular acceleration"},
    {"kg m^2", "a moment of inertia"},
};
/// What is refused, since a slip between them and SI is a classic, and what it is in SI.
constexpr Meaning imperial[] = {
    {"lb", "1 lb is 0.45359237 kg"},       {"lbs", "1 lb is 0.45359237 kg"},
    {"oz", "1 oz is 28.349523125 g"},      {"in", "1 in is 25.4 mm"},
    {"inch", "1 inch is 25.4 mm"},         {"ft", "1 ft is 304.8 mm"},
    {"lbf", "1 lbf is 4.4482216152605 N"},
};

template <class List> const auto* called(const List& list, std::string_view name) {
  const auto found = std::find_if(std::begin(list), std::end(list),
                                  [name](const auto& one) { return name == one.name; });
  return found == std::end(list) ? nullptr : &*found;
}

/// 10^power of the number with these digits.
std::string scaled(const std::string& digits, int power) {
  const std::size_t e = std::min(digits.find_first_of("eE"), digits.size());
  std::string_view exponent = std::string_view(digits).substr(std::min(e + 1, digits.size()));
  if (exponent.substr(0, 1) == "+") exponent.remove_prefix(1);
  power += whole_number<int>(exponent).value_or(0); // beyond int only zeros are left
  return digits.substr(0, e) + "e" + std::to_string(power);
}

Rational radians(const Rational& degrees) {
  return degrees * *Rational::parse("3.1415926535897932384626433832795028841971") / Rational(180);
}

bool is_meant(const Unit& unit, const std::vector<std::string>& si) {
  return std::find(si.begin(), si.end(), unit.si) != si.end();
}

std::string meant(const std::vector<std::string>& si) {
  std::vector<std::string> names;
  for (const Unit& unit : units)
    if (is_meant(unit, si)) names.push_back(unit.name);
  return "; " + (names.empty() ? "a number without a unit" : listed(names, "or")) + " is meant";
}

/// The unit's name as `units` has it: of symbols that people type or paste.
std::string plain_unit(std::string_view typed) {
  constexpr const char* spelled[][2] = {
      {"\xC2\xB2", "^2"}, {"\xC2\xB0", "deg"}, {"\xC2\xB5", "u"}, {"\xCE\xBC", "u"},
      {"\xC2\xB7", " "},  {"*", " "},          {"s2", "s^2"},     {"Nm", "N m"},
  };
  std::string name(typed);
  for (const auto& [symbol, plain] : spelled)
    if (const std::size_t at = name.find(symbol); at != std::string::npos)
      name.replace(at, std::string_view(symbol).size(), plain);
  return name;
}

/// Why "20 mm" is no mass.
std::string objection(const std::string& number, const std::string& name,
                      const std::vector<std::string>& si) {
  if (name.empty())
    return "the unit is missing; write " + number + " without quotes, or " +
           quoted(number + " " + (si[0] == "m" ? "mm" : si[0]));
  const std::size_t digit = name.find_first_of("0123456789");
  if (name[0] == ',' && digit == 1)
    return "write " + quoted(number + "." + name.substr(1)) + ", with a point in decimals";
  if (digit == 0 || (digit != std::string::npos && name[digit - 1] == ' '))
    return "several numbers are a list, [\"..\", \"..\"], each in its own quotes";
  if (const Unit* const unit = called(units, name))
    return called(dimensions, unit->si)->meaning + meant(si);
  if (const Meaning* const foreign = called(imperial, name))
    return quoted(name) + " is not read, " + foreign->meaning + meant(si);
  return "the unit " + quoted(name) + " is unknown" + meant(si);
}

/// "20 mm" in one of these units; neither digits nor a refusal: it does not begin with a number.
SiNumber in_si(std::string_view text, const std::vector<std::string>& si) {
  const std::string_view plain = text.substr(text.substr(0, 1) == "+" ? 1 : 0);
  const auto [length, is_whole] = decimal_prefix(plain);
  if (!is_whole) return {};
  const std::string number(plain.substr(0, length));
  const std::string name = plain_unit(trimmed(plain.substr(length)));
  const auto* const unit = std::find_if(std::begin(units), std::end(units), [&](const Unit& one) {
    return name == one.name && is_meant(one, si);
  });
  if (unit == std::end(units)) return {"", objection(number, name, si)};
  if (name.substr(0, 3) != "deg" || unit->si == std::string_view("degrees"))
    return {unit->power == 0 ? number : scaled(number, unit->power), "", name};
  const std::optional<Rational> degrees = Rational::parse(number);
  if (!degrees) return {"", "too long to be read exactly"};
  return {radians(*degrees).text(), "", name};
}

/// A number, or a fraction such as 1/3, without a unit.
bool is_bare(std::string_view text) {
  return !read_finite_number(text).error || Rational::parse(text);
}

/// Turns the texts of one table's numbers into numbers.
class UnitReader {
public:
  UnitReader(const std::string& file, const std::string& label) : file_(file), label_(label) {}

  /// `si`: the units of bare numbers that may be meant.
  void convert(const std::string& what, const std::vector<std::string>& si,
               TomlValue& value) const {
    if (auto* const list = std::get_if<TomlArray>(&value.data))
      for (std::size_t i = 0; i < list->size(); ++i) convert(entry_of(what, i), si, (*list)[i]);
    if (const auto* const text = std::get_if<std::string>(&value.data))
      value = is_product(*text) ? product(what, si, *text, value)
                                : converted(what + " = " + quoted(*text) + ": ", si,
                                            std::string(trimmed(*text)), value);
  }

private:
  /// "80 mm x 40 mm x 20 mm"?
  static bool is_product(std::string_view text) {
    const std::vector<std::string_view> parts = split_at(text, 'x');
    return parts.size() > 1 && std::all_of(parts.begin(), parts.end(), [](std::string_view part) {
             return decimal_prefix(trimmed(part)).is_whole;
           });
  }
  /// Its list; a unit at the end alone is that of all.
  TomlValue product(const std::string& what, const std::vector<std::string>& si,
                    const std::string& text, const TomlValue& as_text) const {
    const std::string_view last = trimmed(split_at(text, 'x').back());
    const std::string_view unit = last.substr(decimal_prefix(last).length);
    TomlArray list;
    for (const std::string_view part : split_at(text, 'x')) {
      const std::string_view number = trimmed(part);
      const bool is_bare = decimal_prefix(number).length == number.size();
      list.push_back({as_text.line, std::string(number) + std::string(is_bare ? unit : "")});
      convert(entry_of(what, list.size() - 1), si, list.back());
    }
    return {as_text.line, std::move(list)};
  }

  TomlValue converted(const std::string& said, const std::vector<std::string>& si,
                      const std::string& text, const TomlValue& as_text) const {
    const SiNumber number = in_si(text, si);
    if (!number.refusal.empty()) fail(as_text.line, said + number.refusal);
    if (number.digits.empty()) return as_text; // the reader of its table wants a number
    if (number.digits.find('/') != std::string::npos)
      return {as_text.line, number.value(), number.digits};
    TomlValue value{as_text.line, 0.0};
    if (const auto error = read_toml_number(number.digits, value))
      fail(as_text.line, said + *error);
    return value;
  }

  [[noreturn]] void fail(int line, const std::string& message) const {
    throw InputError(file_, line, label_.empty() ? message : label_ + ": " + message);
  }

  const std::string& file_;
  const std::string& label_;
};

/// What bare numbers of this key are measured in: of an actuator's, N of one that shifts its
/// bodies, N m of one that turns them, either where its twists do both.
std::vector<std::string> si_units(const Key& key, const TomlTable& table) {
  const TomlValue* const twists = table.find("twists");
  const auto* const rows = twists != nullptr ? std::get_if<TomlArray>(&twists->data) : nullptr;
  if (rows == nullptr || key.turning == nullptr) return {key.unit};
  bool shifts = false, turns = false;
  for (const TomlValue& row : *rows)
    if (const auto* const list = std::get_if<TomlArray>(&row.data))
      for (std::size_t i = 0; i < list->size(); ++i)
        if ((*list)[i].number().value_or(0) != 0) (i < 3 ? shifts : turns) = true;
  if (shifts && turns) return {key.unit, key.turning};
  return {turns ? key.turning : key.unit};
}

/// tilt stands for a rotation.
void read_tilt(const std::string& file, TomlTable& object) {
  for (TomlEntry& entry : object.entries) {
    if (entry.key != "tilt") continue;
    if (const TomlValue* const rotation = object.find("rotation"))
      throw InputError(file, rotation->line, "object: tilt is a rotation; keep one of the two");
    const std::optional<TomlValue> rotation = rotation_of_tilt(entry.value);
    if (!rotation)
      throw InputError(file, entry.value.line,
                       "object: tilt is an angle about an axis, such as \"20 deg about z\"; about "
                       "another one, write rotation = [x, y, z, \"20 deg\"]");
    const auto& angle = std::get<std::string>(std::get<TomlArray>(rotation->data).back().data);
    if (!read_finite_number(trimmed(angle)).error)
      throw InputError(file, entry.value.line,
                       "object: tilt has no unit; write \"20 deg about z\"");
    entry.key = "rotation";
    entry.value = *rotation;
  }
}

void read_units(const std::string& section, const std::string& label, bool planar,
                const std::string& file, TomlTable& table) {
  for (TomlEntry& entry : table.entries) {
    const Key* const key = key_called(section, entry.key);
    if (key == nullptr || *key->unit == '\0') continue;
    const bool is_text = std::holds_alternative<std::string>(entry.value.data);
    UnitReader(file, label).convert(entry.key, si_units(*key, table), entry.value);
    // In a plane "30 deg/s" can only be about z.
    if (!planar || !is_text || entry.key.find("angular_") != 0 || !entry.value.number()) continue;
    const TomlValue zero{entry.value.line, std::int64_t{0}, "0"};
    entry.value = {entry.value.line, TomlArray{zero, zero, entry.value}};
  }
}

} // namespace

double SiNumber::value() const {
  const NumberText number = read_finite_number(digits);
  return number.error ? Rational::parse(digits)->value() : number.value;
}

SiNumber typed_number(std::string_view word, const std::string& unit) {
  const std::string text(trimmed(word));
  if (is_bare(text)) return {text, ""};
  SiNumber number = in_si(text, {unit});
  if (number.refusal.empty() && number.digits.empty())
    number.refusal = *read_finite_number(text).error;
  return number;
}

std::pair<SiNumber, SiNumber> typed_ends(std::string_view from, std::string_view to,
                                         const std::string& unit) {
  const std::string_view end = trimmed(to);
  std::string begin(trimmed(from));
  if (is_bare(begin) && !is_bare(end)) begin += end.substr(decimal_prefix(end).length);
  return {typed_number(begin, unit), typed_number(end, unit)};
}

TomlDocument parse_scene_tables(std::string_view text, const std::string& file_name) {
  TomlDocument document = parse_toml(text, file_name);
  check_sections(document);
  const TomlValue* const planar = document.root.find("planar");
  const bool* const is_planar = planar != nullptr ? std::get_if<bool>(&planar->data) : nullptr;
  read_units("", "", false, document.file, document.root);
  for (TomlSection& section : document.sections)
    for (std::size_t i = 0; i < section.tables.size(); ++i) {
      if (section.name == "object") read_tilt(document.file, section.tables[i]);
      read_units(section.name, table_label(section, i), is_planar != nullptr && *is_planar,
                 document.file, section.tables[i]);
    }
  read_ranges(document);
  return document;
}

} // namespace lcpush::desktop
