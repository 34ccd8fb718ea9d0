#include "formats/json_writer.hpp"
#include "lcpush/desktop/hold.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "scenes/warnings_json.hpp"

#include <cmath>
#include <optional>
#include <set>

namespace lcpush::desktop {
namespace {

std::vector<std::string> first_names(const SceneFile& file, const GiveWay& gives) {
  std::set<Index> first;
  for (const auto* bodies : {&gives.slips, &gives.opens, &gives.yields})
    first.insert(bodies->begin(), bodies->end());
  std::vector<std::string> names;
  for (const Index b : first) names.push_back(file.body_name(b));
  return names;
}

/// What is not finite is written as null; `unlimited` says which null is no question.
void write_limit(JsonWriter& json, const SceneFile& file, const HoldLimit& limit) {
  json.member("direction", limit.what.direction)
      .member("limit", limit.limit)
      .member("statics_limit", limit.statics)
      .member("unlimited", std::isinf(limit.limit))
      .member("lower", limit.lower)
      .member("upper", limit.upper)
      .member("first", first_names(file, limit.gives));
}

} // namespace

std::string hold_json(const SceneFile& file, const HoldStudy& study, const BoxAnswer* box) {
  JsonWriter json;
  json.begin_object().member("held", study.held);
  json.key("least_grip")
      .begin_object()
      .member("force", study.grip.force > 0 ? study.factor * study.grip.force : unknown_number)
      .member("factor", study.factor)
      .member("statics_factor", study.statics_factor)
      .member("most_factor", study.most)
      .member("of", unless_empty(study.grip.of))
      .end_object();
  json.member(box != nullptr ? "grip_margin" : "margin", study.margin());
  json.objects("disturbances", study.limits, [&](const HoldLimit& limit) {
    json.member("kind", disturbance_texts[static_cast<int>(limit.what.kind)])
        .member("at", study.at);
    write_limit(json, file, limit);
  });
  json.key("weakest").begin_object();
  for (const HoldLimit& limit : study.weakest) {
    json.key(disturbance_texts[static_cast<int>(limit.what.kind)]).begin_object();
    write_limit(json, file, limit);
    json.end_object();
  }
  json.end_object().member("added_mass", study.added_mass).member("tilt", study.tilt);
  std::optional<Vector6<double>> other;
  if (study.other) other = study.other->acceleration;
  json.member("law", study.is_statics ? "statics" : "pad")
      .member("may_bear_more", study.may_bear_more)
      .member("other_acceleration", other)
      .member("answer", hold_answer(file, study));
  if (box != nullptr) write_box(json, *box);
  write_warnings(json, check_scene(file));
  return json.end_object().text();
}

} // namespace lcpush::desktop
