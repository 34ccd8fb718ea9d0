#include "report/isometric_painter.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

// Lengths in pixels.
constexpr double object_width = 235, object_height = 165, longest_arrow = 84, fastest_arrow = 50;
constexpr GraspFigures::Sizes figure_sizes{IsometricPainter::finger_length, 26, 2};

/// Seen from above, from the right of a front view; all three axes equally long.
View isometric_view(const View& front) {
  const Vector3<double> right = (front.right - front.toward) / std::sqrt(2.0);
  const Vector3<double> toward = (front.right + front.up + front.toward) / std::sqrt(3.0);
  const Vector3<double> up = (2 * front.up - front.right - front.toward) / std::sqrt(6.0);
  return {"isometric", "Isometric view", right, up, toward};
}

/// In the middle of the picture, as large as there is room.
Sight isometric_sight(const SceneFile& file) {
  Sight sight{isometric_view(chosen_views(file)[0])};
  std::vector<Pixel> shown;
  for (const auto& corner : corners_of(object_prism(file)))
    shown.push_back(sight.view.flat(corner));
  for (const auto& position : drawn_positions(file)) shown.push_back(sight.view.flat(position));
  const Frame frame = bounds(shown);
  sight.meters = std::min(object_width / std::max(frame.width(), 1e-9),
                          object_height / std::max(frame.height(), 1e-9));
  const Pixel middle((frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2);
  sight.shift =
      Pixel(IsometricPainter::width / 2, IsometricPainter::height / 2) - sight.meters * middle;
  return sight;
}

} // namespace

IsometricPainter::IsometricPainter(const SceneFile& file, const PushReport& report)
    : file_(file), scene_(file.view()), report_(report), sight_(isometric_sight(file)),
      figures_(file, sight_, figure_sizes), scales_(picture_scales(file, report)),
      places_(width, height) {
  scales_.meters = sight_.meters;
  if (!scales_.shows_forces) return;
  double most = (file.object.mass * file.gravity).norm();
  for (const Body<double>& body : scene_.bodies)
    most = std::max({most, std::abs(normal_sum(report_.answer, body)), friction_of(body).norm()});
  scales_.newtons = most > 0 ? longest_arrow / round_above(most) : 0;
  scales_.accelerations *= fastest_arrow / fastest;
}

/// Words do not touch its outline while there is any other place.
std::string IsometricPainter::kept_clear(const Figure& figure) {
  places_.bar_edges(figure.outline);
  return figure.elements;
}

Drawing IsometricPainter::draw() {
  Drawing drawing{view_.name, view_.title, "", width, height, ""};
  const Pixel corner(92, 92); // of the axes
  places_.bar({0, 0, corner.x(), corner.y()});
  std::string behind, before, arrows;
  for (const Index b : bodies_back_to_front(view_, scene_.bodies)) {
    const Body<double>& body = scene_.bodies[b];
    const std::string kind =
        std::string("thing ") + (body.role == Role::pusher ? "pusher" : "finger");
    (view_.toward.dot(body.normal) > 0 ? behind : before) += kept_clear(figures_.body(b, kind));
  }
  const std::string object = kept_clear(figures_.object());
  const std::string ghost_elements =
      scales_.shows_forces ? kept_clear(figures_.ghost(report_)) : "";
  for (Index b = 0; b < scene_.bodies.size; ++b) arrows += forces(b) + body_motion(b);
  const std::string motion = object_motion();
  arrows += weight() + motion;
  for (Index b = 0; b < scene_.bodies.size; ++b) label_body(b);
  const std::vector<Frame> words = placed_labels(places_, labels_);
  const Frame used = places_.used(words, corner, 8);
  drawing.top = used.top;
  drawing.height = used.height();
  drawing.elements = shifted(axes_in_space(view_, {44, 50}, 32), {0, used.top}) + behind + object +
                     before + ghost_elements + arrows + label_elements(labels_, words);
  drawing.description = scales_.shows_forces
                            ? "The object between the bodies that touch it, the forces on it, and "
                              "dashed where it goes."
                            : "The object between the bodies that touch it.";
  for (const std::string& sentence : words_) drawing.description += " " + sentence;
  return drawing;
}

Drawing isometric_picture(const SceneFile& file, const PushReport& report) {
  return IsometricPainter(file, report).draw();
}

} // namespace lcpush::desktop
