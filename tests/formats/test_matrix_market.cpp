#include "lcpush/desktop/matrix_market.hpp"

#include "lcpush/desktop/input_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <random>

namespace {

using namespace lcpush::desktop;

const std::string array_banner = "%%MatrixMarket matrix array real general\n";
const std::string coordinate_banner = "%%MatrixMarket matrix coordinate real general\n";

HostMatrix parse(const std::string& text) { return parse_matrix_market(text, "M.mtx"); }

template <class Action> std::string refusal(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusal_of(const std::string& text) {
  return refusal([&text] { parse(text); });
}

void check_refused(const std::string& text, const std::string& location,
                   const std::string& reason) {
  const std::string message = refusal_of(text);
  CAPTURE(message);
  CHECK(message.rfind("M.mtx:" + location + ": ", 0) == 0);
  CHECK(message.find(reason) != std::string::npos);
}

} // namespace

TEST_CASE("capitals, integers, CRLF, tabs and a missing last newline are fine") {
  const HostMatrix m =
      parse("%%matrixmarket MATRIX Array Integer GENERAL\r\n%\r\n\t2  1\r\n 7 \r\n-8");
  CHECK(m.rows == 2);
  CHECK(m.values == std::vector<double>{7, -8});
}

TEST_CASE("a line may hold several numbers, column by column, and the file a byte order mark") {
  CHECK(parse(array_banner + "2 2\n1 2\n3 4\n").values == std::vector<double>{1, 2, 3, 4});
  CHECK(parse("\xEF\xBB\xBF" + array_banner + "3 1\n1 2\n% half\n3\n").values ==
        std::vector<double>{1, 2, 3});
  CHECK(parse(coordinate_banner + "2 2 2\n1 1 5 2 2 6\n").values ==
        std::vector<double>{5, 0, 0, 6});
  std::string wide = array_banner + "3000 1\n";
  for (int i = 0; i < 3000; ++i) wide += "0.125 ";
  CHECK(parse(wide).values.size() == 3000);
}

TEST_CASE("of a symmetric matrix the lower triangle is written, of a skew-symmetric one less") {
  const std::string start = "%%MatrixMarket matrix ";
  const std::vector<double> symmetric{1, 2, 3, 2, 4, 5, 3, 5, 6},
      skew{0, 2, 3, -2, 0, 5, -3, -5, 0};
  CHECK(parse(start + "array real symmetric\n3 3\n1\n2\n3\n4\n5\n6\n").values == symmetric);
  CHECK(parse(start + "array integer skew-symmetric\n3 3\n2 3\n5\n").values == skew);
  CHECK(
      parse(start + "coordinate real symmetric\n3 3 6\n1 1 1\n2 1 2\n3 1 3\n2 2 4\n3 2 5\n3 3 6\n")
          .values == symmetric);
  CHECK(parse(start + "coordinate real skew-symmetric\n3 3 3\n2 1 2\n3 1 3\n3 2 5\n").values ==
        skew);
  check_refused(start + "coordinate real symmetric\n2 2 1\n1 2 5\n", "3", "not row 1 of column 2");
  check_refused(start + "coordinate real skew-symmetric\n2 2 1\n1 1 5\n", "3",
                "below the diagonal");
  check_refused(start + "array real symmetric\n2 3\n", "2", "only a square matrix is symmetric");
}

TEST_CASE("sparse rows hold what is not zero, and may be many") {
  const SparseRows m =
      parse_sparse_matrix(coordinate_banner + "2 3 4\n2 3 5\n2 1 4\n1 2 0\n1 3 7\n", "M.mtx");
  CHECK(m.rows() == 2);
  CHECK(m.cols == 3);
  REQUIRE(m.row(0).size == 1);
  CHECK(m(0, 2) == 7);
  REQUIRE(m.row(1).size == 2);
  CHECK(m.row(1)[0].column == 0);
  CHECK(m(1, 2) == 5);
  CHECK(m(1, 1) == 0);
  CHECK(parse_sparse_matrix(coordinate_banner + "500000 500000 1\n7 8 1\n", "M.mtx").rows() ==
        500000);
  CHECK(refusal([] {
          parse_sparse_matrix(coordinate_banner + "2000000 1 1\n1 1 1\n", "M.mtx");
        }).find("the limit is 1000000") != std::string::npos);
  CHECK(rows_of(parse(array_banner + "2 1\n0\n3\n")).row(1)[0].value == 3);
}

TEST_CASE("other kinds of Matrix Market are refused by name") {
  const std::string start = "%%MatrixMarket ";
  check_refused(start + "vector array real general\n", "1", "object \"vector\"");
  check_refused(start + "matrix dense real general\n", "1", "format \"dense\"");
  check_refused(start + "matrix array complex general\n", "1", "field \"complex\"");
  check_refused(start + "matrix coordinate pattern general\n", "1", "field \"pattern\"");
  check_refused(start + "matrix array real hermitian\n", "1", "symmetry \"hermitian\"");
  check_refused(start + "matrix array real\n", "1", "five words");
}

TEST_CASE("what is no Matrix Market at all says so") {
  check_refused("", "1", "the file is empty");
  check_refused("\n", "1", "not a Matrix Market file");
  check_refused("2 2\n1\n", "1", "not a Matrix Market file");
  check_refused(std::string("\x7F"
                            "ELF\0\0\0",
                            7),
                "1", "not a Matrix Market file");
  check_refused(std::string(2000000, '\0'), "1", "longer than a million characters");
  check_refused("\x1F\x8B\x08", "1", "gunzip -c FILE | lcpush lcp - q.mtx");
}

TEST_CASE("sizes are whole, positive, and within the limit") {
  check_refused(array_banner, "1", "ends before its sizes");
  check_refused(array_banner + "2\n", "2", "expected the sizes \"ROWS COLUMNS\"");
  check_refused(array_banner + "2 2 4\n", "2", "expected the sizes");
  check_refused(coordinate_banner + "2 2\n", "2", "\"ROWS COLUMNS ENTRIES\"");
  check_refused(array_banner + "-2 2\n", "2", "\"-2\" is not a whole number");
  check_refused(array_banner + "2.0 2\n", "2", "\"2.0\" is not a whole number");
  check_refused(array_banner + "20001 1\n", "2", "20001 rows are too many");
  check_refused(array_banner + "99999999999999999999 1\n", "2", "fits in 64 bits");
}

TEST_CASE("a size that the file is too short for is refused before it takes memory") {
  check_refused(array_banner + "1000000000 1000000000\n1\n", "2", "too many; the limit is 20000");
  check_refused(array_banner + "20000 20000\n1\n", "2", "ask for 400000000 entries");
  check_refused(coordinate_banner + "20000 20000 400000000\n1 1 1\n", "2", "is it cut off?");
  check_refused(coordinate_banner + "2 2 1000000000000000000\n", "2", "do not fit into 2 x 2");
}

TEST_CASE("too few and too many entries are refused") {
  check_refused(array_banner + "2 1\n1\n", "3", "ends after 1 of 2 entries");
  check_refused(array_banner + "1 1\n1\n2\n", "4", "here is more: \"2\"");
  check_refused(array_banner + "2 2\n1 2\n3\n", "4", "ends after 3 of 4 entries");
  check_refused(array_banner + "2 1\n1 2 3\n", "3", "here is more: \"3\"");
  check_refused(coordinate_banner + "1 1 1\n% the end\n", "3", "ends after 0 of 1 entries");
  check_refused(coordinate_banner + "2 2 1\n1 1 1\n2 2 2\n", "4", "here is more");
  check_refused(coordinate_banner + "2 2 1\n1 1\n", "3", "\"ROW COLUMN VALUE\"");
}

TEST_CASE("places are inside of the matrix and taken once") {
  check_refused(coordinate_banner + "2 2 1\n0 1 5\n", "3", "row 0 is outside of 1 to 2");
  check_refused(coordinate_banner + "2 3 1\n1 4 5\n", "3", "column 4 is outside of 1 to 3");
  check_refused(coordinate_banner + "2 2 1\n1.5 1 5\n", "3", "not a whole number");
  check_refused(coordinate_banner + "2 2 3\n2 1 5\n1 1 1\n2 1 5\n", "5", "in line 3");
}

TEST_CASE("entries are finite numbers") {
  for (const char* word : {"nan", "-inf", "Infinity"})
    check_refused(array_banner + "1 1\n" + word + "\n", "3", "numbers must be finite");
  check_refused(array_banner + "1 1\n1e999\n", "3", "too large or too small");
  for (const char* word : {"one", "1x", "0x10", "1d5", "1,5", "+-1", "++1", "+", "--1", "1e", "."})
    check_refused(array_banner + "1 1\n" + word + "\n", "3", "is not a number");
  check_refused(array_banner + "1 1\n" + std::string("1\0", 2) + "\n", "3", "\"1\\x00\"");
}

TEST_CASE("paths that cannot be read are named with the reason") {
  CHECK(refusal([] {
          read_matrix_market("no/such.mtx");
        }).rfind("no/such.mtx: cannot be read: No such file", 0) == 0);
  const std::string folder = std::filesystem::temp_directory_path().string();
  const std::string message = refusal([&folder] { read_matrix_market(folder); });
  CAPTURE(message);
  CHECK(message.rfind(folder + ": cannot be read: Is a directory", 0) == 0);
}

TEST_CASE("what is written reads back bit for bit") {
  std::mt19937_64 random(1);
  HostMatrix m{40, 25, {0.0, -0.0, 5e-324, 1.7976931348623157e308, 1.0 / 3.0}};
  while (m.values.size() < 1000) {
    const std::uint64_t bits = random();
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    if (std::isfinite(number)) m.values.push_back(random() % 4 == 0 ? 0.0 : number);
  }
  for (const auto format : {MatrixMarketFormat::array, MatrixMarketFormat::coordinate}) {
    const HostMatrix again = parse(write_matrix_market(m, format, "a comment"));
    CHECK(again.rows == m.rows);
    CHECK(again.cols == m.cols);
    REQUIRE(again.values.size() == m.values.size());
    CHECK(std::memcmp(again.values.data(), m.values.data(), 1000 * sizeof(double)) == 0);
  }
}

TEST_CASE("inline matrices: rows by semicolons, numbers by blanks or commas") {
  const HostMatrix m = parse_inline_matrix(" 2, 1 ;1\t+2e0; -3 ,4", "--M");
  CHECK(m.rows == 3);
  CHECK(m.cols == 2);
  CHECK(m.values == std::vector<double>{2, 1, -3, 1, 2, 4});
  for (const char* text : {"-5 -6", "-5,-6", "-5; -6"}) {
    const HostMatrix q = parse_inline_vector(text, "--q");
    CHECK(q.rows == 2);
    CHECK(q.cols == 1);
    CHECK(q.values == std::vector<double>{-5, -6});
  }
}

TEST_CASE("what MATLAB and NumPy print is read") {
  for (const char* text :
       {"[2 1\n 1 2]", "M = [2, 1; 1, 2];", "np.array([[2., 1.],\n       [1., 2.]])",
        "[[2. 1.]\n [1. 2.]]", "2,1\n1,2\n", "[2 1; ...\n 1 2];", "array([[2, 1], [1, 2]])"}) {
    CAPTURE(text);
    const HostMatrix m = parse_inline_matrix(text, "--M");
    CHECK(m.rows == 2);
    CHECK(m.values == std::vector<double>{2, 1, 1, 2});
  }
  for (const char* text : {"q = [-5 -6]';",
                           "[\xE2\x88\x92"
                           "5 \xE2\x88\x92"
                           "6]'",
                           "\xE2\x88\x92"
                           "5, -6"}) {
    CAPTURE(text);
    CHECK(parse_inline_vector(text, "--q").values == std::vector<double>{-5, -6});
  }
}

TEST_CASE("malformed inline matrices name the option and the row") {
  const auto refused = [](const char* text) {
    return refusal([text] { parse_inline_matrix(text, "--M"); });
  };
  CHECK(refused("") == "--M: row 1: a number is missing in \"\"");
  CHECK(refused("1 2;") == "--M: row 2: a number is missing in \"\"");
  CHECK(refused("1,,2") == "--M: row 1: a number is missing in \"1,,2\"");
  CHECK(refused("1 2; 3") == "--M: row 2: expected 2 numbers, as in row 1, got 1");
  CHECK(refused("1 2; 3 nan") == "--M: row 2: \"nan\": numbers must be finite");
  CHECK(refused("[1 x]").find("--M: row 1: \"x\" is not a number") == 0);
  CHECK(refusal([] { parse_inline_vector("1 2; 3 4", "--q"); }) ==
        "--q: expected a vector like \"-5 -6\", got a matrix of 2 x 2");
}
