// Edges, sides and verdict of a motion cone in the scene's units.
#include "lcpush/desktop/cone.hpp"

#include "cone/least_grip.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

constexpr double typed_direction = 1e-6;

[[noreturn]] void refuse(const SceneFile& file, Index b, int line, const std::string& what) {
  throw InputError(file.lines.file, line,
                   std::string(file.body(b).role == Role::pusher ? "pusher " : "finger ") +
                       quoted(file.body_name(b)) + ": " + what);
}

/// A cone is drawn where no motion changes what the fingers press with.
void refuse_others(const SceneFile& file, Index pusher) {
  if (!file.planar)
    throw InputError(file.lines.file, file.lines.object,
                     "a motion cone is one of motions in the plane: say planar = true, if the "
                     "object moves in the x-y plane");
  if (file.pressure == Pressure::rigid)
    throw InputError(file.lines.file, 1,
                     "under rigid pressure it is open how a patch shares its force, and so is the "
                     "motion cone: take pressure = \"pad\" or \"even\"");
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    const Body<double>& body = file.body(b);
    const SceneLines::OfBody& lines = file.lines.bodies[static_cast<std::size_t>(b)];
    if (body.role == Role::finger && std::abs(body.normal.z()) < 1 - typed_direction)
      refuse(file, b, lines.normal,
             "its normal lies in the plane, so its force changes with the motion; a motion cone "
             "is one of fingers that press across it, along z");
    if (b != pusher) continue;
    if (std::abs(body.normal.z()) > typed_direction)
      refuse(file, b, lines.normal, "it pushes across the plane, where nothing moves");
    if (body.bilateral)
      refuse(file, b, lines.motion, "it holds the object as well as it pushes: it has no cone");
    if (!(body.friction > 0))
      refuse(file, b, lines.friction, "without friction it slips in every push but one");
  }
}

Vector3<double> load_of(const SceneFile& file, double length) {
  Vector6<double> load = file.object.wrench;
  load.head<3>() += file.object.mass * file.gravity;
  return planar_wrench(load, length);
}

double reach_of(const SceneFile& file) {
  double reach = 0;
  for (const Vector3<double>& p : file.points) reach = std::max(reach, p.head<2>().norm());
  return reach > 0 ? reach : 1;
}

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
      : file_(file), length_(reach_of(file)), grip_(GripPoints(file), length_),
        load_(load_of(file, length_)) {
    report_.pusher = pusher;
    report_.length = length_;
  }

  ConeReport find(const std::optional<Vector6<double>>& asked) {
    if (!grip_.is_solid())
      throw InputError(file_.lines.file, file_.lines.bodies.front().place,
                       "the fingers resist no turning: they press at one place without a patch; "
                       "give them a shape or a torsion_radius");
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
    if (planar_twist(twist, length_).norm() > 0) judge(cone, twist);
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
      report_.sides.push_back(std::move(side));
    }
  }

  void judge(const MotionCone& cone, const Vector6<double>& twist) {
    const Vector3<double> planar = planar_twist(twist, length_);
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
    verdict.leaves = leaves(twist);
    if (!verdict.sticks) verdict.margin = -verdict.margin;
    verdict.grip = least_grip(grip_, cone.pusher(), load_, planar);
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
  refuse_others(file, pusher);
  return ConeFinder(file, pusher).find(twist);
}

} // namespace lcpush::desktop
