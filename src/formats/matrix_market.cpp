#include "lcpush/desktop/matrix_market.hpp"

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/text_file.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <system_error>

namespace lcpush::desktop {
namespace {

constexpr const char* expected_banner = "%%MatrixMarket matrix array real general";

/// ASCII letters only.
std::string lower_case(std::string_view word) {
  std::string result(word);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

/// Reads one file from top to bottom.
template <class S> class MatrixReader {
public:
  MatrixReader(std::istream& stream, std::uintmax_t bytes, std::string file)
      : stream_(stream), bytes_(bytes), file_(std::move(file)) {}

  MatrixOf<S> read() {
    const bool is_array = read_banner();
    return is_array ? read_array() : read_coordinates();
  }

private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(file_, line_, message);
  }

  /// Splits the next line at its blanks; false at the end of the file.
  bool next_line() {
    // A fixed length, so that a file without newlines (/dev/zero) ends here and not in memory.
    std::array<char, 1025> buffer;
    errno = 0;
    stream_.getline(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    if (stream_.bad())
      throw InputError(file_ + ": cannot be read: " + std::generic_category().message(errno) +
                       "; name a readable file");
    auto length = static_cast<std::size_t>(stream_.gcount());
    if (length == 0 && stream_.eof()) return false;
    ++line_;
    if (stream_.fail()) refuse("the line is longer than 1023 characters; is it a text file?");
    if (!stream_.eof()) --length;
    line_text_.assign(buffer.data(), length);
    words_ = split_words(line_text_);
    return true;
  }

  /// The same without blank and comment lines.
  bool next_data() {
    while (next_line())
      if (!words_.empty() && words_[0][0] != '%') return true;
    return false;
  }

  /// True for `array`, false for `coordinate`.
  bool read_banner() {
    if (!next_line()) {
      line_ = 1;
      refuse(std::string("the file is empty; a matrix starts with ") + quoted(expected_banner));
    }
    std::vector<std::string> banner;
    for (const std::string_view word : words_) banner.push_back(lower_case(word));
    if (banner.empty() || banner[0] != "%%matrixmarket")
      refuse(std::string("not a Matrix Market file; its first line must be like ") +
             quoted(expected_banner));
    if (banner.size() != 5)
      refuse(std::string("the first line needs five words, like ") + quoted(expected_banner));
    require_word(banner[1], {"matrix"}, "object");
    require_word(banner[2], {"array", "coordinate"}, "format");
    require_word(banner[3], {"real", "integer"}, "field");
    require_word(banner[4], {"general"}, "symmetry", "; write every entry of the matrix out");
    return banner[2] == "array";
  }

  void require_word(const std::string& word, const std::vector<std::string>& known,
                    const std::string& role, const std::string& remedy = "") const {
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    refuse("the " + role + " " + quoted(word) + " is not supported, only " + listed(known, "and") +
           remedy);
  }

  /// The line of sizes: `count` whole numbers, rows and columns first.
  std::vector<std::uint64_t> read_sizes(std::size_t count, const std::string& form) {
    if (!next_data())
      refuse("the file ends before its sizes; a line " + quoted(form) + " is missing");
    if (words_.size() != count)
      refuse("expected the sizes " + quoted(form) + ", got " + quoted(line_text_));
    std::vector<std::uint64_t> sizes;
    for (const std::string_view word : words_) sizes.push_back(read_count(word));
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string what = i == 0 ? "rows" : "columns";
      if (sizes[i] == 0) refuse("0 " + what + "; a matrix needs at least 1");
      if (sizes[i] > static_cast<std::uint64_t>(largest_dimension))
        refuse(std::to_string(sizes[i]) + " " + what + " are too many; the limit is " +
               std::to_string(largest_dimension));
    }
    return sizes;
  }

  std::uint64_t read_count(std::string_view word) const {
    const auto count = whole_number<std::uint64_t>(word);
    if (!count) refuse(quoted(word) + " is not a whole number >= 0 that fits in 64 bits");
    return *count;
  }

  S read_number(std::string_view word) const {
    const auto number = read_finite_number<S>(word);
    if (number.error) refuse(*number.error);
    return number.value;
  }

  /// An entry takes at least `bytes_each`: more than the file can hold are not worth memory.
  void require_plausible(std::uint64_t entries, std::uint64_t bytes_each) const {
    if (entries > bytes_ / bytes_each + 1)
      refuse("the sizes ask for " + std::to_string(entries) + " entries, but the file has only " +
             std::to_string(bytes_) + " bytes; is it cut off?");
  }

  void require_entry(std::size_t words, const std::string& form, std::uint64_t read,
                     std::uint64_t wanted) {
    if (!next_data())
      refuse("the file ends after " + std::to_string(read) + " of " + std::to_string(wanted) +
             " entries");
    if (words_.size() != words) refuse("expected " + form + ", got " + quoted(line_text_));
  }

  void require_end(std::uint64_t wanted) {
    if (next_data())
      refuse("the sizes promise " + std::to_string(wanted) +
             " entries, but here is more: " + quoted(line_text_));
  }

  MatrixOf<S> read_array() {
    const auto sizes = read_sizes(2, "ROWS COLUMNS");
    const std::uint64_t wanted = sizes[0] * sizes[1];
    require_plausible(wanted, 2);
    MatrixOf<S> matrix = shaped(sizes);
    matrix.values.reserve(wanted);
    for (std::uint64_t read = 0; read < wanted; ++read) {
      require_entry(1, "one entry a line, column by column", read, wanted);
      matrix.values.push_back(read_number(words_[0]));
    }
    require_end(wanted);
    return matrix;
  }

  struct Entry {
    std::size_t position;
    S value;
    int line;
  };

  MatrixOf<S> read_coordinates() {
    const auto sizes = read_sizes(3, "ROWS COLUMNS ENTRIES");
    const std::uint64_t wanted = sizes[2];
    if (wanted > sizes[0] * sizes[1])
      refuse(std::to_string(wanted) + " entries do not fit into " + std::to_string(sizes[0]) +
             " x " + std::to_string(sizes[1]) + " places");
    require_plausible(wanted, 6);
    std::vector<Entry> entries;
    for (std::uint64_t read = 0; read < wanted; ++read) {
      require_entry(3, "\"ROW COLUMN VALUE\"", read, wanted);
      const std::size_t row = read_index(words_[0], sizes[0], "row");
      const std::size_t column = read_index(words_[1], sizes[1], "column");
      entries.push_back({column * sizes[0] + row, read_number(words_[2]), line_});
    }
    require_end(wanted);
    refuse_duplicates(entries);

    MatrixOf<S> matrix = shaped(sizes);
    matrix.values.assign(sizes[0] * sizes[1], S(0));
    for (const Entry& entry : entries) matrix.values[entry.position] = entry.value;
    return matrix;
  }

  /// From 1 in the file, from 0 here.
  std::size_t read_index(std::string_view word, std::uint64_t size, const std::string& what) const {
    const std::uint64_t index = read_count(word);
    if (index < 1 || index > size)
      refuse(what + " " + std::to_string(index) + " is outside of 1 to " + std::to_string(size));
    return index - 1;
  }

  void refuse_duplicates(std::vector<Entry>& entries) {
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.position != b.position ? a.position < b.position : a.line < b.line;
    });
    const auto twin =
        std::adjacent_find(entries.begin(), entries.end(),
                           [](const Entry& a, const Entry& b) { return a.position == b.position; });
    if (twin == entries.end()) return;
    line_ = (twin + 1)->line;
    refuse("this place already has an entry, in line " + std::to_string(twin->line));
  }

  static MatrixOf<S> shaped(const std::vector<std::uint64_t>& sizes) {
    return {static_cast<Index>(sizes[0]), static_cast<Index>(sizes[1]), {}};
  }

  std::istream& stream_;
  std::uintmax_t bytes_;
  std::string file_;
  int line_ = 0;
  std::string line_text_;
  std::vector<std::string_view> words_; ///< of line_text_
};

} // namespace

template <class S> MatrixOf<S> read_matrix_market(const std::string& path) {
  std::ifstream stream = open_file(path);
  const std::streamoff bytes = stream.seekg(0, std::ios::end).tellg();
  stream.clear();
  stream.seekg(0);
  stream.clear();
  // Pipes and devices have no size; then nothing is refused for its length.
  return MatrixReader<S>(stream, bytes > 0 ? static_cast<std::uintmax_t>(bytes) : UINTMAX_MAX, path)
      .read();
}

template HostMatrix read_matrix_market(const std::string& path);
template ExactMatrix read_matrix_market(const std::string& path);

HostMatrix parse_matrix_market(const std::string& text, const std::string& file_name) {
  std::istringstream stream(text);
  return MatrixReader<double>(stream, text.size(), file_name).read();
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
