// What reports say, once for the text and the page: labelled facts, sentences, and table rows.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/report.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {

class JsonWriter;

/// "Motion", and what is said about it: lines with '\n' between them, none at the end.
struct Fact {
  std::string label, text;
  bool is_theory = false; ///< of theorems and of other answers that were looked for in vain
};

/// In two columns, the label's 18 wide.
std::string facts_text(const std::vector<Fact>& facts);

/// "Hand": what moves the fingers.
Fact hand_fact(const SceneFile& file);
/// "Before the push": does the grasp hold the object?
Fact hold_fact(const SceneFile& file, const HoldReport& hold);
/// The same for `break`: also from which grip force on the fingers alone hold, and the same with
/// the pusher in place.
Fact grip_fact(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
               const BreakReport& report);
/// The push of each pusher, the motion, uniqueness, theory; of a failure the theory alone.
std::vector<Fact> push_facts(const SceneFile& file, const PushReport& report);
/// The breaking force and what follows it. Precondition: solved.
std::vector<Fact> break_facts(const SceneFile& file, const BreakReport& report);
/// The same in three digits, without what a first look does not need.
std::vector<Fact> brief_break_facts(const SceneFile& file, const BreakReport& report);

/// Of a grasp that moves before it is pushed.
std::string does_not_hold_text(const SceneFile& file, const BreakReport& report);
/// "Without the push the grasp does not hold the object: ..". Precondition: it does not.
std::string hold_sentence(const SceneFile& file, const HoldReport& hold);
/// "9.81 m/s^2 and 2 rad/s^2", without what is zero; in three digits without what is a thousandth
/// of the other. `length`: m, of the grasp.
std::string acceleration_text(const Vector6<double>& a, double length, Telling telling);
bool has_pusher(const SceneFile& file);
/// Fingers of several points, whose pressure a law shares out.
bool has_patches(const SceneFile& file);

/// A head and a row for each contact; in brief for each body, its forces summed.
TableRows contact_rows(const SceneFile& file, const PushReport& report,
                       Telling telling = Telling::full);
/// Soft points twist: their torque, and how fast they spin.
std::vector<std::string> torsion_sentences(const SceneFile& file, const PushReport& report,
                                           Telling telling);
/// What else the laws allow: lines of sentences, or nothing.
std::string others_sentences(const SceneFile& file, const PushReport& report);
/// Bodies whose actuators move them.
std::vector<std::string> closing_sentences(const SceneFile& file, const PushReport& report,
                                           Telling telling);
/// How the answer was found, without a full stop or an end of line.
std::string run_words(const SceneFile& file, const RunReport& report);

/// "No answer (ray): .." with the jam in words.
std::string failure_text(const SceneFile& file, const RunReport& report);
/// The keys reason, ray and, of a ray, jam.
void write_failure(JsonWriter& json, const SceneFile& file, const RunReport& report);
/// The title and an empty line, or nothing.
std::string title_line(const SceneFile& file);

} // namespace lcpush::desktop
