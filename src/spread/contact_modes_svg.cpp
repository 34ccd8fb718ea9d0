// Small pictures beside each other: what every contact does in a combination of modes, and where
// the object goes.
#include <algorithm>
#include <array>

#include "lcpush/desktop/contact_modes.hpp"
#include "picture/contact_figures.hpp"
#include "picture/grasp_figures.hpp"
#include "solve/sentence.hpp"
#include "spread/spread_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

// Lengths in pixels.
constexpr double cell_width = 270, cell_height = 215, heading = 44, object_room = 130;
constexpr double finger_length = 40, ghost_way = 18, arrow_length = 34;
constexpr std::size_t pictures_a_row = 3, most_pictures = 12;

Sight small_sight(const DrawnScene& drawn) {
  const View view =
      isometric_view(two_views(drawn.file.gravity, drawn.file.shape.size, drawn.file.bodies)[0]);
  std::vector<Pixel> shown;
  for (const auto& corner : corners_of(drawn.object)) shown.push_back(view.flat(corner));
  for (const auto& position : drawn.positions) shown.push_back(view.flat(position));
  const Frame frame = bounds(shown);
  return centered(view, frame, fitting_scale(frame, object_room, object_room),
                  {cell_width, cell_height});
}

/// An arrow along the centre of mass's acceleration, unless the object only turns; an arc for a
/// turn.
std::string motion_sign(const Sight& sight, const DrawnScene& drawn,
                        const ModeCombination& combination) {
  const Motion<double>& motion = combination.shown.motion;
  const Pixel from = sight.place(drawn.center());
  std::string text = circle_element("center", from, 3);
  if (turns(motion)) text += turning_arc(from, sight.view.toward.dot(motion.axis) < 0);
  if (motion.kind != MotionKind::slide && motion.kind != MotionKind::turn) return text;
  const Vector3<double> moves = combination.shown.answer.acceleration.head<3>().normalized();
  return text + arrow_element("motion", from, from + arrow_length * sight.view.flat(moves));
}

std::string picture(const DrawnScene& drawn, const Sight& sight,
                    const ModeCombination& combination) {
  const GraspFigures figures(drawn, sight, {finger_length, ghost_way, 2});
  std::string behind, before, marks;
  for (const Index b : bodies_back_to_front(sight.view, drawn.scene.bodies)) {
    const Body<double>& body = drawn.scene.bodies[b];
    const std::string kind =
        std::string("thing ") + (body.role == Role::pusher ? "pusher" : "finger");
    (sight.view.toward.dot(body.normal) > 0 ? behind : before) += figures.body(b, kind).elements;
    for (const Index i : points_of(body))
      marks +=
          mode_mark(combination.modes[static_cast<std::size_t>(i)], sight.place(drawn.position(i)));
  }
  return behind + figures.object().elements + before + figures.ghost(combination.shown).elements +
         motion_sign(sight, drawn, combination) + marks;
}

/// What the marks mean, in one line.
std::string key(const Pixel& at) {
  const std::array<std::pair<Mode, const char*>, 3> items{
      {{Mode::stick, "sticks, or touches without friction"},
       {Mode::slide, "slips"},
       {Mode::separate, "opens"}}};
  std::string text;
  Pixel place = at;
  for (const auto& [mode, word] : items) {
    text += mode_mark(mode, place) + text_element("quiet", place + Pixel(12, 5), word);
    place.x() += mode == Mode::stick ? 250 : 80;
  }
  return text + text_element("quiet", place + Pixel(0, 5), "dashed, arrows: where it goes");
}

} // namespace

std::string contact_modes_svg(const SceneFile& file, const ModesReport& report) {
  const DrawnScene drawn(file);
  const Sight sight = small_sight(drawn);
  const std::size_t count = std::min(report.combinations.size(), most_pictures);
  const std::size_t rows = (count + pictures_a_row - 1) / pictures_a_row;
  Drawing drawing{"modes",
                  file.title.empty() ? "All modes of a push" : file.title,
                  counted(static_cast<Index>(report.combinations.size()), "combination") +
                      " of contact modes.",
                  static_cast<double>(pictures_a_row) * cell_width,
                  heading + static_cast<double>(rows) * (cell_height + heading) + 40,
                  ""};
  std::string title =
      counted(static_cast<Index>(report.combinations.size()), "lawful combination") +
      (report.complete ? ", and that is all" : " found; there may be others");
  if (count < report.combinations.size()) title += ". The first " + std::to_string(count) + ":";
  drawing.elements = text_element("strong", {14, 26}, title);
  for (std::size_t k = 0; k < count; ++k) {
    const ModeCombination& combination = report.combinations[k];
    std::string words = std::to_string(k + 1);
    if (report.chosen == k) words += ", as lcpush solve has it";
    std::string push;
    for (const PusherSpread& pusher : combination.ranges.pushers)
      push += (push.empty() ? "push " : "; ") +
              interval_text(pusher.force, same_force(combination.ranges), 3) + " N";
    const Pixel corner(static_cast<double>(k % pictures_a_row) * cell_width,
                       heading + static_cast<double>(k / pictures_a_row) * (cell_height + heading));
    const std::string does = shortened(motion_phrase(file, combination.shown), 38);
    drawing.description += " " + words + ": " + push + ", " + does + ".";
    drawing.elements +=
        shifted(text_element("strong", {14, 16}, words) + text_element("", {14, 35}, push) +
                    shifted(picture(drawn, sight, combination), {0, 30}) +
                    text_element("quiet", {14, cell_height + 28}, does),
                corner);
  }
  drawing.elements += key({20, drawing.height - 18});
  return svg_document(drawing);
}

} // namespace lcpush::desktop
