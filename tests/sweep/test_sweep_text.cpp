// What a sweep says, and in how many words.
#include <doctest/doctest.h>

#include <algorithm>

#include "support/swept.hpp"

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;

namespace {

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

} // namespace

TEST_CASE("a brief text has a message, what matters, and at most a dozen rows") {
  const Sweep sweep = swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 2, 30);
  const std::string brief = sweep_text(sweep, Telling::brief), full = sweep_text(sweep);
  CHECK(says(brief, "grows from 0.333 to 30 N, by 1 to 8.76 N per N.\n"));
  CHECK(says(brief, "at *.grip_force = 6.54 N (as prescribed at 6.52 N): wall sticks\n"));
  CHECK_FALSE(says(brief, "another direction"));
  CHECK(says(full, "another direction"));
  CHECK(std::count(brief.begin(), brief.end(), '\n') < 25);
  // Nothing is told twice: the message has said where the grasp holds.
  const Sweep drops = swept(rigid(lcpush::test::with(scene_text("straight_slide.toml"),
                                                     "friction = 0.3", "friction = 0")),
                            "*.grip_force", 1, 4);
  CHECK(says(sweep_text(drops, Telling::brief), "Up to 1.96 N the grasp does not hold the box"));
  CHECK_FALSE(says(sweep_text(drops, Telling::brief), "the grasp holds"));
  CHECK(says(sweep_text(drops, Telling::full), "the grasp holds the box"));
}

TEST_CASE("a brief text tells a few changes and counts the others") {
  Sweep sweep = swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 10, 14);
  REQUIRE(sweep.segments.size() == 1);
  const SweepSegment segment = sweep.segments.front();
  sweep.segments.clear();
  for (Index k = 0; k < 11; ++k) {
    SweepSegment next = segment;
    next.from = 10 + static_cast<double>(k);
    next.to = next.from + 1;
    AnswerChange change;
    const Mode from = k % 2 == 0 ? Mode::slide : Mode::stick;
    const Mode to = k % 2 == 0 ? Mode::stick : Mode::slide;
    change.contacts = {{0, from, to, true, true, Vector3<double>::Zero()}};
    if (k < 10) next.change.push = {change};
    sweep.segments.push_back(next);
  }
  sweep.variations[0].to = 21;
  const std::string text = sweep_text(sweep, Telling::brief);
  CHECK(says(text, "at *.grip_force = 18 N: as prescribed: left.1 begins to slip\n"));
  CHECK_FALSE(says(text, "at *.grip_force = 19 N"));
  CHECK(says(text, "(2 more changes: -v.)\n"));
  CHECK(says(sweep_text(sweep), "at *.grip_force = 19: as prescribed: left.1 sticks\n"));
}

TEST_CASE("a curve's course: grows, falls, stays, turns, or lies between") {
  Sweep sweep = swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 10, 14);
  REQUIRE(sweep.segments.size() == 1);
  const SweepSegment segment = sweep.segments.front();
  const auto told = [&](const std::vector<double>& forces) {
    sweep.segments.clear();
    for (std::size_t k = 0; k + 1 < forces.size(); ++k) {
      SweepSegment next = segment;
      next.from = 10 + static_cast<double>(k);
      next.to = next.from + 1;
      next.at_from.breaking.normal = forces[k];
      next.at_to.breaking.normal = forces[k + 1];
      sweep.segments.push_back(next);
    }
    sweep.variations[0].to = 9 + static_cast<double>(forces.size());
    return sweep_text(sweep, Telling::brief);
  };
  CHECK(says(told({1, 2, 4}), "grows from 1 to 4 N, by 1 to 2 N per N.\n"));
  CHECK(says(told({4, 2, 1}), "falls from 4 to 1 N, by 1 to 2 N per N.\n"));
  CHECK(says(told({4, 4, 4}), "stays at 4 N.\n"));
  CHECK(
      says(told({4, 1, 2}),
           "falls from 4 to 1 N (at 11 N) and grows to 2 N, with slopes from -3 to 1 N per N.\n"));
  CHECK(says(told({1, 3, 3, 2}), "grows from 1 to 3 N (from 11 to 12 N) and falls to 2 N"));
  CHECK(says(told({1, 3, 2, 4}), "lies between 1 N (at 10 N) and 4 N (at 13 N)"));
  // What bisection leaves below zero is zero.
  CHECK(says(told({-0.001, 2, 4}), "grows from 0 to 4 N"));
}
