// What a sweep changes in the tables of a scene that the builder has accepted.
#pragma once

#include "formats/toml.hpp"
#include "lcpush/desktop/rational.hpp"

namespace lcpush::desktop {

void set_number(TomlValue& value, double number);
void set_number(TomlValue& value, const Rational& number);
/// As set_number; a whole number is kept as one.
void set_count(TomlValue& value, double number);

/// Whole numbers that count something: `facets`, and `points` unless it lists them.
bool is_count(const TomlEntry& entry);

/// The velocity, or the acceleration, turns in the x-y plane.
void turn_motion(TomlTable& table, double degrees);

/// The tangent turns about the normal, and with it every friction generator.
void turn_tangent(TomlTable& table, double degrees);

} // namespace lcpush::desktop
