// Lines that fit a terminal.
#include <doctest/doctest.h>

#include "text/format.hpp"
#include "text/wrap.hpp"

using namespace lcpush::desktop;

TEST_CASE("a sentence breaks at blanks, below its own first word") {
  CHECK(wrapped("one two three", 7) == "one two\nthree");
  CHECK(wrapped("  one two three", 9) == "  one two\n  three");
  CHECK(wrapped("- one two three", 9) == "- one two\n  three");
  CHECK(wrapped("one two three\nfour", 13) == "one two three\nfour");
  CHECK(wrapped("unbreakable", 4) == "unbreakable");
}

TEST_CASE("what follows a label goes on below itself") {
  CHECK(wrapped("Motion    slides along x", 16) ==
        "Motion    slides\n          along\n          x");
}

TEST_CASE("a sentence with a comment at its end is no label") {
  CHECK(wrapped("add the mass of it  # kg", 21) == "add the mass of it  #\nkg");
}

TEST_CASE("a row of a table stays whole") {
  const std::string row = "left.1    5    2.5";
  CHECK(wrapped(row, 8) == row);
}

TEST_CASE("columns count, not bytes") {
  CHECK(wrapped("µµ µµ", 5) == "µµ µµ");
  CHECK(wrapped("µµ µµ", 4) == "µµ\nµµ");
}

TEST_CASE("paragraphs become one line, examples stay") {
  CHECK(reflowed("a\nb\n\nc\n  $ d\n  $ e\nf\n") == "a b\n\nc\n  $ d\n  $ e\nf\n");
}

TEST_CASE("a table that is too wide goes on below, behind its first column") {
  const TableRows rows{{"", "aaaa", "bbbb", "cccc"}, {"x", "1", "2", "3"}};
  CHECK(table_text(rows, 1, 80) == "     aaaa  bbbb  cccc\n  x     1     2     3\n");
  CHECK(table_text(rows, 1, 15) == "     aaaa  bbbb\n  x     1     2\n\n     cccc\n  x     3\n");
}
