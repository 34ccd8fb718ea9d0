#include "lcpush/desktop/scene_io.hpp"

#include "scenes/scene_builder.hpp"
#include "scenes/scene_units.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::desktop {

template <class S> SceneOf<S>::SceneOf() = default;
template <class S> SceneOf<S>::SceneOf(const SceneOf&) = default;
template <class S> SceneOf<S>::SceneOf(SceneOf&&) noexcept = default;
template <class S> SceneOf<S>& SceneOf<S>::operator=(const SceneOf&) = default;
template <class S> SceneOf<S>& SceneOf<S>::operator=(SceneOf&&) noexcept = default;
template <class S> SceneOf<S>::~SceneOf() = default;
template struct SceneOf<double>;
template struct SceneOf<Rational>;

std::string read_scene_text(const std::string& path) {
  return read_text_file(path, limits::scene_bytes);
}

std::string scene_label(const std::string& path) { return file_label(path); }

template <class S>
SceneOf<S> parse_scene(std::string_view text, const std::string& file_name, Strokes strokes) {
  return build_scene<S>(parse_scene_tables(text, file_name), {}, strokes);
}
template SceneOf<double> parse_scene(std::string_view text, const std::string& file_name,
                                     Strokes strokes);
template SceneOf<Rational> parse_scene(std::string_view text, const std::string& file_name,
                                       Strokes strokes);

double object_size(const SceneFile& file) {
  double size = file.shape.size.norm();
  for (const Vector3<double>& p : file.points) size = std::max(size, 2 * p.norm());
  return size > 0 ? size : 1;
}

std::vector<std::string> irrational_directions(const SceneOf<Rational>& scene) {
  const std::string are_irrational = " are irrational: fractions within 1e-12 of them are used";
  std::vector<std::string> sentences;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (scene.bodies[b].friction > Rational(0) && scene.bodies[b].torsion_radius > Rational(0))
      sentences.push_back("the soft generators of " + quoted(scene.body_names[b]) + are_irrational);
  }
  if (scene.has_cones() && scene.facets != 4)
    sentences.insert(sentences.begin(), "the friction directions of " +
                                            std::to_string(scene.facets) + " facets" +
                                            are_irrational);
  return sentences;
}

} // namespace lcpush::desktop
