// M and q of a raw problem, from two files or typed in place.
#pragma once

#include <utility>

#include "cli/arguments.hpp"
#include "lcpush/desktop/raw_problem.hpp"

namespace lcpush::cli {

/// M, n x n, and q, n x 1: of --M and --q, or of two files; S = Rational takes every number as
/// typed. Throws UsageError and InputError.
template <class S>
std::pair<MatrixOf<S>, MatrixOf<S>> read_matrices(const Arguments& arguments,
                                                  const std::vector<std::string>& files);

/// These, with the rows of --free.
RawProblem read_raw_problem(const Arguments& arguments, const std::vector<std::string>& files);

} // namespace lcpush::cli
