#include "play/state_picture.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "picture/contact_figures.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

// Lengths in pixels.
constexpr double state_width = 720, state_height = 480, state_margin = 92;
constexpr double longest_arrow = 78;
constexpr double rod_length = 46, label_distance = rod_length + 18;

/// The part of a unit vector's length that lies in the picture, from which on its direction there
/// can be told.
constexpr double seen_part = 0.3;

/// As large as all fits, however it is turned.
double fitted_meters(const DrawnScene& drawn, const View& view) {
  const double least = 0.2 * drawn.reach();
  Pixel most(least, least);
  const auto show = [&](const Vector3<double>& at) {
    most = most.cwiseMax(view.flat(at - drawn.center()).cwiseAbs());
  };
  for (const auto& corner : corners_of(drawn.object)) show(corner);
  for (const auto& position : drawn.positions) show(position);
  return fitting_scale({-most.x(), -most.y(), most.x(), most.y()}, state_width - 2 * state_margin,
                       state_height - 2 * state_margin);
}

View view_of(const DrawnScene& drawn, const PictureRequest& look) {
  if (look.view.empty()) return {"", "", look.right, look.up, cross<double>(look.right, look.up)};
  std::vector<View> views = axis_views(drawn.file.gravity);
  views.push_back(isometric_view(views[0]));
  for (const View& view : views)
    if (view.name == look.view) return view;
  throw InputError("look: no view " + quoted(look.view));
}

Sight sight_of(const DrawnScene& drawn, const PictureRequest& look) {
  const View view = view_of(drawn, look);
  return {view, look.meters > 0 ? look.meters : fitted_meters(drawn, view),
          Pixel(state_width / 2, state_height / 2), view.flat(drawn.center())};
}

} // namespace

/// One state from one direction.
class StatePainter {
public:
  StatePainter(const DrawnScene& drawn, const PushReport& report, const PictureRequest& look)
      : drawn_(drawn), report_(report), look_(look), sight_(sight_of(drawn, look)),
        figures_(drawn, sight_, {rod_length, 30, 2}),
        is_answered_(report.status == Status::solved && !look.moment) {
    double most = look.moment ? look.moment->most_force : 0;
    for (Index i = 0; is_answered_ && i < scene_.points.size; ++i) {
      const ContactAnswer<double>& answer = report.answer.contacts[i];
      most = std::max({most, std::abs(answer.normal_force), answer.friction_force.norm()});
    }
    newtons_ = longest_arrow / std::max(most, 1e-9);
  }

  const Sight& sight() const { return sight_; }
  std::string svg(const std::string& title) const;

private:
  const DrawnScene& drawn_;
  const SceneFile& file_ = drawn_.file;
  const Scene<double>& scene_ = drawn_.scene;
  const PushReport& report_;
  const PictureRequest& look_;
  const Sight sight_;
  const View& view_ = sight_.view;
  const GraspFigures figures_;
  const bool is_answered_; ///< and shown: not a moment of the motion
  double newtons_ = 0;     ///< pixels a newton

  struct Drawn {
    bool is_behind;
    std::string thing, words; // the latter over everything
  };
  Drawn body(Index b, const Frame& object) const;
  Vector3<double> middle(Index b) const;
  std::string label(Index b, const Frame& object) const;
  std::string push_of(const Body<double>& body, const Pixel& at) const;
  std::string contacts() const;
  std::string pressing() const;
  std::string trace() const;
  std::string spoke() const;
  std::string dots() const;
};

/// Of a body's contact, where it is now.
Vector3<double> StatePainter::middle(Index b) const {
  const Vector3<double> at = drawn_.middle(scene_.bodies[b]), center = drawn_.center();
  if (!look_.moment) return at;
  return center + look_.moment->bodies[static_cast<std::size_t>(b)].pose.at(at - center);
}

