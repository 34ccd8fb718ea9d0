// The object, what touches it and where it goes, seen along any direction: the figures that
// reports and the playground put together.
#pragma once

#include "draw/view.hpp"
#include "lcpush/desktop/push.hpp"
#include "lcpush/mechanics/model/pose.hpp"
#include "scenes/drawn_object.hpp"

namespace lcpush::desktop {

/// From where a grasp is seen, and where it stands on the picture.
struct Sight {
  View view;
  double meters = 1;           ///< pixels a metre
  Pixel shift = Pixel::Zero(); ///< where the scene's origin stands

  Pixel place(const Vector3<double>& at) const { return shift + meters * view.flat(at); }
};

/// Elements, and what encloses them.
struct Figure {
  std::vector<Pixel> outline;
  std::string elements;
};

/// The middle of a body's points.
Vector3<double> middle_of(const std::vector<Vector3<double>>& positions, const Body<double>& body);

class GraspFigures {
public:
  /// Lengths in pixels.
  struct Sizes {
    double finger;      ///< how far a finger's rod reaches
    double ghost;       ///< how far the ghost's fastest corner goes
    double least_ghost; ///< a ghost that differs by less is not drawn
  };

  /// Precondition: both outlive the figures.
  GraspFigures(const SceneFile& file, const Sight& sight, const Sizes& sizes);

  /// `pose`: of the object or of the body, about the centre of mass, from where the scene has it.
  Figure object(const Pose<double>& pose = {}) const;
  /// A finger's rod, a plate, or the table that carries the object.
  Figure body(Index b, const std::string& kind, const Pose<double>& pose = {}) const;
  /// Does it stay when a finger is meant to follow, and does the object lie on it?
  bool is_table(Index b) const;
  /// Is it drawn as a rod? Otherwise as a plate.
  bool is_rod(Index b) const;

  /// The object a moment later, dashed; empty where that looks as now. Precondition: it is solved.
  Figure ghost(const PushReport& report) const;

  /// Where contact points are drawn.
  const std::vector<Vector3<double>>& positions() const { return positions_; }
  const Prism& prism() const { return object_; }

private:
  const SceneFile& file_;
  const Scene<double> scene_;
  const Sight& sight_;
  const Sizes sizes_;
  const std::vector<Vector3<double>> positions_;
  const Prism object_;

  PrismPicture seen(const Prism& prism) const;
  Figure figure_of(const Prism& prism, const std::string& kind) const;
  Prism moved(const Prism& prism, const Pose<double>& pose) const;
  Figure rod(const Body<double>& body, const std::string& kind, const Pose<double>& pose) const;
  Prism plate(Index b) const;
  bool is_driven(Index b) const;
};

/// x, y and z from `origin`, with their names; what points at the viewer is left out.
std::string axes_in_space(const View& view, const Pixel& origin, double length);

} // namespace lcpush::desktop
