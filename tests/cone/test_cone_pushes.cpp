// [T.18]: the motion cone against 2,000 pushes that are solved.
#include "support/planar_pushes.hpp"
#include "support/seeds.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::ConeReport;
using desktop::SceneFile;

namespace {

/// How far the object slips over the pusher in a push as slow as that, beside the push's own speed.
std::optional<double> slip_when_pushed(const RandomPush& push, double speed) {
  SceneFile file = push.file;
  Body<double>& wall = file.bodies.back();
  wall.acceleration = speed * push.twist;
  desktop::Push solver(file);
  desktop::PushOptions options;
  options.other_paths = 0;
  options.study_existence = false;
  const desktop::PushReport report = solver.solve(options);
  if (report.status != Status::solved) return std::nullopt;
  double most = 0, fastest = 0;
  for (Index i = wall.first_point; i < wall.first_point + wall.point_count; ++i) {
    const Vector3<double>& p = file.points[static_cast<std::size_t>(i)];
    most = std::max(
        most,
        acceleration_at(p, Vector6<double>(report.answer.acceleration - wall.acceleration)).norm());
    fastest = std::max(fastest, acceleration_at(p, wall.acceleration).norm());
  }
  return most / fastest;
}

} // namespace

TEST_CASE("[T.18] a pusher sticks in solved pushes where the motion cone says so") {
  std::mt19937 random(20180618);
  int judged = 0, sticking = 0, unsolved = 0;
  for (int k = 0; k < static_cast<int>(seeds(2000)); ++k) {
    CAPTURE(k);
    const RandomPush push = random_push(random);
    const ConeReport cone = desktop::find_cone(push.file, 2, push.twist);
    if (cone.status != Status::solved || std::abs(cone.verdict->margin) < 1e-6 ||
        (cone.verdict->leaves && cone.verdict->sticks)) // both are answers
      continue;
    const std::optional<double> slip = slip_when_pushed(push, 1e-3);
    if (!slip) {
      ++unsolved;
      continue;
    }
    ++judged;
    sticking += cone.verdict->sticks ? 1 : 0;
    CHECK((*slip < 1e-4) == cone.verdict->sticks);
  }
  MESSAGE(judged << " judged, " << sticking << " stick, " << unsolved << " not solved");
  CHECK(judged > static_cast<int>(seeds(1950)));
  CHECK(unsolved == 0);
  CHECK(sticking > static_cast<int>(seeds(300)));
}
