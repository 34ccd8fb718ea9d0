// Many scenes that differ in a number or two, built once where that number only stands somewhere.
// A sweep of 1,000 points takes a quarter to a third longer under `rigid`, and a sixth under `pad`,
// where every scene is built from the file's tables instead (straight_slide.toml over *.friction).
#pragma once

#include "lcpush/desktop/varied_scene.hpp"

#include <vector>

namespace lcpush::desktop {

class SceneSeries {
public:
  /// `scene` outlives the series.
  SceneSeries(const VariedScene& scene, const std::vector<Parameter>& parameters, double from,
              double to);

  /// As VariedScene::at, with the same bits.
  SceneFile at(const std::vector<double>& values) const;

private:
  /// A number of the scene that is `factor` times the parameter.
  struct Carrier {
    std::size_t number;
    double factor;
  };

  const VariedScene& scene_;
  std::vector<Parameter> parameters_;
  bool carries_ = false; ///< the parameter goes into the carriers and nowhere else
  SceneFile base_;
  std::vector<Carrier> carriers_;

  void find_carriers(double from, double to);
};

} // namespace lcpush::desktop
