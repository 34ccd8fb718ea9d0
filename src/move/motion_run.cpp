#include "move/motion_run.hpp"

#include "lcpush/desktop/owned.hpp"
#include "lcpush/mechanics/model/even_pressure.hpp"
#include "move/move_words.hpp"
#include "move/settings.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// Actuators whose closing a turned face's friction may feel as well: all, a point each under even
/// pressure.
Index shared_of(const SceneFile& file) {
  if (file.pressure == Pressure::even) return even_size(file.view()).drives;
  return static_cast<Index>(file.actuators.size());
}

std::size_t motion_bytes_of(const SceneFile& file) {
  return static_cast<std::size_t>(
      structured_motion_bytes<double>(motion_size(file.view()), shared_of(file)));
}

Touch touch_of(const StepContact<double>& contact) {
  switch (contact.absence) {
  case Absence::none: break;
  case Absence::outside: return Touch::beside;
  case Absence::behind: return Touch::behind;
  case Absence::far: return Touch::parted;
  case Absence::no_line: return Touch::no_line;
  case Absence::away: return Touch::away;
  }
  return contact.mode == Mode::stick   ? Touch::sticks
         : contact.mode == Mode::slide ? Touch::slips
                                       : Touch::parted;
}

/// Elsewhere there is no gap to speak of, nor where the step has taken the point beside its face.
bool is_over_its_face(const StepContact<double>& contact) {
  const bool was = contact.absence == Absence::none || contact.absence == Absence::far;
  return was && contact.ends == Absence::none;
}

} // namespace

MotionRun::MotionRun(const SceneFile& file, Order order)
    : file_(file), order_(order), faces_(file), cones_(file.is_round ? file.points.size() : 0),
      scene_(scene_of(file)), around_(faces_.view()), bytes_(motion_bytes_of(file)),
      kept_(static_cast<std::size_t>(motion_array_bytes<double>(motion_size(scene_)))),
      memory_(make_structured_motion_memory<double>(span_of(bytes_), motion_size(scene_),
                                                    shared_of(file))),
      stepper_(scene_, around_, memory_) {
  if (order == Order::second) stepper_.end_on_faces();
}

Scene<double> MotionRun::scene_of(const SceneFile& file) const {
  Scene<double> scene = file.view();
  scene.bodies = span_of(faces_.bodies());
  scene.round_cones = {cones_.data(), static_cast<Index>(cones_.size())};
  return scene;
}

Status MotionRun::advance(double h) {
  const double now = stepper_.time();
  began_ = stepper_.pose().position;
  faces_.place_strokes(now + h / 2);
  for (Index b = 0; b < scene_.bodies.size; ++b) {
    // Without inertia, what a step takes is the velocity at its end; over it, the way that an
    // acceleration makes is that of its mean.
    const Vector6<double> end = prescribed(b, now + h), begin = prescribed(b, now);
    const bool is_mean = order_ == Order::first && speeds_up(b);
    stepper_.prescribed(b) = is_absent(b) ? Vector6<double>(Vector6<double>::Zero())
                             : is_mean    ? Vector6<double>((begin + end) / 2)
                                          : end;
  }
  if (!has_round_friction(scene_)) return stepper_.advance(h);
  const Saved before = save();
  const Status status = stepper_.advance(h);
  const bool is_settled = status == Status::solved || status == Status::does_not_hold ||
                          status == Status::ray || stepper_.run().reason == Reason::leap;
  return is_settled || !allows_pyramids_ ? status : advance_by_pyramids(h, before);
}

Status MotionRun::advance_by_pyramids(double h, const Saved& before) {
  restore(before);
  const Span<const LinearizedCone<double>> round = scene_.round_cones;
  scene_.round_cones = {};
  const Status status = stepper_.advance(h);
  if (status == Status::solved) ++by_pyramids_;
  if (by_pyramids_ < MoveSettings::most_unsettled) scene_.round_cones = round;
  return status;
}

void MotionRun::forget_tries(Index by_pyramids) {
  by_pyramids_ = by_pyramids;
  if (by_pyramids_ < MoveSettings::most_unsettled)
    scene_.round_cones = {cones_.data(), static_cast<Index>(cones_.size())};
}

MotionRun::State MotionRun::state() const {
  return {stepper_.moment(),
          {memory_.poses.begin(), memory_.poses.end()},
          {memory_.closings.begin(), memory_.closings.end()},
          {memory_.speeds.begin(), memory_.speeds.end()}};
}

void MotionRun::return_to(const State& state) {
  stepper_.return_to(state.moment);
  std::copy(state.bodies.begin(), state.bodies.end(), memory_.poses.begin());
  std::copy(state.closings.begin(), state.closings.end(), memory_.closings.begin());
  std::copy(state.speeds.begin(), state.speeds.end(), memory_.speeds.begin());
}

bool MotionRun::extrapolate(const State& whole, double slack) {
  const auto beyond = [](const Pose<double>& half, const Pose<double>& full) {
    return Pose<double>{2 * half.position - full.position,
                        half.rotation * full.rotation.transpose() * half.rotation};
  };
  const State halves = state();
  State end = halves;
  end.moment.pose = beyond(halves.moment.pose, whole.moment.pose);
  end.moment.velocity += halves.moment.velocity - whole.moment.velocity;
  for (std::size_t b = 0; b < end.bodies.size(); ++b)
    end.bodies[b] = beyond(halves.bodies[b], whole.bodies[b]);
  for (std::size_t a = 0; a < end.speeds.size(); ++a) {
    end.closings[a] += halves.closings[a] - whole.closings[a];
    end.speeds[a] += halves.speeds[a] - whole.speeds[a];
  }
  return_to(end);
  for (Index b = 0; b < scene_.bodies.size; ++b)
    for (const Index i : points_of(scene_.bodies[b]))
      if (is_touching(touch_of(stepper_.contact(i)))) {
        const PlacedPoint<double> then = placed(b, i, slack);
        if (then.absence == Absence::none && std::abs(then.gap) <= slack) continue;
        return_to(halves);
        return false;
      }
  return true;
}

