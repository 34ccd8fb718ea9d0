#include "scenes/scene_ranges.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "scenes/scene_schema.hpp"
#include "scenes/table_changes.hpp"
#include "scenes/table_reader.hpp"
#include "text/wording.hpp"

#include <cctype>
#include <string_view>
#include <utility>

namespace lcpush::desktop {
namespace {

/// Calls see(label, key, value) for every entry of the document's tables.
template <class Document, class See> void for_each_entry(Document& document, const See& see) {
  for (auto& entry : document.root.entries) see("", "", entry);
  for (auto& section : document.sections)
    for (std::size_t i = 0; i < section.tables.size(); ++i)
      for (auto& entry : section.tables[i].entries)
        see(section.name, table_label(section, i), entry);
}

class RangeReader {
public:
  RangeReader(const std::string& file, const std::string& label) : file_(file), label_(label) {}

  /// `depth`: of the lists in which a key's numbers stand.
  void read(const std::string& what, std::size_t depth, TomlValue& value) const {
    auto* const list = std::get_if<TomlArray>(&value.data);
    if (list == nullptr) return;
    for (std::size_t i = 0; depth > 0 && i < list->size(); ++i)
      read(entry_of(what, i), depth - 1, (*list)[i]);
    if (depth > 0 || list->size() != 2) return; // what is wrong with it says the table's reader
    if (!(*list)[0].number() || !(*list)[1].number()) return;
    const auto low = Rational::parse((*list)[0].digits), high = Rational::parse((*list)[1].digits);
    if (!low || !high) fail(value.line, what + " is too long to be read exactly");
    if (*high < *low)
      fail(value.line, what + " = [" + shown(low->value()) + ", " + shown(high->value()) +
                           "] is a range that goes backwards; the smaller number comes first");
    TomlArray ends = std::move(*list);
    set_number(value, (*low + *high) / Rational(2));
    if (*low < *high) value.range = std::move(ends); // one value is as good as plain
  }

private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw InputError(file_, line, label_.empty() ? message : label_ + ": " + message);
  }

  const std::string& file_;
  const std::string& label_;
};

void add_ranges(const std::string& what, const TomlValue& value, RangeNote& note) {
  if (!value.range.empty()) {
    if (note.line == 0) note.line = value.line;
    note.text += (note.text.empty() ? "" : ", ") + what + " = " + shown(*value.number()) + " (" +
                 shown(*value.range[0].number()) + " to " + shown(*value.range[1].number()) + ")";
  }
  if (const auto* const list = std::get_if<TomlArray>(&value.data))
    for (std::size_t i = 0; i < list->size(); ++i)
      add_ranges(what + "[" + std::to_string(i) + "]", (*list)[i], note);
}

} // namespace

void read_ranges(TomlDocument& document) {
  for_each_entry(document,
                 [&](const std::string& section, const std::string& label, TomlEntry& entry) {
                   const Key* const key = key_called(section, entry.key);
                   if (key == nullptr) return;
                   const std::string_view example = key->example;
                   const std::size_t depth = example.find_first_not_of('[');
                   const char first = example[depth];
                   if (std::isdigit(static_cast<unsigned char>(first)) == 0 && first != '-') return;
                   RangeReader(document.file, label).read(entry.key, depth, entry.value);
                 });
}

RangeNote range_note(const TomlDocument& document) {
  RangeNote note;
  for_each_entry(
      document, [&](const std::string&, const std::string& label, const TomlEntry& entry) {
        add_ranges(label.empty() ? entry.key : label + " " + entry.key, entry.value, note);
      });
  return note;
}

} // namespace lcpush::desktop
