#include "scenes/table_reader.hpp"

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace lcpush::desktop {
namespace {

// Far outside any mechanism in SI units, far inside what double can multiply a few times.
constexpr double largest_magnitude = 1e12;
constexpr double smallest_positive = 1e-24;

std::string described(const TomlValue& value) {
  if (const auto* truth = std::get_if<bool>(&value.data)) return *truth ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value.data)) return shown(*real);
  if (const auto* text = std::get_if<std::string>(&value.data)) return "the text " + quoted(*text);
  return "a list";
}

/// "; write 0.3", of "0.3" and "30 %".
std::string unquoted(const TomlValue& value) {
  const auto* const text = std::get_if<std::string>(&value.data);
  if (text == nullptr) return "";
  const auto [length, is_whole] = decimal_prefix(*text);
  if (!is_whole) return "";
  const std::string_view rest = trimmed(std::string_view(*text).substr(length));
  const double number = read_finite_number(std::string_view(*text).substr(0, length)).value;
  if (rest.empty()) return "; write " + shown(number);
  return rest == "%" ? "; write " + shown(number / 100) : "";
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

} // namespace

std::string table_label(const TomlSection& section, std::size_t index) {
  if (!section.is_array) return section.name;
  const std::string* const name = section.tables[index].name();
  return section.name + " " + (name != nullptr ? quoted(*name) : std::to_string(index + 1));
}

TomlValue typed_vector(int line, const Vector3<Rational>& vector) {
  TomlArray list;
  for (Index i = 0; i < 3; ++i) list.push_back({line, vector[i].value(), vector[i].text()});
  return {line, list};
}

TableReader::TableReader(const std::string& file, const TomlTable& table, std::string label,
                         const Schema& schema)
    : file_(file), table_(table), label_(std::move(label)), schema_(schema) {
  refuse_unknown_keys();
}

void TableReader::fail_at(int line, const std::string& message) const {
  throw InputError(file_, line, label_.empty() ? message : label_ + ": " + message);
}

void TableReader::fail(const std::string& key, const std::string& message) const {
  const TomlValue* value = table_.find(key);
  fail_at(value ? value->line : table_.line, message);
}

int TableReader::line_of(const std::vector<std::string>& keys) const {
  for (const std::string& key : keys)
    if (const TomlValue* value = table_.find(key)) return value->line;
  return table_.line;
}

void TableReader::refuse_unknown_keys() const {
  for (const TomlEntry& entry : table_.entries) {
    const auto is_key = [&entry](const Key& known) { return known.name == entry.key; };
    if (std::any_of(schema_.begin(), schema_.end(), is_key)) continue;
    fail_at(entry.value.line, "unknown key " + quoted(entry.key) + key_hint(schema_, entry.key));
  }
}

const TomlValue& TableReader::require(const std::string& key) const {
  if (const TomlValue* value = table_.find(key)) return *value;
  const auto is_key = [&key](const Key& known) { return known.name == key; };
  const auto known = std::find_if(schema_.begin(), schema_.end(), is_key);
  fail(key, "missing key " + quoted(key) + "; add for example " + key + " = " + known->example +
                (*known->unit == '\0' ? "" : std::string("  # ") + known->unit));
}

bool TableReader::is_text(const std::string& key) const {
  const TomlValue* const value = table_.find(key);
  return value != nullptr && std::holds_alternative<std::string>(value->data);
}

bool TableReader::is_irrational(const std::string& key) const {
  const TomlValue* const value = table_.find(key);
  if (value == nullptr) return false;
  const auto is_fraction = [](const TomlValue& one) {
    return one.digits.find('/') != std::string::npos;
  };
  const auto* const list = std::get_if<TomlArray>(&value->data);
  return list != nullptr ? std::any_of(list->begin(), list->end(), is_fraction)
                         : is_fraction(*value);
}

bool TableReader::boolean(const std::string& key) const {
  const TomlValue& value = require(key);
  if (const auto* truth = std::get_if<bool>(&value.data)) return *truth;
  fail(key, key + " must be true or false, got " + described(value));
}

std::string TableReader::as_text(const std::string& what, const TomlValue& value) const {
  const auto* text = std::get_if<std::string>(&value.data);
  if (!text)
    fail_at(value.line, what + " must be a text in \"double quotes\", got " + described(value));
  if (text->empty()) fail_at(value.line, what + " must not be empty");
  if (std::any_of(text->begin(), text->end(), is_control))
    fail_at(value.line, what + " must not contain control characters, got " + quoted(*text));
  return *text;
}

std::string TableReader::text(const std::string& key) const { return as_text(key, require(key)); }

