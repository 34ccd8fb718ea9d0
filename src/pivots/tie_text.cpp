// What decides a tie by the lexicographic rule: how the tied ratios grow with q + (e, e^2, ..).
#include "pivots/tie_text.hpp"

#include <algorithm>
#include <cmath>

#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr std::size_t most_compared = 5; // ratios in one sentence

TraceNumber times_sign(TraceNumber x, int sign) {
  if (sign > 0 || x.value == 0) return x;
  x.value = -x.value;
  if (!x.fraction.empty())
    x.fraction = x.fraction[0] == '-' ? x.fraction.substr(1) : "-" + x.fraction;
  return x;
}

TraceNumber over(const TraceNumber& x, const TraceNumber& y) {
  TraceNumber result{x.value / y.value, ""};
  const auto a = Rational::parse(x.fraction), b = Rational::parse(y.fraction);
  if (a && b) result.fraction = (*a / *b).text();
  return result;
}

/// Of a row of a dictionary: its value's part of e^(i+1). w_i stands beside it as w_i - e^(i+1).
TraceNumber part_of(const Tableau& tableau, std::size_t row, Index i) {
  const bool has_fractions = !tableau.entry(row, 0).fraction.empty();
  const auto at = std::find(tableau.columns.begin(), tableau.columns.end(), slack(i));
  if (at != tableau.columns.end())
    return times_sign(tableau.entry(row, static_cast<std::size_t>(at - tableau.columns.begin())),
                      -1);
  const bool is_own = tableau.rows[row] == slack(i);
  return {is_own ? 1.0 : 0.0, !has_fractions ? "" : is_own ? "1" : "0"};
}

/// "1/3 e - 2 e^3 + .."
std::string series_text(const TraceNumber& begin, const std::vector<TraceNumber>& parts,
                        bool has_more) {
  const auto plain = [](const TraceNumber& x) {
    return x.fraction.empty() ? number(x.value) : x.fraction;
  };
  std::string text = begin.value == 0 ? "" : plain(begin);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].value == 0) continue;
    std::string size = plain(times_sign(parts[i], parts[i].value < 0 ? -1 : 1));
    size = size == "1" ? "" : size + " ";
    const bool is_negative = parts[i].value < 0;
    text += text.empty() ? (is_negative ? "-" : "") : is_negative ? " - " : " + ";
    text += size + (i == 0 ? "e" : "e^" + std::to_string(i + 1));
  }
  if (text.empty()) text = "0";
  return text + (has_more ? " + .." : "");
}

} // namespace

std::string lexicographic_text(const PivotTrace& trace, const TracedPivot& pivot) {
  if (!pivot.before || pivot.ties.size() > most_compared) return "";
  const Tableau& tableau = *pivot.before;
  const bool covers = pivot.entering == 2 * trace.size; // the most violated row: it needs most z0
  std::vector<std::size_t> rows;
  std::vector<std::vector<TraceNumber>> parts(pivot.ties.size());
  for (const Index variable : pivot.ties)
    rows.push_back(static_cast<std::size_t>(
        std::find(tableau.rows.begin(), tableau.rows.end(), variable) - tableau.rows.begin()));
  std::vector<std::size_t> left(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) left[k] = k;
  Index i = 0;
  for (; i < trace.size && left.size() > 1; ++i) {
    for (std::size_t k = 0; k < rows.size(); ++k)
      parts[k].push_back(
          over(part_of(tableau, rows[k], i),
               times_sign(tableau.entry(rows[k], static_cast<std::size_t>(pivot.column)), -1)));
    double best = 0;
    for (const std::size_t k : left) {
      const double part = (covers ? -1 : 1) * parts[k].back().value;
      best = k == left.front() ? part : std::min(best, part);
    }
    left.erase(std::remove_if(
                   left.begin(), left.end(),
                   [&](std::size_t k) { return (covers ? -1 : 1) * parts[k].back().value > best; }),
               left.end());
  }
  std::vector<std::string> words;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    bool has_more = false;
    for (Index more = i; more < trace.size; ++more)
      has_more = has_more || part_of(tableau, rows[k], more).value != 0;
    words.push_back(trace.name(pivot.ties[k]) + " at " +
                    series_text(pivot.ratios[rows[k]]->finite, parts[k], has_more));
  }
  return "  with q + (e, e^2, ..), e small: " + joined(words, "; ") + "; the " +
         (covers ? "largest" : "least") + " leaves\n";
}

} // namespace lcpush::desktop
