// Every shipped scene: a picture, what happens, and a way into the playground.
#include "draw/markup.hpp"
#include "lcpush/desktop/play.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "play/answers.hpp"
#include "play/page_text.hpp"
#include "scenes/shipped_scenes.hpp"

namespace lcpush::desktop {
namespace {

/// As an address carries it.
std::string in_address(const std::string& text) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string address;
  for (const char c : text) {
    const bool is_plain =
        (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (is_plain || c == '-' || c == '_' || c == '.') {
      address += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    address += {'%', digits[byte / 16], digits[byte % 16]};
  }
  return address;
}

/// The entry of a scene, and its picture as a file.
std::string entry(const ShippedScene& scene, std::vector<PlayFile>& files) {
  const SceneFile file = parse_scene(scene.text, scene.name);
  Push push(file);
  PushOptions options;
  options.other_covers = 0;
  const HoldReport hold = push.holds_without_push(options);
  const PushReport report = push.solve(options);
  files.push_back({scene.name + ".svg",
                   report_pictures({file, hold, report, nullptr, nullptr, {}}).front().svg});
  return "<li><a href=\"play.html#text=" + in_address(scene.text) + "\"><img src=\"" + scene.name +
         ".svg\" alt=\"\" loading=\"lazy\"><strong>" + escaped(file.title) + "</strong><span>" +
         escaped(first_sentence(file, report)) + "</span></a></li>\n";
}

} // namespace

std::vector<PlayFile> play_gallery() {
  const std::vector<ShippedScene> scenes = example_scenes();
  std::vector<PlayFile> files{{"play.html", play_html(*scene_called(scenes, "straight_slide"))}};
  std::string entries;
  for (const ShippedScene& scene : scenes) entries += entry(scene, files);
  std::string page = gallery_template();
  const auto fill = [&](const std::string& placeholder, const std::string& text) {
    page.replace(page.find(placeholder), placeholder.size(), text);
  };
  fill("/*STYLE*/", palette(":root"));
  fill("/*SCENES*/", entries);
  files.push_back({"index.html", page});
  return files;
}

} // namespace lcpush::desktop
