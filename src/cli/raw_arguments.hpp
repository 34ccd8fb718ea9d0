// M and q of a raw problem, from two files or typed in place.
#pragma once

#include <utility>

#include "cli/arguments.hpp"
#include "lcpush/desktop/raw_problem.hpp"

namespace lcpush::cli {

/// M, n x n, and q, n x 1: of --M and --q, or of two files. Throws UsageError and InputError.
std::pair<desktop::HostMatrix, desktop::HostMatrix>
read_matrices(const Arguments& arguments, const std::vector<std::string>& files);
/// The same with every number taken as typed.
std::pair<desktop::ExactMatrix, desktop::ExactMatrix>
read_matrices_exactly(const Arguments& arguments);

/// These, with the rows of --free.
desktop::RawProblem read_raw_problem(const Arguments& arguments,
                                     const std::vector<std::string>& files);

} // namespace lcpush::cli
