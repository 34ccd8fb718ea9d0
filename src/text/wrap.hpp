// Lines that fit.
#pragma once

#include <string>
#include <string_view>

namespace lcpush::desktop {

constexpr std::size_t usual_width = 80;

/// What a text takes on a line: its letters, not their bytes.
std::size_t text_columns(std::string_view text);

/// Breaks lines of more than `width` columns at blanks. What follows a label (two blanks or more
/// after it, not at the line's end) goes on below itself, everything else below its line's first
/// word. Rows of a table, with several such gaps, and words longer than a line stay as they are.
std::string wrapped(const std::string& text, std::size_t width = usual_width);

/// Paragraphs as one line each; lines that start with a blank, and empty ones, stay.
std::string reflowed(const std::string& text);

} // namespace lcpush::desktop
