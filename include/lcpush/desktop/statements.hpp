// Which theorem covers a scene: does an answer exist, and is it the only one? In words, with the
// bodies that decide.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/study/existence.hpp"

namespace lcpush::desktop {

struct ExistenceFound {
  bool studied = false; ///< not for scenes of very many unknowns
  Existence verdict = Existence::not_known;
  std::vector<std::string> bodies; ///< that decide: who closes on nothing, or who squeezes
};

/// [T.8] The lemma's conditions on an assembled scene of `file`.
ExistenceFound find_existence(const SceneFile& file, const Assembly<double>& assembly);

struct Statement {
  bool covered = false;             ///< a theorem of docs/theory/theory.md says so
  std::string statement;            ///< what it says, or "none"
  std::vector<std::string> reasons; ///< why, or why not; the first stands for itself

  std::string reason() const; ///< all of them
};

Statement existence_statement(const SceneFile& file, const ExistenceFound& found);

/// "2 contacts are between two modes".
std::string tied_words(Index contacts);

struct PushReport;
/// For a push that is solved.
Statement uniqueness_statement(const PushReport& report);

} // namespace lcpush::desktop
