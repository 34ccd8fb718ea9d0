// Prints every file named on the command line as one line of JSON, or as `error: MESSAGE`; exits 2
// if any was refused. tests/formats/toml_fuzz.py compares the lines with Python's tomllib.
#include "formats/toml.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/text_file.hpp"

#include <charconv>
#include <cstdio>
#include <iostream>

namespace {

using namespace lcpush::desktop;

struct Printer {
  std::string out;

  void operator()(bool value) { out += value ? "true" : "false"; }
  void operator()(std::int64_t value) { out += std::to_string(value); }
  void operator()(double value) {
    std::string digits(40, ' ');
    char* const start = digits.data();
    const char* const end = std::to_chars(start, start + digits.size(), value).ptr;
    digits.resize(static_cast<std::size_t>(end - start));
    // Without a point or an exponent, a reader of JSON would take it for a whole number.
    out += digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
  }
  void operator()(const std::string& value) {
    out += '"';
    for (const char c : value) {
      char escape[8];
      if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\') {
        std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
        out += escape;
      } else {
        out += c;
      }
    }
    out += '"';
  }
  void operator()(const TomlArray& array) {
    print_list(array, "[]", [this](const TomlValue& element) { std::visit(*this, element.data); });
  }
  void operator()(const TomlTable& table) {
    print_list(table.entries, "{}", [this](const TomlEntry& entry) { print(entry); });
  }
  void operator()(const TomlSection& section) {
    (*this)(section.name);
    out += ':';
    if (section.is_array) {
      print_list(section.tables, "[]", [this](const TomlTable& table) { (*this)(table); });
    } else {
      (*this)(section.tables.front());
    }
  }
  void print(const TomlEntry& entry) {
    (*this)(entry.key);
    out += ':';
    std::visit(*this, entry.value.data);
  }
  template <class List, class PrintOne>
  void print_list(const List& list, const char* brackets, PrintOne&& print_one) {
    out += brackets[0];
    for (const auto& element : list) {
      if (&element != &list.front()) out += ',';
      print_one(element);
    }
    out += brackets[1];
  }
};

} // namespace

int main(int count, char** arguments) {
  bool refused = false;
  for (int i = 1; i < count; ++i) {
    try {
      const TomlDocument document = parse_toml(read_text_file(arguments[i], 1U << 26U), "FILE");
      Printer root;
      root(document.root);
      Printer sections;
      sections.print_list(document.sections, "{}",
                          [&sections](const TomlSection& section) { sections(section); });
      std::cout << "[" << root.out << "," << sections.out << "]" << std::endl;
    } catch (const InputError& error) {
      refused = true;
      std::cout << "error: " << error.what() << std::endl;
    }
  }
  return refused ? 2 : 0;
}
