#include "lcpush/desktop/matrix_market.hpp"

#include "formats/matrix_reader.hpp"
#include "text/text_file.hpp"

#include <cmath>
#include <iostream>
#include <sstream>

namespace lcpush::desktop {
namespace {

template <class S> MatrixOf<S> whole(Parsed<S> parsed) {
  MatrixOf<S> matrix{static_cast<Index>(parsed.rows), static_cast<Index>(parsed.cols),
                     std::move(parsed.values)};
  if (matrix.values.empty()) matrix.values.assign(parsed.rows * parsed.cols, S(0));
  for (const auto& entry : parsed.entries)
    matrix.values[entry.column * parsed.rows + entry.row] = entry.value;
  return matrix;
}

SparseRows sparse(Parsed<double> parsed) {
  if (!parsed.values.empty()) return rows_of(whole(std::move(parsed)));
  SparseRows matrix;
  matrix.cols = static_cast<Index>(parsed.cols);
  auto entry = parsed.entries.begin();
  for (std::size_t i = 0; i < parsed.rows; ++i) {
    for (; entry != parsed.entries.end() && entry->row == i; ++entry)
      if (entry->value != 0) matrix.add(static_cast<Index>(entry->column), entry->value);
    matrix.end_row();
  }
  return matrix;
}

template <class S> Parsed<S> parse_file(const std::string& path, Entries kind, Index largest) {
  // Pipes and devices have no size; then nothing is refused for its length.
  if (path == "-")
    return MatrixReader<S>(std::cin, UINTMAX_MAX, file_label(path), kind, largest).read();
  std::ifstream stream = open_file(path);
  const std::streamoff bytes = stream.seekg(0, std::ios::end).tellg();
  stream.clear();
  stream.seekg(0);
  stream.clear();
  return MatrixReader<S>(stream, bytes > 0 ? static_cast<std::uintmax_t>(bytes) : UINTMAX_MAX, path,
                         kind, largest)
      .read();
}

Parsed<double> parse_text(const std::string& text, const std::string& file_name, Index largest) {
  std::istringstream stream(text);
  return MatrixReader<double>(stream, text.size(), file_name, Entries::finite, largest).read();
}

} // namespace

template <class S> MatrixOf<S> read_matrix_market(const std::string& path, Entries kind) {
  return whole(parse_file<S>(path, kind, largest_dimension));
}
template HostMatrix read_matrix_market(const std::string& path, Entries kind);
template ExactMatrix read_matrix_market(const std::string& path, Entries kind);

SparseRows read_sparse_matrix(const std::string& path) {
  return sparse(parse_file<double>(path, Entries::finite, largest_sparse_dimension));
}

HostMatrix parse_matrix_market(const std::string& text, const std::string& file_name) {
  return whole(parse_text(text, file_name, largest_dimension));
}

SparseRows parse_sparse_matrix(const std::string& text, const std::string& file_name) {
  return sparse(parse_text(text, file_name, largest_sparse_dimension));
}

SparseRows rows_of(const HostMatrix& matrix) {
  SparseRows rows;
  rows.cols = matrix.cols;
  for (Index i = 0; i < matrix.rows; ++i) {
    for (Index j = 0; j < matrix.cols; ++j)
      if (matrix(i, j) != 0) rows.add(j, matrix(i, j));
    rows.end_row();
  }
  return rows;
}

std::string write_matrix_market(const HostMatrix& matrix, MatrixMarketFormat format,
                                const std::string& comment) {
  const bool is_array = format == MatrixMarketFormat::array;
  const auto is_written = [is_array](double value) {
    return is_array || value != 0 || std::signbit(value);
  };
  std::string text = "%%MatrixMarket matrix ";
  text += is_array ? "array real general\n" : "coordinate real general\n";
  if (!comment.empty()) text += "% " + comment + "\n";
  text += std::to_string(matrix.rows) + " " + std::to_string(matrix.cols);
  if (!is_array)
    text +=
        " " + std::to_string(std::count_if(matrix.values.begin(), matrix.values.end(), is_written));
  text += '\n';
  for (Index j = 0; j < matrix.cols; ++j)
    for (Index i = 0; i < matrix.rows; ++i) {
      if (!is_written(matrix(i, j))) continue;
      if (!is_array) text += std::to_string(i + 1) + " " + std::to_string(j + 1) + " ";
      text += shown(matrix(i, j)) + "\n";
    }
  return text;
}

} // namespace lcpush::desktop
