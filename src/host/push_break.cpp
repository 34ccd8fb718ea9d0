// Push: the grasp without a push, and the push that breaks it.
#include "push_rounds.hpp"

namespace lcpush::host {

HoldReport Push::holds_without_push(const PushOptions& options) {
  Scene<double> alone = scene_;
  std::vector<Drive<double>> drives;
  alone.points.size = alone.bodies.size = 0;
  for (const Body<double>& body : scene_.bodies) {
    if (body.role == Role::pusher) break; // fingers come first
    ++alone.bodies.size;
    alone.points.size += body.point_count;
  }
  std::vector<Actuator<double>> actuators;
  for (Index a = 0; a < scene_.actuators.size; ++a) {
    const std::size_t before = drives.size();
    for (const Drive<double>& drive : scene_.drives)
      if (drive.actuator == a && drive.body < alone.bodies.size)
        drives.push_back({drive.body, static_cast<Index>(actuators.size()), drive.twist});
    if (drives.size() > before) actuators.push_back(scene_.actuators[a]);
  }
  alone.drives = {drives.data(), static_cast<Index>(drives.size())};
  alone.actuators = {actuators.data(), static_cast<Index>(actuators.size())};

  HoldReport report;
  report.length = layout().scales.length;
  report.acceleration.head<3>() = scene_.gravity;
  if (scene_.planar) report.acceleration[2] = 0;
  if (alone.bodies.size == 0) {
    report.status = Status::solved;
    report.holds = !(report.acceleration.norm() > 0);
    return report;
  }
  assembly_.assemble(alone);
  PressureRun ignored;
  report.status = run(options, 1.0, ignored);
  if (report.status == Status::solved) {
    report.acceleration = work_.answer.acceleration;
    report.holds = motion_size(report.acceleration, layout().scales) <= at_rest<double>();
  }
  assembly_.assemble(scene_);
  return report;
}

BreakReport Push::find_breaking(Index pusher, const PushOptions& options) {
  BreakReport report;
  report.solver = options.solver;
  report.pusher = pusher;
  assembly_.assemble(scene_);
  report.scales = layout().scales;
  history_.clear();
  swept_before_ = 0;
  report.status = with_rounds(options, [&](const auto& rounds) {
    return lcpush::find_breaking(assembly_, rounds, work_,
                                 file_.bodies[static_cast<std::size_t>(pusher)], {},
                                 report.breaking, report.run);
  });
  report.history = history_;
  if (report.status == Status::does_not_hold)
    report.reason = "the object moves before it is pushed: the grasp does not hold its load";
  else if (report.status == Status::bad_input && report.run.reason == Reason::none)
    report.reason = "no pusher moves: give one an acceleration";
  else if (report.status != Status::solved)
    report.reason = explain(report.status, report.run);
  if (report.status == Status::ray) {
    report.ray = named_ray();
    report.jam = read_jam(options);
  }
  if (report.status != Status::solved) return report;
  name_file_bodies();
  Answer<double> moving = work_.answer;
  moving.acceleration = report.breaking.twist;
  report.motion = describe_motion(file_.view(), moving, report.scales.length, 1.0);
  return report;
}

} // namespace lcpush::host
