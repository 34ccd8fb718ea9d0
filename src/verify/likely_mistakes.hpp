// What goes wrong at an interface between two programs: signs, units, axes.
#pragma once

#include "lcpush/desktop/foreign_answer.hpp"

namespace lcpush::desktop {

/// An answer with one mistake undone, and what to say if the laws then hold.
struct LikelyMistake {
  std::string undone;  ///< "With every force turned round"
  std::string because; ///< "these are forces on the bodies; forces on the object are asked for"
  ForeignAnswer answer;
  bool is_of_signs;                      ///< then a much smaller error tells as well
  bool is_of_moments = false;            ///< only near lcpush's own: moments may be open
  std::optional<ForeignAnswer> beside{}; ///< what is left out on the way: without the mistake
                                         ///< undone it must not hold
};

/// Commonest first. Only those that change what is given.
std::vector<LikelyMistake> likely_mistakes(const SceneFile& file, const ForeignAnswer& given);

} // namespace lcpush::desktop
