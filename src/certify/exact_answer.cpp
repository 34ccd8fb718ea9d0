#include "certify/exact_answer.hpp"

#include "certify/settings.hpp"

#include <cmath>
#include <list>
#include <random>
#include <utility>

namespace lcpush::desktop {
namespace {

/// With these unknowns, all others zero; nullopt if that is no answer.
std::optional<ExactAnswer> answer_with(const MixedProblem& problem,
                                       const std::vector<std::size_t>& unknowns,
                                       const std::optional<Column>& values) {
  if (!values) return std::nullopt;
  ExactAnswer answer{Column(problem.size()), {}};
  for (std::size_t j = 0; j < unknowns.size(); ++j) answer.x[unknowns[j]] = (*values)[j];
  answer.w = times(problem, answer.x, problem.q);
  if (!solves_exactly(problem, answer)) return std::nullopt;
  return answer;
}

/// What the unknowns have to make up for in these rows.
Column right_hand_side(const Column& constant, const std::vector<std::size_t>& rows) {
  Column right;
  for (const std::size_t i : rows) right.push_back(-constant[i]);
  return right;
}

/// Lemke's method on the original sparse rows: every pivot solves for what is basic anew, since the
/// dictionary would fill with long fractions. The free unknowns are basic all the time.
class Pivots {
public:
  /// `seed` chooses the covering vector, and with it the path; and by how little q is moved, so
  /// that nothing ties.
  Pivots(const MixedProblem& problem, Basis basic, std::uint32_t seed)
      : problem_(problem), n_(problem.size()), basic_(std::move(basic)), q_(problem.q),
        blocked_(n_), random_(seed) {
    for (std::size_t i = 0; i < n_; ++i)
      if (problem_.is_free(i)) basic_[i] = 1;
    const Rational tiny(std::ldexp(1.0, certify_settings.tiny));
    const Column by = right_hand_side_of(generic());
    for (std::size_t i = 0; i < n_; ++i) q_[i] += tiny * by[i];
  }

  const Basis& basic() const { return basic_; }

  /// The pair that leaves, n of the artificial unknown z0; nullopt on a ray or a singular basis.
  std::optional<std::size_t> next() {
    Column entering(n_);
    const bool is_first = cover_.empty();
    const Column sizes = is_first ? generic() : Column();
    if (is_first) {
      cover_ = right_hand_side_of(sizes);
      entering = cover_;
    } else if (!x_enters_) {
      entering[blocked_] = -1;
    } else {
      for (std::size_t i = 0; i < n_; ++i)
        for (const ExactEntry& entry : problem_.rows[i])
          if (static_cast<std::size_t>(entry.column) == blocked_) entering[i] += entry.value;
    }
    const auto values = basic_values(q_, entering);
    if (!values) return std::nullopt;
    // z0 rises until nothing is negative any more; what enters later, until something would be.
    const Column &now = values->first, &rates = values->second;
    std::size_t leaving = n_ + 1;
    Rational least;
    for (std::size_t i = 0; i <= n_; ++i) {
      const bool is_pair = i < n_ && !problem_.is_free(i) && i != blocked_;
      if (!is_pair && (i < n_ || is_first)) continue;
      if (is_first ? now[i].sign() >= 0 : rates[i].sign() >= 0) continue;
      const Rational ratio = now[i] / (is_first ? sizes[i] : -rates[i]);
      if (leaving <= n_ && ratio >= least) continue;
      leaving = i;
      least = ratio;
    }
    if (leaving > n_) return is_first ? std::optional<std::size_t>(n_) : std::nullopt;
    if (!is_first) basic_[blocked_] = x_enters_ ? 1 : 0;
    blocked_ = leaving;
    if (leaving < n_) x_enters_ = std::exchange(basic_[leaving], 0) == 0;
    return leaving;
  }

private:
  const MixedProblem& problem_;
  const std::size_t n_;
  Basis basic_;
  Column q_, cover_;
  std::size_t blocked_;   // the pair of which neither is basic, while z0 is
  bool x_enters_ = false; // or w, of that pair
  std::mt19937 random_;

  /// Whole numbers that look like chance, the same ones every time.
  Column generic() {
    Column numbers;
    for (std::size_t i = 0; i < n_; ++i) numbers.emplace_back(1 + (random_() >> 16U));
    return numbers;
  }

  /// The right-hand side of which the present basis makes these positive values.
  Column right_hand_side_of(const Column& sizes) const {
    Column x(n_);
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] != 0 && !problem_.is_free(i)) x[i] = sizes[i];
    Column column = times(problem_, x);
    for (std::size_t i = 0; i < n_; ++i)
      column[i] = (basic_[i] != 0 ? Rational(0) : sizes[i]) - column[i];
    return column;
  }

