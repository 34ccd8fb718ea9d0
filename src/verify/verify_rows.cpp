#include "verify/verify_rows.hpp"
#include "text/format.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

/// Finds the words for a row of a law.
class RowNames {
public:
  RowNames(const Push& push, const Answer<double>& answer)
      : push_(push), scene_(push.scene()), answer_(answer) {}

  std::string operator()(const Violation<double>& row) const {
    const std::string point = row.law == Law::newton || row.law == Law::grip
                                  ? std::string()
                                  : point_name(push_.file(), row.of);
    switch (row.law) {
    case Law::newton: return newton(row.of);
    case Law::normal: return normal(row, point);
    case Law::dissipation: return dissipation(row, point);
    case Law::cone: return cone(row, point);
    case Law::grip: return "force of actuator " + push_.actuator_name(row.of);
    case Law::rigidity: return rigidity(row, point);
    case Law::pusher: return point + " presses and does not move with its pusher";
    }
    return {};
  }

  std::string unit(const Violation<double>& row) const {
    const bool turns = row.law == Law::newton && row.of >= 3;
    if (row.law == Law::newton && scene_.planar && row.of >= 2 && row.of <= 4)
      return turns ? "rad/s^2" : "m/s^2";
    if (turns || (row.law == Law::cone && row.part == 3)) return "N m";
    if (row.law == Law::newton || row.law == Law::grip) return "N";
    if (row.law == Law::rigidity) return "m/s^2";
    return row.moves ? "m/s^2" : "N";
  }

private:
  const Push& push_;
  const Scene<double>& scene_;
  const Answer<double>& answer_;

  const Body<double>& body_of(Index point) const {
    return scene_.bodies[push_.layout().body[point]];
  }
  std::string newton(Index axis) const {
    const std::string name(1, "xyz"[axis % 3]);
    if (scene_.planar && axis >= 2 && axis <= 4)
      return axis == 2 ? "motion out of the plane along z"
                       : "rotation out of the plane about " + name;
    return axis < 3 ? "balance of forces along " + name : "balance of moments about " + name;
  }
  std::string normal(const Violation<double>& row, const std::string& point) const {
    const ContactAnswer<double>& contact = answer_.contacts[row.of];
    if (body_of(row.of).bilateral) return point + " leaves a pusher that holds it";
    if (!(row.scaled < 0)) return point + " presses while it separates";
    return contact.normal_force < 0 ? point + " pulls" : point + " moves into its body";
  }
  std::string dissipation(const Violation<double>& row, const std::string& point) const {
    if (row.part < 0)
      return "friction of " + point +
             (row.scaled < 0 ? " is none" : " is not opposite to its slip");
    const Generator<double> d = generator(scene_, body_of(row.of), row.of, row.part);
    return "friction of " + point + generator_text(d, body_of(row.of).torsion_radius) +
           (row.scaled < 0 ? " is negative" : " does not oppose the slip");
  }
  std::string cone(const Violation<double>& row, const std::string& point) const {
    if (row.part >= 0) return "friction of " + point + " is no force of its contact plane";
    if (row.scaled < 0) return "friction of " + point + " exceeds its cone";
    return point + " slides with friction inside its cone";
  }
  std::string rigidity(const Violation<double>& row, const std::string& point) const {
    if (row.part < 3)
      return "acceleration of " + point + " along " + std::string(1, "xyz"[row.part]) +
             " is not the object's";
    return point + " and " + point_name(push_.file(), row.part - 3) +
           " do not move as one rigid body";
  }
};

bool is_worse(double violation, double than) {
  return !(std::abs(violation) <= than) && than == than;
}

/// Numbers of the file that follow from others, and those that the answer judged has otherwise.
class GivenNumbers {
public:
  GivenNumbers(const Push& push, const ForeignAnswer& given, const Answer<double>& answer,
               bool is_completed)
      : sums_(is_completed ? "the laws leave" : "its points make"), file_(push.file()),
        scene_(push.file().view()), scales_(push.layout().scales), given_(given), answer_(answer) {}

