#include "cli/shell_listener.hpp"

#include <algorithm>
#include <iostream>

#include "lcpush/desktop/pivots.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {

using namespace desktop;

namespace {

/// The row that a name or a number from 1 on stands for, or -1.
Index row_of(const PivotTrace& trace, const std::vector<Index>& rows, const std::string& word) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (trace.name(rows[i]) == word) return static_cast<Index>(i);
  const auto number = whole_number<std::size_t>(word);
  if (number && *number >= 1 && *number <= rows.size()) return static_cast<Index>(*number) - 1;
  return -1;
}

/// Why this row cannot leave.
std::string objection(const PivotTrace& trace, const TracedPivot& pivot,
                      const std::vector<Index>& rows, Index row) {
  const auto at = static_cast<std::size_t>(row), best = static_cast<std::size_t>(pivot.row);
  const std::string &enters = trace.name(pivot.entering), &it = trace.name(rows[at]);
  if (!pivot.ratios[at]) {
    if (pivot.entering == artificial(trace.size))
      return it + " needs no help: its value is not negative. z0 has to become large enough for "
                  "every row, so the row that needs most decides.";
    return it + " does not fall as " + enters + " grows (its entry in the column of " + enters +
           " is not negative), so it cannot block.";
  }
  const std::string own = value_text(*pivot.ratios[at]);
  const std::string right = value_text(*pivot.ratios[best]);
  if (pivot.entering == artificial(trace.size))
    return it + " needs only z0 = " + own + ", and " + trace.name(rows[best]) +
           " would still be negative there: it needs " + right + ".";
  return it + " reaches zero at " + own + ", but " + trace.name(rows[best]) +
         " gets there first, at " + right + ", and would be negative.";
}

} // namespace

Index ask_for_row(const PivotTrace& trace) {
  const TracedPivot& pivot = trace.pivots.back();
  if (!pivot.before) return pivot.row;
  const Tableau& before = *pivot.before;
  const std::string& by_rule = trace.name(before.rows[static_cast<std::size_t>(pivot.row)]);
  const Index z0 = artificial(trace.size);
  const auto ties = [&pivot](Index variable) {
    return std::find(pivot.ties.begin(), pivot.ties.end(), variable) != pivot.ties.end();
  };
  std::cerr << "Pivot " << trace.pivots.size() - 1 << ": " << trace.name(pivot.entering)
            << " enters (" << trace.variables[static_cast<std::size_t>(pivot.entering)].meaning
            << ").\n"
            << tableau_text(trace, before, nullptr);
  std::string word;
  for (;;) {
    std::cerr << "Which variable leaves? " << std::flush;
    if (!(std::cin >> word)) {
      std::cerr << by_rule << " (the rule's choice)\n";
      return pivot.row;
    }
    const Index row = row_of(trace, before.rows, word);
    if (row < 0) {
      std::cerr << desktop::quoted(word)
                << " is no row; type a name from the first column, such as "
                << trace.name(before.rows[0]) << ".\n";
      continue;
    }
    const Index leaving = before.rows[static_cast<std::size_t>(row)];
    const bool may_leave = row == pivot.row || ties(leaving);
    if (!may_leave) {
      std::cerr << "No: " << objection(trace, pivot, before.rows, row) << "\n";
    } else if (leaving != z0 && ties(z0)) {
      std::cerr << "It ties with z0, and when z0 can leave the problem is solved: take z0.\n";
    } else {
      if (row != pivot.row)
        std::cerr << "Right; it ties, and the lexicographic rule would have taken " << by_rule
                  << ", so that it never comes back to a basis.\n\n";
      else
        std::cerr << "Right.\n\n";
      return row;
    }
  }
}

} // namespace lcpush::cli
