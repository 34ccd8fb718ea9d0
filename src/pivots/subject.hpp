// What is pivoted: a scene's problem or two matrices, and what its variables mean.
#pragma once

#include "lcpush/desktop/pivots.hpp"

namespace lcpush::desktop {

struct PivotSubject {
  ExactProblem problem;  ///< of a scene only if it is not replayed as solved
  bool is_short = false; ///< so small that it is pivoted in fractions even if decimals are shown
  std::unique_ptr<SceneFile> scene; ///< null, and the next one, for matrices
  std::unique_ptr<Push> push;
  std::unique_ptr<Story> story;
  std::vector<std::string> notes;
};

/// `file`: the scene of `text` with the facets and the pressure law to be used. `path` names it in
/// messages. Throws InputError if it is too large to be shown, or for fractions if `is_exact`.
PivotSubject scene_subject(SceneFile file, const std::string& text, const std::string& path,
                           bool as_solved, bool is_exact);
/// Of the doubles that the scene was read as: no fraction is, and the reader of fractions is not
/// needed, which is a fifth of a program.
PivotSubject rounded_subject(SceneFile file, const std::string& path);
/// `name` is M's in messages.
PivotSubject raw_subject(ExactProblem problem, const std::string& name, bool is_exact);

/// Why the scene's pressure law goes without an answer, "even does not go with .."; or empty.
std::string unknown_shares(const SceneFile& file);

/// For text, JSON and LaTeX; or for the page, which pivots by itself and can show fractions beside
/// decimals where they are quick.
PivotOptions pivot_options(const PivotSubject& subject, bool is_exact, bool is_page);
/// The real run of a scene or of matrices.
PivotTrace trace_solve(const PivotSubject& subject, const PivotOptions& options = {});
/// The subject's title and notes.
void finish_trace(PivotTrace& trace, const PivotSubject& subject, bool is_exact);

} // namespace lcpush::desktop