std::size_t TableReader::choice(const std::string& key,
                                const std::vector<std::string>& choices) const {
  const std::string word = text(key);
  const auto found = std::find(choices.begin(), choices.end(), word);
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  std::vector<std::string> in_quotes;
  for (const std::string& one : choices) in_quotes.push_back(quoted(one));
  fail(key, key + " must be " + listed(in_quotes, "or") + ", got " + quoted(word) +
                suggestion(word, choices));
}

double TableReader::checked_number(const std::string& what, const TomlValue& value,
                                   Sign sign) const {
  for (const TomlValue& end : value.range) (void)checked_number(what, end, sign);
  if (!value.number())
    fail_at(value.line, what + " must be a number, got " + described(value) + unquoted(value));
  const double number = *value.number();
  const auto require_that = [&](bool holds, const std::string& rule) {
    if (!holds) fail_at(value.line, what + " must be " + rule + ", got " + described(value));
  };
  if (sign == Sign::positive) require_that(number > 0, "> 0");
  if (sign == Sign::not_negative) require_that(number >= 0, ">= 0");
  require_that(std::abs(number) <= largest_magnitude, "within 1e12 in SI units");
  require_that(sign != Sign::positive || number >= smallest_positive, ">= 1e-24 in SI units");
  return number;
}

std::string entry_of(const std::string& what, std::size_t index) {
  return "entry " + std::to_string(index + 1) + " of " + what;
}

template <class S>
S TableReader::as_number(const std::string& what, const TomlValue& value, Sign sign) const {
  const double number = checked_number(what, value, sign);
  if constexpr (std::is_same_v<S, double>) {
    return number;
  } else {
    if (std::optional<S> exact = S::parse(value.digits)) return std::move(*exact);
    fail_at(value.line, what + " is too long to be read exactly, got " + described(value) +
                            "; use exponents within +-1000 and at most 10,000 digits");
  }
}
template double TableReader::as_number(const std::string&, const TomlValue&, Sign) const;
template Rational TableReader::as_number(const std::string&, const TomlValue&, Sign) const;

Index TableReader::as_whole(const std::string& what, const TomlValue& value, Index smallest,
                            Index largest) const {
  const auto* whole = std::get_if<std::int64_t>(&value.data);
  if (!whole || *whole < smallest || *whole > largest)
    fail_at(value.line, what + " must be a whole number from " + std::to_string(smallest) + " to " +
                            std::to_string(largest) + ", got " + described(value));
  return static_cast<Index>(*whole);
}

Index TableReader::whole(const std::string& key, Index smallest, Index largest) const {
  return as_whole(key, require(key), smallest, largest);
}

const TomlArray& TableReader::as_list(const std::string& what, const TomlValue& value,
                                      const std::vector<std::size_t>& lengths) const {
  const auto* list = std::get_if<TomlArray>(&value.data);
  if (list && std::find(lengths.begin(), lengths.end(), list->size()) != lengths.end())
    return *list;
  std::vector<std::string> allowed;
  for (const std::size_t length : lengths) allowed.push_back(std::to_string(length));
  std::string got = list ? "a list of " + std::to_string(list->size()) : described(value);
  if (list && list->size() > lengths.back()) got += "; a decimal number has a point, such as 0.3";
  if (!list && lengths.back() > 2) // on a face they are two, and examples have three
    for (const Key& key : schema_)
      if (key.name == what) got += std::string("; write ") + key.example;
  fail_at(value.line,
          what + " must be a list of " + listed(allowed, "or") + " numbers, got " + got);
}

std::vector<Index> TableReader::wholes(const std::string& key, std::size_t size, Index smallest,
                                       Index largest) const {
  std::vector<Index> result;
  for (const TomlValue& element : as_list(key, require(key), {size}))
    result.push_back(as_whole(entry_of(key, result.size()), element, smallest, largest));
  return result;
}

const TomlArray& TableReader::list(const std::string& key, std::size_t most) const {
  const TomlValue& value = require(key);
  const auto* array = std::get_if<TomlArray>(&value.data);
  if (!array) fail(key, key + " must be a list, got " + described(value));
  if (array->empty()) fail(key, key + " must not be empty");
  if (array->size() > most)
    fail(key, key + " must have at most " + std::to_string(most) + " entries, got " +
                  std::to_string(array->size()));
  return *array;
}

std::vector<std::string> TableReader::texts(const std::string& key, std::size_t most) const {
  std::vector<std::string> result;
  for (const TomlValue& element : list(key, most))
    result.push_back(as_text(entry_of(key, result.size()), element));
  return result;
}

} // namespace lcpush::desktop
