// The few elements of HTML that pages are made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/markup.hpp"
#include "draw/plot_svg.hpp"
#include "solve/push_words.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {

inline std::string paragraph(const std::string& text, const std::string& kind = "") {
  return "<p" + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + escaped(text) + "</p>\n";
}

/// Escaped; lines stay lines.
inline std::string with_breaks(const std::string& text) {
  std::vector<std::string> lines;
  for (const std::string_view line : split_at(text, '\n'))
    lines.push_back(escaped(std::string(line)));
  return joined(lines, "<br/>");
}

/// What stands there on demand.
inline std::string fold(const std::string& summary, const std::string& inside) {
  return "<details>\n<summary>" + escaped(summary) + "</summary>\n" + inside + "</details>\n";
}

/// What theory says of the answer stands in a fold below.
inline std::string facts_html(const std::vector<Fact>& facts) {
  const auto list_of = [&facts](bool of_theory) {
    std::string text;
    for (const Fact& fact : facts)
      if (fact.is_theory == of_theory)
        text += "<div><dt>" + escaped(fact.label) + "</dt><dd>" + with_breaks(fact.text) +
                "</dd></div>\n";
    return text.empty() ? text : "<dl class=\"facts\">\n" + text + "</dl>\n";
  };
  const std::string theory = list_of(true);
  return list_of(false) +
         (theory.empty() ? theory : fold("Theory: is it the only answer?", theory));
}

/// A list, or nothing.
inline std::string list_html(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string text = "<ul>\n";
  for (const std::string& sentence : sentences) text += "<li>" + escaped(sentence) + "</li>\n";
  return text + "</ul>\n";
}

inline std::string paragraphs_html(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += paragraph(sentence);
  return text;
}

/// A box that scrolls by itself, also by the keyboard.
inline std::string scrolling(const std::string& label, const std::string& inside) {
  return "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" + escaped(label) +
         "\">\n" + inside + "</div>\n";
}

/// The first row holds the heads of the columns, the first column those of the rows; cells are
/// HTML.
inline std::string table_html(const std::string& caption,
                              const std::vector<std::vector<std::string>>& rows) {
  std::string text =
      "<table>\n<caption><span>" + escaped(caption) + "</span></caption>\n<thead>\n<tr>";
  for (const std::string& cell : rows[0]) text += "<th scope=\"col\">" + cell + "</th>";
  text += "</tr>\n</thead>\n<tbody>\n";
  for (std::size_t r = 1; r < rows.size(); ++r) {
    text += "<tr><th scope=\"row\">" + rows[r][0] + "</th>";
    for (std::size_t c = 1; c < rows[r].size(); ++c) text += "<td>" + rows[r][c] + "</td>";
    text += "</tr>\n";
  }
  return scrolling(caption, text + "</tbody>\n</table>\n");
}

inline std::string figure(const Drawing& drawing, const std::string& caption) {
  return "<figure>\n" + svg_element(drawing) + "<figcaption>" + escaped(caption) +
         "</figcaption>\n</figure>\n";
}

} // namespace lcpush::desktop