StatePainter::Drawn StatePainter::body(Index b, const Frame& object) const {
  const Body<double>& body = scene_.bodies[b];
  const bool is_behind = view_.toward.dot(body.normal) > seen_part;
  const std::string role = body.role == Role::pusher ? "pusher" : "finger";
  const auto squeezes = [b](const JamBody& one) { return one.body == b; };
  const std::vector<JamBody>& jam = report_.jam.bodies;
  const bool is_jammed = !look_.moment && std::any_of(jam.begin(), jam.end(), squeezes);
  const Pose<double> pose =
      look_.moment ? look_.moment->bodies[static_cast<std::size_t>(b)].pose : Pose<double>();
  const std::string kind =
      "thing " + role + (is_behind ? " behind" : "") + (is_jammed ? " squeezes" : "");
  const std::string name = escaped(file_.body_name(b));
  const Figure figure = figures_.body(b, kind, pose);
  return {is_behind,
          "<g class=\"body\" tabindex=\"0\" role=\"button\" data-body=\"" + name +
              "\" aria-label=\"" + name + ", " + role + ": arrow keys move it\">" +
              polygon_element("hold", figure.outline) + figure.elements + "</g>\n",
          push_of(body, sight_.place(middle(b))) + label(b, object)};
}

/// Its name and how hard it presses, behind it; not over the picture's edge nor along the object's.
std::string StatePainter::label(Index b, const Frame& object) const {
  const Body<double>& body = scene_.bodies[b];
  std::string words = shortened(file_.body_name(b), 18);
  const std::optional<double> force =
      look_.moment   ? look_.moment->bodies[static_cast<std::size_t>(b)].normal_force
      : is_answered_ ? std::optional(normal_sum(report_.answer, body))
                     : std::nullopt;
  if (force) words += "  " + brief(*force) + " N";
  const Pixel back = -view_.flat(body.normal);
  const bool is_seen_across = back.norm() > seen_part;
  const bool is_behind = view_.toward.dot(body.normal) > seen_part;
  const Pixel away =
      is_seen_across ? Pixel(back.normalized()) : Pixel(is_behind ? -0.5 : 0.5, is_behind ? 1 : -1);
  Pixel at = sight_.place(middle(b)) + (is_seen_across ? label_distance : 76) * away;
  const double size = static_cast<double>(words.size()) * look_.letter;
  const double left = at.x() - (away.x() < -0.3 ? size : away.x() > 0.3 ? 0 : size / 2);
  const double inward = std::max(6 - left, 0.0) - std::max(left + size - (state_width - 6), 0.0);
  if (inward != 0) at += Pixel(inward, -34);
  constexpr double line = 16;
  if (std::abs(at.y() - object.top) < line)
    at.y() = object.top - 10;
  else if (std::abs(at.y() - object.bottom) < line)
    at.y() = object.bottom + line;
  at.y() = std::clamp(at.y(), line, state_height - line);
  const Pixel named = sight_.place(middle(b));
  // Of what lies over the object, the name may lie over it, too.
  const std::string leader = is_seen_across ? "" : line_element("leader", at, named);
  return leader +
         text_element(std::string("label ") + (body.role == Role::pusher ? "pusher" : "finger"),
                      at + Pixel(0, 4), words,
                      away.x() < -0.3  ? "end"
                      : away.x() > 0.3 ? "start"
                                       : "middle");
}

/// Beside a pusher, which way it moves; not where that is out of the picture.
std::string StatePainter::push_of(const Body<double>& body, const Pixel& at) const {
  const double moves = body.acceleration.head<3>().norm();
  if (look_.moment || body.role != Role::pusher || !(moves > 0)) return "";
  const Pixel flat = view_.flat(body.acceleration.head<3>() / moves);
  if (flat.norm() < seen_part) return "";
  const Pixel along = flat.normalized(), across(-along.y(), along.x());
  const Pixel from = at + 22 * across - rod_length * along;
  return arrow_element("motion thin", from, from + 36 * flat);
}

std::string StatePainter::contacts() const {
  std::string text;
  for (Index b = 0; is_answered_ && b < scene_.bodies.size; ++b) {
    const Body<double>& body = scene_.bodies[b];
    for (const Index i : points_of(body)) {
      const ContactAnswer<double>& answer = report_.answer.contacts[i];
      const Pixel tip = sight_.place(drawn_.position(i));
      text +=
          contact_figure(file_, view_, body, answer, tip, newtons_, report_.noise.force).elements +
          mode_mark(answer.mode, tip);
    }
  }
  return text;
}

