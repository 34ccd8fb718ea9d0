#include "certify/exact_answer.hpp"
#include "certify/sha256.hpp"

#include <doctest/doctest.h>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

MixedProblem raw(const std::vector<std::vector<int>>& M, const std::vector<int>& q) {
  MixedProblem problem;
  for (const std::vector<int>& from : M) {
    ExactRow& row = problem.rows.emplace_back();
    for (std::size_t j = 0; j < from.size(); ++j)
      if (from[j] != 0) row.push_back({static_cast<Index>(j), from[j]});
  }
  problem.q.assign(q.begin(), q.end());
  problem.free.assign(q.size(), 0);
  return problem;
}

} // namespace

TEST_CASE("any basis leads to the answer of a positive definite problem") {
  // Murty's example: from zero Lemke's pivots pass through many bases.
  const MixedProblem problem =
      raw({{1, 2, 2, 2}, {0, 1, 2, 2}, {0, 0, 1, 2}, {0, 0, 0, 1}}, {-1, -1, -1, -1});
  for (unsigned basis = 0; basis < 16; ++basis) {
    Basis basic;
    for (unsigned i = 0; i < 4; ++i) basic.push_back((basis >> i) & 1U);
    const auto answer = answer_by_pivots(problem, {basic});
    REQUIRE(answer);
    CHECK(answer->x == std::vector<Rational>{0, 0, 0, 1});
    CHECK(answer->w == std::vector<Rational>{1, 1, 1, 0});
  }
}

TEST_CASE("pivots that end on a ray give no answer") {
  const MixedProblem problem = raw({{0, -1}, {-1, 0}}, {-1, -1}); // Murty: q in no cone
  CHECK(!answer_by_pivots(problem, {{0, 0}}));
}

TEST_CASE("the answer near doubles keeps what doubles chose among many") {
  // Two supports of one load: any split of 3 solves; the guess says 1 and 2, a little off.
  const MixedProblem problem = raw({{1, 1}, {1, 1}}, {-3, -3});
  const auto answer = answer_near(problem, {Part::x, Part::x}, {1.0 + 1e-13, 2.0});
  REQUIRE(answer);
  CHECK(answer->x[0] + answer->x[1] == 3);
  CHECK(std::abs(answer->x[0].value() - 1) < 1e-9);
  // Neither may act alone where its row would be left over.
  CHECK(!answer_near(problem, {Part::w, Part::w}, {0.0, 0.0}));
}

TEST_CASE("an answer with a wrong sign, product or row is no exact answer") {
  const MixedProblem problem = raw({{2, 1}, {1, 2}}, {-5, -6});
  ExactAnswer answer{{Rational(4) / 3, Rational(7) / 3}, {0, 0}};
  CHECK(solves_exactly(problem, answer));
  answer.x[0] += Rational(1) / 1000000000;
  CHECK(!solves_exactly(problem, answer));
  CHECK(!solves_exactly(problem, {{0, 0}, {-5, -6}}));
  CHECK(!solves_exactly(raw({{1}}, {1}), {{1}, {2}}));
}

TEST_CASE("exact pivots tell apart what doubles call a tie") {
  // The second support bears a little more of one load, and so all of it.
  MixedProblem problem = raw({{1, 1}, {1, 1}}, {-1, -1});
  problem.q[1] -= *Rational::parse("1e-50");
  CHECK(!answer_of_basis(problem, {1, 0}));
  const auto answer = answer_by_pivots(problem, {{1, 0}});
  REQUIRE(answer);
  CHECK(answer->x == Column{0, -problem.q[1]});
}

TEST_CASE("free unknowns are basic from the start") {
  // x2 free with a diagonal, x3 without: 2 x2 = x0 + x3 + 1, x1 = 2; x0 takes what is left.
  MixedProblem problem =
      raw({{2, 0, 1, 0}, {0, 1, 0, 1}, {-1, 0, 2, -1}, {0, -1, 0, 0}}, {-3, -1, 1, 2});
  problem.free = {0, 0, 1, 1};
  const auto answer = answer_of_basis(problem, {1, 1, 0, 0});
  REQUIRE(answer);
  CHECK(answer->x[1] == 2);
  CHECK(answer->x[3] == -1);
}

TEST_CASE("SHA-256 of the standard's examples") {
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}
