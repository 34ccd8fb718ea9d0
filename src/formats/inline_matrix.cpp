#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

template <class S> std::vector<S> read_row(std::string_view text, const std::string& where) {
  std::vector<S> row;
  for (const std::string_view part : split_at(text, ',')) {
    const std::vector<std::string_view> words = split_words(part);
    if (words.empty()) throw InputError(where + "a number is missing in " + quoted(text));
    for (const std::string_view word : words) {
      const NumberTextOf<S> number = read_number_or_fraction<S>(word);
      if (number.error) throw InputError(where + *number.error);
      row.push_back(number.value);
    }
  }
  return row;
}

} // namespace

namespace {

/// What MATLAB, NumPy and pages write about a matrix: "M = np.array(..);", "..." at the end of a
/// line, "[-5 -6]'", a minus that is no hyphen. The end of a line within ends a row, unless a comma
/// goes on.
std::string pasted(std::string_view given) {
  std::string text(given);
  constexpr std::string_view minus = "\xE2\x88\x92";
  for (std::size_t at; (at = text.find(minus)) != std::string::npos;)
    text.replace(at, minus.size(), "-");
  if (const std::size_t at = text.find("]'"); at != std::string::npos && text.find(';') > at)
    text.erase(at + 1, 1); // of a vector, which is a column anyway
  for (std::size_t at; (at = text.find("...")) != std::string::npos;)
    text.replace(at, text.substr(at + 3, 1) == "\n" ? 4 : 3, " ");
  if (const std::size_t at = text.find('='); at != std::string::npos) text.erase(0, at + 1);
  for (const char* word : {"np.", "numpy.", "array(", "matrix(", ")"})
    if (const std::size_t at = text.find(word); at != std::string::npos)
      text.erase(at, std::string_view(word).size());
  const auto blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  char last = ';';
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool goes_on = last == ';' || last == ',' || last == '[' || last == ']';
    if (text[at] == '\n' && !goes_on) text[at] = last = ';';
    if (!blank(text[at])) last = text[at];
  }
  return text;
}

} // namespace

std::string without_brackets(std::string_view given) {
  const std::string text = pasted(given);
  std::string plain;
  int depth = 0;
  bool ends_row = false;
  for (const char c : text) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ']' && depth == 1) ends_row = true;
    if (c == '[' && ends_row) plain += ';';
    if (c == '[') ends_row = false;
    const bool is_between = ends_row && (c == ',' || c == ' ' || c == '\n');
    if (c != '[' && c != ']' && !is_between) plain += c;
  }
  const bool is_closed = depth == 0 && plain.size() < text.size();
  if (!is_closed) return text;
  const std::size_t last = plain.find_last_not_of(" ;");
  return last == std::string::npos ? plain : plain.substr(0, last + 1);
}

template <class S>
MatrixOf<S> parse_inline_matrix(std::string_view given, const std::string& option) {
  std::vector<std::vector<S>> rows;
  const std::string text = without_brackets(given);
  for (const std::string_view part : split_at(text, ';')) {
    const std::string where = option + ": row " + std::to_string(rows.size() + 1) + ": ";
    rows.push_back(read_row<S>(part, where));
    if (rows.back().size() != rows.front().size())
      throw InputError(where + "expected " + std::to_string(rows.front().size()) +
                       " numbers, as in row 1, got " + std::to_string(rows.back().size()));
  }
  MatrixOf<S> matrix{static_cast<Index>(rows.size()), static_cast<Index>(rows.front().size()), {}};
  for (std::size_t j = 0; j < rows.front().size(); ++j)
    for (const std::vector<S>& row : rows) matrix.values.push_back(row[j]);
  return matrix;
}

template <class S>
MatrixOf<S> parse_inline_vector(std::string_view text, const std::string& option) {
  MatrixOf<S> matrix = parse_inline_matrix<S>(text, option);
  if (matrix.rows != 1 && matrix.cols != 1)
    throw InputError(option + ": expected a vector like \"-5 -6\", got a matrix of " +
                     std::to_string(matrix.rows) + " x " + std::to_string(matrix.cols));
  return {matrix.rows * matrix.cols, 1, std::move(matrix.values)};
}

template HostMatrix parse_inline_matrix(std::string_view text, const std::string& option);
template HostMatrix parse_inline_vector(std::string_view text, const std::string& option);
template ExactMatrix parse_inline_matrix(std::string_view text, const std::string& option);
template ExactMatrix parse_inline_vector(std::string_view text, const std::string& option);

} // namespace lcpush::desktop
