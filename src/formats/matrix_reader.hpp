// Matrix Market text, from top to bottom.
#pragma once

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <istream>
#include <system_error>

namespace lcpush::desktop {

inline constexpr const char* expected_banner = "%%MatrixMarket matrix array real general";

/// What a file says: the entries of an array column by column, or of a coordinate file as they
/// come.
template <class S> struct Parsed {
  struct Entry {
    std::size_t row, column;
    S value;
    int line;
  };
  std::size_t rows = 0, cols = 0;
  std::vector<S> values;
  std::vector<Entry> entries;
};

/// A line as long as this is no text. Longer ones end there, so that a file without newlines
/// (/dev/zero) does not end in memory; a column of 20,000 numbers fits.
constexpr std::size_t longest_line = std::size_t{1} << 20U;

/// Reads one file from top to bottom.
template <class S> class MatrixReader {
public:
  MatrixReader(std::istream& stream, std::uintmax_t bytes, std::string file, Entries kind,
               Index largest)
      : stream_(stream), bytes_(bytes), file_(std::move(file)), kind_(kind), largest_(largest),
        buffer_(longest_line) {}

  Parsed<S> read() {
    read_banner();
    if (is_array_)
      read_array();
    else
      read_coordinates();
    return std::move(parsed_);
  }

private:
  enum class Symmetry { general, symmetric, skew };

  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(file_, line_, message);
  }

  /// Splits the next line at its blanks; false at the end of the file.
  bool next_line() {
    errno = 0;
    stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    if (stream_.bad())
      throw InputError(file_ + ": cannot be read: " + std::generic_category().message(errno) +
                       "; name a readable file");
    auto length = static_cast<std::size_t>(stream_.gcount());
    if (length == 0 && stream_.eof()) return false;
    ++line_;
    if (stream_.fail()) refuse("the line is longer than a million characters; is it a text file?");
    if (!stream_.eof()) --length;
    std::string_view text(buffer_.data(), length);
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (line_ == 1 && text.substr(0, 3) == byte_order_mark) text.remove_prefix(3);
    if (line_ == 1 && text.substr(0, 2) == "\x1F\x8B")
      refuse("the file is compressed; unpack it on the way: gunzip -c FILE | lcpush lcp - q.mtx");
    line_text_ = text;
    words_ = split_words(line_text_);
    return true;
  }

  /// The same without blank and comment lines.
  bool next_data() {
    while (next_line())
      if (!words_.empty() && words_[0][0] != '%') return true;
    return false;
  }

  void read_banner() {
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
    require_word(banner[3], {"real", "integer", "double"}, "field");
    require_word(banner[4], {"general", "symmetric", "skew-symmetric"}, "symmetry");
    is_array_ = banner[2] == "array";
    symmetry_ = banner[4] == "general"     ? Symmetry::general
                : banner[4] == "symmetric" ? Symmetry::symmetric
                                           : Symmetry::skew;
  }

