#include "formats/toml.hpp"

#include "formats/read_number.hpp"
#include "formats/text_cursor.hpp"
#include "text/limits.hpp"
#include "text/utf8.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>

namespace lcpush::desktop {
namespace {

bool is_bare_key_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

class TomlParser : TextCursor {
public:
  TomlParser(std::string_view text, const std::string& file) : TextCursor(text, file) {
    document_.file = file;
    document_.root.line = 1;
  }

  TomlDocument parse() {
    check_characters();
    for (skip_blank_lines(); !at_end(); skip_blank_lines()) {
      if (peek() == '[') {
        parse_header();
      } else {
        parse_entry();
      }
      expect_end_of_line();
    }
    return std::move(document_);
  }

private:
  // Past check_characters() there is no NUL in the text, so peek() alone tells the end.
  std::string found() const {
    if (at_end()) return "the end of the file";
    if (peek() == '\n' || peek() == '\r') return "the end of the line";
    return quoted(text_.substr(at_, utf8_length(text_.substr(at_))));
  }

  /// What TOML allows nowhere is refused first, so that the grammar below need not think of it.
  void check_characters() {
    (void)take("\xEF\xBB\xBF"); // a byte order mark
    if (peek() == '{') fail("this looks like JSON; a scene is TOML (`lcpush new box` writes one)");
    if (next_is("%%MatrixMarket"))
      fail("this is a Matrix Market file; a scene is TOML (`lcpush new box` writes one), and a "
           "problem is two files, M.mtx and q.mtx");
    int line = 1;
    for (std::size_t i = 0; i < text_.size();) {
      const std::string_view rest = text_.substr(i);
      const std::size_t length = utf8_length(rest);
      if (length == 0) fail_at(line, "not valid UTF-8; save the file as UTF-8 text");
      const auto byte = static_cast<unsigned char>(rest[0]);
      const bool is_line_end = byte == '\n' || rest.substr(0, 2) == "\r\n";
      if ((byte < 0x20 && byte != '\t' && !is_line_end) || byte == 0x7F)
        fail_at(line, "control character " + quoted(rest.substr(0, 1)) +
                          "; remove it, or write it as an escape inside a string");
      if (byte == '\n') ++line;
      i += length;
    }
  }

  void skip_spaces() {
    while (peek() == ' ' || peek() == '\t') ++at_;
  }

  void skip_comment() {
    if (peek() != '#') return;
    at_ = std::min(text_.find('\n', at_), text_.size());
  }

  void skip_blank_lines() {
    for (;;) {
      skip_spaces();
      skip_comment();
      (void)take("\r");
      if (!take("\n")) return;
      ++line_;
    }
  }

  void expect_end_of_line() {
    skip_spaces();
    skip_comment();
    if (peek() == ',') fail("unexpected \",\"; a decimal number has a point, such as 0.3");
    if (!at_end() && peek() != '\n' && peek() != '\r')
      fail("unexpected " + found() + "; start a new line, or put # before a comment");
  }

  void count_item() {
    if (++items_ > limits::toml_items)
      fail("more than " + std::to_string(limits::toml_items) +
           " tables and values; split the file");
  }

  void parse_header() {
    const int line = line_;
    const bool is_array = next_is("[[");
    const std::string_view closing = is_array ? "]]" : "]";
    at_ += closing.size();
    skip_spaces();
    const std::string name = parse_key();
    skip_spaces();
    if (!take(closing))
      fail("expected " + quoted(closing) + " after the table name " + quoted(name) + ", found " +
           found());
    open_table(name, is_array, line);
  }

