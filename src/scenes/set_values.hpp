// Values of a scene that are given beside its file: --set PATH=VALUE.
#pragma once

#include <string>
#include <vector>

namespace lcpush::desktop {

/// The scene's text with these values in it, "wall.friction=0.4", one after the other; its title
/// says so. Other lines stay where they are, if there is a blank line below a table that gets a new
/// key. Throws InputError, which begins with `label` and the words that were given.
std::string with_values(std::string text, const std::string& file, const std::string& label,
                        const std::vector<std::string>& given);

} // namespace lcpush::desktop