  void require_word(const std::string& word, const std::vector<std::string>& known,
                    const std::string& role) const {
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    refuse("the " + role + " " + quoted(word) + " is not supported, only " + listed(known, "and"));
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
      const Index limit = is_array_ ? largest_dimension : largest_;
      if (sizes[i] > static_cast<std::uint64_t>(limit))
        refuse(std::to_string(sizes[i]) + " " + what + " are too many; the limit is " +
               std::to_string(limit));
    }
    if (symmetry_ != Symmetry::general && sizes[0] != sizes[1])
      refuse("only a square matrix is symmetric; this one is " + std::to_string(sizes[0]) + " x " +
             std::to_string(sizes[1]));
    parsed_.rows = sizes[0];
    parsed_.cols = sizes[1];
    at_ = words_.size();
    return sizes;
  }

  std::uint64_t read_count(std::string_view word) const {
    const auto count = whole_number<std::uint64_t>(word);
    if (!count) refuse(quoted(word) + " is not a whole number >= 0 that fits in 64 bits");
    return *count;
  }

  S read_number(std::string_view word) const {
    if constexpr (std::is_same_v<S, double>)
      if (kind_ == Entries::bounds)
        if (const auto infinite = read_infinite(word)) return *infinite;
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

  /// The `count` words of the entry after `read` others; a line holds whole entries.
  const std::string_view* next_entry(std::size_t count, std::uint64_t read, std::uint64_t wanted) {
    if (at_ == words_.size()) {
      if (!next_data())
        refuse("the file ends after " + std::to_string(read) + " of " + std::to_string(wanted) +
               " entries");
      if (words_.size() % count != 0)
        refuse("expected \"ROW COLUMN VALUE\", got " + quoted(line_text_));
      at_ = 0;
    }
    at_ += count;
    return &words_[at_ - count];
  }

  void expect_end(std::uint64_t wanted) {
    const bool line_has_more = at_ < words_.size();
    if (line_has_more || next_data())
      refuse("the sizes promise " + std::to_string(wanted) +
             " entries, but here is more: " + quoted(line_has_more ? words_[at_] : line_text_));
  }

  /// Of a symmetric matrix a file holds the lower triangle, of a skew-symmetric one what is below
  /// the diagonal.
  std::size_t first_row(std::size_t column) const {
    return symmetry_ == Symmetry::general     ? 0
           : symmetry_ == Symmetry::symmetric ? column
                                              : column + 1;
  }

  /// Column by column, however many numbers a line has: as the format's own reader does.
  void read_array() {
    const auto sizes = read_sizes(2, "ROWS COLUMNS");
    const std::uint64_t rows = sizes[0], cols = sizes[1];
    const std::uint64_t wanted = symmetry_ == Symmetry::general     ? rows * cols
                                 : symmetry_ == Symmetry::symmetric ? rows * (rows + 1) / 2
                                                                    : rows * (rows - 1) / 2;
    require_plausible(wanted, 2);
    parsed_.values.assign(bytes_ == UINTMAX_MAX ? 0 : rows * cols, S(0));
    std::uint64_t read = 0;
    for (std::size_t j = 0; j < cols; ++j)
      for (std::size_t i = first_row(j); i < rows; ++i, ++read) {
        const std::string_view word = *next_entry(1, read, wanted);
        if (parsed_.values.empty()) parsed_.values.assign(rows * cols, S(0));
        const S value = read_number(word);
        parsed_.values[j * rows + i] = value;
        if (symmetry_ != Symmetry::general && i != j)
          parsed_.values[i * rows + j] = symmetry_ == Symmetry::skew ? S(-value) : value;
      }
    expect_end(wanted);
  }

  void read_coordinates() {
    const auto sizes = read_sizes(3, "ROWS COLUMNS ENTRIES");
    const std::uint64_t wanted = sizes[2];
    if (wanted > sizes[0] * sizes[1])
      refuse(std::to_string(wanted) + " entries do not fit into " + std::to_string(sizes[0]) +
             " x " + std::to_string(sizes[1]) + " places");
    require_plausible(wanted, 6);
    for (std::uint64_t read = 0; read < wanted; ++read) {
      const std::string_view* const words = next_entry(3, read, wanted);
      const std::size_t row = read_index(words[0], sizes[0], "row");
      const std::size_t column = read_index(words[1], sizes[1], "column");
      add_entry(row, column, read_number(words[2]));
    }
    expect_end(wanted);
    refuse_duplicates(parsed_.entries);
  }

  void add_entry(std::size_t row, std::size_t column, const S& value) {
    if (row < first_row(column))
      refuse(std::string(symmetry_ == Symmetry::skew
                             ? "a skew-symmetric file holds what is below the diagonal"
                             : "a symmetric file holds the diagonal and what is below it") +
             ", not row " + std::to_string(row + 1) + " of column " + std::to_string(column + 1));
    parsed_.entries.push_back({row, column, value, line_});
    if (symmetry_ != Symmetry::general && row != column)
      parsed_.entries.push_back(
          {column, row, symmetry_ == Symmetry::skew ? S(-value) : value, line_});
  }

  /// From 1 in the file, from 0 here.
  std::size_t read_index(std::string_view word, std::uint64_t size, const std::string& what) const {
    const std::uint64_t index = read_count(word);
    if (index < 1 || index > size)
      refuse(what + " " + std::to_string(index) + " is outside of 1 to " + std::to_string(size));
    return index - 1;
  }

  /// Sorts them row by row.
  void refuse_duplicates(std::vector<typename Parsed<S>::Entry>& entries) {
    const auto place = [](const auto& entry) { return std::pair(entry.row, entry.column); };
    std::sort(entries.begin(), entries.end(), [&](const auto& a, const auto& b) {
      return place(a) != place(b) ? place(a) < place(b) : a.line < b.line;
    });
    const auto twin =
        std::adjacent_find(entries.begin(), entries.end(),
                           [&](const auto& a, const auto& b) { return place(a) == place(b); });
    if (twin == entries.end()) return;
    line_ = (twin + 1)->line;
    refuse("this place already has an entry, in line " + std::to_string(twin->line));
  }

  std::istream& stream_;
  std::uintmax_t bytes_;
  std::string file_;
  Entries kind_;
  Index largest_; ///< dimension of a coordinate file
  std::vector<char> buffer_;
  int line_ = 0;
  bool is_array_ = true;
  Symmetry symmetry_ = Symmetry::general;
  std::string_view line_text_;          ///< in the buffer
  std::vector<std::string_view> words_; ///< of line_text_
  std::size_t at_ = 0;                  ///< the next of words_
  Parsed<S> parsed_;
};

} // namespace lcpush::desktop
