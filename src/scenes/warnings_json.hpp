// The key `warnings` of every answer about a scene.
#pragma once

#include "formats/json_writer.hpp"
#include "lcpush/desktop/scene_check.hpp"

namespace lcpush::desktop {

inline void write_warnings(JsonWriter& json, const std::vector<SceneDoubt>& doubts) {
  json.objects("warnings", doubts, [&](const SceneDoubt& doubt) {
    json.member("code", doubt_code(doubt.doubt)).member("file", doubt.file);
    json.member("line", Index{doubt.line}).member("text", doubt.text);
  });
}

} // namespace lcpush::desktop
