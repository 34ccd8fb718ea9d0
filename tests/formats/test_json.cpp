#include "formats/json_writer.hpp"

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace {

using lcpush::desktop::JsonWriter;

template <class T> std::string written(const T& data) {
  std::string text = JsonWriter().value(data).text();
  text.pop_back(); // the final newline
  return text;
}

} // namespace

TEST_CASE("numbers are the shortest that read back, others are null") {
  CHECK(written(0.1) == "0.1");
  CHECK(written(20.0) == "20");
  CHECK(written(1e300) == "1e+300");
  CHECK(written(-0.0) == "-0.0");
  CHECK(written(5e-324) == "5e-324");
  CHECK(written(std::numeric_limits<double>::infinity()) == "null");
  CHECK(written(-std::numeric_limits<double>::infinity()) == "null");
  CHECK(written(std::nan("")) == "null");
}

TEST_CASE("any finite double reads back bit for bit") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i) {
    const std::uint64_t bits = random();
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number)) continue;
    const std::string text = written(number);
    double again = 0;
    std::from_chars(text.data(), text.data() + text.size(), again);
    CHECK(std::memcmp(&again, &number, sizeof number) == 0);
  }
}

TEST_CASE("strings are escaped") {
  CHECK(written("a\"b\\c") == R"("a\"b\\c")");
  CHECK(written("\b\f\n\r\t") == R"("\b\f\n\r\t")");
  CHECK(written(std::string("\0\x1f", 2)) == R"("\u0000\u001f")");
  CHECK(written("\xC3\xA9 \xF0\x9F\x98\x80") == "\"\xC3\xA9 \xF0\x9F\x98\x80\"");
}

TEST_CASE("what is no UTF-8 is replaced, one character a byte") {
  const std::string replaced = "\xEF\xBF\xBD";
  CHECK(written("a\xFF"
                "b") == "\"a" + replaced + "b\"");
  CHECK(written("\xC0\x80") == "\"" + replaced + replaced + "\"");                // overlong
  CHECK(written("\xED\xA0\x80") == "\"" + replaced + replaced + replaced + "\""); // surrogate
  CHECK(written("\xC3") == "\"" + replaced + "\"");                               // cut off
}

TEST_CASE("objects and arrays are indented, short vectors stay on a line") {
  const Eigen::Vector3d force(1, -2.5, 0);
  JsonWriter json;
  json.begin_object().member("status", "solved").member("force", force);
  json.key("contacts").begin_array();
  json.begin_object().member("name", "left").member("torsion", nullptr).end_object();
  json.begin_object().end_object();
  json.end_array().key("ray").begin_array().end_array();
  json.member("basis", std::vector<std::string>{"z1", "w\n"});
  json.member("none", std::vector<double>{}).member("rows", std::vector{force, force});
  json.end_object();
  CHECK(json.text() == R"({
  "status": "solved",
  "force": [1, -2.5, 0],
  "contacts": [
    {
      "name": "left",
      "torsion": null
    },
    {}
  ],
  "ray": [],
  "basis": ["z1", "w\n"],
  "none": [],
  "rows": [
    [1, -2.5, 0],
    [1, -2.5, 0]
  ]
}
)");
}

TEST_CASE("lists of objects, and what is not known") {
  JsonWriter json;
  json.begin_object().objects("named", std::vector<std::string>{"a"},
                              [&](const std::string& name) { json.member("name", name); });
  json.objects("counted", std::ptrdiff_t{2}, [&](std::ptrdiff_t i) { json.member("i", i); });
  json.list("each", std::vector<int>{1, 2}, [&](int number) { json.value(number); });
  json.member("known", lcpush::desktop::when(true, 1))
      .member("unknown", lcpush::desktop::when(false, 1));
  json.member("empty", lcpush::desktop::unless_empty(std::string()));
  json.member("full", lcpush::desktop::unless_empty(std::vector<double>{1, 2})).end_object();
  CHECK(json.text() == R"({
  "named": [
    {
      "name": "a"
    }
  ],
  "counted": [
    {
      "i": 0
    },
    {
      "i": 1
    }
  ],
  "each": [
    1,
    2
  ],
  "known": 1,
  "unknown": null,
  "empty": null,
  "full": [1, 2]
}
)");
}

TEST_CASE("a vector stays on its line up to the hundredth character, its comma included") {
  for (std::size_t length = 85; length <= 100; ++length) {
    JsonWriter json;
    const std::vector<std::string> vector{std::string(length, 'x')};
    json.begin_object().member("z", vector).member("y", 1).end_object();
    const std::string& text = json.text();
    const std::size_t vector_line = text.find('\n', 2) - 2;
    CHECK(vector_line <= 100);
    CHECK((vector_line > 50) == (length <= 88));
  }
}
