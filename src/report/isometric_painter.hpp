// The isometric view: bodies as fingers, plates and tables, what each does to the object, and where
// the object goes.
#pragma once

#include <algorithm>

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
  const View view_;
  const std::vector<Vector3<double>> positions_;
  const Prism object_;
  PictureScales scales_;
  Frame frame_{};
  LabelPlaces places_;
  ArrowPlaces arrows_;
  std::vector<Label> labels_;
  std::vector<std::string> words_; // the description's sentences

  Pixel place(const Vector3<double>& at) const {
    const Pixel middle((frame_.left + frame_.right) / 2, (frame_.top + frame_.bottom) / 2);
    return Pixel(width / 2, height / 2) + scales_.meters * (view_.flat(at) - middle);
  }
  Vector3<double> friction_of(const Body<double>& body) const {
    Vector3<double> sum = Vector3<double>::Zero();
    for (const Index i : points_of(body)) sum += report_.answer.contacts[i].friction_force;
    return sum;
  }
  bool is_driven(Index b) const {
    return std::any_of(scene_.drives.begin(), scene_.drives.end(),
                       [b](const Drive<double>& drive) { return drive.body == b; });
  }
  /// Does the object lie on it?
  bool is_table(Index b) const {
    const double weight = file_.gravity.norm();
    return !is_driven(b) && weight > 0 &&
           scene_.bodies[b].normal.dot(file_.gravity) < -0.9 * weight;
  }

  std::string prism_elements(const Prism& prism, const std::string& kind);
  std::string finger(const Body<double>& body, const std::string& kind);
  std::string plate(const Body<double>& body, double margin, bool carries_object,
                    const std::string& kind);
  std::string body_elements(Index b);
  std::string axes() const;
  std::string ghost();
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
