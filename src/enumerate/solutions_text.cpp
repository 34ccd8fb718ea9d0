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
constexpr std::size_t most_rows = 13;        // so that all of it is 20 lines
constexpr std::ptrdiff_t most_lines = 14;    // of rows that are broken

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

std::string sentence(const AllSolutions& found, const std::string& noun) {
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

class Table {
public:
  Table(const AllSolutions& found, const AllWording& wording, bool is_full)
      : found_(found), wording_(wording), has_w_(is_full || wording.rows > 0) {
    const auto names = [this](const std::string& name, std::size_t count) {
      for (std::size_t i = 1; i <= count; ++i) rows_[0].push_back(name + std::to_string(i));
    };
    if (found.sets.empty()) return;
    const std::size_t n = found.points.front().z.size(), m = static_cast<std::size_t>(wording.rows);
    rows_ = {{""}};
    names(m > 0 ? "row " : "z", m > 0 ? m : n);
    if (m > 0) names("column ", n - m);
    if (m > 0)
      rows_[0].insert(rows_[0].end(), {"row gets", "column gets"});
    else if (has_w_)
      names("w", n);
  }

  void add(const std::string& name, const SolutionSet& set) {
    const auto at = [](Index k) { return static_cast<std::size_t>(k); };
    for (const Index k : set.vertices)
      add(name + (set.dimension > 0 ? ", vertex" : ""), found_.points[at(k)].z,
          has_w_ ? found_.points[at(k)].w : ExactVector());
    for (const Index k : set.rays) add(name + ", direction", found_.rays[at(k)], {});
  }

  /// All rows, or as many as fit.
  std::string text(bool is_full) const {
    if (rows_.empty()) return "";
    std::size_t shown = is_full ? rows_.size() : std::min(rows_.size(), most_rows);
    const auto some = [&] {
      return table_text({rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(shown)});
    };
    std::string table = some();
    while (!is_full && shown > 2 && std::count(table.begin(), table.end(), '\n') > most_lines) {
      --shown;
      table = some();
    }
    const auto left = static_cast<Index>(rows_.size() - shown);
    return "\n" + table +
           (left > 0 ? "  .. and " + counted(left, "more row") + ", with -v or --json\n" : "");
  }

private:
  const AllSolutions& found_;
  const AllWording& wording_;
  bool has_w_;
  TableRows rows_;

  void add(const std::string& name, const ExactVector& z, const ExactVector& w) {
    std::vector<std::string> row = {name};
    for (const ExactVector* const numbers : {&z, &w})
      for (const Rational& x : *numbers) row.push_back(cell(x));
    row.resize(rows_[0].size());
    rows_.push_back(std::move(row));
  }

  std::string cell(const Rational& x) const {
    const std::string fraction = wording_.is_exact ? x.text() : number(x.value());
    return fraction.size() > longest_fraction ? "~" + number(x.value()) : fraction;
  }
};

} // namespace

std::string all_solutions_text(const AllSolutions& found, const AllWording& wording,
                               Telling telling) {
  const bool is_full = telling == Telling::full;
  const std::string noun = wording.rows > 0 ? "equilibrium" : kinds[0];
  Table table(found, wording, is_full);
  std::map<std::string, int> counts;
  std::map<Index, std::vector<std::string>> together;
  for (const SolutionSet& set : found.sets) {
    const std::string kind = set.dimension == 0 ? noun : kind_of(set),
                      name = kind + " " + std::to_string(++counts[kind]);
    table.add(name, set);
    if (set.dimension > 0) together[set.component].push_back(name);
  }
  std::string below;
  for (const auto& [component, names] : together)
    if (names.size() > 1) below += "Connected: " + listed(names, "and") + ".\n";
  std::string text =
      sentence(found, noun) + table.text(is_full) + (below.empty() ? "" : "\n" + below);
  if (found.complete())
    text += "\nProved in fractions: each choice of z_i = 0 or w_i = 0 was followed to its end, " +
            counted(found.cases, "case") + ".\n";
  return text;
}

} // namespace lcpush::desktop
