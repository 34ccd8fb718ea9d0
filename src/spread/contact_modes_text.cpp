#include <algorithm>
#include <cstddef>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/contact_modes.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "spread/settings.hpp"
#include "spread/spread_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr Mode all_modes[] = {Mode::stick, Mode::slide, Mode::separate};

/// "stick", "slip", "open"; "touch" where there is no friction.
std::string mode_word(const SceneFile& file, Index point, Mode mode) {
  if (mode == Mode::separate) return "open";
  if (!(file.body(file.body_of(point)).friction > 0)) return "touch";
  return mode == Mode::slide ? "slip" : "stick";
}

/// What a body's points do: "slip", "1 stick, 3 slip".
std::string body_words(const SceneFile& file, const Body<double>& body,
                       const ModeCombination& combination) {
  std::vector<std::string> words;
  for (const Mode mode : all_modes) {
    Index count = 0;
    for (const Index i : points_of(body))
      count += combination.modes[static_cast<std::size_t>(i)] == mode ? 1 : 0;
    const std::string word = mode_word(file, body.first_point, mode);
    if (count == body.point_count) return word;
    if (count > 0) words.push_back(std::to_string(count) + " " + word);
  }
  return joined(words, ", ");
}

std::string yes_or_no(bool yes) { return yes ? "yes" : "no"; }

/// "along x or against x"; of many their number.
std::string slip_words(const SceneFile& file, const PointModes& point) {
  if (point.slips.size() > SpreadSettings::slips_named)
    return "in " + std::to_string(point.slips.size()) + " ways";
  std::vector<std::string> words;
  for (const Vector3<double>& slip : point.slips) words.push_back(direction_phrase(file, slip));
  return listed(words, "or");
}

/// A row for each point: what it can do.
std::string point_table(const SceneFile& file, const ModesReport& report) {
  TableRows rows{{"contact", "stick", "slip", "open", "slips"}};
  for (Index i = 0; i < static_cast<Index>(report.points.size()); ++i) {
    const PointModes& point = report.points[static_cast<std::size_t>(i)];
    std::vector<std::string> row{point_name(file, i)};
    for (const Mode mode : all_modes)
      row.push_back(yes_or_no(point.can[static_cast<std::size_t>(mode)]));
    if (!(file.body(file.body_of(i)).friction > 0)) {
      row[1] = row[2] = "-";
      row.emplace_back("without friction");
    } else {
      row.push_back(slip_words(file, point));
    }
    rows.push_back(row);
  }
  return table_text(rows, rows[0].size());
}

std::string motion_words(const SceneFile& file, const ModeCombination& combination) {
  const bool is_one = combination.ranges.verdict != SpreadVerdict::ambiguous;
  return (is_one ? "" : "such as: ") + motion_phrase(file, combination.shown);
}

/// The heads and the cells of a table's columns, one below the other.
using Columns = std::vector<std::vector<std::string>>;

/// What each body's points do in these combinations: in brief, or point by point. Bodies that do
/// the same stand together.
void add_bodies(const SceneFile& file, const ModesReport& report,
                const std::vector<std::size_t>& shown, bool is_full, Columns& columns) {
  const std::size_t first = columns.size();
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    const Body<double>& body = file.bodies[b];
    std::vector<std::string> column{file.body_names[b]};
    for (const std::size_t k : shown) {
      const ModeCombination& combination = report.combinations[k];
      std::vector<std::string> points;
      for (const Index i : points_of(body))
        points.push_back(mode_word(file, i, combination.modes[static_cast<std::size_t>(i)]));
      column.push_back(is_full ? joined(points, " ") : body_words(file, body, combination));
    }
    const auto twin =
        std::find_if(columns.begin() + static_cast<std::ptrdiff_t>(first), columns.end(),
                     [&](const std::vector<std::string>& other) {
                       return std::equal(other.begin() + 1, other.end(), column.begin() + 1);
                     });
    if (twin == columns.end())
      columns.push_back(column);
    else
      twin->front() += ", " + column.front();
  }
}

/// A row for each of the first `most` combinations, and for the one that was chosen.
std::string combination_table(const SceneFile& file, const ModesReport& report, std::size_t most,
                              bool is_full) {
  const std::vector<ModeCombination>& all = report.combinations;
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k < most || report.chosen == k) shown.push_back(k);
  Columns columns{{""}};
  for (const std::size_t k : shown)
    columns[0].push_back(std::to_string(k + 1) + (report.chosen == k ? " *" : ""));
  const std::vector<PusherSpread>& pushers = all[0].ranges.pushers;
  for (std::size_t p = 0; p < pushers.size(); ++p) {
    columns.push_back({pushers.size() == 1 ? "push N" : file.body_name(pushers[p].body) + " N"});
    for (const std::size_t k : shown)
      columns.back().push_back(
          interval_text(all[k].ranges.pushers[p].force, same_force(all[k].ranges), 3));
  }
  add_bodies(file, report, shown, is_full, columns);
  columns.push_back({object_name(file)});
  for (const std::size_t k : shown) columns.back().push_back(motion_words(file, all[k]));
  TableRows rows(shown.size() + 1);
  for (const std::vector<std::string>& column : columns)
    for (std::size_t r = 0; r < rows.size(); ++r) rows[r].push_back(column[r]);
  return table_text(rows, columns.size());
}

