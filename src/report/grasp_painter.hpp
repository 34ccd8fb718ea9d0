// A grasp and what a push does to it, seen along an axis or as things in space: layer by layer, and
// labels that keep clear of them.
#pragma once

#include "draw/arrow_places.hpp"
#include "draw/label_places.hpp"
#include "report/pictures.hpp"

namespace lcpush::desktop {

/// Scales that the views of a scene share.
struct PictureScales {
  double newtons = 1;        ///< pixels per newton
  double accelerations = 1;  ///< pixels per m/s^2
  double no_force = 0;       ///< N, what counts as none
  double still = 0;          ///< m/s^2, the same
  bool shows_forces = false; ///< there is an answer
};
PictureScales picture_scales(const DrawnScene& drawn, const PushReport& report);

class GraspPainter {
protected:
  /// Of arrows, in pixels: their longest head, the least length that can be told from a dot, and
  /// how heavily they keep labels away.
  struct ArrowLook {
    double head, least, weight;
  };

  GraspPainter(const DrawnScene& drawn, const PushReport& report, const PictureScales& scales,
               const Sight& sight, const Pixel& size, const ArrowLook& look)
      : drawn_(drawn), report_(report), scales_(scales), sight_(sight), size_(size), look_(look),
        places_(size.x(), size.y()) {}

  const DrawnScene& drawn_;
  const SceneFile& file_ = drawn_.file;
  const Scene<double>& scene_ = drawn_.scene;
  const PushReport& report_;
  PictureScales scales_;
  const Sight sight_;
  const View& view_ = sight_.view;
  const Pixel size_;
  const ArrowLook look_;
  LabelPlaces places_;
  ArrowPlaces arrows_;
  std::vector<Label> labels_;
  std::vector<std::string> words_; // the description's sentences

  Pixel place(const Vector3<double>& at) const { return sight_.place(at); }
  Pixel center() const { return place(drawn_.center()); }
  Pixel contact(const Body<double>& body) const { return place(drawn_.middle(body)); }

  std::string arrow(const std::string& kind, const Pixel& from, const Pixel& to);
  std::string weight();
  /// Without an answer: an arrow of no particular length for a body of a jam.
  std::string squeeze(Index b, const std::string& kind);
  bool squeezes(Index b) const;

  Vector3<double> friction_of(const Body<double>& body) const;
  /// Of the middle of its points.
  Vector3<double> acceleration_of(const Body<double>& body) const;
  /// The lines beside a body, and in the description.
  void label_body(const std::vector<std::string>& lines, const Pixel& at, const Pixel& away,
                  const Pixel& target);

  /// As high as what is drawn and its labels, which are its elements; nothing else stands in the
  /// corner at its top left.
  Drawing labelled(const Pixel& corner, double below, const std::string& description) const;
};

/// Along an axis.
class ScenePainter : GraspPainter {
public:
  static constexpr double width = 420, margin = 108, margin_above = 140;

  ScenePainter(const DrawnScene& drawn, const PushReport& report, const View& view, double meters,
               const PictureScales& scales);
  Drawing draw();

  /// What a view has to show, in metres of the drawing: left, top, right, bottom.
  static Frame extent(const DrawnScene& drawn, const PushReport& report, const View& view);

private:
  std::string outline();
  std::string pad(const Body<double>& body);
  std::string forces(const Body<double>& body, Index point);
  std::string marks(const Body<double>& body);
  std::string object_motion();
  std::string turning_axis();
  std::string away_mark(const Pixel& center, const std::string& name, const std::string& pitch);
  std::string body_motion(Index b);
  std::vector<std::string> body_words(Index b) const;
};

/// Bodies as fingers, plates and tables, what each does to the object, and where the object goes.
class IsometricPainter : GraspPainter {
public:
  IsometricPainter(const DrawnScene& drawn, const PushReport& report);
  Drawing draw();

private:
  const GraspFigures figures_;

  std::string kept_clear(const Figure& figure);
  std::string forces(Index b);
  std::string turning();
  std::string object_motion();
  std::string body_motion(Index b);
  void label(Index b);
  std::vector<std::string> body_words(Index b) const;
};

} // namespace lcpush::desktop
