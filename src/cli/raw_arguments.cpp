#include "cli/raw_arguments.hpp"

#include "cli/raw_bounds.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"
#include "text/wording.hpp"

#include <charconv>
#include <filesystem>

namespace lcpush::cli {
namespace {

/// The rows of --free, and how messages name them: "7,8", or the file that holds such a line.
struct FreeRows {
  std::string list, where = "--free";
};
FreeRows free_rows(const std::string& given) {
  const bool is_typed = given.empty() || (given[0] >= '0' && given[0] <= '9') || given[0] == '-';
  std::error_code ignored;
  if (is_typed || !std::filesystem::is_regular_file(given, ignored)) return {given};
  std::string list = read_text_file(given, limits::matrix_bytes);
  list.erase(list.find_last_not_of(" \t\r\n") + 1);
  return {list, given + ": --free"};
}

/// 1-based rows; nothing is free if the option is not given, or its file is empty.
std::vector<unsigned char> read_free(const Arguments& arguments, Index n) {
  std::vector<unsigned char> free(static_cast<std::size_t>(n), 0);
  if (!arguments.has("--free")) return free;
  const FreeRows rows = free_rows(*arguments.value("--free"));
  if (rows.list.empty() && rows.where != "--free") return free;
  const char* at = rows.list.data();
  const char* const end = at + rows.list.size();
  for (;;) {
    Index row = 0;
    const auto [rest, error] = std::from_chars(at, end, row);
    if (error != std::errc() || row < 1 || row > n)
      throw UsageError(rows.where + " is a list of rows from 1 to " + std::to_string(n) +
                       " such as 7,8, or a file of it, not " + desktop::quoted(rows.list));
    unsigned char& is_free = free[static_cast<std::size_t>(row - 1)];
    if (is_free != 0) throw UsageError(rows.where + " names row " + std::to_string(row) + " twice");
    is_free = 1;
    if (rest == end) return free;
    if (*rest != ',')
      throw UsageError(rows.where + " wants commas between rows: " + desktop::quoted(rows.list));
    at = rest + 1;
  }
}

/// Where M and q come from: two files, or the command line.
struct MatrixNames {
  bool typed = false;
  std::string M = "--M", q = "--q"; ///< as messages name them, and the paths of files
};

MatrixNames names_of(const Arguments& arguments, const std::vector<std::string>& files) {
  const bool typed = arguments.has("--M");
  if (typed != arguments.has("--q")) throw UsageError("--M and --q go together");
  if (typed && !files.empty()) throw UsageError("give either files or --M and --q, not both");
  if (typed) return {true};
  if (files.size() != 2)
    throw UsageError("two files are needed: M.mtx q.mtx (or --M \"2 1; 1 2\" --q \"-5 -6\")");
  return {false, files[0], files[1]};
}

void check_sizes(const MatrixNames& names, Index rows, Index cols, Index q_rows, Index q_cols) {
  const auto by = [](Index m, Index n) { return std::to_string(m) + " x " + std::to_string(n); };
  if (cols != rows) throw InputError(names.M + ": M must be square, but it is " + by(rows, cols));
  if (q_cols != 1 || q_rows != rows)
    throw InputError(names.q + ": q must be " + by(rows, 1) + " like M's rows, but it is " +
                     by(q_rows, q_cols));
}

} // namespace

template <class S>
std::pair<MatrixOf<S>, MatrixOf<S>> read_matrices(const Arguments& arguments,
                                                  const std::vector<std::string>& files) {
  const MatrixNames names = names_of(arguments, files);
  MatrixOf<S> M = names.typed ? parse_inline_matrix<S>(*arguments.value("--M"), "--M")
                              : read_matrix_market<S>(names.M);
  MatrixOf<S> q = names.typed ? parse_inline_vector<S>(*arguments.value("--q"), "--q")
                              : read_matrix_market<S>(names.q);
  check_sizes(names, M.rows, M.cols, q.rows, q.cols);
  return {std::move(M), std::move(q)};
}
template std::pair<ExactMatrix, ExactMatrix> read_matrices(const Arguments& arguments,
                                                           const std::vector<std::string>& files);

RawProblem read_raw_problem(const Arguments& arguments, const std::vector<std::string>& files) {
  const MatrixNames names = names_of(arguments, files);
  RawProblem problem;
  problem.M = names.typed ? rows_of(parse_inline_matrix(*arguments.value("--M"), "--M"))
                          : read_sparse_matrix(names.M);
  HostMatrix q = names.typed ? parse_inline_vector(*arguments.value("--q"), "--q")
                             : read_matrix_market(names.q);
  check_sizes(names, problem.M.rows(), problem.M.cols, q.rows, q.cols);
  problem.q = std::move(q.values);
  problem.free = read_free(arguments, problem.size());
  problem.bounds = read_bounds(arguments, problem.size());
  return problem;
}

} // namespace lcpush::cli
