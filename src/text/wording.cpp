#include "text/wording.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "text/utf8.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace lcpush::desktop {
namespace {

constexpr std::size_t longest_shown = 48;
constexpr std::size_t least_part = 4; ///< letters of a word that name a longer one

/// Insertions, deletions, substitutions and swapped neighbours between two short words.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  // between the beginnings of i and j letters
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      d[i][j] = i + j;
      if (i == 0 || j == 0) continue;
      const std::size_t substituted = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({substituted, d[i - 1][j] + 1, d[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// In small letters, without the dashes that make a word an option.
std::string letters_of(std::string_view word) {
  std::string letters(word.substr(std::min(word.find_first_not_of('-'), word.size())));
  for (char& c : letters)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return letters;
}

/// Words of other people for ours.
constexpr const char* others_words[][2] = {
    {"circle", "disc"}, {"square", "rectangle"}, {"duration", "--time"}, {"tex", "latex"}};

} // namespace

InputError::InputError(const std::string& file, int line, const std::string& message)
    : std::runtime_error(file + ":" + std::to_string(line) + ": " + message), file_(file),
      message_(message), line_(line) {}

std::string quoted(std::string_view text) {
  std::size_t length = std::min(text.size(), longest_shown);
  while (length < text.size() && length > 0 && continues_character(text[length])) --length;
  const bool has_quotes = text.find('"') < text.size() && text.find('\'') >= text.size();
  const std::string quote = has_quotes ? "'" : "\"";
  std::string result = quote;
  for (const char c : text.substr(0, length)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      constexpr std::string_view digits = "0123456789ABCDEF";
      result += {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
    } else {
      result += c;
    }
  }
  return result + (length < text.size() ? "..." : "") + quote;
}

std::string shown(double number) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return std::string(buffer.data(), end);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  const std::string letters = letters_of(word);
  for (const auto& [other, ours] : others_words)
    if (letters == other && std::find(known.begin(), known.end(), ours) != known.end())
      return std::string(" (did you mean \"") + ours + "\"?)";
  if (letters.empty() || letters.size() > longest_shown) return "";
  // Half of the letters wrong, or more than three, is another word rather than a slip.
  std::size_t nearest = std::clamp<std::size_t>((letters.size() - 1) / 2, 1, 3) + 1;
  std::string best, longer;
  bool is_last = false;
  for (const std::string& candidate : known) {
    const std::string its_letters = letters_of(candidate);
    if (const std::size_t at = its_letters.rfind(letters);
        letters.size() >= least_part && at != std::string::npos && !is_last) {
      longer = candidate; // rather where the word is the last part of a path
      is_last = at + letters.size() == its_letters.size();
    }
    const std::size_t distance = edit_distance(letters, its_letters);
    if (distance >= nearest) continue;
    nearest = distance;
    best = candidate;
  }
  if (best.empty()) best = longer;
  return best.empty() ? "" : " (did you mean \"" + best + "\"?)";
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r"; // some ends of lines are two characters
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::vector<std::string_view> split_at(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string result;
  for (const std::string& word : words) result += (&word == words.data() ? "" : separator) + word;
  return result;
}

std::string listed(const std::vector<std::string>& words, const std::string& conjunction) {
  if (words.size() < 2) return joined(words, "");
  return joined({words.begin(), words.end() - 1}, ", ") + " " + conjunction + " " + words.back();
}

} // namespace lcpush::desktop
