// Edges, sides and verdict of a motion cone in the scene's units.
#include "lcpush/desktop/cone.hpp"

#include "cone/motion_cone.hpp"
#include "cone/pusher_cone.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

/// Such that the pusher's fastest point moves at 1 m/s.
Vector6<double> scaled(const SceneFile& file, Index pusher, const Vector3<double>& planar,
                       double length) {
  const Vector6<double> twist = spatial_twist(planar, length);
  double fastest = 0;
  for (const Index i : points_of(file.body(pusher)))
    fastest =
        std::max(fastest, acceleration_at(file.points[static_cast<std::size_t>(i)], twist).norm());
  return fastest > 0 ? Vector6<double>(twist / fastest) : twist;
}

class ConeFinder {
public:
  ConeFinder(const SceneFile& file, Index pusher)
      : file_(file), length_(planar_reach(file)), grip_(GripPoints(file), length_),
        load_(planar_load(file, length_)) {
    report_.pusher = pusher;
    report_.length = length_;
  }

  ConeReport find(const std::optional<Vector6<double>>& asked) {
    refuse_single_place(file_, grip_);
    report_.holding_grip = grip_.share_of(load_);
    if (!(report_.holding_grip < 1)) {
      report_.status = Status::does_not_hold;
      return std::move(report_);
    }
    report_.status = Status::solved;
    const MotionCone cone(grip_, pusher_cone(file_, report_.pusher, length_), load_);
    report_.is_single_place = cone.pusher().faces.empty();
    add_edges(cone);
    add_sides(cone);
    const Vector6<double> twist = asked.value_or(file_.body(report_.pusher).acceleration);
    if (!twist.isZero(0)) judge(cone, twist);
    return std::move(report_);
  }

private:
  void add_edges(const MotionCone& cone) {
    for (std::size_t k = 0; k < cone.edges().size(); ++k) {
      const ExtremeWrench& edge = cone.pusher().edges[k];
      const Crossing& there = cone.edges()[k];
      report_.edges.push_back(
          {edge.point, Vector3<double>(Vector3<double>::Zero() - edge.side * cone.pusher().along),
           scaled(file_, report_.pusher, there.twist, length_),
           spatial_wrench(there.force * edge.wrench, length_)});
    }
  }

  void add_sides(const MotionCone& cone) {
    for (std::size_t k = 0; k < cone.arcs().size(); ++k) {
      ConeReport::Side side;
      if (report_.is_single_place) {
        side.to = 1;
      } else {
        const ConeFace& face = cone.pusher().faces[k];
        side.from = face.from;
        side.to = face.to;
        side.is_slip = face.is_slip;
      }
      if (side.is_slip) side.slips = report_.edges[side.from].slips;
      side.point = report_.edges[side.from].point;
      for (const Vector3<double>& twist : cone.arcs()[k].twists)
        side.twists.push_back(scaled(file_, report_.pusher, twist, length_));
      side.twists.front() = report_.edges[side.from].twist;
      side.twists.back() = report_.edges[side.to].twist;
      report_.sides.push_back(std::move(side));
    }
  }

  void judge(const MotionCone& cone, const Vector6<double>& twist) {
    // A direction is all that counts; without its size nothing is lost to a number's range.
    const Vector3<double> planar = planar_twist(twist / twist.cwiseAbs().maxCoeff(), length_);
    ConeReport::Verdict verdict;
    verdict.twist = twist;
    if (report_.is_single_place) {
      const PlaceVerdict at = judge_at_place(cone.pusher(), cone.edges(), planar);
      verdict.sticks = at.sticks;
      verdict.margin = at.angle;
      verdict.nearest = at.edge;
    } else {
      const MotionCone::Nearest nearest = cone.nearest(planar);
      verdict.sticks = cone.contains(planar);
      verdict.margin = nearest.angle;
      verdict.nearest = nearest.arc;
    }
    verdict.leaves = leaves(twist / twist.cwiseAbs().maxCoeff());
    if (!verdict.sticks) verdict.margin = -verdict.margin;
    if (const auto sticks = sticking_grips(grip_, cone.pusher(), load_, planar)) {
      verdict.grip = sticks->least;
      verdict.most_grip = sticks->most;
    }
    report_.verdict = verdict;
  }

  bool leaves(const Vector6<double>& twist) const {
    const Body<double>& pusher = file_.body(report_.pusher);
    for (const Index i : points_of(pusher))
      if (acceleration_at(file_.points[static_cast<std::size_t>(i)], twist).dot(pusher.normal) > 0)
        return false;
    return true;
  }

  const SceneFile& file_;
  const double length_;
  const LimitSurface grip_;
  const Vector3<double> load_;
  ConeReport report_;
};

} // namespace

ConeReport find_cone(const SceneFile& file, Index pusher,
                     const std::optional<Vector6<double>>& twist) {
  refuse_no_cone(file, pusher);
  return ConeFinder(file, pusher).find(twist);
}

} // namespace lcpush::desktop
