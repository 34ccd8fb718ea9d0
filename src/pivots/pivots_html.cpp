// The explorer's page with a trace in it.
#include "draw/markup.hpp"
#include "lcpush/desktop/pivots.hpp"
#include "pivots/explorer.hpp"

namespace lcpush::desktop {
namespace {

void put(std::string& page, const std::string& placeholder, const std::string& text) {
  page.replace(page.find(placeholder), placeholder.size(), text);
}

/// No "</script>" and no "<!--" may end the element that the JSON stands in.
std::string embedded(const std::string& json) {
  std::string text;
  for (const char c : json) c == '<' ? text += "\\u003c" : text += c;
  return text;
}

} // namespace

std::string open_pivots_html(const PivotTrace& trace, const Push* push) {
  std::string page = explorer_template();
  // The trace last: what it says must not be taken for a placeholder. The places that stay stand
  // before it.
  put(page, "/*STYLE*/", explorer_style());
  put(page, "/*SCRIPT*/", explorer_script());
  put(page, "/*TRACE*/", embedded(pivots_json(trace, push, false)));
  return page;
}

std::string pivots_html(const PivotTrace& trace, const Push* push) {
  std::string page = open_pivots_html(trace, push);
  put(page, "/*LOOKS*/", palette(":root") + drawing_style());
  put(page, "/*DRAWING*/", drawing_script());
  return page;
}

} // namespace lcpush::desktop
