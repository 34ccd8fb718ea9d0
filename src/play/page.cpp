// The playground's page with a scene in it.
#include "draw/markup.hpp"
#include "lcpush/desktop/play.hpp"
#include "play/page_text.hpp"
#include "play/state_picture.hpp"

namespace lcpush::desktop {
namespace {

void fill(std::string& page, const std::string& placeholder, const std::string& text) {
  page.replace(page.find(placeholder), placeholder.size(), text);
}

} // namespace

std::string play_html(const std::string& text) {
  std::string page = play_template();
  // The scene last: what it says must not be taken for a placeholder.
  fill(page, "/*LOOKS*/", palette(":root") + drawing_style());
  fill(page, "/*STYLE*/", play_style());
  fill(page, "/*DRAWING*/", drawing_script());
  fill(page, "<!--KEY-->", state_key());
  fill(page, "/*SCRIPT*/", play_script());
  fill(page, "/*SOLVER*/", solver_text());
  fill(page, "/*SCENE*/", escaped(text));
  return page;
}

} // namespace lcpush::desktop
