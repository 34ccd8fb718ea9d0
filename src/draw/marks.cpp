#include "draw/marks.hpp"

namespace lcpush::desktop {

std::string mark_element(Mark mark, const std::string& kind, const Pixel& at) {
  const std::string style = "mark " + kind;
  switch (mark) {
  case Mark::square:
    return polygon_element(style, {at + Pixel(-3.6, -3.6), at + Pixel(3.6, -3.6),
                                   at + Pixel(3.6, 3.6), at + Pixel(-3.6, 3.6)});
  case Mark::triangle:
    return polygon_element(style,
                           {at + Pixel(0, -4.8), at + Pixel(4.6, 3.6), at + Pixel(-4.6, 3.6)});
  case Mark::cross:
    return path_element(style, move_to(at - Pixel(3.6, 3.6)) + "l7.2 7.2m0 -7.2l-7.2 7.2");
  case Mark::ring:
  case Mark::small_ring: break;
  }
  return circle_element(style, at, mark == Mark::ring ? 4.4 : 2.4);
}

std::string turning_arc(const Pixel& center, bool is_clockwise) {
  constexpr double radius = 19;
  const double along = is_clockwise ? 1 : -1; // at the top it moves to the right
  const Pixel tip = center - Pixel(0, radius);
  const std::string r = pixels(radius);
  return "<g class=\"motion\">" +
         path_element("arc", move_to(center + Pixel(along * radius, 0)) + "A" + r + " " + r +
                                 " 0 1 " + (is_clockwise ? "1 " : "0 ") + pixels(tip.x()) + " " +
                                 pixels(tip.y())) +
         polygon_element("head", {tip + Pixel(8 * along, 0), tip + Pixel(-2 * along, -4.5),
                                  tip + Pixel(-2 * along, 4.5)}) +
         "</g>\n";
}

std::string turning_center(const Pixel& at) {
  return circle_element("turning", at, 5) +
         path_element("turning",
                      move_to(at - Pixel(9, 0)) + "h18" + move_to(at - Pixel(0, 9)) + "v18");
}

std::string sight_ring(const Pixel& at, bool is_behind) {
  if (is_behind)
    return "<g class=\"force normal behind\">" + circle_element("ring", at, 10) + "</g>\n";
  return "<g class=\"force normal\">" + circle_element("ring", at, 7.5) +
         path_element("ring", move_to(at - Pixel(5, 5)) + "l10 10m0 -10l-10 10") + "</g>\n";
}

std::string key_html(const KeyItems& items) {
  std::string text = "<ul class=\"key\">\n";
  for (const auto& [drawn, words] : items) text += "<li>" + drawn + escaped(words) + "</li>\n";
  return text + "</ul>\n";
}

std::string sample(const std::string& view_box, const std::string& elements) {
  return "<svg class=\"drawing\" viewBox=\"" + view_box + "\" aria-hidden=\"true\">" + elements +
         "</svg>";
}

} // namespace lcpush::desktop
