// All modes of a push: which of stick, slip and open each contact can do, which combinations of
// them obey the laws, and which one `solve` takes. docs/guide/spread.md, "All modes of a push".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lcpush/desktop/spread.hpp"

namespace lcpush::desktop {

/// The answers in which every contact keeps its mode. A point without friction neither sticks nor
/// slips: where it touches, its mode is `stick`.
struct ModeCombination {
  std::vector<Mode> modes; ///< one a point
  SpreadReport ranges;     ///< over these answers: push, motion, forces, as find_spread has them
  PushReport shown;        ///< of one answer: `motion`, and answer.acceleration; no contacts
};

struct PointModes {
  bool can[3] = {};                   ///< by Mode, in some answer
  std::vector<Vector3<double>> slips; ///< unit, of some answers: one for each edge of the friction
                                      ///< cone, and for each two together, that opposes a slip
};

struct ModesReport {
  /// solved: there are combinations. Else as Push::solve ends.
  Status status = Status::bad_input;
  std::vector<ModeCombination> combinations; ///< that obey the laws; the weakest push first
  std::vector<PointModes> points;
  Index possible = 1;      ///< combinations of modes that there are, whatever the laws say
  bool complete = false;   ///< there are no others
  std::string enumeration; ///< why it is not, empty otherwise
  Stop stop = Stop::none;  ///< what ended it early
  PushReport solved;       ///< as Push::solve ends under the file's own laws; its arrays are gone
  std::optional<std::size_t> chosen; ///< the combination that `solved` has; none: no such answer
};

/// [T.15] Every combination of modes that obeys the literal laws, whatever pressure law `file`
/// names: an answer is open, slips or sticks at a contact by its motion there, so that it has one
/// combination. Uses `enumeration`, `most_work`, `by_time`, `progress` and `stop` of the options.
/// Pre: no soft point with friction.
ModesReport find_modes(const SceneFile& file, const SpreadOptions& options);

/// A line a sentence: wrap them as you like.
std::string contact_modes_text(const SceneFile& file, const ModesReport& report,
                               Telling telling = Telling::brief);
std::string contact_modes_json(const SceneFile& file, const ModesReport& report);
/// A small picture for each of the first combinations.
std::string contact_modes_svg(const SceneFile& file, const ModesReport& report);

} // namespace lcpush::desktop
