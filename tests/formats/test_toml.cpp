#include "formats/toml.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/text_file.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <fstream>
#include <string>

using namespace lcpush::desktop;

namespace {

std::string refusal(const std::string& text) {
  try {
    parse_toml(text, "t.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool refused_at(int line, const std::string& text) {
  const std::string message = refusal(text);
  CAPTURE(text);
  CAPTURE(message);
  return message.rfind("t.toml:" + std::to_string(line) + ": ", 0) == 0;
}

bool says(const std::string& message, const std::string& part) {
  CAPTURE(message);
  return message.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("tables and arrays of tables keep their keys and their lines") {
  const TomlDocument document =
      parse_toml("a = true\n[ t ] # one\nb = 1\r\n[[f]]\n[[f]]\nc = 2\n[u]", "f");
  CHECK(std::get<bool>(document.root.find("a")->data));
  CHECK(document.root.find("b") == nullptr);
  CHECK(document.find("t")->tables.front().line == 2);
  CHECK(document.find("t")->tables.front().find("b")->line == 3);
  REQUIRE(document.find("f")->tables.size() == 2);
  CHECK(document.find("f")->is_array);
  CHECK(document.find("f")->tables[0].entries.empty());
  CHECK(document.find("f")->tables[1].find("c")->line == 6);
  CHECK(document.find("u")->tables.front().entries.empty());
  CHECK(document.find("v") == nullptr);
}

TEST_CASE("what TOML forbids is refused at its line") {
  for (const char* value :
       {"",        "01",     "-01",      "1.",        ".5",          "1.e5",
        "1e",      "1__0",   "_1",       "1_",        "1_.5",        "1e_5",
        "++1",     "1 2",    "tru",      "True",      "[1 2]",       "[,]",
        "[1,,2]",  "\"open", "\"a\\q\"", "\"\\u12\"", "\"\\uD800\"", "\"\\U00110000\"",
        "\"a\" b", "\"a\\",  "[1",       "]"})
    CHECK(refused_at(2, "# first\nk = " + std::string(value)));
}

TEST_CASE("what TOML allows beyond the subset is refused, and the message says so") {
  CHECK(says(refusal("k = 0x1F"), "only decimal numbers"));
  CHECK(says(refusal("k = inf"), "must be finite"));
  CHECK(says(refusal("k = -nan"), "must be finite"));
  CHECK(says(refusal("k = 1979-05-27"), "dates and times are not supported"));
  CHECK(says(refusal("k = 07:32:00"), "dates and times are not supported"));
  CHECK(says(refusal("k = 'x'"), "literal"));
  CHECK(says(refusal("k = \"\"\"x\"\"\""), "multi-line"));
  CHECK(says(refusal("k = {a = 1}"), "inline tables"));
  CHECK(says(refusal("k.l = 1"), "dotted"));
  CHECK(says(refusal("[k.l]"), "dotted"));
  CHECK(says(refusal("\"k\" = 1"), "quoted keys"));
  CHECK(says(refusal("k = [true]"), "not supported in a list"));
  CHECK(says(refusal("k = 9223372036854775808"), "64 bits"));
  CHECK(says(refusal("k = 1e400"), "too large or too small"));
  CHECK(says(refusal("k = 1e-400"), "too large or too small"));
  CHECK(says(refusal("k = friction"), "double quotes"));
  CHECK(says(refusal("k = 120g"), "a number with a unit is a text; write \"120 g\""));
  CHECK(says(refusal("k = [1, -5 N m, 2]"), "write \"-5 N m\""));
}

TEST_CASE("duplicates are refused and name the first line") {
  CHECK(says(refusal("a = 1\na = 2"), "t.toml:2: duplicate key \"a\", first given on line 1"));
  CHECK(says(refusal("[a]\n[a]"),
             "t.toml:2: [a] is already defined on line 1; write [[a]] in both places if"));
  CHECK(refused_at(2, "[a]\n[[a]]"));
  CHECK(refused_at(2, "[[a]]\n[a]"));
  CHECK(refused_at(2, "a = 1\n[a]"));
  CHECK(refused_at(2, "a = []\n[[a]]"));
  CHECK(refusal("[a]\nk = 1\n[b]\nk = 1") == "accepted");
}

TEST_CASE("malformed headers and lines are refused") {
  for (const char* text : {"[a", "[a]]", "[[a]", "[[a] ]", "[ [a]]", "[]", "[a b]", "[a] b = 1",
                           "a", "a =", "= 1", "a == 1", "a = 1 b = 2", "a b = 1"})
    CHECK(refused_at(1, text));
}

TEST_CASE("a byte order mark is no part of the text") {
  CHECK(parse_toml("\xEF\xBB\xBF"
                   "a = 1",
                   "t.toml")
            .root.find("a") != nullptr);
  CHECK(says(refusal("a = 1\n\xEF\xBB\xBF"), "t.toml:2: "));
}

TEST_CASE("bytes that are no text are refused at their line") {
  CHECK(refused_at(2, "a = 1\nb = \"\x01\""));
  CHECK(refused_at(2, std::string("a = 1\n\0", 7)));
  CHECK(refused_at(1, "# \x7F"));
  CHECK(refused_at(1, "a = 1\rb = 2"));
  for (const char* bytes : {"\xFF", "\xC3", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80",
                            "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\x80", "\xF0\x80\x80\x80"})
    CHECK(says(refusal("a = 1\n# " + std::string(bytes)), "t.toml:2: not valid UTF-8"));
}

TEST_CASE("a hundred thousand brackets are an error, not a stack overflow") {
  CHECK(says(refusal("a = " + std::string(100000, '[')), "nested more than 8 deep"));
  CHECK(refusal("a = " + std::string(8, '[') + std::string(8, ']')) == "accepted");
  CHECK(refused_at(1, std::string(100000, '[')));
}

TEST_CASE("more values than memory should hold are an error") {
  std::string text = "a = [";
  for (int i = 0; i < 1000000; ++i) text += "0,";
  CHECK(says(refusal(text + "]"), "more than 1000000 tables and values"));
}

TEST_CASE("messages stay on one line and short, whatever the input") {
  const std::string message = refusal("k = " + std::string(5000, 'x'));
  CHECK(message.size() < 200);
  CHECK(refusal("k = \x1b").find('\x1b') == std::string::npos);
}

TEST_CASE("a directory and an endless file are refused") {
  CHECK_THROWS_WITH_AS(read_text_file(".", 5), ".: is a directory; name a file inside it",
                       InputError);
  if (std::ifstream("/dev/zero"))
    CHECK_THROWS_AS(read_text_file("/dev/zero", 1U << 20U), InputError);
}
