// What frames of a motion show of its steps: where contacts touch, and how they slip. Geometry and
// differences alone; nothing is solved.
#pragma once

#include "lcpush/desktop/trajectory.hpp"
#include "move/stroke_faces.hpp"
#include "verify/settings.hpp"

#include <algorithm>

namespace lcpush::desktop {

/// The mean velocity between two poses, h seconds apart.
Vector6<double> mean_twist(const Pose<double>& from, const Pose<double>& to, double h);

/// A contact point in a step.
struct SeenContact {
  bool is_placed = false;                             ///< it is known where it touches, if it does
  bool touches = false;                               ///< it is over its face at an end of the step
  Vector3<double> position = Vector3<double>::Zero(); ///< at the begin, from the centre of mass
  Vector3<double> normal = Vector3<double>::UnitZ();  ///< then, unit, into the object
  std::optional<double> gap;                          ///< m, at the end; none: its body's place is
                                                      ///< not known
  std::optional<double> gap_before;    ///< m, at the begin, if it is over its face then and at the
                                       ///< end, as strictly as to the laws' own steps
  double missed = 0;                   ///< m, by which a straight step may miss a face that turns
  std::optional<Vector3<double>> slip; ///< m/s, of the object beside the body, at the end
  double spin = 0;                     ///< rad/s about the normal, where slip is known
  double unsure = 0; ///< m/s, by which slip is off, told at the step's end of a body that speeds up
};

/// The step that ends at a frame.
struct SeenStep {
  double time = 0, h = 0;
  bool is_whole = false; ///< it begins at the frame before
  Pose<double> begin;    ///< of the object
  Matrix3<double> begin_inertia, end_inertia;
  std::optional<Vector6<double>> before, twist; ///< of the object, at its begin and its end
  /// Actuators: how fast they close, at its begin and its end.
  std::vector<std::optional<double>> speeds_before, speeds;
  std::vector<SeenContact> contacts;
  double fastest = 0; ///< m/s, of contact points and bodies there
};

/// Places on the object that show every motion of it, about its centre of mass: the contact points,
/// and where these lie on one line, others beside it.
struct TellingPoints {
  std::vector<Vector3<double>> points;
  double size; ///< m, of the object

  explicit TellingPoints(const SceneFile& file);
  /// The one that this twist moves fastest, from the centre of mass; and its speed, m/s.
  Vector3<double> fastest_point(const Pose<double>& object, const Vector6<double>& twist) const;
  double fastest(const Pose<double>& object, const Vector6<double>& twist) const;
};

class SeenMotion {
public:
  using Closings = std::vector<std::optional<double>>;

  /// Both must outlive it.
  SeenMotion(const SceneFile& file, const std::vector<TrajectoryFrame>& frames);

  /// The one that ends at frame k >= 1. Pre: called with growing k, since strokes begin.
  SeenStep step(std::size_t k);
  const TellingPoints& telling() const { return telling_; }
  bool is_absent(Index body) const { return faces_.is_absent(body); }

  /// Of the actuators, at frame k; none: it does not say.
  std::vector<std::optional<double>> closings_at(std::size_t k) const {
    return of_actuators(k, &FrameBody::closing);
  }
  std::vector<std::optional<double>> speeds_at(std::size_t k) const;
  /// Where a driven body is at frame k; none: that is not known.
  std::optional<Pose<double>> driven_pose(Index body, std::size_t k) const;
  /// Where a body is at that time by its stroke alone.
  Pose<double> stroke_pose(Index body, double time) const {
    return pose_of(body, time, Closings(file_.actuators.size()));
  }

private:
  std::optional<Vector6<double>> twist_of(std::size_t k) const;
  bool is_whole(std::size_t k) const;
  Closings of_actuators(std::size_t k, std::optional<double> FrameBody::*number) const;
  Closings begin_closings(std::size_t k, const SeenStep& step) const;
  bool are_pads(Index body) const;
  bool is_found(Index body, const Closings& closings) const;
  bool turns(Index body) const;
  Pose<double> touching_pose(Index body, double time, Closings closings,
                             const Pose<double>& object) const;
  Pose<double> pose_of(Index body, double time, const Closings& closings) const;
  PlacedPoint<double> placed(Index body, Index point, const Pose<double>& object,
                             const Pose<double>& hand, double part = 1) const;
  std::optional<Vector6<double>> body_twist(Index body, const SeenContact& contact,
                                            const SeenStep& step) const;
  void see_body(Index b, std::size_t k, const Closings& begin, const Closings& end, SeenStep& step);
  void see_slip(Index b, SeenContact& contact, SeenStep& step) const;

  const SceneFile& file_;
  const std::vector<TrajectoryFrame>& frames_;
  StrokeFaces faces_;
  Surroundings<double> around_;
  TellingPoints telling_;
};

/// How much of `way`, that twice as many steps change, leads nearest to `to`; up to what ever more
/// of them change.
template <class Vector, class Other> double part_of(const Vector& way, const Other& to) {
  const double square = way.squaredNorm();
  return square > 0 ? std::clamp(way.dot(to) / square, 0.0, VerifySettings::limit) : 0;
}

/// Of all points over all steps, from the first frame on.
Overlap find_overlap(const SceneFile& file, const std::vector<TrajectoryFrame>& frames);

/// Does it begin as the scene does, with a velocity that the scene says?
inline bool starts_as_scene(const SceneFile& file, const TrajectoryFrame& first) {
  return first.time == 0 && !file.start.isZero(0);
}

/// At frame k, as given; or as of every implicit scheme the mean since the frame before.
Vector6<double> velocity_at(const std::vector<TrajectoryFrame>& given, std::size_t k);

} // namespace lcpush::desktop