  BrokenRow worst() {
    worst_ = {std::nullopt, "numbers that the file states", 0, 0, "N", {}, {}};
    for (std::size_t b = 0; b < given_.bodies.size(); ++b) look_at(b);
    for (std::size_t i = 0; i < given_.contacts.size(); ++i)
      if (const auto& spin = given_.contacts[i].spin)
        note(*spin, answer_.contacts[static_cast<Index>(i)].spin, per_length(scales_.acceleration),
             "rad/s^2", "the spin of " + point_name(file_, static_cast<Index>(i)), motion_);
    for (Index k = 0; given_.acceleration && k < 6; ++k) {
      const double found = (*given_.acceleration)[k], lawful = answer_.acceleration[k];
      const double unit = beside_the_push(found - lawful, k < 3 ? 1 : scales_.length);
      note(found, lawful, k < 3 ? unit : per_length(unit), k < 3 ? "m/s^2" : "rad/s^2",
           "the object's acceleration" + axis_words(k), "lcpush's own answer has");
    }
    return worst_;
  }

private:
  static constexpr const char* motion_ = "the motion makes";
  const char* sums_;
  const SceneFile& file_;
  Scene<double> scene_;
  const Scales<double>& scales_;
  const ForeignAnswer& given_;
  const Answer<double>& answer_;
  BrokenRow worst_;

  double per_length(double x) const { return x / scales_.length; }
  /// Where more than a twentieth of the prescribed motion is missing, that is the unit, however
  /// large the scene's other accelerations are.
  double beside_the_push(double off, double length) const {
    const double push = push_size(scene_);
    const bool is_large = push > 0 && std::abs(off) * length > VerifySettings::of_asked * push;
    return is_large ? std::min(push, scales_.acceleration) : scales_.acceleration;
  }
  static std::string axis_words(Index k) {
    return (k < 3 ? " along " : " about ") + std::string(1, "xyz"[k % 3]);
  }

  /// "the force of wall along x is 4.7 N, where the laws leave 4.64 N"
  void note(double found, double lawful, double unit, const char* unit_name,
            const std::string& what, const char* source) {
    const double off = found - lawful;
    if (!is_worse(off / unit, worst_.scaled)) return;
    const auto [is, should] = told_apart(found, lawful, VerifySettings::negligible * unit);
    worst_ = {std::nullopt,
              what + " is " + is + " " + unit_name + ", where " + source + " " + should + " " +
                  unit_name,
              std::abs(off / unit),
              std::abs(off),
              unit_name,
              found,
              lawful};
  }

  void look_at(std::size_t b) {
    const ForeignBody& given = given_.bodies[b];
    const Body<double>& body = scene_.bodies[static_cast<Index>(b)];
    const std::string of = " of " + file_.body_names[b];
    const Vector6<double> wrench = body_wrench(scene_, answer_, body);
    for (Index k = 0; k < 3; ++k) {
      if (given.force)
        note((*given.force)[k], wrench[k], scales_.force, "N", "the force" + of + axis_words(k),
             sums_);
      if (given.moment)
        note((*given.moment)[k], wrench[3 + k], scales_.force * scales_.length, "N m",
             "the moment" + of + axis_words(3 + k), sums_);
    }
    if (given.normal_force)
      note(*given.normal_force, normal_sum(answer_, body), scales_.force, "N",
           "the normal force" + of, sums_);
    const std::string closes = "the closing acceleration" + of;
    if (given.closing.size() == 1)
      note(given.closing[0], mean_closing(answer_, body), scales_.acceleration, "m/s^2", closes,
           motion_);
    for (std::size_t k = 0; given.closing.size() > 1 && k < given.closing.size(); ++k)
      if (static_cast<Index>(given.closing.size()) == body.point_count)
        note(given.closing[k],
             answer_.contacts[body.first_point + static_cast<Index>(k)].closing_acceleration,
             scales_.acceleration, "m/s^2", closes, motion_);
  }
};

/// The generator's share of a row of a pyramid.
double generator_force(const Scene<double>& scene, const Answer<double>& answer,
                       const Violation<double>& row) {
  Index entry = row.part;
  for (const Body<double>& body : scene.bodies)
    for (const Index i : points_of(body))
      if (i < row.of) entry += generator_count(scene, body);
  return answer.friction[entry];
}

