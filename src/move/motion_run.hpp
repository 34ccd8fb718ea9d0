// A motion's stepper with its memory: it goes forward, and back to where it was.
#pragma once

#include "lcpush/desktop/move.hpp"
#include "lcpush/mechanics/solve/step.hpp"
#include "move/stroke_faces.hpp"

#include <vector>

namespace lcpush::desktop {

class MotionRun {
public:
  using Stepper = TimeStepper<double, StructuredLemke<double>>;

  /// Of the error of its steps in their length. First: a body that speeds up goes its whole way in
  /// a step at its mean velocity. Second, for extrapolate(): bodies have the velocities of the
  /// step's end there, and what presses touches.
  enum class Order { first, second };

  /// `file` must outlive it.
  explicit MotionRun(const SceneFile& file, Order order = Order::first);
  MotionRun(const MotionRun&) = delete; // the views inside would point into the other one
  MotionRun& operator=(const MotionRun&) = delete;

  /// Of the steps to come; what presses goes on to end on its faces.
  void set_order(Order order) { order_ = order; }
  bool speeds_up() const {
    for (Index b = 0; b < scene_.bodies.size; ++b)
      if (speeds_up(b)) return true;
    return false;
  }

  [[nodiscard]] Status start() { return stepper_.start(); }

  /// To be called where strokes may begin: their bodies touch what they meet there.
  void begin_strokes() { faces_.begin_strokes(stepper_.time(), stepper_.pose().rotation); }

  void widen_faces(double by) { faces_.widen(by); }

  /// One step of h seconds that ends within the same strokes as it begins. Where round friction
  /// does not settle, pyramids have the answer; after some such steps, they have all others too.
  [[nodiscard]] Status advance(double h);
  Index by_pyramids() const { return by_pyramids_; }
  /// As if round friction had not settled in more than so many solves: the others were tries.
  void forget_tries(Index by_pyramids);
  /// Of the steps to come: may pyramids answer instead? Else such a step says why it does not.
  void allow_pyramids(bool allowed) { allows_pyramids_ = allowed; }

  /// All that a step changes.
  struct Saved {
    std::vector<unsigned char> arrays;
    Stepper::Moment moment;
  };
  Saved save() const;
  void restore(const Saved& saved);

  /// Where all is at the end of a step, and how fast.
  struct State {
    Stepper::Moment moment;
    std::vector<Pose<double>> bodies;
    std::vector<double> closings, speeds; ///< of the actuators
  };
  State state() const;
  /// The two steps just made are halves of one that ended in `whole`: goes where they lead without
  /// their error of first order. False, and all stays as it is: a point that touches would be off
  /// its face by more than `slack`.
  [[nodiscard]] bool extrapolate(const State& whole, double slack);
  void return_to(const State& state);

  /// The object is there, then, at this speed; the bodies stay where they are.
  void begin_at(double time, const Pose<double>& pose, const Vector6<double>& twist) {
    stepper_.return_to({pose, twist, time, stepper_.moment().knows_last});
  }

  /// An actuator has closed so far, and does so at this speed.
  void close(Index actuator, double closing, double speed) {
    memory_.closings[actuator] = closing;
    memory_.speeds[actuator] = speed;
  }
  /// A body is there.
  void put(Index body, const Pose<double>& pose) { memory_.poses[body] = pose; }

  const Stepper& stepper() const { return stepper_; }
  const Scene<double>& scene() const { return scene_; }
  bool is_absent(Index body) const { return faces_.is_absent(body); }
  /// What prescribes a body's motion at `time`, a twist at the object's first centre of mass.
  Vector6<double> prescribed(Index body, double time) const {
    return faces_.prescribed(body, time);
  }
  /// What each point did in the step just made.
  std::vector<Touch> touches() const;
  /// Has the step just made taken a point that touched beside its face?
  bool leaves() const;
  /// The end of the step just made; or the start.
  MotionFrame frame(double h) const;
  /// Of the step just made, in words of the instant: its twist where an acceleration stands.
  Motion<double> describe(double length) const;
  /// The body, of those whose strokes begin at the present time, that stands deeper than `slack`
  /// in its face; < 0: none.
  Index inside(double slack) const;

private:
  [[nodiscard]] Status advance_by_pyramids(double h, const Saved& before);
  Scene<double> scene_of(const SceneFile& file) const;
  bool rolls() const;
  bool speeds_up(Index body) const {
    return !file_.strokes[static_cast<std::size_t>(body)].is_velocity &&
           !scene_.bodies[body].acceleration.isZero(0);
  }
  PlacedPoint<double> placed(Index body, Index point, double slack) const {
    return place(around_, faces_.touching(body), scene_.bodies[body], scene_.points[point],
                 stepper_.pose(), stepper_.pose_of(body), slack);
  }

  const SceneFile& file_;
  Order order_;
  StrokeFaces faces_;
  std::vector<LinearizedCone<double>> cones_; ///< of round friction
  Scene<double> scene_;
  Surroundings<double> around_;
  std::vector<unsigned char> bytes_;
  std::size_t kept_;            ///< of the bytes, those that a step leaves to the next
  MotionMemory<double> memory_; ///< over the bytes
  bool allows_pyramids_ = true;
  Index by_pyramids_ = 0; ///< solves of round friction that did not settle
  Vector3<double> began_ = Vector3<double>::Zero(); ///< m, the centre when the last step began
  Stepper stepper_;
};

} // namespace lcpush::desktop