  /// L x + cover z0 + constant = w, where what is not basic is zero: of each pair what is basic,
  /// and z0, for two constants.
  std::optional<std::pair<Column, Column>> basic_values(const Column& one,
                                                        const Column& two) const {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] != 0) rows.push_back(i);
    const std::vector<std::size_t> columns = rows;
    if (blocked_ < n_) rows.push_back(blocked_);
    std::vector<ExactRow> matrix = cut(problem_, rows, columns);
    for (std::size_t k = 0; blocked_ < n_ && k < rows.size(); ++k)
      if (cover_[rows[k]].sign() != 0)
        matrix[k].push_back({static_cast<Index>(columns.size()), cover_[rows[k]]});
    const auto solutions =
        exact_solutions(matrix, {right_hand_side(one, rows), right_hand_side(two, rows)});
    if (!solutions) return std::nullopt;
    const auto complete = [&](const Column& solution, Column constant) {
      Column x(n_);
      for (std::size_t k = 0; k < columns.size(); ++k) x[columns[k]] = solution[k];
      const Rational z0 = blocked_ < n_ ? solution.back() : Rational(0);
      for (std::size_t i = 0; i < n_ && z0.sign() != 0; ++i) constant[i] += cover_[i] * z0;
      Column values = times(problem_, x, constant);
      for (const std::size_t i : columns) values[i] = x[i];
      values.push_back(z0);
      return values;
    };
    return std::pair(complete(solutions->front(), one), complete(solutions->back(), two));
  }
};

} // namespace

bool solves_exactly(const MixedProblem& problem, const ExactAnswer& answer) {
  if (times(problem, answer.x, problem.q) != answer.w) return false;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const int x = answer.x[i].sign(), w = answer.w[i].sign();
    if (problem.is_free(i) ? w != 0 : x < 0 || w < 0 || (x > 0 && w > 0)) return false;
  }
  return true;
}

std::optional<ExactAnswer> answer_near(const MixedProblem& problem, const std::vector<Part>& acting,
                                       const std::vector<double>& guess) {
  // The free unknowns first: they are not to stay at a guess. The rows of what acts first, which
  // share fewest columns; last those of pairs of which neither acts, as far as the acting ones can
  // make them vanish.
  std::vector<std::size_t> free, pairs, idle;
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (problem.is_free(i))
      free.push_back(i);
    else if (acting[i] != Part::w)
      (acting[i] == Part::x ? pairs : idle).push_back(i);
  std::vector<std::size_t> unknowns = free, equations = pairs;
  unknowns.insert(unknowns.end(), pairs.begin(), pairs.end());
  equations.insert(equations.end(), free.begin(), free.end());
  equations.insert(equations.end(), idle.begin(), idle.end());
  std::vector<double> near;
  for (const std::size_t i : unknowns) near.push_back(guess[i]);
  return answer_with(problem, unknowns,
                     solution_near(cut(problem, equations, unknowns),
                                   right_hand_side(problem.q, equations), near,
                                   certify_settings.guess_bits));
}

std::optional<ExactAnswer> answer_of_basis(const MixedProblem& problem, const Basis& basic) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (problem.is_free(i) || basic[i] != 0) places.push_back(i);
  const auto values =
      exact_solutions(cut(problem, places, places), {right_hand_side(problem.q, places)});
  if (!values) return std::nullopt;
  return answer_with(problem, places, values->front());
}

std::optional<ExactAnswer> answer_by_pivots(const MixedProblem& problem,
                                            const std::vector<Basis>& bases) {
  // A basis in the middle promises nothing: some paths from it end on rays, others are long. So all
  // of them go on by turns, and the shortest one ends the search.
  for (std::uint32_t cover = 0; cover < certify_settings.covers; ++cover) {
    std::list<Pivots> paths;
    for (const Basis& basic : bases) paths.emplace_back(problem, basic, cover);
    for (int k = 0; k < certify_settings.pivots; ++k)
      for (auto path = paths.begin(); path != paths.end();) {
        const auto leaving = path->next();
        const bool is_solved = leaving && *leaving == problem.size();
        if (is_solved)
          if (auto answer = answer_of_basis(problem, path->basic())) return answer;
        path = leaving && !is_solved ? std::next(path) : paths.erase(path);
      }
  }
  return std::nullopt;
}

} // namespace lcpush::desktop
