// Scene files that the tool carries with it, embedded by src/cmake/embed_text.cmake.
#pragma once

#include <string>
#include <vector>

namespace lcpush::desktop {

struct ShippedScene {
  std::string name; ///< of the file, without .toml
  std::string text;
};

/// fixtures/scenes/, by name.
std::vector<ShippedScene> example_scenes();

/// The text of the scene called `name`, or nullptr.
inline const std::string* scene_called(const std::vector<ShippedScene>& scenes,
                                       const std::string& name) {
  for (const ShippedScene& scene : scenes)
    if (scene.name == name) return &scene.text;
  return nullptr;
}

} // namespace lcpush::desktop