MotionRun::Saved MotionRun::save() const {
  return {{bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(kept_)}, stepper_.moment()};
}

void MotionRun::restore(const Saved& saved) {
  std::copy(saved.arrays.begin(), saved.arrays.end(), bytes_.begin());
  stepper_.return_to(saved.moment);
}

std::vector<Touch> MotionRun::touches() const {
  std::vector<Touch> touches;
  for (Index i = 0; i < scene_.points.size; ++i) touches.push_back(touch_of(stepper_.contact(i)));
  return touches;
}

bool MotionRun::leaves() const {
  for (Index i = 0; i < scene_.points.size; ++i) {
    const StepContact<double>& contact = stepper_.contact(i);
    if (contact.absence == Absence::none &&
        (contact.ends == Absence::outside || contact.ends == Absence::behind))
      return true;
  }
  return false;
}

MotionFrame MotionRun::frame(double h) const {
  MotionFrame frame;
  frame.time = stepper_.time();
  frame.step = h;
  frame.pose = stepper_.pose();
  frame.twist = stepper_.velocity();
  // Points press where they were when the step began.
  const Vector3<double>& center = began_;
  for (Index b = 0; b < scene_.bodies.size; ++b) {
    const Body<double>& body = scene_.bodies[b];
    BodyForce sum;
    for (const Drive<double>& drive : scene_.drives)
      if (drive.body == b && !sum.closing) {
        sum.closing = stepper_.closing(drive.actuator);
        sum.closing_speed = stepper_.closing_speed(drive.actuator);
      }
    for (const Index i : points_of(body)) {
      const StepContact<double>& contact = stepper_.contact(i);
      PointState state;
      state.touch = h > 0 ? touch_of(contact) : is_absent(b) ? Touch::away : Touch::sticks;
      state.position = file_.points[static_cast<std::size_t>(i)];
      state.normal = body.normal;
      if (h > 0) {
        if (is_over_its_face(contact)) state.gap = contact.gap;
        state.normal_force = contact.normal_force;
        state.friction_force = contact.friction_force;
        state.torsion = contact.torsion;
        state.velocity = contact.velocity;
        state.position = contact.position;
        state.normal = contact.normal;
        const Vector3<double> f = contact.normal_force * contact.normal + contact.friction_force;
        sum.force += f;
        sum.normal_force += contact.normal_force;
        sum.moment +=
            cross<double>(contact.position - center, f) + contact.torsion * contact.normal;
      }
      state.position += file_.object.center_of_mass;
      frame.contacts.push_back(state);
    }
    frame.bodies.push_back(sum);
    frame.body_poses.push_back(stepper_.pose_of(b));
  }
  return frame;
}

Motion<double> MotionRun::describe(double length) const {
  const Scene<double>& push = stepper_.step_scene();
  const Answer<double>& solved = stepper_.step_answer();
  // Behind those of the present points stand contacts of earlier steps.
  std::vector<ContactAnswer<double>> contacts(solved.contacts.data,
                                              solved.contacts.data + push.points.size);
  // The instant's words are about a motion from rest: the velocities at the step's end.
  std::vector<Body<double>> bodies(push.bodies.data, push.bodies.data + push.bodies.size);
  double speed = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].point_count == 0) continue;
    const Index of = file_.body_of(stepper_.point_of(bodies[b].first_point));
    bodies[b].acceleration = twist_at(prescribed(of, stepper_.time()), stepper_.pose().position);
    for (const Index i : points_of(bodies[b])) {
      contacts[static_cast<std::size_t>(i)].acceleration =
          stepper_.contact(stepper_.point_of(i)).velocity;
      speed = std::max(speed, acceleration_at(push.points[i], bodies[b].acceleration).norm());
    }
  }
  Answer<double> answer = solved;
  answer.contacts = span_of(contacts);
  answer.acceleration = stepper_.velocity();
  Scene<double> scene = push;
  scene.bodies = span_of(std::as_const(bodies));
  Motion<double> motion = describe_motion(scene, answer, length, speed > 0 ? speed : length, speed);
  if (motion.kind == MotionKind::pivot || motion.kind == MotionKind::turn)
    motion.kind = rolls() ? MotionKind::roll : motion.kind;
  return motion;
}

/// Does the round side stick to a plane and turn over on it?
bool MotionRun::rolls() const {
  const Vector3<double> turn = stepper_.velocity().tail<3>();
  for (Index b = 0; b < scene_.bodies.size; ++b)
    for (const Index i : points_of(scene_.bodies[b])) {
      const StepContact<double>& contact = stepper_.contact(i);
      if (faces_.touching(b).riding == Riding::on_side && contact.normal_force > 0 &&
          touch_of(contact) == Touch::sticks &&
          std::abs(turn.dot(contact.normal)) < turn.norm() / 2)
        return true;
    }
  return false;
}

Index MotionRun::inside(double slack) const {
  for (Index b = 0; b < scene_.bodies.size; ++b) {
    if (file_.strokes[static_cast<std::size_t>(b)].from != stepper_.time()) continue;
    for (const Index i : points_of(scene_.bodies[b])) {
      const PlacedPoint<double> now = placed(b, i, slack);
      if (now.absence != Absence::outside && now.gap < -slack) return b;
    }
  }
  return -1;
}

} // namespace lcpush::desktop
