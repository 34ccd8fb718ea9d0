// --pusher: whose force is meant.
#pragma once

#include "cli/arguments.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {

/// The body of --pusher, or the only pusher.
inline Index chosen_pusher(const Arguments& arguments, const desktop::SceneFile& file) {
  std::vector<std::string> names;
  Index pusher = -1;
  const std::optional<std::string> wanted = arguments.value("--pusher");
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].role != Role::pusher) continue;
    names.push_back(file.body_names[b]);
    if (!wanted || *wanted == file.body_names[b]) pusher = static_cast<Index>(b);
  }
  if (names.empty()) throw UsageError("the scene has no [[pusher]]: nothing can break the grasp");
  if (!wanted && names.size() > 1)
    throw UsageError("the scene has several pushers: say which with --pusher " +
                     desktop::listed(names, "or"));
  if (pusher < 0)
    throw UsageError("no pusher is named " + desktop::quoted(*wanted) +
                     desktop::suggestion(*wanted, names));
  return pusher;
}

} // namespace lcpush::cli
