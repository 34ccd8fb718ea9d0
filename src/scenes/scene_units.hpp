// Units in scene files: "120 g" stands for 0.12.
#pragma once

#include "formats/toml.hpp"

#include <string>
#include <string_view>

namespace lcpush::desktop {

/// The tables of a scene file, with every number in SI units: the decimal number that a text with a
/// unit stands for, as if it were typed; degrees as a fraction within 1e-38 of them; and the
/// middle of a range where one is given. Throws InputError, also for tables that no scene has.
TomlDocument parse_scene_tables(std::string_view text, const std::string& file_name);

} // namespace lcpush::desktop
