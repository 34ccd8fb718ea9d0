// What `lcpush lcp` says of a raw problem's answer.
#include <cmath>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "raw/settings.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

std::string reason_of(const RawAnswer& answer) {
  if (answer.inconsistent_row >= 0)
    return "equality " + std::to_string(answer.inconsistent_row + 1) +
           " cannot hold, for what the others leave of it says 0 = something";
  const std::string at = printed(" (the scaled residual is %.1e)", answer.residual);
  if (answer.status == Status::sweep_limit)
    return "the limit of sweeps was reached" + at + "; raise --sweeps";
  if (answer.status == Status::stagnated)
    return "the sweeps make no more progress" + at + "; use hybrid or lemke";
  std::string reason = reason_text(answer.reason);
  if (answer.status == Status::ray)
    reason = "Lemke ended on a secondary ray under " + counted(answer.covers, "covering vector");
  if (answer.status == Status::pivot_limit) reason = "the limit of pivots was reached";
  if (answer.search.starts > 0)
    reason += ", and from " + std::to_string(answer.search.starts) + " other starts";
  if (answer.search.whole)
    reason += "; in rounded numbers none of its complementary cones holds q; lcp --all asks in "
              "fractions";
  return reason;
}

/// Where each unknown lies in its box.
std::vector<std::string> places_of(const RawProblem& problem, const RawAnswer& answer) {
  std::vector<std::string> places;
  for (Index i = 0; i < problem.size(); ++i) {
    const BoxEnds ends = ends_of(problem, i, answer.z);
    const double z = answer.z[static_cast<std::size_t>(i)];
    const double near = raw_settings.at_end * std::abs(z);
    const bool is_low = z - ends.lo <= near, is_high = ends.hi - z <= near;
    places.emplace_back(is_low && is_high ? "fixed" : is_low ? "lo" : is_high ? "hi" : "between");
  }
  return places;
}

std::vector<std::string> basis_of(const RawAnswer& answer) {
  std::vector<std::string> basis;
  for (std::size_t i = 0; i < answer.basic.size(); ++i)
    basis.push_back((answer.basic[i] != 0 ? "z" : "w") + std::to_string(i + 1));
  return basis;
}

/// "12 sweeps and 3 pivots", without what was not tried.
std::string effort_of(const RawAnswer& answer) {
  const std::string sweeps = std::to_string(answer.sweeps) + " sweeps";
  const std::string pivots = std::to_string(answer.pivots) + " pivots";
  if (answer.covers == 0) return sweeps;
  return answer.history.empty() ? pivots : sweeps + " and " + pivots;
}

std::string numbered(std::size_t i) {
  std::string row = std::to_string(i + 1);
  return row.insert(0, row.size() < 5 ? 5 - row.size() : 0, ' ');
}

std::string pair_table(const RawProblem& problem, const RawAnswer& answer) {
  std::string text = "\n    i  basic                z                w\n";
  for (std::size_t i = 0; i < problem.free.size(); ++i)
    text += numbered(i) + (answer.basic[i] != 0 ? "  z    " : "  w    ") +
            printed("%17.9g", answer.z[i]) +
            (problem.free[i] != 0 ? "             free\n" : printed("%17.9g\n", answer.w[i]));
  return text;
}

std::string box_table(const RawProblem& problem, const RawAnswer& answer) {
  std::string text = "\n    i  at                   z                w\n";
  const std::vector<std::string> places = places_of(problem, answer);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::string place = places[i];
    place.resize(7, ' ');
    text += numbered(i) + "  " + place + printed("%15.9g", answer.z[i]) +
            printed("%17.9g\n", answer.w[i]);
  }
  return text;
}

