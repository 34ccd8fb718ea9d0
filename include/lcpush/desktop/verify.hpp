// lcpush: is somebody else's answer right, and if it is not, why?
#pragma once

#include "lcpush/desktop/final_basis.hpp"
#include "lcpush/desktop/foreign_answer.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/desktop/telling.hpp"
#include "lcpush/mechanics/model/check.hpp"

#include <optional>

namespace lcpush::desktop {

enum class Verdict {
  same_solution,    ///< as lcpush's own
  other_forces,     ///< a solution: the object moves as in lcpush's own, the forces differ
  other_solution,   ///< a solution: the motion differs, or there is none to compare with
  not_a_solution,   ///< a law is broken
  spurious_minimum, ///< all linear constraints hold, the products do not vanish, and no step lowers
                    ///< their sum: where the paper's quadratic program can get stuck
  other_data,       ///< of another scene or problem
};
const char* verdict_text(Verdict verdict); ///< "same solution", ...
constexpr bool is_valid(Verdict verdict) { return verdict <= Verdict::other_solution; }

struct VerifyOptions {
  /// What a row may be off by, in the scaled units that the report names.
  double tolerance = 1e-6;
};

/// A row, by how much it is broken, and in which unit.
struct BrokenRow {
  std::optional<Law> law; ///< none: numbers of the file that contradict each other
  std::string name;       ///< "wall.1 presses while it separates"
  double scaled = 0;      ///< >= 0
  double si = 0;          ///< the same in `unit`
  std::string unit;
  std::optional<double> found, lawful; ///< SI, of a given number: the nearest that the rest allows
};

/// "newton", "normal", .. or "given".
inline const char* law_text(const BrokenRow& row) { return row.law ? law_text(*row.law) : "given"; }

/// What outsiders measure on the complementarity problem 0 <= z _|_ w = M z + q >= 0, scaled.
struct ForeignMetrics {
  double natural_map = 0;        ///< max |min(z, w)|
  double fischer_burmeister = 0; ///< 2-norm of sqrt(z^2 + w^2) - z - w
  double products = 0;           ///< z'w
};

/// The answer's basis (z_i where it is larger than w_i), solved once.
struct RefinedAnswer {
  bool found = false;
  double residual = 0;         ///< largest scaled violation of what came out
  double moved = 0;            ///< in scaled units, the largest change of an unknown
  std::optional<double> force; ///< N, the largest change of a force that is given
  double acceleration = 0;     ///< m/s^2, the object's
};

/// Beside lcpush's own answer.
struct OwnAnswer {
  Status status = Status::bad_input;
  std::optional<double> force; ///< N, the largest difference of a contact's force that is given
  double acceleration = 0;     ///< m/s^2, of the object
};

/// What is said of any answer.
struct JudgedAnswer {
  Verdict verdict = Verdict::other_data;
  std::string because; ///< the row, or what is not this scene's; empty for a solution
  double tolerance = 0;
  double residual = 0; ///< the largest scaled violation; of a raw problem natural_residual
  ForeignMetrics metrics;
  RefinedAnswer refined;
  OwnAnswer own;
};

struct VerifyReport : JudgedAnswer {
  std::vector<BrokenRow> rows; ///< the worst of "given", then of each law
  std::size_t told = 0;        ///< the row that `because` tells
  Vector3<double> acceleration = Vector3<double>::Zero(); ///< m/s^2, with which it was judged
  /// N, where every body's force is given: what they and the load leave beside it.
  std::optional<Vector3<double>> imbalance;
  double out_of_plane = 0; ///< N, the same along z of a planar scene, where no law asks for it
  std::string hint; ///< a change of signs, units or axes with which the laws hold; empty: none
  std::vector<std::string> completed;
  bool in_few_digits = false; ///< no number given has more digits than people print
  double objective = 0;       ///< N m/s^2, what the paper's program minimises
  FinalBasis basis;           ///< other answers next to this one
  bool motion_proved = false; ///< only one motion is possible
};

/// Throws InputError if the answer leaves open what it does not give.
VerifyReport verify_answer(const SceneFile& file, const ForeignAnswer& answer,
                           const VerifyOptions& options);

/// own.force: the largest difference of a z_i.
struct RawVerifyReport : JudgedAnswer {
  Index row = -1;             ///< the worst; -1: every row holds exactly
  std::optional<double> z, w; ///< of that row
};

RawVerifyReport verify_raw(const RawProblem& problem, const std::vector<double>& z,
                           const VerifyOptions& options);

/// A line a sentence: wrap them as you like.
std::string verify_text(const SceneFile& file, const VerifyReport& report,
                        Telling telling = Telling::brief);
std::string verify_json(const VerifyReport& report, const std::vector<SceneDoubt>& warnings = {});
std::string verify_text(const RawVerifyReport& report, Telling telling = Telling::brief);
std::string verify_json(const RawVerifyReport& report);

} // namespace lcpush::desktop
