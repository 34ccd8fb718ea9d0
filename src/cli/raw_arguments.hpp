// M and q of a raw problem, from two files or typed in place.
#pragma once

#include <utility>

#include "arguments.hpp"
#include "lcpush/host/matrix_market.hpp"

namespace lcpush::cli {

/// M, n x n, and q, n x 1. Throws UsageError and InputError.
std::pair<host::HostMatrix, host::HostMatrix> read_matrices(const Arguments& arguments);
/// The same with every number taken as typed.
std::pair<host::ExactMatrix, host::ExactMatrix> read_matrices_exactly(const Arguments& arguments);

} // namespace lcpush::cli
