#include "verify/trajectory_forces.hpp"
#include "verify/settings.hpp"
#include "verify/trajectory_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Settings = VerifySettings;

/// A body's force on the object as far as it is known; the moment about the object's centre of mass
/// at the step's begin.
struct SeenWrench {
  std::optional<Vector3<double>> force, moment;
};

class ForceJudge {
public:
  ForceJudge(const SceneFile& file, const std::vector<TrajectoryFrame>& frames)
      : file_(file), frames_(frames), seen_(file, frames) {
    units_.size = seen_.telling().size;
  }

  std::optional<ForceReport> judge() {
    for (std::size_t k = 1; k < frames_.size(); ++k) {
      fastest_ = std::max(fastest_, mean_speed(k));
      for (std::size_t i = 0; i < frames_[k].contacts.size(); ++i)
        largest_ = std::max(largest_, force_size(contact(frames_[k], i)));
    }
    for (std::size_t k = 1; k < frames_.size(); ++k) {
      if (!says_forces(frames_[k])) continue;
      step_ = seen_.step(k);
      if (!(step_.h > 0)) continue;
      frame_ = &frames_[k];
      const Vector6<double> twist = velocity_at(frames_, k);
      step_.fastest = std::max(step_.fastest, seen_.telling().fastest(frame_->pose, twist));
      judge_frame();
    }
    if (report_.frames == 0) return std::nullopt;
    for (const std::optional<WorstForce>& worst : worst_)
      if (worst) report_.worst.push_back(*worst);
    return report_;
  }

private:
  static bool says_forces(const TrajectoryFrame& frame) {
    return std::any_of(frame.contacts.begin(), frame.contacts.end(),
                       [](const FrameContact& c) { return c.normal_force || c.friction_force; }) ||
           std::any_of(frame.bodies.begin(), frame.bodies.end(),
                       [](const FrameBody& b) { return b.force.has_value(); });
  }
  double mean_speed(std::size_t k) const {
    const double h = frames_[k].time - frames_[k - 1].time;
    return (frames_[k].pose.position - frames_[k - 1].pose.position).norm() / h;
  }
  /// What hard and frictionless points have none of need not be said.
  FrameContact contact(const TrajectoryFrame& frame, std::size_t i) const {
    if (frame.contacts.empty()) return {};
    FrameContact contact = frame.contacts[i];
    const Body<double>& body = file_.body(file_.body_of(static_cast<Index>(i)));
    if (!contact.friction_force && contact.normal_force && !(body.friction > 0))
      contact.friction_force = Vector3<double>::Zero();
    if (!contact.torsion && contact.friction_force && !(body.torsion_radius * body.friction > 0))
      contact.torsion = 0;
    return contact;
  }

  void judge_frame() {
    ++report_.frames;
    contacts_.clear();
    wrenches_.clear();
    for (std::size_t i = 0; i < file_.points.size(); ++i) contacts_.push_back(contact(*frame_, i));
    for (Index b = 0; b < static_cast<Index>(file_.bodies.size()); ++b)
      wrenches_.push_back(wrench_of(b));
    measure();
    for (Index b = 0; b < static_cast<Index>(file_.bodies.size()); ++b) {
      for (const Index i : points_of(file_.body(b))) {
        const auto at = static_cast<std::size_t>(i);
        for (const WorstForce& one :
             judge_point(file_, i, contacts_[at], step_.contacts[at], step_.h, units_))
          note(one);
      }
      judge_sum(b);
      judge_flat(b);
    }
    for (std::size_t a = 0; a < file_.actuators.size(); ++a) judge_grip(static_cast<Index>(a));
    judge_balance();
  }

  void measure() {
    const Object<double>& object = file_.object;
    double force = std::max(object.mass * file_.gravity.norm(), object.wrench.head<3>().norm());
    if (step_.before && step_.twist) {
      const Vector6<double> change = *step_.twist - *step_.before;
      force = std::max(force, object.mass / step_.h * change.head<3>().norm());
    }
    for (const SeenWrench& wrench : wrenches_)
      if (wrench.force) force = std::max(force, wrench.force->norm());
    for (const Actuator<double>& actuator : file_.actuators)
      force = std::max(force, std::abs(actuator.force));
    units_.force = std::max({force, Settings::of_motion * largest_, Settings::least_force});
    units_.point_force = Settings::of_loads * units_.force;
    for (const FrameContact& contact : contacts_)
      units_.point_force = std::max(units_.point_force, force_size(contact));
    const double gained = step_.h * units_.force / object.mass;
    units_.speed = std::max(step_.fastest, Settings::of_speeds * std::max(fastest_, gained));
  }

