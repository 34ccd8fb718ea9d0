// The isometric view: bodies as fingers, plates and tables, what each does to the object, and where
// the object goes.
#pragma once

#include "report/scene_painter.hpp"

namespace lcpush::desktop {

class IsometricPainter {
public:
  static constexpr double width = 420, height = 340, finger_length = 62; ///< pixels

  IsometricPainter(const SceneFile& file, const PushReport& report);
  Drawing draw();

private:
  const SceneFile& file_;
  const Scene<double> scene_;
  const PushReport& report_;
  const Sight sight_;
  const View& view_ = sight_.view;
  const GraspFigures figures_;
  const std::vector<Vector3<double>>& positions_ = figures_.positions();
  PictureScales scales_;
  LabelPlaces places_;
  ArrowPlaces arrows_;
  std::vector<Label> labels_;
  std::vector<std::string> words_; // the description's sentences

  Pixel place(const Vector3<double>& at) const { return sight_.place(at); }
  Vector3<double> friction_of(const Body<double>& body) const {
    Vector3<double> sum = Vector3<double>::Zero();
    for (const Index i : points_of(body)) sum += report_.answer.contacts[i].friction_force;
    return sum;
  }

  std::string kept_clear(const Figure& figure);
  std::string forces(Index b);
  std::string turning();
  std::string object_motion();
  std::string weight();
  void label_body(Index b);
  std::string body_motion(Index b);
  std::string arrow(const std::string& kind, const Pixel& from, const Pixel& to);
  std::vector<std::string> body_words(Index b) const;
};

} // namespace lcpush::desktop
