// What `lcpush lcp --all` says.
#include <algorithm>
#include <cctype>
#include <map>

#include "lcpush/desktop/all_solutions.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr std::size_t longest_fraction = 16; // characters of a cell
constexpr std::size_t most_lines = 11;       // of the table, so that all of it is 20
constexpr std::size_t most_names = 5, most_lists = 2;

/// By dimension and directions; in the order in which they are told.
const std::vector<std::string> kinds = {"solution", "segment",  "half-line",    "line",
                                        "polygon",  "polytope", "unbounded set"};

const std::string& kind_of(const SolutionSet& set) {
  if (set.dimension < 2) return kinds[static_cast<std::size_t>(set.dimension) + set.rays.size()];
  return kinds[!set.rays.empty() ? 6 : set.dimension == 2 ? 4 : 5];
}

/// "3 solutions", "one segment", "2 equilibria".
std::string several(Index count, const std::string& word) {
  if (count == 1) return "one " + word;
  const bool is_latin = word.back() == 'm';
  return std::to_string(count) + " " +
         (is_latin ? word.substr(0, word.size() - 2) + "a" : word + "s");
}

std::string noun_of(const AllWording& wording) {
  return wording.rows > 0 ? "equilibrium" : kinds[0];
}

/// The table's first row.
std::vector<std::string> headings(const AllSolutions& found, Index rows, bool has_w) {
  std::vector<std::string> row = {""};
  const auto add = [&row](const std::string& name, Index count) {
    for (Index i = 1; i <= count; ++i) row.push_back(name + std::to_string(i));
  };
  const auto n = static_cast<Index>(found.points.front().z.size());
  if (rows > 0) {
    add("row ", rows);
    add("column ", n - rows);
    row.insert(row.end(), {"row gets", "column gets"});
  } else {
    add("z", n);
    if (has_w) add("w", n);
  }
  return row;
}

std::vector<std::string> table_row(const std::string& name, const ExactVector& z,
                                   const ExactVector& w, bool is_exact) {
  std::vector<std::string> row = {name};
  for (const ExactVector* const numbers : {&z, &w})
    for (const Rational& x : *numbers) {
      const std::string text = is_exact ? x.text() : number(x.value());
      row.push_back(text.size() > longest_fraction ? "~" + number(x.value()) : text);
    }
  return row;
}

/// All rows, or as many as fit.
std::string table_of(const TableRows& rows, bool is_full) {
  std::size_t shown = is_full ? rows.size() : std::min(rows.size(), most_lines);
  for (;; --shown) {
    const auto end = rows.begin() + static_cast<std::ptrdiff_t>(shown);
    const std::string table = table_text({rows.begin(), end});
    const auto lines = static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n'));
    if (!is_full && shown > 2 && lines > most_lines) continue;
    const auto left = static_cast<Index>(rows.size() - shown);
    return table +
           (left > 0 ? "  .. and " + counted(left, "more row") + ", with -v or --json\n" : "");
  }
}

} // namespace

std::string all_solutions_sentence(const AllSolutions& found, const AllWording& wording) {
  const std::string noun = noun_of(wording);
  std::map<std::string, Index> counts;
  for (const SolutionSet& set : found.sets) ++counts[kind_of(set)];
  const bool is_plain = counts.size() == counts.count(kinds[0]); // isolated ones alone, or none
  std::vector<std::string> parts;
  for (const std::string& kind : kinds)
    if (const auto place = counts.find(kind); place != counts.end())
      parts.push_back(
          several(place->second, kind != kinds[0] ? kind : (is_plain ? "" : "isolated ") + noun));
  std::string text = parts.empty()      ? "There is no " + noun
                     : found.complete() ? listed(parts, "and")
                                        : "at least " + listed(parts, "and");
  if (!is_plain) text += " of " + several(2, noun).substr(2);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (found.complete()) return text + (parts.empty() ? ".\n" : ", and that is all.\n");
  return (parts.empty() ? "No " + noun + " was found yet" : text) +
         "; there may be more: the search ended " +
         (found.stop == Stop::none ? "at --most " + std::to_string(found.most) : "early") + ".\n";
}

std::string all_solutions_text(const AllSolutions& found, const AllWording& wording,
                               Telling telling) {
  const bool is_full = telling == Telling::full, has_w = is_full || wording.rows > 0;
  const std::string noun = noun_of(wording);
  TableRows rows;
  std::map<std::string, int> counts;
  std::map<Index, std::vector<std::string>> together;
  for (const SolutionSet& set : found.sets) {
    const std::string kind = set.dimension == 0 ? noun : kind_of(set),
                      name = kind + " " + std::to_string(++counts[kind]);
    if (rows.empty()) rows.push_back(headings(found, wording.rows, has_w));
    for (const Index k : set.vertices) {
      const auto& [z, w] = found.points[static_cast<std::size_t>(k)];
      rows.push_back(table_row(name + (set.dimension > 0 ? ", vertex" : ""), z,
                               has_w ? w : ExactVector(), wording.is_exact));
    }
    for (const Index k : set.rays)
      rows.push_back(table_row(name + ", direction", found.rays[static_cast<std::size_t>(k)], {},
                               wording.is_exact));
    if (set.dimension > 0) together[set.component].push_back(name);
  }
  for (auto& row : rows) row.resize(rows.front().size());
  std::string below;
  std::size_t lists = 0;
  for (auto& [component, names] : together) {
    if (names.size() < 2 || (!is_full && ++lists > most_lists)) continue;
    if (const std::size_t count = names.size(); !is_full && count > most_names) {
      names.resize(most_names);
      names.push_back(std::to_string(count - most_names) + " more");
    }
    below += "Connected: " + listed(names, "and") + ".\n";
  }
  std::string text = all_solutions_sentence(found, wording);
  if (!rows.empty()) text += "\n" + table_of(rows, is_full);
  if (!below.empty()) text += "\n" + below;
  if (found.complete())
    text += "\nProved in fractions: each choice of z_i = 0 or w_i = 0 was followed to its end, " +
            counted(found.cases, "case") + ".\n";
  return text;
}

} // namespace lcpush::desktop
