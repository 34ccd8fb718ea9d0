// The object, what touches it and where it goes, seen along any direction: the figures that
// reports and the playground put together.
#pragma once

#include "draw/view.hpp"
#include "lcpush/desktop/push.hpp"
#include "lcpush/mechanics/model/pose.hpp"
#include "scenes/drawn_object.hpp"

namespace lcpush::desktop {

/// A scene with what every picture of it draws, made once. Precondition: the file outlives it.
struct DrawnScene {
  const SceneFile& file;
  Scene<double> scene;
  Prism object;                           ///< its box where the scene gives an inertia alone
  std::vector<Vector3<double>> positions; ///< where contact points are drawn

  explicit DrawnScene(const SceneFile& scene_file)
      : file(scene_file), scene(file.view()), object(object_prism(file)),
        positions(drawn_positions(file)) {}

  const Vector3<double>& center() const { return file.object.center_of_mass; }
  const Vector3<double>& position(Index point) const {
    return positions[static_cast<std::size_t>(point)];
  }
  /// The middle of a body's points.
  Vector3<double> middle(const Body<double>& body) const;
  /// Half of the largest extent of all that is there, about the centre of mass [m].
  double reach() const;
};

/// Does the object turn about an axis?
inline bool turns(const Motion<double>& motion) {
  return motion.kind != MotionKind::rest && motion.kind != MotionKind::slide;
}

/// Elements, and what encloses them.
struct Figure {
  std::vector<Pixel> outline;
  std::string elements;
};

class GraspFigures {
public:
  /// Lengths in pixels.
  struct Sizes {
    double finger;      ///< how far a finger reaches
    double ghost;       ///< how far the ghost's fastest corner goes
    double least_ghost; ///< a ghost that differs by less is not drawn
  };

  /// Precondition: both outlive the figures.
  GraspFigures(const DrawnScene& drawn, const Sight& sight, const Sizes& sizes)
      : drawn_(drawn), sight_(sight), sizes_(sizes) {}

  /// `pose`: of the object or of the body, about the centre of mass, from where the scene has it.
  Figure object(const Pose<double>& pose = {}) const;
  /// A finger or a pusher as wide as its patch, or the table that carries the object.
  Figure body(Index b, const std::string& kind, const Pose<double>& pose = {}) const;
  /// Does it stay when a finger is meant to follow, and does the object lie on it?
  bool is_table(Index b) const;

  /// The object a moment later, dashed; empty where that looks as now. Precondition: it is solved.
  Figure ghost(const PushReport& report) const;

private:
  const DrawnScene& drawn_;
  const Sight& sight_;
  const Sizes sizes_;

  PrismPicture seen(const Prism& prism) const;
  Figure figure_of(const Prism& prism, const std::string& kind) const;
  Prism moved(const Prism& prism, const Pose<double>& pose) const;
  Prism thing(Index b) const;
  bool is_driven(Index b) const;
};

/// x, y and z from `origin`, with their names; what points at the viewer is left out.
std::string axes_in_space(const View& view, const Pixel& origin, double length);

} // namespace lcpush::desktop