  /// By its contacts if they are known, else as given.
  SeenWrench wrench_of(Index b) const {
    if (const std::optional<SeenWrench> sum = sum_of(b)) return *sum;
    if (frame_->bodies.empty()) return {};
    const FrameBody& body = frame_->bodies[static_cast<std::size_t>(b)];
    return {body.force, body.moment};
  }
  std::optional<SeenWrench> sum_of(Index b) const {
    Vector3<double> force = Vector3<double>::Zero();
    std::optional<Vector3<double>> moment = Vector3<double>(Vector3<double>::Zero());
    for (const Index i : points_of(file_.body(b))) {
      const FrameContact& contact = contacts_[static_cast<std::size_t>(i)];
      const SeenContact& seen = step_.contacts[static_cast<std::size_t>(i)];
      if (!contact.normal_force || !contact.friction_force || !seen.is_placed) return std::nullopt;
      const Vector3<double> f = *contact.normal_force * seen.normal + *contact.friction_force;
      force += f;
      if (!contact.torsion)
        moment.reset();
      else if (moment)
        *moment += cross<double>(seen.position, f) + *contact.torsion * seen.normal;
    }
    return SeenWrench{force, moment};
  }

  void note(WorstForce worst) {
    worst.time = step_.time;
    std::optional<WorstForce>& most = worst_[static_cast<std::size_t>(worst.law)];
    if (!most || !(worst.off <= most->off)) most = worst;
  }

  /// A body whose force is given without its contacts': where they are on one plane, the sum obeys
  /// what a single one would, and where they slip alike, opposes that.
  void judge_flat(Index b) {
    const SeenWrench& wrench = wrenches_[static_cast<std::size_t>(b)];
    if (!wrench.force || sum_of(b)) return;
    const Index first = file_.body(b).first_point;
    SeenContact all = step_.contacts[static_cast<std::size_t>(first)];
    for (const Index i : points_of(file_.body(b))) {
      const SeenContact& seen = step_.contacts[static_cast<std::size_t>(i)];
      if (!seen.is_placed || (seen.normal - all.normal).norm() > Settings::along_normal) return;
      all.touches = all.touches || seen.touches;
      if (!seen.slip || !all.slip ||
          (*seen.slip - *all.slip).norm() > Settings::same_slip * all.slip->norm())
        all.slip.reset();
    }
    FrameContact said;
    said.normal_force = wrench.force->dot(all.normal);
    said.friction_force = *wrench.force - *said.normal_force * all.normal;
    const bool is_soft = file_.body(b).torsion_radius > 0; // one point: its torsion by the moment
    if (is_soft && wrench.moment)
      said.torsion = (*wrench.moment - cross<double>(all.position, *wrench.force)).dot(all.normal);
    else if (!is_soft && all.slip)
      said.torsion = 0;
    ForceUnits units = units_;
    units.point_force = std::max(units.point_force, force_size(said));
    for (WorstForce one : judge_point(file_, first, said, all, step_.h, units)) {
      if (one.law == ForceLaw::gap) continue; // which of them touch was told point by point
      one.is_of_body = true;
      note(one);
    }
  }

  void judge_sum(Index b) {
    const std::optional<SeenWrench> sum = sum_of(b);
    if (!sum || frame_->bodies.empty()) return;
    const FrameBody& given = frame_->bodies[static_cast<std::size_t>(b)];
    if (given.force) note_missing(ForceLaw::sum, b, *given.force - *sum->force, false);
    if (given.moment && sum->moment)
      note_missing(ForceLaw::sum, b, *given.moment - *sum->moment, true);
  }

  void note_missing(ForceLaw law, Index of, const Vector3<double>& missing, bool is_moment) {
    const double unit = is_moment ? units_.force * units_.size / 2 : units_.force;
    WorstForce worst;
    worst.law = law;
    worst.of = of;
    worst.off = missing.norm() / unit;
    worst.found = missing.norm();
    worst.is_moment = is_moment;
    note(worst);
  }

  /// What a body's forces do along a unit of a drive; none: they are not known well enough.
  std::optional<double> driven(const Drive<double>& drive) const {
    const auto b = static_cast<std::size_t>(drive.body);
    const Vector6<double> twist = twist_at(drive.twist, step_.begin.position);
    const Vector3<double> linear = twist.head<3>(), angular = twist.tail<3>();
    const bool turns = angular.squaredNorm() > 0;
    const SeenWrench& wrench = wrenches_[b];
    if (wrench.force && (wrench.moment || !turns))
      return linear.dot(*wrench.force) + (turns ? angular.dot(*wrench.moment) : 0.0);
    double pressing = 0; // friction has no part in what closes along the normal
    for (const Index i : points_of(file_.body(drive.body))) {
      const std::optional<double>& force = contacts_[static_cast<std::size_t>(i)].normal_force;
      const Vector3<double>& n = step_.contacts[static_cast<std::size_t>(i)].normal;
      if (!force || turns ||
          (linear - n * n.dot(linear)).norm() > Settings::along_normal * linear.norm())
        return std::nullopt;
      pressing += *force * n.dot(linear);
    }
    return pressing;
  }