/// What excludes the motion of such a row, over its body's forces: the force that presses, what the
/// cone has left, or the friction that does not oppose the slip.
double excluded(const Scene<double>& scene, const Scales<double>& scales,
                const Answer<double>& answer, const Violation<double>& row) {
  const ContactAnswer<double>& contact = answer.contacts[row.of];
  const Body<double>& body = scene.bodies[contact.body];
  const double friction = contact.friction_force.norm(), normal = std::abs(contact.normal_force);
  if (row.law == Law::normal && body.bilateral) return std::numeric_limits<double>::infinity();
  const double force = row.law == Law::normal ? normal
                       : row.law == Law::cone ? body.friction * normal - friction
                       : row.part >= 0        ? generator_force(scene, answer, row)
                                              : friction;
  double pressing = Tolerances<double>().noise * scales.force;
  for (const Index i : points_of(body))
    pressing +=
        std::abs(answer.contacts[i].normal_force) + answer.contacts[i].friction_force.norm();
  return std::abs(force) / std::min(pressing, scales.force);
}

/// Where more than a twentieth of an actuator's load is missing, or a contact goes otherwise by so
/// much of the prescribed motion, or slips otherwise by half of it, that is the unit, however large
/// the scene's other forces and accelerations are.
/// `says_motion`: it is given, and does not follow from forces, whose digits would leave it open.
Violation<double> beside_what_is_asked(const Scene<double>& scene, const Scales<double>& scales,
                                       const Answer<double>& answer, bool says_motion,
                                       Violation<double> row) {
  const bool is_rigid = row.law == Law::rigidity;
  if (row.law != Law::grip && !row.moves && !is_rigid) return row;
  double asked = row.law == Law::grip ? std::abs(scene.actuators[row.of].force) : push_size(scene);
  if (is_rigid && asked > 0)
    asked = std::max(asked, acceleration_at(scene.points[row.of], answer.acceleration).norm());
  const bool is_of_slip = row.law == Law::dissipation || row.law == Law::cone;
  const bool is_strict = says_motion && !is_of_slip;
  const double off = row.scaled * row.unit, part = is_strict ? VerifySettings::of_asked : 0.5;
  if (!(asked < row.unit) || !(std::abs(off) > part * asked) || !(asked > 0)) return row;
  row.scaled = off / asked;
  // Then the smaller of both.
  const bool excludes = row.law != Law::pusher && !is_rigid && off > 0;
  if (excludes) row.scaled = std::min(row.scaled, excluded(scene, scales, answer, row));
  row.unit = row.scaled != 0 ? off / row.scaled : asked;
  return row;
}

} // namespace

std::vector<BrokenRow> broken_rows(const Push& push, const ForeignAnswer& given,
                                   const Answer<double>& answer, bool is_completed) {
  std::vector<Violation<double>> worst(static_cast<std::size_t>(law_count));
  std::vector<bool> any(worst.size());
  const bool says_motion =
      given.acceleration ||
      std::any_of(given.contacts.begin(), given.contacts.end(),
                  [](const ForeignContact& contact) { return contact.acceleration.has_value(); });
  check_rows(push.scene(), push.layout().scales, answer, 1.0, [&](const Violation<double>& shown) {
    const Violation<double> row =
        beside_what_is_asked(push.scene(), push.layout().scales, answer, says_motion, shown);
    const auto law = static_cast<std::size_t>(row.law);
    if (!any[law] || is_worse(row.scaled, std::abs(worst[law].scaled))) worst[law] = row;
    any[law] = true;
  });
  const RowNames name(push, answer);
  std::vector<BrokenRow> rows{GivenNumbers(push, given, answer, is_completed).worst()};
  for (std::size_t law = 0; law < worst.size(); ++law) {
    const Violation<double>& row = worst[law];
    if (!any[law]) continue;
    rows.push_back({row.law,
                    name(row),
                    std::abs(row.scaled),
                    std::abs(row.scaled * row.unit),
                    name.unit(row),
                    {},
                    {}});
  }
  return rows;
}

std::string next_tolerance(double off) {
  return printed("%g", std::pow(VerifySettings::decade, std::ceil(std::log10(off))));
}

} // namespace lcpush::desktop
