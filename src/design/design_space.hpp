// What is chosen, and the scene and its box there.
#pragma once

#include "boxes/box.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

using Values = std::vector<double>; ///< of the choices

class DesignSpace {
public:
  /// A number, a pattern's numbers or a turn; or the middle or the length of a line that is given
  /// by its ends, which moves each of them by so much a unit.
  struct Choice {
    std::string path;
    double from, to, given;
    std::vector<Parameter> parameters;
    std::vector<double> slopes; ///< empty: they take its value
  };

  DesignSpace(const VariedScene& scene, const std::vector<std::string>& choices,
              const std::vector<std::string>& tolerances);

  const std::vector<Choice>& choices() const { return choices_; }
  Values given() const;
  VariedScene scene_at(const Values& values) const;
  /// With the tolerances about it: as they were given, or all of them so wide.
  VariedScene box_at(const Values& values, const std::optional<double>& margin = {}) const;
  bool asks_ranges() const;

  /// What is known to a tolerance.
  struct Uncertain {
    std::string path;
    bool is_relative;
    double off; ///< a share, or about the value
  };
  const Uncertain* uncertain(const std::string& path) const;
  /// The scene whose ranges are those of these choices and of what is uncertain; and its sides for
  /// ends that move together.
  VariedScene scene_over(const std::vector<bool>& choices, const Values& at) const;
  std::vector<BoxSide> sides_over(const std::vector<bool>& choices, const Values& at) const;

private:
  VariedScene scene_;
  std::vector<Choice> choices_;
  std::vector<Uncertain> uncertain_;

  Choice read_choice(const std::string& text) const;
  void find_length(const std::string& text, std::string& path) const;
  bool find_line(const std::string& path, Choice& choice) const;
};

} // namespace lcpush::desktop
