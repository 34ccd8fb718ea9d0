// The search for a plan, and its replay.
#include "lcpush/desktop/plan.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "plan/plan_parts.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int smoothing_tries = 150;
// Sticking pushes first: each is a matter of microseconds, where a slipping one takes a motion.
constexpr Index tries_without_slips = 150, slips_every = 4, looks_every = 4;
// m, of a pusher, in a replay by equal steps: where one has no answer, others are tried.
constexpr Index most_steps = 5000; // solved in a replay; usual are hundreds
constexpr double ways_a_step[] = {1e-3, 6e-4, 3e-4};
// Of the object's size: a replay that is ahead of the plan by more stands in the next pusher's way.
constexpr double gaps[] = {2e-4, 1e-3, 5e-3};

class Planner {
public:
  Planner(std::string_view text, const std::string& file_name, const PlanarPose& goal,
          const PlanOptions& options)
      : text_(text), file_name_(file_name), options_(options),
        file_(along_faces(parse_scene(text, file_name, Strokes::all))),
        pushing_(file_, corners(std::nullopt)),
        roadmap_(pushing_, PlanarPose(), goal,
                 {options.position_error / 2, 0, options.angle_error / 2}) {
    report_.goal = goal;
  }

  PlanReport plan() {
    report_.holds_start = pushing_.holds(PlanarPose());
    report_.holds_goal = pushing_.holds(report_.goal);
    if (!report_.holds_start || !report_.holds_goal) return std::move(report_);
    report_.found = is_there();
    if (report_.found) return finished();
    for (const double way_a_step : ways_a_step) {
      const std::optional<Legs> way = found_way();
      if (!way) {
        report_.nearest = roadmap_.nearest_reached();
        break;
      }
      take(roadmap_.smoothed(*way, smoothing_tries));
      replay(std::nullopt); // as `move` does it by itself
      if (!report_.found && goes_on()) replay(way_a_step / options_.speed);
      if (report_.found || !goes_on()) break;
    }
    return finished();
  }

private:
  const std::string_view text_;
  const std::string file_name_;
  const PlanOptions& options_;
  const SceneFile file_;
  const Pushing pushing_;
  Roadmap roadmap_;
  PlanReport report_;

  /// [T.20] What the pushes have to stick with.
  std::vector<SceneFile> corners(const std::optional<double>& margin) const {
    std::vector<SceneFile> scenes;
    if (!options_.box) return scenes;
    for (SceneFile& corner : corner_scenes(*options_.box, margin)) {
      if (corner.points.size() != file_.points.size())
        throw InputError(file_name_ + ": pushers of a plan for every value are there all the time");
      corner.points = file_.points; // along the faces
      scenes.push_back(std::move(corner));
    }
    return scenes;
  }

  PlanReport finished() {
    if (!options_.box) return std::move(report_);
    report_.box = unknown_box(*options_.box);
    report_.box->reason = "no plan was found whose every push sticks for every value";
    if (!report_.found) return std::move(report_);
    report_.box->verdict = BoxVerdict::always;
    report_.box->reason.clear();
    report_.box->margin = widest_margin([this](double e) { return sticks(e); }, true);
    return std::move(report_);
  }

  bool sticks(double margin) const {
    const Pushing pushing(file_, corners(margin));
    return std::all_of(report_.pushes.begin(), report_.pushes.end(), [&](const PlannedPush& push) {
      unsigned bit = 1;
      for (std::size_t k = 0; pushing.body(k) != push.pusher; ++k) bit *= 2;
      return (pushing.sticking(Arc(push.from, push.to)) & bit) != 0;
    });
  }

  bool is_there() const {
    return place_of(report_.goal).norm() <= options_.position_error &&
           std::abs(report_.goal.angle) <= options_.angle_error;
  }

  std::optional<Legs> found_way() {
    std::optional<Legs> way = roadmap_.cheapest();
    while (!way && report_.tried < options_.tries && goes_on()) {
      const Index k = ++report_.tried;
      if (k % 2 == 0)
        roadmap_.add_place();
      else
        roadmap_.add_pushed();
      if (!options_.box && k > tries_without_slips && k % slips_every == 0)
        roadmap_.add_slip(
            [&](const PlanarPose& from, const Slip& slip) {
              return slid(file_, pushing_.body(slip.pusher), from, slip);
            },
            options_.speed);
      if (k % looks_every == 0) way = roadmap_.cheapest();
    }
    return way ? way : roadmap_.cheapest();
  }

  bool goes_on() {
    if (options_.progress)
      options_.progress(static_cast<double>(report_.tried) / static_cast<double>(options_.tries));
    report_.stop = stop_now(options_.stop);
    return report_.stop == Stop::none;
  }

  void take(const Legs& legs) {
    report_.cost = legs.cost;
    report_.pushes.clear();
    for (const Leg& leg : legs.list) {
      PlannedPush push;
      push.pusher = pushing_.body(leg.pusher);
      push.from = leg.from;
      push.to = leg.to;
      if (leg.slip) {
        push.kind = PushKind::slip;
        push.twist << leg.slip->velocity.x(), leg.slip->velocity.y(), 0, 0, 0, leg.slip->turn;
        push.end = leg.slip->time;
        report_.pushes.push_back(push);
        continue;
      }
      const PushNeeds needs = pushing_.needs(leg.pusher, Arc(leg.from, leg.to));
      push.friction = needs.friction;
      push.reach = needs.reach;
      push.grip = needs.grip;
      report_.pushes.push_back(push);
    }
  }

  void replay(std::optional<double> step) {
    for (const double gap : gaps) {
      replay(gap * object_size(file_), step);
      if (report_.replay.end != MoveEnd::inside) break;
    }
    if (report_.found && step)
      report_.scene_text = "# In steps of its own `move` has no answer here: use --step " +
                           number(*step) + "\n" + report_.scene_text;
  }

  void replay(double gap, std::optional<double> step) {
    report_.scene_text = strokes_text(text_, file_, report_.pushes, options_.speed, gap);
    report_.scene = parse_scene(report_.scene_text, "the plan for " + file_name_, Strokes::all);
    MoveOptions options;
    options.step = report_.replay_step = step;
    options.most_steps = most_steps;
    options.stop = options_.stop;
    report_.replay = move(report_.scene, options);
    const Pose<double>& end = report_.replay.frames.back().pose;
    const double angle = std::atan2(end.rotation(1, 0), end.rotation(0, 0));
    report_.nearest = {end.position.x(), end.position.y(), angle};
    report_.position_error = (end.position.head<2>() - place_of(report_.goal)).norm();
    report_.angle_error = std::abs(std::remainder(angle - report_.goal.angle, 2 * pi));
    report_.found = report_.replay.end == MoveEnd::time &&
                    report_.position_error <= options_.position_error &&
                    report_.angle_error <= options_.angle_error;
  }
};

} // namespace

PlanReport find_plan(std::string_view text, const std::string& file_name, const PlanarPose& goal,
                     const PlanOptions& options) {
  return Planner(text, file_name, goal, options).plan();
}

} // namespace lcpush::desktop
