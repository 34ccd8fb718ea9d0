// What a scene file may contain besides [object] and the patches.
#pragma once

#include "formats/toml.hpp"
#include "lcpush/mechanics/model/scene.hpp"
#include "scenes/table_reader.hpp"

namespace lcpush::desktop {

const Schema& root_schema();
const Schema& gripper_schema();
const Schema& actuator_schema();
/// The keys of a [[finger]] or [[pusher]], its patch's among them.
const Schema& body_schema(Role role);

/// Refuses unknown sections, [name] for [[name]] and the reverse, a missing [object].
void check_sections(const TomlDocument& document);

} // namespace lcpush::desktop