/// Does v show that there is no solution? With v >= 0 (of rows of equalities of any sign), M'v <= 0
/// (of free unknowns 0) and v'q < 0, v'(M z + q) < 0 for every z: to rounding.
bool refutes(const RawProblem& problem, const std::vector<double>& v) {
  if (problem.bounds.given() || v.size() != problem.q.size()) return false;
  std::vector<double> sums(v.size()), terms(v.size());
  double closes = 0, size = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (v[i] == 0) continue;
    if (v[i] < 0 && problem.free[i] == 0) return false;
    closes += v[i] * problem.q[i];
    size += std::abs(v[i] * problem.q[i]);
    for (const SparseEntry& entry : problem.M.row(static_cast<Index>(i))) {
      sums[static_cast<std::size_t>(entry.column)] += v[i] * entry.value;
      terms[static_cast<std::size_t>(entry.column)] += std::abs(v[i] * entry.value);
    }
  }
  for (std::size_t j = 0; j < sums.size(); ++j) {
    const double above = problem.free[j] != 0 ? std::abs(sums[j]) : sums[j];
    if (above > RawSettings().rounding * terms[j]) return false;
  }
  return closes < -RawSettings().rounding * size;
}

/// Is it proved that no z solves the problem?
bool is_unsolvable(const RawProblem& problem, const RawAnswer& answer) {
  return answer.inconsistent_row >= 0 || (!answer.ray.empty() && refutes(problem, answer.ray));
}

} // namespace

std::string raw_text(const RawProblem& problem, const RawAnswer& answer) {
  std::string text;
  if (answer.inconsistent_row >= 0) return "There is no solution: " + reason_of(answer) + ".\n";
  if (answer.status != Status::solved) {
    if (is_unsolvable(problem, answer))
      text = "There is no solution: of the v below M'v <= 0 and v'q < 0, so that v'(M z + q) < 0 "
             "for every z >= 0.\n";
    text += "Not solved (" + std::string(status_text(answer.status)) + "): " + reason_of(answer) +
            ".\n" +
            (answer.covers == 0 ? "Sweeps: " + std::to_string(answer.sweeps)
                                : "Pivots: " + std::to_string(answer.pivots)) +
            ".\n";
    if (answer.ray.empty()) return text;
    text += "\nThe ray v (v >= 0, M v >= 0 along it up to the covering vector, largest entry 1):\n";
    for (std::size_t i = 0; i < answer.ray.size(); ++i)
      if (answer.ray[i] != 0)
        text += "  v" + std::to_string(i + 1) + printed(" = %.9g\n", answer.ray[i]);
    return text;
  }
  text =
      "Solved in " + effort_of(answer) +
      (answer.covers > 1 ? " under " + std::to_string(answer.covers) + " covering vectors" : "") +
      "; largest scaled residual " + residual_text(answer.residual) + ".\n";
  for (const Index row : answer.redundant_rows)
    text += "Equality " + std::to_string(row + 1) + " follows from the others and was dropped.\n";
  return text + (problem.bounds.given() ? box_table(problem, answer) : pair_table(problem, answer));
}

std::string raw_json(const RawProblem& problem, const RawAnswer& answer,
                     const std::string& solver) {
  const bool solved = answer.status == Status::solved;
  JsonWriter json;
  json.begin_object();
  json.member("status", status_text(answer.status)).member("solver", solver);
  json.member("pivots", answer.pivots).member("sweeps", answer.sweeps);
  json.member("covers", answer.covers).member("residual", when(solved, answer.residual));
  json.member("z", when(solved, answer.z)).member("w", when(solved, answer.w));
  json.member("basis", when(solved && !problem.bounds.given(), basis_of(answer)));
  if (problem.bounds.given()) json.member("at", when(solved, places_of(problem, answer)));
  json.member("pieces", answer.search.pieces).member("starts", answer.search.starts);
  if (!solved) {
    json.member("reason", reason_of(answer)).member("ray", unless_empty(answer.ray));
    json.member("has_no_solution", is_unsolvable(problem, answer));
  }
  if (answer.inconsistent_row >= 0) json.member("inconsistent_row", answer.inconsistent_row + 1);
  json.list("redundant_rows", answer.redundant_rows, [&](Index row) { json.value(row + 1); });
  return json.end_object().text();
}

} // namespace lcpush::desktop
