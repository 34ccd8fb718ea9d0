// What a raw problem is given by beside files; its box: --lo, --hi and --findex.
#pragma once

#include "cli/arguments.hpp"
#include "lcpush/desktop/raw_problem.hpp"

namespace lcpush::cli {

inline const Option matrix_option{"--M", "MATRIX", "rows by semicolons, numbers by blanks"};
inline const Option vector_option{"--q", "VECTOR", "n numbers"};
inline const Option free_option{"--free", "I,J,..",
                                "1-based rows that are equalities, or a file of them"};
inline const Option lo_option{"--lo", "ENDS", "lower ends of z: a file, numbers, or one for all"};
inline const Option hi_option{"--hi", "ENDS", "upper ends; friction where --findex names a row"};
inline const Option findex_option{"--findex", "ROWS",
                                  "-1, or from 0 the row j with ends -hi z_j and hi z_j"};

/// Of n rows; none if no option is given. Throws UsageError and InputError.
RawBounds read_bounds(const Arguments& arguments, Index n);

} // namespace lcpush::cli
