// The referee of raw problems, with what it needs to know of M once.
#pragma once

#include "lcpush/desktop/raw_problem.hpp"

namespace lcpush::desktop {

/// Powers of two.
struct Scales {
  std::vector<double> row, column;
};
/// R and C for which the largest entries of all rows and columns of R M C are near 1.
Scales balanced_scales(const SparseRows& M, int passes);

/// [T.11] on sparse rows. The unit of an unknown is its column's scale, so that units do not
/// matter.
class Referee {
public:
  /// `problem` outlives it.
  explicit Referee(const RawProblem& problem);

  /// w becomes M z + q. Cost: four passes over the entries of M.
  WorstRow<double> judge(const std::vector<double>& z, std::vector<double>& w);

private:
  const RawProblem& problem_;
  std::vector<double> unit_, size_, caught_, scale_, share_;

  void measure_unknowns(const std::vector<double>& z);
  void measure_rows(const std::vector<double>& z, std::vector<double>& w);
};

} // namespace lcpush::desktop
