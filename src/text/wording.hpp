// Wording shared by the messages about bad input.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lcpush::desktop {

/// `text` in double quotes, fit for one line of a terminal: control characters become \xNN and a
/// long text is cut.
std::string quoted(std::string_view text);

/// The shortest decimal number that reads back as `number`.
std::string shown(double number);

/// ` (did you mean "friction"?)` for the nearest of `known`, or for one that has `word` in it;
/// nothing if there is none. Capitals and dashes in front do not count.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

/// The parts of `text` between `separator`s: one more than there are separators.
std::vector<std::string_view> split_at(std::string_view text, char separator);

/// Without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// With the separator between them.
std::string joined(const std::vector<std::string>& words, const std::string& separator);

/// `a, b and c`.
std::string listed(const std::vector<std::string>& words, const std::string& conjunction);

} // namespace lcpush::desktop
