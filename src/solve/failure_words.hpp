// What several reports share: how a failure reads.
#pragma once

#include <string>
#include <vector>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// "NOT SOLVED (ray): .." with the jam in words and the ray.
std::string failure_text(const SceneFile& file, const RunReport& report);
/// The keys reason, ray and, of a ray, jam.
void write_failure(JsonWriter& json, const SceneFile& file, const RunReport& report);
/// The title and an empty line, or nothing.
std::string title_line(const SceneFile& file);

} // namespace lcpush::desktop
