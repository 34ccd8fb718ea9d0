// Pivots for people: as text for a terminal, and as arrays for LaTeX.
#include "lcpush/desktop/pivots.hpp"
#include "pivots/tie_text.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cctype>

namespace lcpush::desktop {
namespace {

constexpr Index most_rows = 12;      // of a tableau that is read, and fits a terminal of 80 columns
constexpr std::size_t most_tied = 5; // names of one tie

/// The first few of a tie's names, and how many there are.
std::string tied_names(const PivotTrace& trace, const TracedPivot& pivot) {
  std::vector<std::string> names = trace.names(pivot.ties);
  const std::size_t all = names.size();
  if (all <= most_tied) return joined(names, ", ");
  names.resize(most_tied);
  return joined(names, ", ") + ", .. (" + std::to_string(all) + ")";
}

std::string number_text(const TraceNumber& x) {
  return x.fraction.empty() ? number(x.value) : x.fraction;
}

/// \tfrac{2}{7}, or a decimal.
std::string number_latex(const TraceNumber& x) {
  const std::string text = number_text(x);
  if (const std::size_t e = text.find('e'); e != std::string::npos)
    return text.substr(0, e) + "\\cdot 10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}";
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return text;
  const std::size_t begin = text[0] == '-' ? 1 : 0;
  return text.substr(0, begin) + "\\tfrac{" + text.substr(begin, slash - begin) + "}{" +
         text.substr(slash + 1) + "}";
}

std::string name_latex(const std::string& name) {
  return name.substr(0, 1) + "_{" + name.substr(1) + "}";
}

/// How a tableau is written.
struct Style {
  std::string (*number)(const TraceNumber&);
  std::string (*name)(const std::string&);
  const char* space; ///< around S and signs
  const char *value, *ratio, *no_ratio, *box, *box_end;
};
constexpr Style as_text = {
    number_text, [](const std::string& name) { return name; }, " ", "value", "ratio", "-", "[",
    "]"};
constexpr Style as_latex = {number_latex,    name_latex, "",         "1",
                            "\\text{ratio}", "",         "\\boxed{", "}"};

bool is_zero(const TraceNumber& x) { return x.value == 0; }

std::string value_in(const Style& notation, const TraceValue& value) {
  const std::string rest = notation.number(value.finite), space = notation.space;
  if (!value.has_S()) return rest;
  std::string text = notation.number(value.times_S);
  text = text == "1" ? "S" : text == "-1" ? "-S" : text + space + "S";
  if (is_zero(value.finite)) return text;
  const bool is_negative = rest[0] == '-';
  return text + space + (is_negative ? "-" : "+") + space + rest.substr(is_negative ? 1 : 0);
}

/// The names first; the pivot element is boxed.
TableRows cells_of(const Style& notation, const PivotTrace& trace, const Tableau& tableau,
                   const TracedPivot* pivot) {
  TableRows rows{{"", notation.value}};
  for (const Index variable : tableau.columns)
    rows[0].push_back(notation.name(trace.name(variable)));
  if (pivot != nullptr) rows[0].push_back(notation.ratio);
  for (std::size_t i = 0; i < tableau.rows.size(); ++i) {
    rows.push_back(
        {notation.name(trace.name(tableau.rows[i])), value_in(notation, tableau.values[i])});
    for (std::size_t j = 0; j < tableau.columns.size(); ++j) {
      const std::string cell = notation.number(tableau.entry(i, j));
      rows.back().push_back(
          pivot != nullptr && pivot->is_at(i, j) ? notation.box + cell + notation.box_end : cell);
    }
    if (pivot != nullptr)
      rows.back().push_back(pivot->ratios[i] ? value_in(notation, *pivot->ratios[i])
                                             : notation.no_ratio);
  }
  return rows;
}

std::string rule_text(const PivotTrace& trace) {
  if (trace.is_as_solved) return "generic covers and tie columns, scaled";
  return trace.rule == TieRule::first_row ? "first tied row" : "lexicographic";
}

std::string header(const PivotTrace& trace) {
  std::string text = trace.title.empty() ? "" : trace.title + "\n";
  text += counted(trace.size, "unknown") + "; tie rule: " + rule_text(trace) + "; " +
          (trace.has_fractions ? "exact fractions" : "decimals") + ".\n";
  if (trace.free_count > 0)
    text += "S stands for a number larger than all others: actuators retreat at most at S.\n";
  for (const std::string& note : trace.notes) text += note + "\n";
  return text;
}

/// What the variables mean, for scenes.
std::string legend(const PivotTrace& trace) {
  if (!trace.is_physical) return {};
  TableRows unknowns, slacks;
  for (Index i = 0; i < trace.size; ++i) {
    const Variable& w = trace.variables[static_cast<std::size_t>(slack(i))];
    const Variable& z = trace.variables[static_cast<std::size_t>(unknown(i, trace.size))];
    unknowns.push_back({z.name, z.meaning});
    slacks.push_back({w.name, w.meaning});
  }
  return "\n" + table_text(unknowns, 2) + "\n" + table_text(slacks, 2);
}

std::string pivot_line(const PivotTrace& trace, std::size_t k) {
  const TracedPivot& pivot = trace.pivots[k];
  std::string text = "\nPivot " + std::to_string(k) + ": " + trace.name(pivot.entering) +
                     " enters, " + trace.name(pivot.leaving) + " leaves";
  const auto& ratio = pivot.ratios[static_cast<std::size_t>(pivot.row)];
  if (ratio) text += " at " + value_text(*ratio);
  text += "; z0 = " + value_text(pivot.z0) + "\n";
  if (!pivot.ties.empty())
    text += "  tied: " + tied_names(trace, pivot) + "; " + tie_words(pivot).text + "\n";
  if (pivot.decided_by == TieBreak::lexicographic && !pivot.chosen)
    text += lexicographic_text(trace, pivot);
  return text + "  " + pivot.sentence + "\n";
}

bool is_free(const PivotTrace& trace, std::size_t i) {
  return static_cast<Index>(i) >= trace.size - trace.free_count;
}

/// "  z3 = 2  normal of left.1 (N)", for `letter` z.
std::string unknown_line(const PivotTrace& trace, char letter, std::size_t i,
                         const std::string& value) {
  const Variable& z = trace.variables[i + static_cast<std::size_t>(trace.size)];
  return std::string("  ") + letter + std::to_string(i + 1) + " = " + value +
         (trace.is_physical ? "  " + z.meaning : "") + "\n";
}

/// A free unknown is counted from its bound -S.
std::string unknown_text(const PivotTrace& trace, std::size_t i) {
  TraceValue value{{}, trace.z[i]};
  if (is_free(trace, i)) value.times_S = {1, trace.has_fractions ? "1" : ""};
  return value_text(value);
}

/// How it ended, in a sentence or two.
std::string verdict(const PivotTrace& trace) {
  const std::string count = counted(static_cast<Index>(trace.pivots.size()), "pivot");
  if (trace.status == Status::solved)
    return "Solved after " + count + (trace.is_proved ? ", proved in fractions" : "") + ".\n";
  return std::string("Not solved (") + (trace.cycle ? "cycle" : status_text(trace.status)) +
         ") after " + count + ": " + trace.reason + ".\n" +
         (trace.ray ? trace.ray->words + "\n" : "") +
         (trace.status == Status::ray && !trace.is_physical
              ? "That need not mean that there is no solution: --cover tries another way, lcp ten, "
                "and lcp --all finds every solution.\n"
              : "");
}

/// What the answer says of each body and actuator: its points' normal forces together, and how many
/// of them press and slide.
std::string answer_by_body(const PivotTrace& trace, const Push& push) {
  const Layout<double>& layout = push.layout();
  constexpr double rounding = 1e-9; // of a force in N or a slip in m/s^2
  const auto z = [&trace](Index i) {
    const double value = trace.z[static_cast<std::size_t>(i)].value;
    return value > rounding ? value : 0;
  };
  TableRows rows{{"contact", "normal N", "points", "press", "slide"}};
  for (Index point = 0; point < layout.points;) {
    const Index body = layout.body[point];
    double normal = 0;
    Index points = 0, press = 0, slide = 0;
    for (; point < layout.points && layout.body[point] == body; ++point, ++points) {
      const double force = z(layout.normal_index(point));
      normal += force;
      press += force > 0 ? 1 : 0;
      slide += layout.cones[point].generators > 0 && z(layout.slip_index(point)) > 0 ? 1 : 0;
    }
    rows.push_back({push.file().body_name(body), brief(normal), std::to_string(points),
                    std::to_string(press), std::to_string(slide)});
  }
  return "\n" + table_text(rows);
}

/// Of a large problem: that it is large, and the answer.
std::string brief_text(const PivotTrace& trace, const Push* push) {
  std::string text = trace.title.empty() ? "" : trace.title + "\n\n";
  text += counted(trace.size, "unknown") + ", " +
          counted(static_cast<Index>(trace.pivots.size()), "pivot") +
          ": too many to read here.\n--format html -o pivots.html steps through them; -v prints "
          "all.\n\n" +
          verdict(trace);
  if (trace.status != Status::solved) return text;
  for (const std::string& note : trace.notes) text += note + "\n";
  return push == nullptr ? text : text + answer_by_body(trace, *push);
}

std::string ending(const PivotTrace& trace) {
  std::string text = "\n" + verdict(trace);
  if (trace.status == Status::solved) {
    const std::size_t before = text.size();
    for (std::size_t i = 0; i < trace.z.size(); ++i)
      if (!is_zero(trace.z[i]) || is_free(trace, i))
        text += unknown_line(trace, 'z', i, unknown_text(trace, i));
    return text.size() > before ? text : text + "  z = 0\n";
  }
  if (!trace.ray) return text;
  text += "The ray v >= 0 with M v + d v0 >= 0, v0 = " + number_text(trace.ray->v0) + ":\n";
  for (std::size_t i = 0; i < trace.ray->v.size(); ++i)
    if (!is_zero(trace.ray->v[i]))
      text += unknown_line(trace, 'v', i, number_text(trace.ray->v[i]));
  return text;
}

} // namespace

std::string value_text(const TraceValue& value) { return value_in(as_text, value); }

TieWords tie_words(const TracedPivot& pivot) {
  if (pivot.chosen) return {"chosen", "chosen, not by the rule"};
  switch (pivot.decided_by) {
  case TieBreak::artificial: return {"artificial", "z0 wins every tie, as a solution is reached"};
  case TieBreak::lexicographic: return {"lexicographic", "the lexicographic rule decides"};
  case TieBreak::order: return {"first_row", "the first row is taken"};
  case TieBreak::tie_column: return {"tie_column", "a generic column decides"};
  case TieBreak::size: return {"largest_pivot", "the largest pivot is taken"};
  case TieBreak::right_hand_side: return {"none", "a later right-hand side decides"};
  case TieBreak::none: break;
  }
  return {"none", ""};
}

std::string tableau_text(const PivotTrace& trace, const Tableau& tableau,
                         const TracedPivot* pivot) {
  return table_text(cells_of(as_text, trace, tableau, pivot));
}

std::string pivots_text(const PivotTrace& trace, Telling telling, const Push* push) {
  if (telling == Telling::brief && trace.size > most_rows) return brief_text(trace, push);
  std::string text = header(trace) + legend(trace);
  std::size_t run = 0;
  for (std::size_t k = 0; k < trace.pivots.size(); ++k) {
    for (; run < trace.runs.size() && trace.runs[run].first_pivot == k; ++run)
      if (trace.runs.size() > 1) text += "\nStart " + trace.runs[run].title + ".\n";
    text += pivot_line(trace, k);
    if (trace.pivots[k].before)
      text += tableau_text(trace, *trace.pivots[k].before, &trace.pivots[k]);
  }
  text += ending(trace);
  return trace.last ? text + "\n" + tableau_text(trace, *trace.last, nullptr) : text;
}

namespace {

/// The size at which a table fits the width of an article's text, as far as one does.
std::string size_latex(const TableRows& cells) {
  constexpr double text_width = 345, letter = 5, gap = 8; // pt
  double width = 0;
  for (std::size_t j = 0; j < cells[0].size(); ++j) {
    std::size_t longest = 0;
    for (const auto& row : cells) longest = std::max(longest, row[j].size());
    width += letter * static_cast<double>(longest) + gap;
  }
  constexpr double footnote = 0.8; // of the letters' own size
  return width < text_width              ? "\\normalsize"
         : width * footnote < text_width ? "\\footnotesize"
                                         : "\\scriptsize";
}

std::string array_latex(const PivotTrace& trace, const Tableau& tableau, const TracedPivot* pivot) {
  const TableRows rows = cells_of(as_latex, trace, tableau, pivot);
  // Fractions keep off the rules and the frame.
  std::string text = "{" + size_latex(cells_of(as_text, trace, tableau, pivot)) +
                     "\n\\[\n\\renewcommand{\\arraystretch}{1.4}\\setlength{\\arraycolsep}{4pt}\n"
                     "\\begin{array}{r|r|" +
                     std::string(tableau.columns.size(), 'r') +
                     (pivot != nullptr ? "|r}\n " : "}\n ") + joined(rows[0], " & ") +
                     " \\\\\n\\hline\n";
  for (std::size_t i = 1; i < rows.size(); ++i) text += "  " + joined(rows[i], " & ") + " \\\\\n";
  return text + "\\end{array}\n\\]}\n";
}

/// Text in which nothing is a command, variables and comparisons as mathematics.
std::string plain(const std::string& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char c = words[i];
    const std::size_t end = words.find_first_not_of("0123456789", i + 1);
    const bool begins = i == 0 || std::isalnum(static_cast<unsigned char>(words[i - 1])) == 0;
    if (begins && (c == 'w' || c == 'z' || c == 'v') && end != i + 1) {
      text += "$" + name_latex(words.substr(i, end - i)) + "$";
      i = std::min(end, words.size()) - 1;
    } else if (c == '<' || c == '>' || c == '|') {
      const bool or_equal = c != '|' && i + 1 < words.size() && words[i + 1] == '=';
      text += or_equal ? c == '<' ? "$\\le$" : "$\\ge$" : std::string("$") + c + "$";
      i += or_equal ? 1 : 0;
    } else {
      if (std::string("#$%&_{}").find(c) != std::string::npos) text += '\\';
      if (c == '\\' || c == '~' || c == '^') text += "\\char`\\";
      text += c;
    }
  }
  return text;
}

} // namespace

std::string pivots_latex(const PivotTrace& trace) {
  std::string text = "% Needs \\usepackage{amsmath}. A row says: basic variable = value + sum of "
                     "entries times nonbasic variables.\n";
  for (std::size_t k = 0; k < trace.pivots.size(); ++k) {
    const TracedPivot& pivot = trace.pivots[k];
    text += "\n\\noindent Pivot " + std::to_string(k) + ": $" +
            name_latex(trace.name(pivot.entering)) + "$ enters, $" +
            name_latex(trace.name(pivot.leaving)) + "$ leaves. " + plain(pivot.sentence) + "\n";
    if (pivot.before) text += array_latex(trace, *pivot.before, &pivot);
  }
  const std::string end =
      trace.status == Status::solved ? "Solved." : "Not solved: " + plain(trace.reason) + ".";
  text += "\n\\noindent " + end + "\n";
  if (trace.last) text += array_latex(trace, *trace.last, nullptr);
  return text;
}

} // namespace lcpush::desktop
