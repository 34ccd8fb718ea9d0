// The playground's page with a scene in it; and every shipped scene with a picture, what happens,
// and a way into the playground.
#include "draw/markup.hpp"
#include "lcpush/desktop/play.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "play/answers.hpp"
#include "play/page_text.hpp"
#include "play/state_picture.hpp"
#include "scenes/shipped_scenes.hpp"

namespace lcpush::desktop {
namespace {

void fill(std::string& page, const std::string& placeholder, const std::string& text) {
  page.replace(page.find(placeholder), placeholder.size(), text);
}

/// A page around the solver, with all but what its body begins with.
std::string with_solver(const std::string& title, const std::string& body) {
  std::string page = play_frame();
  fill(page, "/*TITLE*/", title);
  fill(page, "/*BODY*/", body);
  fill(page, "/*LOOKS*/", palette(":root") + drawing_style());
  fill(page, "/*STYLE*/", play_style());
  fill(page, "/*DRAWING*/", drawing_script());
  fill(page, "/*SCRIPT*/", play_script());
  fill(page, "/*SOLVER*/", solver_text());
  return page;
}

/// The entry of a scene, and its picture as a file.
std::string entry(const ShippedScene& scene, std::vector<PlayFile>& files) {
  const SceneFile file = parse_scene(scene.text, scene.name);
  Push push(file);
  PushOptions options;
  options.other_paths = 0;
  const HoldReport hold = push.holds_without_push(options);
  const PushReport report = push.solve(options);
  files.push_back({scene.name + ".svg",
                   report_pictures({file, hold, report, nullptr, nullptr, {}}).front().svg});
  return "<li><a href=\"play.html#text=" + percent_encoded(scene.text, "-_.") + "\"><img src=\"" +
         scene.name + ".svg\" alt=\"\" loading=\"lazy\"><strong>" + escaped(file.title) +
         "</strong><span>" + escaped(first_sentence(file, report)) + "</span></a></li>\n";
}

} // namespace

std::string play_html(const std::string& text) {
  std::string page = with_solver("lcpush playground", play_body());
  fill(page, "<!--KEY-->", state_key());
  // The scene last: what it says must not be taken for a placeholder.
  fill(page, "/*SCENE*/", escaped(text));
  return page;
}

std::string lcp_html() { return with_solver("Your own M and q", lcp_body()); }

std::vector<PlayFile> play_gallery() {
  const std::vector<ShippedScene> scenes = example_scenes();
  std::vector<PlayFile> files{{"play.html", play_html(*scene_called(scenes, "straight_slide"))},
                              {"lcp.html", lcp_html()}};
  std::string entries;
  for (const ShippedScene& scene : scenes) entries += entry(scene, files);
  std::string page = gallery_template();
  fill(page, "/*STYLE*/", palette(":root"));
  fill(page, "/*SCENES*/", entries);
  files.push_back({"index.html", page});
  return files;
}

} // namespace lcpush::desktop
