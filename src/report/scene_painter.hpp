// One view of a grasp, layer by layer.
#pragma once

#include "draw/arrow_places.hpp"
#include "draw/label_places.hpp"
#include "picture/grasp_figures.hpp"
#include "report/pictures.hpp"

namespace lcpush::desktop {

/// Scales that the views of a scene share.
struct PictureScales {
  double meters = 1;         ///< pixels per metre
  double newtons = 1;        ///< pixels per newton
  double accelerations = 1;  ///< pixels per m/s^2
  double no_force = 0;       ///< N, what counts as none
  double still = 0;          ///< m/s^2, the same
  bool shows_forces = false; ///< there is an answer
};

/// Those of forces and motions; `meters` is left at 1.
PictureScales picture_scales(const SceneFile& file, const PushReport& report);

/// Of a point: what its body is told and what its actuators add; without an answer the former.
Vector3<double> point_acceleration(const Scene<double>& scene, const Body<double>& body,
                                   Index point, const PushReport& report);
/// Of the middle of its points.
Vector3<double> body_acceleration(const Scene<double>& scene, const Body<double>& body,
                                  const PushReport& report);
/// "slips"; "3 slip and 1 sticks".
std::string modes_of(const Body<double>& body, const PushReport& report);

class ScenePainter {
public:
  static constexpr double width = 420, margin = 108, margin_above = 140;

  ScenePainter(const SceneFile& file, const PushReport& report, const View& view,
               const PictureScales& scales);
  Drawing draw();

  /// What a view has to show, in metres of the drawing: left, top, right, bottom.
  static Frame extent(const SceneFile& file, const PushReport& report, const View& view);

private:
  const SceneFile& file_;
  const Scene<double> scene_;
  const PushReport& report_;
  const View& view_;
  const PictureScales scales_;
  const std::vector<Vector3<double>> positions_; // as drawn
  Frame extent_;
  double height_;
  LabelPlaces places_;
  ArrowPlaces arrows_;
  std::vector<Label> labels_;
  std::vector<std::string> words_; // the description's sentences

  Pixel place(const Vector3<double>& position) const;

  std::string outline();
  std::string pad(const Body<double>& body);
  std::string forces(const Body<double>& body, Index point);
  std::string marks(const Body<double>& body);
  std::string weight();
  std::string squeezes();
  std::string object_motion();
  std::string turning_axis();
  std::string away_mark(const Pixel& center, const std::string& name, const std::string& pitch);
  std::string body_motion(Index b);
  std::vector<std::string> body_words(Index b) const;
  std::string scale_bars(double bottom);
};

} // namespace lcpush::desktop
