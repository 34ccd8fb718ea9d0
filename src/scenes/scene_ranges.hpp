// Ranges in scene files: `friction = [0.3, 0.5]` stands for every number in between.
#pragma once

#include "formats/toml.hpp"

#include <string>

namespace lcpush::desktop {

/// Where a list of two numbers stands in the place of one number, the number in their middle takes
/// it, with the two as its range. Throws InputError for one that goes backwards.
void read_ranges(TomlDocument& document);

/// What a scene with ranges is taken for by what asks no box: "friction = 0.4 (0.3 to 0.5), ..";
/// and the line of the first. Empty: there are none.
struct RangeNote {
  int line = 0;
  std::string text;
};
RangeNote range_note(const TomlDocument& document);

} // namespace lcpush::desktop
