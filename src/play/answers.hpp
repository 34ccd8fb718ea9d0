// What the playground's page asks its solver. It answers as the commands do, in the same JSON, so
// that the page and the tool cannot say different things.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "lcpush/desktop/push.hpp"
#include "picture/grasp_figures.hpp"

namespace lcpush::desktop {

/// Questions one after the other. What was solved last is kept, so that looking at it from
/// elsewhere solves nothing again; no answer depends on it.
class Playground {
public:
  /// `question` is a word and what goes with it, `text` a scene; LOOK as read_picture_request reads
  /// it:
  ///   "solve LOOK"   {"answer": as `solve --json`, "sentence": its first, "scene": what a hand can
  ///                  take, and as "look"}; without LOOK the first two
  ///   "drag LOOK"    the same without other answers and remedies, which take most of the time
  ///   "look LOOK"    {"picture": as SVG, "meters": pixels a metre, "right", "up": the directions
  ///                  that it shows so}
  ///   "break"        {"answer": as `break --json`, "sentence": empty without an answer}
  ///   "move T N"     {"answer": as `move --json --time T --frames N`, "sentence": its first,
  ///                  "poses": where the bodies are, frame by frame: position, rotation column by
  ///                  column, the middle of the points that press, their normal};
  ///                  T = 0: as long as the scene says
  ///   "pivots T"     the page of `pivots --format html`, in decimals, of the scene as it stands T
  ///                  seconds later; without T as it is
  ///   "lcp"          that page of a typed problem: M on the first line, q on the second
  /// Throws InputError where the commands would.
  std::string answer_to(std::string_view question, std::string_view text);

private:
  struct Solved {
    std::string text;
    bool in_full;
    SceneFile file;
    DrawnScene drawn; ///< of the file
    Push push;        ///< whose memory the report looks at
    HoldReport hold;
    PushReport report;

    Solved(std::string_view scene, bool in_full);
  };
  std::unique_ptr<const Solved> last_;

  const Solved& solved(std::string_view text, bool in_full);
  std::string solve(std::string_view text, bool in_full, std::string_view look);
  std::string look(std::string_view text, std::string_view look);
};

/// What happens, or why there is no answer.
std::string first_sentence(const SceneFile& file, const PushReport& report);

} // namespace lcpush::desktop
