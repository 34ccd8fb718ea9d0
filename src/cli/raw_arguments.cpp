#include "raw_arguments.hpp"

#include "lcpush/host/input_error.hpp"

namespace lcpush::cli {
namespace {

/// How to read a matrix or a vector that is typed in place, and a file.
template <class S> struct Readers {
  host::MatrixOf<S> (*matrix)(std::string_view text, const std::string& option);
  host::MatrixOf<S> (*vector)(std::string_view text, const std::string& option);
  host::MatrixOf<S> (*file)(const std::string& path);
};

template <class S>
std::pair<host::MatrixOf<S>, host::MatrixOf<S>> read(const Arguments& arguments,
                                                     const Readers<S>& readers) {
  const auto M_text = arguments.value("--M"), q_text = arguments.value("--q");
  if (M_text.has_value() != q_text.has_value()) throw UsageError("--M and --q go together");
  if (M_text && !arguments.files().empty())
    throw UsageError("give either files or --M and --q, not both");
  host::MatrixOf<S> M, q;
  std::string of_M = "--M", of_q = "--q";
  if (M_text) {
    M = readers.matrix(*M_text, "--M");
    q = readers.vector(*q_text, "--q");
  } else {
    if (arguments.files().size() != 2)
      throw UsageError("two files are needed: M.mtx q.mtx (or --M \"2 1; 1 2\" --q \"-5 -6\")");
    of_M = arguments.files()[0];
    of_q = arguments.files()[1];
    M = readers.file(of_M);
    q = readers.file(of_q);
  }
  const Index n = M.rows;
  if (M.cols != n)
    throw host::InputError(of_M + ": M must be square, but it is " + std::to_string(n) + " x " +
                           std::to_string(M.cols));
  if (q.cols != 1 || q.rows != n)
    throw host::InputError(of_q + ": q must be " + std::to_string(n) +
                           " x 1 like M's rows, but it is " + std::to_string(q.rows) + " x " +
                           std::to_string(q.cols));
  return {std::move(M), std::move(q)};
}

} // namespace

std::pair<host::HostMatrix, host::HostMatrix> read_matrices(const Arguments& arguments) {
  return read<double>(
      arguments, {host::parse_inline_matrix, host::parse_inline_vector, host::read_matrix_market});
}

std::pair<host::ExactMatrix, host::ExactMatrix> read_matrices_exactly(const Arguments& arguments) {
  return read<host::Rational>(arguments,
                              {host::parse_inline_matrix_exactly, host::parse_inline_vector_exactly,
                               host::read_matrix_market_exactly});
}

} // namespace lcpush::cli
