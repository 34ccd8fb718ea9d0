// Units in scene files: "120 g" stands for 0.12.
#pragma once

#include "formats/toml.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lcpush::desktop {

/// The tables of a scene file, with every number in SI units: the decimal number that a text with a
/// unit stands for, as if it were typed; degrees as a fraction within 1e-38 of them; and the
/// middle of a range where one is given. Throws InputError, also for tables that no scene has.
TomlDocument parse_scene_tables(std::string_view text, const std::string& file_name);

/// A number with its unit, in SI units: digits as Rational::parse reads them, of degrees a
/// fraction; or why it is no such number.
struct SiNumber {
  std::string digits, refusal;
  std::string unit = {}; ///< as typed; empty of a bare number
  double value() const;  ///< pre: not refused
};
/// What is typed outside of a file: "20 mm", or a bare number or fraction, in `unit`.
SiNumber typed_number(std::string_view word, const std::string& unit);
/// Two of them: of "-9:29 mm" both are lengths in mm.
std::pair<SiNumber, SiNumber> typed_ends(std::string_view from, std::string_view to,
                                         const std::string& unit);

} // namespace lcpush::desktop