/// While the push is played: what each body does to the object.
std::string StatePainter::pressing() const {
  std::string text;
  if (!look_.moment) return text;
  for (const Moment::Pressing& body : look_.moment->bodies) {
    if (!body.normal_force) continue;
    const Pixel tip = sight_.place(body.middle);
    const auto arrow = [&](const char* kind, const Vector3<double>& force) {
      const Pixel shaft = newtons_ * view_.flat(force);
      const double size = shaft.norm(), most = 2 * longest_arrow;
      return arrow_element(kind, tip - (size > most ? most / size : 1) * shaft, tip);
    };
    const Vector3<double> press = *body.normal_force * body.normal;
    text += arrow("force normal", press) + arrow("force friction", body.force - press);
  }
  return text;
}

std::string StatePainter::trace() const {
  if (!look_.moment) return "";
  std::vector<Pixel> places;
  for (const auto& at : look_.moment->path) places.push_back(sight_.place(drawn_.center() + at));
  return polyline_element("trace", places);
}

/// While the push is played: a mark that turns with the object, where the outline of a cylinder or
/// a ball would not show it.
std::string StatePainter::spoke() const {
  if (!look_.moment) return "";
  const Vector3<double> at = drawn_.center() + look_.moment->object.position;
  const Vector3<double> right = look_.moment->object.turned(view_.right);
  return line_element("tick", sight_.place(at), sight_.place(at + 0.3 * drawn_.reach() * right)) +
         circle_element("center", sight_.place(at), 3.4);
}

std::string StatePainter::dots() const {
  std::string text;
  for (const OtherPlace& dot : look_.dots) {
    const Pixel at = sight_.place(dot.at);
    text += "<g class=\"dot " + escaped(dot.kind) + "\">" + circle_element("where", at, 4.5);
    if (dot.kind == "jams")
      text += path_element("cross", move_to(at - Pixel(3, 3)) + "l6 6m0 -6l-6 6");
    text += "<title>" + escaped(dot.words) + "</title></g>\n";
  }
  return text;
}

std::string StatePainter::svg(const std::string& title) const {
  const Pose<double> pose = look_.moment ? look_.moment->object : Pose<double>();
  const Figure object = figures_.object(pose);
  std::string behind, before, labels;
  for (const Index b : bodies_back_to_front(view_, scene_.bodies)) {
    const Drawn drawn = body(b, bounds(object.outline));
    (drawn.is_behind ? behind : before) += drawn.thing;
    labels += drawn.words;
  }
  const std::string ghost = is_answered_ ? figures_.ghost(report_).elements : "";
  return "<svg class=\"drawing\" viewBox=\"0 0 " + pixels(state_width, 0) + " " +
         pixels(state_height, 0) +
         "\" role=\"group\" tabindex=\"0\" aria-label=\"The grasp: " + escaped(title) + "\">\n" +
         axes_in_space(view_, {44, state_height - 40}, 26) + behind + object.elements + ghost +
         before + trace() + spoke() + dots() + contacts() + pressing() + labels + "</svg>";
}

StatePicture state_picture(const DrawnScene& drawn, const PushReport& report,
                           const PictureRequest& look, const std::string& title) {
  if (look.moment && look.moment->bodies.size() != drawn.file.bodies.size())
    throw InputError("look: another number of bodies than the scene has");
  const StatePainter painter(drawn, report, look);
  return {painter.svg(title), painter.sight()};
}

std::string state_key() {
  const auto small = [](const std::string& elements) { return sample("0 0 26 14", elements); };
  const auto arrow = [&](const char* kind) { return small(arrow_element(kind, {2, 7}, {25, 7})); };
  KeyItems items{{arrow("force normal"), "normal force"},
                 {arrow("force friction"), "friction"},
                 {small(polygon_element("cone", {{24, 7}, {4, 1}, {4, 13}})), "friction cone"}};
  for (const auto& [mode, words] :
       {std::pair(Mode::stick, "sticks"), std::pair(Mode::slide, "slips"),
        std::pair(Mode::separate, "opens")})
    items.emplace_back(small(mode_mark(mode, {13, 7})), words);
  items.emplace_back(arrow("motion thin"), "the pusher moves");
  items.emplace_back(small(polygon_element("ghost", {{2, 4}, {23, 1}, {24, 10}, {3, 13}})),
                     "where the object goes");
  return key_html(items);
}

} // namespace lcpush::desktop