/// Does the pad law say how contacts share a force?
bool has_pads(const SceneFile& file) {
  const Scene<double> scene = file.view();
  for (Index b = 0; b < scene.bodies.size; ++b)
    if (scene.bodies[b].preload > 0 || is_driven(scene, b)) return file.pressure == Pressure::pad;
  return false;
}

/// Why the answer of `solve` is none of the combinations.
std::string stranger_words(const SceneFile& file, const ModesReport& report) {
  if (report.solved.status != Status::solved)
    return "lcpush solve reaches none of them (" + std::string(status_text(report.solved.status)) +
           ")";
  const std::string why =
      file.pressure == Pressure::even
          ? "its law \"even\" prescribes each point's share, which is another problem"
      : file.is_round   ? "its friction is round, not by pyramids"
      : report.complete ? "it stands between two modes, and is told as the other one"
                        : "it was not reached in this search";
  return "the answer of lcpush solve is none of these: " + why;
}

/// Which one `solve` takes, and why.
std::string choice_words(const SceneFile& file, const ModesReport& report) {
  if (!report.chosen) return stranger_words(file, report);
  const std::string number = "number " + std::to_string(*report.chosen + 1);
  if (report.combinations.size() == 1 && report.complete)
    return "there is no choice for lcpush solve: it is the only one";
  const bool finds_others = report.solved.unique_motion == Uniqueness::no;
  if (!has_pads(file))
    return "rigid contact does not choose between them: lcpush solve ends in " + number +
           ", where its pivots lead from their start";
  if (finds_others)
    return "rigid contact does not choose between them, nor does the pad law: lcpush solve ends "
           "in " +
           number + ", and in another one from other starts";
  return "rigid contact does not choose between them; the pad law does: pressure grows with "
         "indentation, so that points share a force, and under it lcpush solve finds " +
         number + " alone";
}

/// How many there are, and whether that is all.
std::string count_words(const ModesReport& report) {
  const auto count = static_cast<Index>(report.combinations.size());
  const std::string obey = counted(count, "combination") + " of stick, slip and open " +
                           (count == 1 ? "obeys" : "obey") + " the laws of rigid contact";
  if (!report.complete)
    return sentence("at least " + obey + "; there may be others: " + report.enumeration);
  return sentence(obey + ", and that is all: the other " + std::to_string(report.possible - count) +
                  " are refuted");
}

} // namespace

std::string contact_modes_text(const SceneFile& file, const ModesReport& report, Telling telling) {
  const bool is_full = telling == Telling::full;
  std::string text = title_line(file);
  if (report.combinations.empty())
    return text + (report.complete ? "No combination of stick, slip and open obeys the laws: all " +
                                         std::to_string(report.possible) + " are refuted.\n"
                                   : "No combination was found: " + report.enumeration + ".\n");
  const std::size_t count = report.combinations.size();
  const std::size_t most = is_full ? count : SpreadSettings::combinations_told;
  text += count_words(report) + sentence(choice_words(file, report)) + "\n";
  if (is_full) text += point_table(file, report) + "\n";
  text += combination_table(file, report, most, is_full);
  if (count > most) text += "  ..\n";
  text += "\n";
  if (report.chosen) text += "*: of lcpush solve. ";
  text += "Push: the sum of normal forces, over all answers with these modes.";
  if (!is_full) text += " -v tells all combinations, point by point.";
  const std::string pyramids = pyramid_text(file);
  return text + "\n" + (pyramids.empty() ? "" : sentence(pyramids));
}

std::string contact_modes_json(const SceneFile& file, const ModesReport& report) {
  JsonWriter json;
  json.begin_object().member("status", status_text(report.status));
  write_warnings(json, check_scene(file));
  json.member("laws", "rigid").member("pressure", pressure_text(file.pressure));
  json.member("possible", report.possible).member("complete", report.complete);
  json.member("enumeration", unless_empty(report.enumeration));
  json.member("stopped", unless_empty(std::string(stop_text(report.stop))));
  json.member("solve", when(report.chosen.has_value(), report.chosen.value_or(0) + 1));
  json.member("why", when(!report.combinations.empty(), choice_words(file, report)));
  const auto write_ends = [&](const Interval& interval) { json.value(ends_of(interval)); };
  json.objects("combinations", report.combinations, [&](const ModeCombination& combination) {
    json.key("modes").begin_object();
    for (Index i = 0; i < static_cast<Index>(combination.modes.size()); ++i)
      json.member(point_name(file, i),
                  mode_word(file, i, combination.modes[static_cast<std::size_t>(i)]));
    json.end_object().key("push_force").begin_object();
    for (const PusherSpread& pusher : combination.ranges.pushers)
      json.member(file.body_name(pusher.body), ends_of(pusher.force));
    json.end_object().list("twist", combination.ranges.twist, write_ends);
    json.member("motion", motion_words(file, combination));
  });
  json.objects("contacts", static_cast<Index>(report.points.size()), [&](Index i) {
    const PointModes& point = report.points[static_cast<std::size_t>(i)];
    std::vector<std::string> can;
    for (const Mode mode : all_modes)
      if (point.can[static_cast<std::size_t>(mode)]) can.push_back(mode_word(file, i, mode));
    json.member("name", point_name(file, i)).member("body", file.body_name(file.body_of(i)));
    json.member("can", can).member("slips", point.slips);
  });
  return json.end_object().text();
}

} // namespace lcpush::desktop
