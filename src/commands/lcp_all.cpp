// lcp --all: every solution of a raw problem, or of a game.
#include <algorithm>

#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/all_solutions.hpp"

namespace lcpush::commands {
namespace {

constexpr Index most_solutions = 100'000; // each is compared with each

void refuse_others(const Values& values) {
  for (const char* option : {"solver", "sweeps", "relaxation", "history", "certify"})
    if (values.has(option))
      values.refuse(option, values.label(option) + " is about one solution; leave it or " +
                                values.label("all") + " out");
  for (const char* option : {"lo", "hi", "findex"})
    if (values.has(option))
      values.refuse(option, values.label("all") + " takes no boxes: leave " + values.label(option) +
                                " out; an unknown without ends goes into " + values.label("free"));
  for (const char* option : {"M", "q", "free"})
    if (values.has("game") && values.has(option))
      values.refuse(option,
                    values.label("game") + " says all: leave " + values.label(option) + " out");
}

void refuse_larger(const Values& values, Index n, const std::string& what) {
  if (n > largest_enumerated)
    values.refuse("all", values.label("all") + " takes at most " +
                             std::to_string(largest_enumerated) + " " + what + ", not " +
                             std::to_string(n));
}

AllSolutions find_equilibria(const Values& values, const AllOptions& options, AllWording& wording) {
  const std::vector<std::string> texts = values.texts("game");
  const std::string label = values.label("game");
  if (texts.size() != 2)
    values.refuse("game", label + " takes two matrices: what each player gets");
  const ExactMatrix A = parse_inline_matrix<Rational>(texts[0], label + " A"),
                    B = parse_inline_matrix<Rational>(texts[1], label + " B");
  const auto size = [](const ExactMatrix& matrix) {
    return std::to_string(matrix.rows) + " x " + std::to_string(matrix.cols);
  };
  if (A.rows != B.rows || A.cols != B.cols)
    values.refuse("game", label + ": what each player gets has a row for each action of the one " +
                              "and a column for each of the other; the two are " + size(A) +
                              " and " + size(B));
  refuse_larger(values, A.rows + A.cols, "actions of both players");
  wording.rows = A.rows;
  return all_equilibria(A, B, options);
}

} // namespace

Result find_all(const Values& values, Listener& listener) {
  const std::string format = values.format({"text", "json", "svg"});
  refuse_others(values);
  AllOptions options;
  options.most = values.whole("most", {1, most_solutions}).value_or(options.most);
  options.stop = [&listener](double part) { return listener.stop(part); };
  AllWording wording;
  wording.is_exact = values.has("exact");
  AllSolutions found;
  if (values.has("game")) {
    if (format == "svg")
      values.refuse("format", values.label("format") + " svg draws M and q, not a game");
    found = find_equilibria(values, options, wording);
  } else {
    const ExactMatrices typed = values.exact_matrices();
    refuse_larger(values, typed.M.rows, "unknowns");
    if (format == "svg" && (typed.M.rows < 2 || typed.M.rows > 3))
      values.refuse("format", values.label("format") + " svg draws two or three unknowns, not " +
                                  std::to_string(typed.M.rows));
    found = all_solutions(typed.M, typed.q, typed.free, options);
    if (format == "svg")
      return {found.complete(),
              all_solutions_svg(found, typed.M, typed.q,
                                std::count(typed.free.begin(), typed.free.end(), 0) == 2),
              {},
              found.stop};
  }
  return {found.complete(),
          format == "json" ? all_solutions_json(found, wording)
                           : all_solutions_text(found, wording, values.telling()),
          {},
          found.stop};
}

} // namespace lcpush::commands