  void judge_grip(Index a) {
    const auto at = static_cast<std::size_t>(a);
    const Actuator<double>& actuator = file_.actuators[at];
    double found = 0, size = std::abs(actuator.force), lawful = actuator.force;
    if (actuator.inertia > 0) {
      if (!step_.speeds[at] || !step_.speeds_before[at]) return;
      lawful -= actuator.inertia * (*step_.speeds[at] - *step_.speeds_before[at]) / step_.h;
    }
    for (const Drive<double>& drive : file_.drives) {
      if (drive.actuator != a) continue;
      const std::optional<double> force = driven(drive);
      if (!force || seen_.is_absent(drive.body)) return;
      found += *force;
      size = std::max(size, std::abs(*force));
    }
    size = std::max(size, Settings::of_loads * units_.force);
    WorstForce worst;
    worst.law = ForceLaw::grip;
    worst.of = a;
    worst.off = std::abs(found - lawful) / size;
    worst.found = found;
    worst.lawful = lawful;
    note(worst);
  }

  /// Of one step from frame to frame: over several, the forces between are not known.
  void judge_balance() {
    if (!step_.is_whole || !step_.before || !step_.twist) return;
    const Object<double>& object = file_.object;
    Vector3<double> force = object.mass * file_.gravity + object.wrench.head<3>();
    std::optional<Vector3<double>> moment = Vector3<double>(object.wrench.tail<3>());
    for (const SeenWrench& wrench : wrenches_) {
      if (!wrench.force) return;
      force += *wrench.force;
      if (moment && wrench.moment)
        *moment += *wrench.moment;
      else
        moment.reset();
    }
    ++report_.balanced;
    const Vector6<double> change = (*step_.twist - *step_.before) / step_.h;
    note_missing(ForceLaw::newton, -1, in_plane(object.mass * change.head<3>() - force), false);
    if (!moment) return;
    // Schemes take the torque of a spin at the step's begin, at its end, or as a change of the
    // angular momentum: each is right to the same order.
    const Vector3<double> w0 = step_.before->tail<3>(), w1 = step_.twist->tail<3>();
    const Vector3<double> L0 = step_.begin_inertia * w0, L1 = step_.end_inertia * w1;
    Vector3<double> missing = (L1 - L0) / step_.h - *moment;
    const Vector3<double> others[] = {
        step_.begin_inertia * change.tail<3>() + cross<double>(w0, L0) - *moment,
        step_.end_inertia * change.tail<3>() + cross<double>(w1, L1) - *moment};
    for (const Vector3<double>& other : others)
      if (about_plane(other).norm() < about_plane(missing).norm()) missing = other;
    note_missing(ForceLaw::newton, -1, about_plane(missing), true);
  }

  /// In a planar scene the balance across the plane is dropped.
  Vector3<double> in_plane(Vector3<double> force) const {
    if (file_.planar) force[2] = 0;
    return force;
  }
  Vector3<double> about_plane(Vector3<double> moment) const {
    if (file_.planar) moment[0] = moment[1] = 0;
    return moment;
  }

  const SceneFile& file_;
  const std::vector<TrajectoryFrame>& frames_;
  SeenMotion seen_;
  ForceReport report_;
  std::array<std::optional<WorstForce>, std::size(force_laws)> worst_;
  double largest_ = 0, fastest_ = 0; ///< N, m/s, of all frames
  // Of the frame that is judged.
  const TrajectoryFrame* frame_ = nullptr;
  SeenStep step_;
  std::vector<FrameContact> contacts_;
  std::vector<SeenWrench> wrenches_;
  ForceUnits units_;
};

} // namespace

const char* force_law_text(ForceLaw law) {
  constexpr const char* texts[] = {"gap", "normal", "cone", "dissipation", "sum", "grip", "newton"};
  return texts[static_cast<int>(law)];
}

const WorstForce* ForceReport::broken(double tolerance) const {
  const auto first = std::find_if(worst.begin(), worst.end(),
                                  [&](const WorstForce& one) { return !(one.off <= tolerance); });
  return first == worst.end() ? nullptr : &*first;
}

std::optional<ForceReport> judge_forces(const SceneFile& file,
                                        const std::vector<TrajectoryFrame>& frames) {
  return ForceJudge(file, frames).judge();
}

} // namespace lcpush::desktop
