#include "lcpush/desktop/pivots.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// \tfrac{2}{7}, or a decimal.
std::string number_latex(const TraceNumber& x) {
  if (x.fraction.empty()) return number(x.value);
  const std::size_t slash = x.fraction.find('/');
  if (slash == std::string::npos) return x.fraction;
  const bool is_negative = x.fraction[0] == '-';
  const std::string top = x.fraction.substr(is_negative ? 1 : 0, slash - (is_negative ? 1 : 0));
  return (is_negative ? "-" : "") + ("\\tfrac{" + top + "}{" + x.fraction.substr(slash + 1) + "}");
}

std::string value_latex(const TraceValue& value) {
  if (!value.has_S()) return number_latex(value.finite);
  const std::string rest = number_latex(value.finite);
  const std::string times = number_latex(value.times_S);
  return (times == "1"    ? ""
          : times == "-1" ? "-"
                          : times) +
         "S" + (value.finite.value == 0 ? "" : (rest[0] == '-' ? rest : "+" + rest));
}

std::string name_latex(const PivotTrace& trace, Index variable) {
  const std::string& name = trace.name(variable);
  return name.substr(0, 1) + "_{" + name.substr(1) + "}";
}

std::string array_latex(const PivotTrace& trace, const Tableau& tableau, const TracedPivot* pivot) {
  std::string text = "\\[\n\\begin{array}{r|r|" + std::string(tableau.columns.size(), 'r') +
                     (pivot != nullptr ? "|r}\n" : "}\n") + "  & 1";
  for (const Index variable : tableau.columns) text += " & " + name_latex(trace, variable);
  text += (pivot != nullptr ? " & \\text{ratio} \\\\\n\\hline\n" : " \\\\\n\\hline\n");
  for (std::size_t i = 0; i < tableau.rows.size(); ++i) {
    text += "  " + name_latex(trace, tableau.rows[i]) + " & " + value_latex(tableau.values[i]);
    for (std::size_t j = 0; j < tableau.columns.size(); ++j) {
      const std::string cell = number_latex(tableau.entry(i, j));
      text += " & " + (pivot != nullptr && pivot->is_at(i, j) ? "\\boxed{" + cell + "}" : cell);
    }
    if (pivot != nullptr) text += " & " + (pivot->ratios[i] ? value_latex(*pivot->ratios[i]) : "");
    text += " \\\\\n";
  }
  return text + "\\end{array}\n\\]\n";
}

/// Text in which nothing is a command.
std::string plain(const std::string& words) {
  std::string text;
  for (const char c : words) {
    if (std::string("#$%&_{}").find(c) != std::string::npos) text += '\\';
    if (c == '\\' || c == '~' || c == '^') text += "\\char`\\";
    text += c;
  }
  return text;
}

} // namespace

std::string pivots_latex(const PivotTrace& trace) {
  std::string text = "% Needs \\usepackage{amsmath}. A row says: basic variable = value + sum of "
                     "entries times nonbasic variables.\n";
  for (std::size_t k = 0; k < trace.pivots.size(); ++k) {
    const TracedPivot& pivot = trace.pivots[k];
    text += "\n\\noindent Pivot " + std::to_string(k) + ": $" + name_latex(trace, pivot.entering) +
            "$ enters, $" + name_latex(trace, pivot.leaving) + "$ leaves. " +
            plain(pivot.sentence) + "\n";
    if (pivot.before) text += array_latex(trace, *pivot.before, &pivot);
  }
  const std::string end =
      trace.status == Status::solved ? "Solved." : "Not solved: " + plain(trace.reason) + ".";
  text += "\n\\noindent " + end + "\n";
  if (trace.last) text += array_latex(trace, *trace.last, nullptr);
  return text;
}

} // namespace lcpush::desktop
