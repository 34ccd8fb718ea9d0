// Contacts that a scene file puts on a face of its object: on = "+z".
#pragma once

#include "formats/toml.hpp"

#include <optional>

namespace lcpush::desktop {

/// Of the numbers of a `center` beside `on`: the axis that number `i` of two lies along; nothing
/// if the table has no usable `on`.
std::optional<int> axis_in_face(const TomlTable& table, std::size_t i);

bool has_contacts_on_faces(const TomlDocument& document);
/// Is every body's place given so?
bool are_all_on_faces(const TomlDocument& document);

/// The same scene, with a normal and a center of three numbers for every `on`, exactly. Throws
/// InputError. Pre: check_sections().
TomlDocument with_typed_places(TomlDocument document);

} // namespace lcpush::desktop
