#include "lcpush/host/scene_io.hpp"

#include "lcpush/host/text_file.hpp"
#include "lcpush/host/toml.hpp"
#include "scene_builder.hpp"

namespace lcpush::host {
namespace {

constexpr std::size_t most_scene_bytes = std::size_t{64} << 20U;

template <class T> Span<const T> span_of(const std::vector<T>& list) {
  return {list.data(), static_cast<Index>(list.size())};
}

} // namespace

Scene<double> SceneFile::view() const {
  return {object,         gravity,         facets,          pressure,
          planar,         span_of(bodies), span_of(points), span_of(actuators),
          span_of(drives)};
}

SceneFile parse_scene(std::string_view text, const std::string& file_name) {
  const TomlDocument document = parse_toml(text, file_name);
  return SceneBuilder(document).build();
}

SceneFile read_scene(const std::string& path) {
  return parse_scene(read_text_file(path, most_scene_bytes), path);
}

} // namespace lcpush::host
