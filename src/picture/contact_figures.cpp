#include "picture/contact_figures.hpp"

#include "text/wording.hpp"

namespace lcpush::desktop {

std::string mode_mark(Mode mode, const Pixel& at) {
  return mark_element(mode == Mode::stick   ? Mark::square
                      : mode == Mode::slide ? Mark::triangle
                                            : Mark::ring,
                      mode_text(mode), at);
}

ContactFigure contact_figure(const SceneFile& file, const View& view, const Body<double>& body,
                             const ContactAnswer<double>& answer, const Pixel& tip, double newtons,
                             double no_force) {
  ContactFigure figure;
  const bool is_behind = view.is_behind(body.normal);
  const std::string behind = is_behind ? " behind" : "";
  const auto from = [&](const Vector3<double>& force) {
    return Pixel(tip - newtons * view.flat(force));
  };
  const Vector3<double> normal = answer.normal_force * body.normal;
  const bool is_pressed = answer.normal_force > no_force;
  if (is_pressed && body.friction > 0) {
    std::vector<Pixel> rim{tip};
    const Index corners = drawn_facets(file, body);
    for (Index j = 0; j < corners; ++j)
      rim.push_back(
          from(normal + body.friction * answer.normal_force * generator(body, j, corners).force));
    figure.cone = hull(rim);
    figure.elements += polygon_element("cone" + behind, figure.cone);
  }
  const auto add_arrow = [&](const std::string& kind, const Pixel& tail) {
    figure.shafts.emplace_back(tail, tip);
    figure.elements += arrow_element(kind + behind, tail, tip);
  };
  if (view.flat(body.normal).norm() > 0.3)
    add_arrow("force normal", from(normal));
  else if (is_pressed)
    figure.elements += sight_ring(tip, is_behind);
  add_arrow("force friction", from(answer.friction_force));
  return figure;
}

} // namespace lcpush::desktop
