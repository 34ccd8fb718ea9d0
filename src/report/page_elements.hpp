// The few elements of HTML that pages are made of.
#pragma once

#include <string>
#include <vector>

#include "draw/markup.hpp"
#include "solve/push_words.hpp"

namespace lcpush::desktop {

std::string paragraph(const std::string& text, const std::string& kind = "");
/// Escaped; lines stay lines.
std::string with_breaks(const std::string& text);
std::string facts_html(const std::vector<Fact>& facts);
/// A list, or nothing.
std::string list_html(const std::vector<std::string>& sentences);
std::string paragraphs_html(const std::vector<std::string>& sentences);
/// A box that scrolls by itself, also by the keyboard.
std::string scrolling(const std::string& label, const std::string& inside);
/// The first row holds the heads of the columns, the first column those of the rows; cells are
/// HTML.
std::string table_html(const std::string& caption,
                       const std::vector<std::vector<std::string>>& rows);
/// A plot that stands in its document's own style, which would reach the whole page otherwise.
/// `words`: for those who do not see it.
std::string plot_image(const std::string& svg, const std::string& words);
std::string figure(const Drawing& drawing, const std::string& caption);

} // namespace lcpush::desktop
