// A problem in a box as a mixed complementarity problem [T.14].
#pragma once

#include "lcpush/desktop/raw_problem.hpp"

namespace lcpush::desktop {

/// Each row of the box becomes none, one, two or three pairs; see the theory.
class BoxForm {
public:
  /// Precondition: problem.bounds are given, lo <= hi, and what another row follows is >= 0. It
  /// outlives the form.
  explicit BoxForm(const RawProblem& boxed);

  const RawProblem& problem() const { return problem_; }
  /// The unknowns of problem() at a point of the box.
  std::vector<double> inside(const std::vector<double>& z) const;
  /// Answer, ray and row numbers of problem() become those of the box; w is left out.
  void take_back(RawAnswer& answer) const;

private:
  enum class Kind { fixed, free, lower, upper, both, follows };
  /// z = at + sign * first unknown (- the second one, where it follows another row).
  struct Row {
    Kind kind;
    double at = 0, sign = 1;
    Index first = -1; ///< of problem_'s unknowns
  };

  const RawProblem& boxed_;
  RawProblem problem_;
  std::vector<Row> rows_;
  std::vector<Index> origin_; ///< row of the box, for each of problem_'s

  static Row row_of(const RawProblem& boxed, Index i);
  static Index unknowns_of(Kind kind);
  void add_row(Index i, double sign, Index multiplier);
  void add_limit(Index i);
  double place(Index i, const std::vector<double>& p) const;
};

} // namespace lcpush::desktop
