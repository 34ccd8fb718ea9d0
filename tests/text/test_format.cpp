// Numbers for people, and words that were meant.
#include <doctest/doctest.h>

#include "text/format.hpp"
#include "text/wording.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

TEST_CASE("three digits, and thousands without an exponent") {
  CHECK(brief(0) == "0");
  CHECK(brief(20.1159) == "20.1");
  CHECK(brief(-0.0123456) == "-0.0123");
  CHECK(brief(999.4) == "999");
  CHECK(brief(999.7) == "1000");
  CHECK(brief(-20012) == "-20000");
  CHECK(brief(123456) == "123000");
  CHECK(brief(1234567) == "1.23e+06");
  CHECK(brief(1.5e-7) == "1.5e-07");
}

TEST_CASE("a bound in three digits stays one, and a clean number what it is") {
  CHECK(brief_within(29.819, true) == "29.9");
  CHECK(brief_within(29.819, false) == "29.8");
  CHECK(brief_within(29.8000000001, true) == "29.8");
  CHECK(brief_within(0.99999999999, false) == "1");
  CHECK(brief_within(999.2, true) == "1000");
  CHECK(brief_within(1e-14, true, 1e-13) == "0");
  CHECK(brief_within(-1.239, false) == "-1.24");
}

TEST_CASE("a column is as wide as its letters, not as their bytes") {
  CHECK(table_text({{"name", "N"}, {"\xC3\xBC", "1"}}, 1, 80) == "  name  N\n  \xC3\xBC     1\n");
}

TEST_CASE("a slip is a word that is near, or part of one; another word is not") {
  const std::vector<std::string> keys{"friction", "grip_force", "center"};
  const auto meant = [&](const char* word) { return suggestion(word, keys); };
  CHECK(meant("fricton") == " (did you mean \"friction\"?)");
  CHECK(meant("Friction") == " (did you mean \"friction\"?)");
  CHECK(meant("frictoin") == " (did you mean \"friction\"?)");
  CHECK(meant("force") == " (did you mean \"grip_force\"?)");
  CHECK(meant("for").empty());
  CHECK(meant("radius").empty());
  CHECK(meant("").empty());
  CHECK(suggestion("--open", {"--json", "--output"}).empty());
  CHECK(suggestion("pda", {"pad", "even"}) == " (did you mean \"pad\"?)");
}

TEST_CASE("blanks at the ends of a word do not count") {
  CHECK(trimmed("  a b\t") == "a b");
  CHECK(trimmed(" \t").empty());
  CHECK(trimmed("").empty());
}

TEST_CASE("a sentence with a number is printed whole, however long it is") {
  const std::string words = " N m across the plane; remove planar if the contacts are to bear it";
  CHECK(printed(("%.3g" + words).c_str(), 0.25) == "0.25" + words);
}