  void open_table(const std::string& name, bool is_array, int line) {
    count_item();
    if (const TomlValue* value = document_.root.find(name))
      fail(quoted(name) + " is already a key, on line " + std::to_string(value->line) +
           "; rename one of them");
    const auto [position, is_new] = sections_by_name_.emplace(name, document_.sections.size());
    if (is_new) document_.sections.push_back({name, is_array, {}});
    TomlSection& section = document_.sections[position->second];
    if (!is_new && !(is_array && section.is_array)) {
      const bool mixed = is_array != section.is_array;
      fail("[" + name + "] is already defined on line " +
           std::to_string(section.tables.front().line) + "; write [[" + name + "]] in both places" +
           (mixed ? "" : " if there may be several, else merge the two"));
    }
    section.tables.push_back({line, {}, at_});
    table_ = &section.tables.back();
    key_lines_.clear();
  }

  void parse_entry() {
    const std::size_t begin = at_;
    std::string key = parse_key();
    const auto [first, is_new] = key_lines_.emplace(key, line_);
    if (!is_new)
      fail("duplicate key " + quoted(key) + ", first given on line " +
           std::to_string(first->second) + "; remove one of them");
    skip_spaces();
    if (!take("=")) fail("expected = after " + quoted(key) + ", found " + found());
    skip_spaces();
    TomlValue value = parse_value(0);
    table_->entries.push_back({std::move(key), std::move(value), begin, at_});
    table_->end = at_;
  }

  std::string parse_key() {
    if (peek() == '"' || peek() == '\'') fail("quoted keys are not supported; write a bare key");
    const std::size_t start = at_;
    while (is_bare_key_character(peek())) ++at_;
    if (at_ == start)
      fail("expected a key or table name (letters, digits, _ and -), found " + found());
    std::string key(text_.substr(start, at_ - start));
    if (peek() == '.') fail("dotted keys are not supported; write " + quoted(key) + " as a table");
    return key;
  }

  TomlValue parse_value(int depth) {
    count_item();
    const int line = line_;
    switch (peek()) {
    case '"': return {line, parse_string()};
    case '[': return {line, parse_array(depth + 1)};
    case '\'': fail("'literal' strings are not supported; use \"double quotes\"");
    case '{': fail("inline tables are not supported; use a [table] of its own");
    default: break;
    }
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n,]#", at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    if (word.empty()) fail("expected a value, found " + found());
    at_ = end;
    if (word == "true" || word == "false") {
      if (depth > 0) fail("true and false are not supported in a list; use numbers or strings");
      return {line, word == "true"};
    }
    refuse_bare_unit(at_ - word.size());
    TomlValue number{line, 0.0};
    if (const auto error = read_toml_number(word, number)) fail(*error);
    return number;
  }

  /// 120g or 120 g: a number, then letters up to the end of the value.
  void refuse_bare_unit(std::size_t start) const {
    const std::size_t end = std::min(text_.find_first_of("\r\n,]#=", start), text_.size());
    const std::string_view typed = trimmed(text_.substr(start, end - start));
    const auto [length, is_whole] = decimal_prefix(typed);
    const std::string unit(trimmed(typed.substr(length)));
    const bool is_letter = !unit.empty() && std::isalpha(static_cast<unsigned char>(unit[0])) != 0;
    const bool is_octal =
        typed.substr(0, 1) == "0" && length == 1 && typed.find_first_of("xob") == 1;
    if (!is_whole || !is_letter || is_octal || (end < text_.size() && text_[end] == '=')) return;
    fail("a number with a unit is a text; write \"" + std::string(typed.substr(0, length)) + " " +
         unit + "\"");
  }

  TomlArray parse_array(int depth) {
    if (depth > limits::toml_list_depth)
      fail("lists are nested more than " + std::to_string(limits::toml_list_depth) +
           " deep; is a ] missing before?");
    const int opened = line_;
    TomlArray array;
    ++at_;
    for (skip_blank_lines(); peek() != ']'; skip_blank_lines()) {
      if (at_end()) fail_at(opened, "this [ is never closed; add the missing ]");
      array.push_back(parse_value(depth));
      skip_blank_lines();
      if (!take(",") && !at_end() && peek() != ']')
        fail("expected , or ] in the list that starts on line " + std::to_string(opened) +
             ", found " + found());
    }
    ++at_;
    return array;
  }

