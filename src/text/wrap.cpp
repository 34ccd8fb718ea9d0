#include "text/wrap.hpp"

#include "text/utf8.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace lcpush::desktop {
namespace {

/// Where the words after a gap of two blanks or more begin; the first word of the line is no such.
std::vector<std::size_t> gap_ends(std::string_view line) {
  std::vector<std::size_t> ends;
  const std::size_t first = line.find_first_not_of(' ');
  for (std::size_t at = line.find("  ", first); at < line.size(); at = line.find("  ", at)) {
    at = line.find_first_not_of(' ', at);
    if (at == std::string_view::npos) break;
    ends.push_back(at);
  }
  return ends;
}

std::string wrapped_line(std::string_view line, std::size_t width) {
  std::vector<std::size_t> gaps = gap_ends(line);
  // A comment after a long sentence: what stands before it is no label.
  if (gaps.size() == 1 && gaps.front() > width - width / 4) gaps.clear();
  if (text_columns(line) <= width || gaps.size() > 1) return std::string(line);
  std::size_t start = gaps.empty() ? line.find_first_not_of(' ') : gaps.front();
  if (line.substr(start, 2) == "- ") start += 2; // an entry of a list
  const std::string indent(start, ' ');
  std::string text(line.substr(0, start));
  std::size_t column = start;
  while (start < line.size()) {
    const std::size_t end = std::min(line.find(' ', start), line.size());
    const std::string_view word = line.substr(start, end - start);
    if (column > indent.size()) {
      const bool fits = column + 1 + text_columns(word) <= width;
      text += fits ? std::string(" ") : "\n" + indent;
      column = fits ? column + 1 : indent.size();
    }
    text += word;
    column += text_columns(word);
    start = end + 1;
  }
  return text;
}

} // namespace

std::size_t text_columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

std::string wrapped(const std::string& text, std::size_t width) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    result += wrapped_line(std::string_view(text).substr(at, end - at), width);
    if (end < text.size()) result += '\n';
    at = end + 1;
  }
  return result;
}

std::string reflowed(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool ends_line = text[at] == '\n';
    const char before = result.empty() ? '\n' : result.back();
    const char after = at + 1 < text.size() ? text[at + 1] : '\n';
    const std::size_t start = result.rfind('\n');
    const bool is_prose =
        before != '\n' && result[start == std::string::npos ? 0 : start + 1] != ' ';
    result += ends_line && is_prose && after != '\n' && after != ' ' ? ' ' : text[at];
  }
  return result;
}

} // namespace lcpush::desktop
