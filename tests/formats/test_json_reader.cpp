#include "formats/json_reader.hpp"

#include <doctest/doctest.h>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/input_error.hpp"

#include <cmath>
#include <cstring>
#include <random>

using namespace lcpush::desktop;

namespace {

std::string refusal(std::string_view text) {
  try {
    parse_json(text, "a.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("JSON: values of every type, and the lines where they start") {
  const JsonValue root = parse_json(
      "{\"a\": [1, -2.5e-3, true, null],\n \"b\": {\"c\": \"x\"},\n\"d\": false}", "a.json");
  const JsonArray& array = *root.find("a")->as<JsonArray>();
  REQUIRE(array.size() == 4);
  CHECK(*array[0].as<double>() == 1);
  CHECK(*array[1].as<double>() == -2.5e-3);
  CHECK(*array[2].as<bool>());
  CHECK(array[3].is_null());
  CHECK(*root.find("b")->find("c")->as<std::string>() == "x");
  CHECK(root.find("b")->line == 2);
  CHECK(root.find("d")->line == 3);
  CHECK(root.find("e") == nullptr);
  CHECK(root.find("a")->find("b") == nullptr); // no object
}

TEST_CASE("JSON: escapes become UTF-8, surrogate pairs one character") {
  const JsonValue value = parse_json(R"("\"\\\/\b\f\n\r\t\u00e9\ud83d\ude00")", "a.json");
  CHECK(*value.as<std::string>() == "\"\\/\b\f\n\r\t\xC3\xA9\xF0\x9F\x98\x80");
}

TEST_CASE("JSON: what the writer writes reads back, bit for bit") {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    double number = 0;
    const std::uint64_t bits = random();
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number)) continue;
    JsonWriter json;
    json.begin_object().member("\n\"x\x01", number).end_object();
    CHECK(*parse_json(json.text(), "a.json").find("\n\"x\x01")->as<double>() == number);
  }
}

TEST_CASE("JSON: everything else is refused with file and line") {
  for (const char* text : {"",
                           "[1,]",
                           "{\"a\" 1}",
                           "{a: 1}",
                           "[1 2]",
                           "01",
                           "1.",
                           ".5",
                           "+1",
                           "1e",
                           "--1",
                           "1e999",
                           "\"a",
                           "\"\x01\"",
                           "\"\\x\"",
                           "\"\\u12g4\"",
                           "\"\\ud800\"",
                           "\"\\ude00\"",
                           "tru",
                           "nul",
                           "[1] 2",
                           "{\"a\": 1, \"a\": 2}",
                           "NaN",
                           "-Infinity",
                           "[",
                           "{\"a\": "}) {
    const std::string given = text;
    CAPTURE(given);
    CHECK(refusal(text).find("a.json:1: ") == 0);
  }
  CHECK(refusal("\n\n[1,]").find("a.json:3: ") == 0);
  CHECK(refusal(std::string(1000, '[')).find("100 levels") != std::string::npos);
  CHECK(refusal(std::string(100, '[') + std::string(100, ']')).empty());
}
