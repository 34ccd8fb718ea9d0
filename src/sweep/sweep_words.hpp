// The sentences and tables that a sweep's text consists of.
#pragma once

#include "sweep/sweep_events.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// A value of the parameter: three digits of where it lies in the range.
std::string value_text(const Variation& variation, double value);
/// "6.52 N".
std::string with_unit(const Variation& variation, double value);

/// The one axis about which the push turns the object all along, 0 to 2; nothing if it turns about
/// several, or not at all.
std::optional<Index> axis_of_turn(const Sweep& sweep);

/// Too near to be told apart.
bool are_one_place(const Variation& variation, double a, double b);
/// "6.54 N (as prescribed at 6.52 N)".
std::string event_place(const Variation& variation, const SweepEvent& event);

/// What a sweep is about: the force that breaks the grasp, or the push as prescribed where nothing
/// breaks.
Question asked(const Sweep& sweep);
/// Of breaking the normal force, of the push its size.
double force_of(const SweepValue& value, Question question);

/// As a brief text shows it: zero if it is no ten-thousandth of the largest, or less than a
/// thousandth below zero, which is how far off breaking is that small pushes are extrapolated to.
double told_force(double force, double largest);

/// How the force changes, where the grasp does not hold and where there is no answer: a line each.
std::string message_text(const Sweep& sweep);
/// "Between 8.36 and 8.61 N there are two answers: ..", or nothing of a range that is not worth a
/// word in a brief text.
std::string bistable_text(const Sweep& sweep, const BistableRange& range, Telling telling);

/// At most so many of n indices, evenly chosen, ends included.
std::vector<std::size_t> evenly(std::size_t n, std::size_t most);

/// Some of the values, in three digits and at most 80 columns; `left_out` says how many are not
/// there.
std::string brief_table(const Sweep& sweep, std::size_t& left_out);
/// The force of several curves side by side.
std::string curves_table(const std::vector<SweepCurve>& curves);
/// A map's force over both parameters.
std::string map_table(const Sweep& sweep, std::size_t& left_out);
/// Everything, in as many digits as fit into 80 columns, six at most.
std::string segment_table(const Sweep& sweep, const std::vector<SweepSegment>& segments);
std::string point_table(const Sweep& sweep, const std::vector<SweepPoint>& points);

} // namespace lcpush::desktop
