// Which pusher can push along an arc without slipping, and what that takes.
#pragma once

#include "cone/pusher_cone.hpp"
#include "plan/planar_motion.hpp"

#include <optional>

namespace lcpush::desktop {

/// What a sticking push takes, the most along its way (see PlannedPush).
struct PushNeeds {
  double friction = 0, reach = 0, grip = 0;
};

class Pushing {
public:
  /// `file` has its pushers where they touch the object; `corners`: the same scene with other
  /// numbers, with which a push has to stick as well. Throws InputError as find_cone does.
  explicit Pushing(const SceneFile& file, const std::vector<SceneFile>& corners = {});

  std::size_t pushers() const { return pushers_.size(); }
  Index body(std::size_t pusher) const { return pushers_[pusher].body; }
  const Vector3<double>& normal(std::size_t pusher) const {
    return file_.body(pushers_[pusher].body).normal;
  }
  double length() const { return length_; }

  /// Does the grip hold the object there, with a part of every patch on it?
  bool holds(const PlanarPose& pose) const;
  /// Does every finger point press on the object there?
  bool touches_whole(const PlanarPose& pose) const;
  /// The pushers that stick from end to end, with some room: bit k for pusher k.
  unsigned sticking(const Arc& arc) const;
  /// A twist between those of the pusher's cone there, mixed in these shares, over a way in m
  /// (see `way`); backwards if it is negative. Pre: as many shares as `edges`.
  Arc mixed(std::size_t pusher, const PlanarPose& pose, const std::vector<double>& shares,
            double way) const;
  std::size_t edges(std::size_t pusher) const { return pushers_[pusher].cone.edges.size(); }
  /// m: the way of the centre of mass, and of the turn at the object's size.
  double way(const Arc& arc) const {
    return arc.velocity(0).norm() + length_ * std::abs(arc.turn());
  }
  PushNeeds needs(std::size_t pusher, const Arc& arc) const;

private:
  struct Pusher {
    Index body;
    PusherCone cone; ///< in the object's own axes
    double middle;   ///< m, of its points along cone.along
    double standoff; ///< m, of its points along the normal
    double share;    ///< of its friction that a pyramid lets act in the plane
  };
  const SceneFile& file_;
  double length_;
  GripPoints grip_;
  std::vector<Planar> face_; ///< corners of the object's face under the fingers, convex
  std::vector<Pusher> pushers_;
  /// What else may press, pull and push.
  struct Corner {
    GripPoints grip;
    Vector3<double> load;
    std::vector<PusherCone> cones; ///< of the pushers
  };
  Vector3<double> load_;
  std::vector<Corner> corners_;

  std::vector<bool> touching(const PlanarPose& pose) const;
  /// The pusher's wrench in the object's axes, if the object is to move so.
  std::optional<Vector3<double>> wrench(const PlanarPose& pose, const Planar& velocity,
                                        double turn) const {
    return wrench(grip_, load_, pose, velocity, turn);
  }
  std::optional<Vector3<double>> wrench(const GripPoints& points, const Vector3<double>& load,
                                        const PlanarPose& pose, const Planar& velocity,
                                        double turn) const;
  bool sticks_at_corners(std::size_t pusher, const PlanarPose& pose, const Planar& velocity,
                         double turn) const;
  bool presses(const Pusher& pusher, const PlanarPose& pose, const Planar& velocity,
               double turn) const;
};

} // namespace lcpush::desktop
