#include "cone/planar_scene.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr double typed_direction = 1e-6;

[[noreturn]] void refuse(const SceneFile& file, Index b, int line, const std::string& what) {
  throw InputError(file.lines.file, line,
                   std::string(file.body(b).role == Role::pusher ? "pusher " : "finger ") +
                       quoted(file.body_name(b)) + ": " + what);
}

} // namespace

void refuse_no_cone(const SceneFile& file, Index pusher) {
  if (!file.planar)
    throw InputError(file.lines.file, file.lines.object,
                     "a whole motion cone is one of motions in the plane: say planar = true, if "
                     "the object moves in the x-y plane; or cut the cone with --vary, such as " +
                         file.body_name(pusher) + ".acceleration[1]=-1:1");
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
  if (!grip.is_solid())
    throw InputError(file.lines.file, file.lines.bodies.front().place,
                     "the fingers resist no turning: they press at one place without a patch; "
                     "give them a shape or a torsion_radius");
}

} // namespace lcpush::desktop
