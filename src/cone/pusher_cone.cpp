#include "cone/pusher_cone.hpp"
#include "cone/settings.hpp"

#include "draw/view.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

[[noreturn]] void refuse(const SceneFile& file, Index b, int line, const std::string& what) {
  throw InputError(file.lines.file, line,
                   std::string(file.body(b).role == Role::pusher ? "pusher " : "finger ") +
                       quoted(file.body_name(b)) + ": " + what);
}

} // namespace

/// A number of the pusher's motion, across its push, that would cut the cone.
static std::string possible_cut(const SceneFile& file, Index pusher) {
  const Body<double>& body = file.body(pusher);
  const double size = body.acceleration.head<3>().norm();
  const bool is_velocity = file.strokes[static_cast<std::size_t>(pusher)].is_velocity;
  const std::string end = brief(size > 0 ? size : 1);
  return "\"" + file.body_name(pusher) + (is_velocity ? ".velocity" : ".acceleration") +
         (std::abs(body.normal.y()) > std::abs(body.normal.x()) ? "[0]=-" : "[1]=-") + end + ":" +
         end + (is_velocity ? " m/s\"" : " m/s^2\"");
}

void refuse_no_cone(const SceneFile& file, Index pusher) {
  if (!file.planar)
    throw InputError(file.lines.file, file.lines.object,
                     "a whole motion cone is one of motions in the plane: say planar = true, if "
                     "the object moves in the x-y plane; or cut the cone by `lcpush cone` with "
                     "--vary, such as " +
                         possible_cut(file, pusher));
  if (file.pressure == Pressure::rigid)
    throw InputError(file.lines.file, 1,
                     "under rigid pressure it is open how a patch shares its force, and so is the "
                     "motion cone: take pressure = \"pad\" or \"even\"");
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    const Body<double>& body = file.body(b);
    const SceneLines::OfBody& lines = file.lines.bodies[static_cast<std::size_t>(b)];
    if (body.role == Role::finger && std::abs(body.normal.z()) < 1 - cone_settings.typed_direction)
      refuse(file, b, lines.normal,
             "its normal lies in the plane, so its force changes with the motion; a motion cone "
             "is one of fingers that press across it, along z");
    if (b != pusher) continue;
    if (std::abs(body.normal.z()) > cone_settings.typed_direction)
      refuse(file, b, lines.normal, "it pushes across the plane, where nothing moves");
    if (is_driven(file.view(), b))
      refuse(file, b, lines.motion,
             "its force is given, not its motion, which a motion cone is about; `lcpush solve` "
             "says whether it slips");
    if (body.bilateral)
      refuse(file, b, lines.motion, "it holds the object as well as it pushes: it has no cone");
    if (!(body.friction > 0))
      refuse(file, b, lines.friction, "without friction it slips in every push but one");
  }
}

Vector3<double> planar_load(const SceneFile& file, double length) {
  Vector6<double> load = file.object.wrench;
  load.head<3>() += file.object.mass * file.gravity;
  return planar_wrench(load, length);
}

double planar_reach(const SceneFile& file) {
  double reach = 0;
  for (const Vector3<double>& p : file.points) reach = std::max(reach, p.head<2>().norm());
  return reach > 0 ? reach : 1;
}

void refuse_single_place(const SceneFile& file, const LimitSurface& grip) {
  if (grip.is_empty()) {
    const double weight = file.object.mass * std::abs(file.gravity[2]);
    throw InputError(
        file.lines.file, file.lines.bodies.front().place,
        "no finger presses on the object across the plane, so no friction resists a push; give " +
            (weight > 0 ? "what carries it grip_force = " + brief(weight) + ", its weight"
                        : std::string("one a grip_force")));
  }
  if (!grip.is_solid())
    throw InputError(file.lines.file, file.lines.bodies.front().place,
                     "the fingers resist no turning: they press at one place without a patch; "
                     "give them a shape or a torsion_radius");
}

double PusherCone::room(const Vector3<double>& wrench) const {
  if (faces.empty()) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const ConeFace& face : faces)
    least = std::min(least, face.inward.dot(wrench) / wrench.norm());
  return least;
}

PusherCone pusher_cone(const SceneFile& file, Index pusher, double length) {
  const Body<double>& body = file.body(pusher);
  PusherCone cone;
  cone.along = cross<double>(Vector3<double>::UnitZ(), body.normal);
  const double mu = body.friction;
  std::vector<ExtremeWrench> all;
  std::vector<Pixel> flat; // (share of its friction, torque) of a unit force
  for (const Index i : points_of(body))
    for (const double side : {1.0, -1.0}) {
      const Vector3<double> force = body.normal + side * mu * cone.along;
      const Vector6<double> w =
          wrench_column<double>(file.points[static_cast<std::size_t>(i)], force);
      all.push_back({i, side, planar_wrench(w, length), force});
      flat.push_back({mu > 0 ? side : 0, w[5] / (length * (1 + mu))});
    }
  for (const std::size_t k : hull_corners(flat)) cone.edges.push_back(all[k]);
  const std::size_t count = cone.edges.size();
  if (count < 3) return cone;
  Vector3<double> middle = Vector3<double>::Zero();
  for (const ExtremeWrench& edge : cone.edges) middle += edge.wrench;
  for (std::size_t k = 0; k < count; ++k) {
    const ExtremeWrench &a = cone.edges[k], &b = cone.edges[(k + 1) % count];
    Vector3<double> inward = cross<double>(a.wrench, b.wrench).normalized();
    if (inward.dot(middle) < 0) inward = -inward;
    cone.faces.push_back({k, (k + 1) % count, inward, a.side == b.side});
  }
  return cone;
}

} // namespace lcpush::desktop
