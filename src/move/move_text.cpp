#include "lcpush/desktop/move.hpp"

#include "move/motion_painter.hpp"
#include "move/move_words.hpp"
#include "move/settings.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// "left 8 slip; wall 2 stick, 2 beside": bodies that touch first.
std::string contacts_words(const SceneFile& file, const MotionFrame& frame) {
  constexpr const char* words[] = {"sticks", "slips", "open", "beside", "behind", "end", "away"};
  std::vector<std::string> parts;
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    parts.push_back(file.body_names[b] + " " +
                    joined(touch_words(file, frame, b, words, false), " "));
  return joined(parts, ", ");
}

/// Axes along or about which something happens.
std::vector<Index> moving_axes(const MotionReport& report, bool turns, double least) {
  std::vector<Index> axes;
  for (Index axis = 0; axis < 3; ++axis) {
    double most = 0;
    for (const MotionFrame& frame : report.frames)
      most = std::max(most, std::abs(turns ? frame.turn[axis] : frame.pose.position[axis]));
    if (most > least) axes.push_back(axis);
  }
  return axes;
}

std::string frames_table(const SceneFile& file, const MotionReport& report, bool verbose) {
  double path = 0, turned = 0;
  for (const MotionFrame& frame : report.frames) {
    path = std::max(path, frame.pose.position.norm());
    turned = std::max(turned, object_size(file) / 2 * frame.turn.norm());
  }
  const double least = std::max(MoveSettings::worth_a_word * std::max(path, turned),
                                MoveSettings::unmoved * object_size(file));
  const double unseen = MoveSettings::unseen * least;
  std::vector<Index> shifts = moving_axes(report, false, least);
  const std::vector<Index> turns = moving_axes(report, true, 2 * least / object_size(file));
  if (shifts.empty() && turns.empty()) shifts = {0, 1, 2};
  const auto made = [&](int digits) {
    TableRows rows{{"time s"}};
    for (const Index axis : shifts) rows[0].push_back(std::string(1, "xyz"[axis]) + " mm");
    for (const Index axis : turns) rows[0].push_back(std::string("turn ") + "xyz"[axis] + " deg");
    rows[0].insert(rows[0].end(), {"push N"});
    for (const std::size_t k : spread_out(
             report.frames.size(), verbose ? report.frames.size() : MoveSettings::brief_rows)) {
      const MotionFrame& frame = report.frames[k];
      rows.push_back({in_digits(frame.time, digits)});
      const Vector3<double> turn = frame.turn;
      for (const Index axis : shifts)
        rows.back().push_back(in_digits(millimetres_a_metre * frame.pose.position[axis], digits,
                                        millimetres_a_metre * unseen));
      for (const Index axis : turns)
        rows.back().push_back(
            in_digits(degrees_a_radian * turn[axis], digits, degrees_a_radian * unseen));
      const std::vector<BodyForce>& forces = forces_beside(report, k);
      const double noise = MoveSettings::exact * std::max(1.0, hardest(forces));
      rows.back().push_back(
          forces.empty() ? "-" : in_digits(push_force(file, forces).norm(), digits, noise));
    }
    return rows;
  };
  return table_text(made(verbose ? 6 : 4));
}

std::string events_text(const SceneFile& file, const MotionReport& report, bool verbose) {
  std::vector<std::string> lines;
  for (const EventLine& event : event_lines(file, report))
    lines.push_back(in_digits(event.time, 4) + " s: " + event.words +
                    (verbose ? printed(" (within %.1g s)", event.within) : ""));
  std::string text;
  const std::size_t shown =
      verbose ? lines.size() : std::min(lines.size(), MoveSettings::brief_events);
  for (std::size_t k = 0; k < shown; ++k) text += (k > 0 ? "\n" : "") + lines[k];
  if (shown < lines.size()) text += "\n" + std::to_string(lines.size() - shown) + " more, with -v";
  return text;
}

} // namespace

std::string move_text(const SceneFile& file, const MotionReport& report, bool verbose) {
  std::vector<Fact> facts{{"Ends", pose_words(file, report.frames.back())},
                          {"Contacts then", contacts_words(file, report.frames.back())}};
  if (!report.events.empty() || !report.jumps.empty())
    facts.push_back({"Events", events_text(file, report, verbose)});
  if (verbose)
    for (const MotionPhase& phase : report.phases)
      facts.push_back({"Phase", brief(phase.from) + " to " + brief(phase.until) +
                                    " s: " + phase_words(file, phase)});
  facts.push_back({"Steps", step_words(report, verbose)});
  for (const SceneDoubt& doubt : motion_doubts(file, report))
    if (doubt.doubt == Doubt::unknown_shape) facts.push_back({"Check", doubt_text(doubt)});
  return title_line(file) + move_sentence(file, report) + "\n\n" +
         frames_table(file, report, verbose) + "\n" + facts_text(facts);
}

} // namespace lcpush::desktop