  std::string parse_string() {
    if (next_is("\"\"\"")) fail("multi-line strings are not supported; use one line and \\n");
    ++at_;
    std::string result;
    while (peek() != '"') {
      if (at_end() || peek() == '\n' || peek() == '\r')
        fail("the string is not closed; add the missing \" on this line");
      if (peek() == '\\') {
        parse_escape(result);
      } else {
        result += text_[at_++];
      }
    }
    ++at_;
    return result;
  }

  void parse_escape(std::string& result) {
    ++at_;
    if (take_escape("btnfr\"\\", "\b\t\n\f\r\"\\", result)) return;
    if (peek() != 'u' && peek() != 'U')
      fail("unknown escape; use \\b \\t \\n \\f \\r \\\" \\\\ \\uXXXX or \\UXXXXXXXX");
    const std::size_t digits = peek() == 'u' ? 4 : 8;
    ++at_;
    const std::optional<std::uint32_t> code = take_hexadecimal(digits);
    if (!code || !is_unicode_scalar(*code))
      fail("an escape needs " + std::to_string(digits) +
           " hexadecimal digits that name a Unicode character");
    append_utf8(result, *code);
  }

  std::size_t items_ = 0;
  TomlDocument document_;
  TomlTable* table_ = &document_.root;
  std::map<std::string, int> key_lines_;                ///< of the current table
  std::map<std::string, std::size_t> sections_by_name_; ///< indices into document_.sections
};

} // namespace

std::optional<double> TomlValue::number() const {
  if (const auto* whole = std::get_if<std::int64_t>(&data)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&data)) return *real;
  return std::nullopt;
}

const std::string* TomlTable::name() const {
  const TomlValue* const value = find("name");
  return value != nullptr ? std::get_if<std::string>(&value->data) : nullptr;
}

const TomlValue* TomlTable::find(std::string_view key) const {
  const auto is_key = [key](const TomlEntry& entry) { return entry.key == key; };
  const auto entry = std::find_if(entries.begin(), entries.end(), is_key);
  return entry == entries.end() ? nullptr : &entry->value;
}

const TomlSection* TomlDocument::find(std::string_view name) const {
  const auto is_name = [name](const TomlSection& section) { return section.name == name; };
  const auto section = std::find_if(sections.begin(), sections.end(), is_name);
  return section == sections.end() ? nullptr : &*section;
}

std::string toml_text(const TomlValue& value) {
  if (const auto* const truth = std::get_if<bool>(&value.data)) return *truth ? "true" : "false";
  std::string text;
  if (const auto* const word = std::get_if<std::string>(&value.data)) {
    constexpr unsigned first_printable = 0x20, deleted = 0x7F;
    for (const char c : *word) {
      const auto byte = static_cast<unsigned char>(c);
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04X", static_cast<unsigned>(byte));
      text += byte < first_printable || byte == deleted ? code
              : c == '"' || c == '\\'                   ? std::string("\\") + c
                                                        : std::string(1, c);
    }
    return "\"" + text + "\"";
  }
  const auto* const list = std::get_if<TomlArray>(&value.data);
  const bool is_decimal = !value.digits.empty() && value.digits.find('/') == std::string::npos;
  if (list == nullptr) return is_decimal ? value.digits : shown(*value.number());
  for (const TomlValue& entry : *list) text += (text.empty() ? "" : ", ") + toml_text(entry);
  return "[" + text + "]";
}

std::string toml_text(const TomlDocument& document) {
  std::string text;
  const auto add = [&text](const TomlTable& table) {
    for (const TomlEntry& entry : table.entries)
      text += entry.key + " = " + toml_text(entry.value) + "\n";
  };
  add(document.root);
  for (const TomlSection& section : document.sections)
    for (const TomlTable& table : section.tables) {
      text += section.is_array ? "\n[[" + section.name + "]]\n" : "\n[" + section.name + "]\n";
      add(table);
    }
  return text;
}

TomlDocument parse_toml(std::string_view text, const std::string& file_name) {
  return TomlParser(text, file_name).parse();
}

} // namespace lcpush::desktop
