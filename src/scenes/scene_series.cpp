#include "scenes/scene_series.hpp"

#include <utility>

namespace lcpush::desktop {
namespace {

void add(std::vector<double*>& list, double& number) { list.push_back(&number); }
template <class Vector> void add_all(std::vector<double*>& list, Vector& vector) {
  for (Index i = 0; i < vector.size(); ++i) list.push_back(vector.data() + i);
}

/// Every number that is computed with, in a fixed order.
std::vector<double*> numbers_of(SceneFile& file) {
  std::vector<double*> list;
  add(list, file.object.mass);
  add_all(list, file.object.inertia);
  add_all(list, file.object.center_of_mass);
  add_all(list, file.gravity);
  for (Body<double>& body : file.bodies) {
    add_all(list, body.normal);
    add_all(list, body.tangent);
    add_all(list, body.acceleration);
    add(list, body.friction);
    add(list, body.torsion_radius);
  }
  for (Vector3<double>& point : file.points) add_all(list, point);
  for (Vector3<double>& position : file.positions) add_all(list, position);
  for (Actuator<double>& actuator : file.actuators) {
    add(list, actuator.force);
    add(list, actuator.inertia);
  }
  for (Drive<double>& drive : file.drives) add_all(list, drive.twist);
  return list;
}

} // namespace

SceneSeries::SceneSeries(const VariedScene& scene, const std::vector<Parameter>& parameters,
                         double from, double to)
    : scene_(scene), parameters_(parameters) {
  if (parameters.size() == 1 && !parameters[0].whole &&
      parameters[0].kind == Parameter::Kind::number)
    find_carriers(from, to);
}

/// What the builder refuses of a number that it only copies lies outside an interval: with both
/// ends of the range, everything in between is a scene. Throws InputError if an end is none.
void SceneSeries::find_carriers(double from, double to) {
  const double values[] = {from, to, from + 0.37 * (to - from)};
  SceneFile files[] = {scene_.at(parameters_, {values[0]}), scene_.at(parameters_, {values[1]}),
                       scene_.at(parameters_, {values[2]})};
  std::vector<double*> numbers[3];
  for (int k = 0; k < 3; ++k) numbers[k] = numbers_of(files[k]);
  if (numbers[0].size() != numbers[1].size() || numbers[0].size() != numbers[2].size()) return;
  for (std::size_t i = 0; i < numbers[0].size(); ++i) {
    const double a = *numbers[0][i], b = *numbers[1][i], c = *numbers[2][i];
    if (a == b && a == c) continue;
    double factor = 0;
    for (const double candidate : {1.0, 2.0}) // 2: the jaw's one actuator for both fingers
      if (a == candidate * values[0] && b == candidate * values[1] && c == candidate * values[2])
        factor = candidate;
    if (factor == 0) return;
    carriers_.push_back({i, factor});
  }
  carries_ = true;
  base_ = std::move(files[0]);
}

SceneFile SceneSeries::at(const std::vector<double>& values) const {
  if (!carries_) return scene_.at(parameters_, values);
  SceneFile file = base_;
  const std::vector<double*> numbers = numbers_of(file);
  for (const Carrier& carrier : carriers_) *numbers[carrier.number] = carrier.factor * values[0];
  return file;
}

} // namespace lcpush::desktop
