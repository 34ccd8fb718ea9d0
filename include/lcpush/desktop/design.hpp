// Which numbers of a scene let a push stick with the widest margin (docs/theory/theory.md, [T.21])?
#pragma once

#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/scene_check.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lcpush::desktop {

struct DesignReport {
  /// What is chosen, in a range.
  struct Choice {
    std::string path;
    std::string label; ///< of an axis
    double from, to, given;
    double value; ///< with all of them chosen
    double alone; ///< with this one chosen, the others as the file has them
    std::optional<double> alone_margin;
    /// The margin over its range, the others chosen; and from where on something else happens first
    /// beyond it.
    std::vector<std::pair<double, double>> curve;
    std::vector<std::pair<double, std::string>> breaks;
  };
  std::vector<Choice> choices;
  BoxAnswer chosen, given;  ///< of the tolerances, as chosen and as the file has them
  bool asks_ranges = false; ///< tolerances of a size, not of the margin alone
  std::string binds; ///< a clause: what happens first beyond the margin; of none that sticks why
  std::string scene; ///< as a file's text
  std::vector<SceneDoubt> doubts; ///< about the scene as chosen, that the given one does not raise

  bool sticks() const { return chosen.margin ? *chosen.margin > 0 : chosen.is_indifferent; }
};

/// The choices, "wall.shift[1]=-0.005:0.005" (a pattern's numbers take one value; `wall.width` and
/// `wall.center[1]` move both ends of a line), for which the scene's push sticks with the largest
/// margin of the scene's ranges and of the tolerances; without any those of all frictions, grips
/// and the mass. Pre: one pusher. Throws InputError as judge_push does, and for choices that are
/// none. Cost: bounded, about a second.
DesignReport find_design(const VariedScene& scene, const std::vector<std::string>& choices,
                         const std::vector<std::string>& tolerances, bool with_curves = false);

/// Of a scene that is its own image across z: a choice, and the value of it, that would leave that.
/// Not of a friction or a grip: they are uncertain one by one, too.
std::optional<std::pair<std::string, double>>
leaves_plane(const VariedScene& scene, const std::vector<std::string>& choices,
             const std::vector<std::string>& tolerances);

std::string design_text(const SceneFile& file, const DesignReport& report);
std::string design_json(const DesignReport& report);
std::string design_svg(const SceneFile& file, const DesignReport& report);

} // namespace lcpush::desktop
