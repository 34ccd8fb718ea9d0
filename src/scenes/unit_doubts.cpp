#include "scenes/unit_doubts.hpp"

#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

// From aerogel to osmium, with a margin for hollow things.
constexpr double lightest = 10, heaviest = 30000; // kg/m^3
// Beyond gecko feet and racing tyres; also what people write for "does not slip".
constexpr double most_friction = 10;
// Four times Jupiter's; and a thousand times the Earth's.
constexpr double most_gravity = 100, most_acceleration = 1e4; // m/s^2
// Ten times a fast robot's hand.
constexpr double most_speed = 10; // m/s
// Of how far out the contacts lie; a long rod is held in its middle.
constexpr double most_gyration = 100;

class UnitChecker {
public:
  explicit UnitChecker(const SceneFile& file) : file_(file) {}

  std::vector<SceneDoubt> check() {
    check_density();
    check_inertia();
    check_gravity();
    for (std::size_t b = 0; b < file_.bodies.size(); ++b) {
      check_friction(b);
      check_acceleration(b);
    }
    return std::move(doubts_);
  }

private:
  void doubt(Doubt doubt, int line, const std::string& text) {
    doubts_.push_back({doubt, file_.lines.file, line, text});
  }

  void check_density() {
    if (file_.shape.kind == ObjectShape::Kind::unknown) return;
    const Vector3<double>& size = file_.shape.size;
    const double round = file_.shape.kind == ObjectShape::Kind::cylinder ? std::atan(1)
                         : file_.shape.kind == ObjectShape::Kind::ball   ? std::atan(1) * 2 / 3
                                                                         : 1;
    const double volume = round * size.prod(), density = file_.object.mass / volume;
    if (density >= lightest && density <= heaviest) return;
    doubt(Doubt::density, file_.lines.object,
          "object: " + printed("%.3g kg in ", file_.object.mass) + printed("%.3g m^3 is ", volume) +
              printed("%.3g kg/m^3, ", density) +
              (density < lightest ? "lighter than any solid" : "heavier than any material") +
              "; lengths are in m, masses in kg");
  }

  void check_inertia() {
    if (file_.shape.kind != ObjectShape::Kind::unknown || is_particle(file_)) return;
    double reach = 0;
    for (const Vector3<double>& p : file_.points) reach = std::max(reach, p.norm());
    const double gyration =
        std::sqrt(file_.object.inertia.diagonal().maxCoeff() / file_.object.mass);
    if (gyration <= most_gyration * reach) return;
    doubt(Doubt::inertia, file_.lines.object,
          "object: its inertia is that of a body of about " + length_text(gyration) +
              ", but its contacts lie within " + length_text(reach) + "; inertia is in kg m^2");
  }

  void check_gravity() {
    if (file_.gravity.norm() <= most_gravity) return;
    doubt(Doubt::gravity, file_.lines.gravity,
          printed("gravity is %.3g m/s^2", file_.gravity.norm()) +
              ", more than on any planet; the Earth's is 9.81");
  }

  void check_friction(std::size_t b) {
    const double friction = file_.bodies[b].friction;
    if (friction <= most_friction) return;
    doubt(Doubt::friction, file_.lines.bodies[b].friction,
          body_label(file_, b) + printed("friction %.3g", friction) +
              " is more than any material has; it is a coefficient such as 0.5, neither percent "
              "nor an angle");
  }

  void check_acceleration(std::size_t b) {
    const double size = file_.bodies[b].acceleration.head<3>().norm();
    if (size <= (file_.strokes[b].is_velocity ? most_speed : most_acceleration)) return;
    doubt(Doubt::acceleration, file_.lines.bodies[b].motion,
          body_label(file_, b) +
              (file_.strokes[b].is_velocity
                   ? printed("it moves at %.3g m/s", size) +
                         ", which is no speed of a hand; velocities are in m/s and rad/s"
                   : printed("it moves at %.3g m/s^2", size) +
                         ", more than a thousand times the Earth's gravity; accelerations are in "
                         "m/s^2 and rad/s^2"));
  }

  const SceneFile& file_;
  std::vector<SceneDoubt> doubts_;
};

} // namespace

std::vector<SceneDoubt> unit_doubts(const SceneFile& file) { return UnitChecker(file).check(); }

bool is_particle(const SceneFile& file) {
  return std::all_of(file.points.begin(), file.points.end(),
                     [](const Vector3<double>& p) { return p.isZero(); });
}

std::string body_label(const SceneFile& file, std::size_t b) {
  return std::string(file.bodies[b].role == Role::finger ? "finger " : "pusher ") +
         quoted(file.body_names[b]) + ": ";
}

std::string length_text(double length) {
  return length < 1 ? printed("%.3g mm", 1000 * length) : printed("%.3g m", length);
}

} // namespace lcpush::desktop
