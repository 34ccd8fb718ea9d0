#include "certify/exact_answer.hpp"

#include "certify/settings.hpp"

#include <random>

namespace lcpush::desktop {
namespace {

/// Lemke's method on the original sparse rows: every pivot solves for what is basic anew, since the
/// dictionary would fill with long fractions. The free unknowns are basic all the time.
class Pivots {
public:
  Pivots(const MixedProblem& problem, Basis basic)
      : problem_(problem), n_(problem.size()), basic_(std::move(basic)) {
    for (std::size_t i = 0; i < n_; ++i)
      if (problem_.is_free(i)) basic_[i] = 1;
  }

  /// `seed` chooses the covering vector, and with it the path.
  void start(std::uint32_t seed) {
    values_ = basic_values();
    if (!values_) return end(State::lost);
    if (is_feasible()) return end(State::solved);
    const std::vector<Rational> sizes = generic(seed);
    cover_ = right_hand_side_of(sizes);
    perturbation_ = right_hand_side_of(generic(seed + 1));
    const std::optional<Values> ties = solved_for(perturbation_);
    if (!ties) return end(State::lost);
    enter_artificial(sizes, *ties);
  }

  void go_on(std::size_t pivots) {
    for (; pivots > 0 && state_ == State::going; --pivots) step();
  }

  bool is_solved() const { return state_ == State::solved; }
  /// Pre: solved.
  ExactAnswer answer() const { return {values_->x, values_->w}; }

private:
  enum class State : unsigned char { going, solved, lost }; // lost: singular, or on a ray
  struct Values {
    Column x, w;
    Rational z0;
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const MixedProblem& problem_;
  const std::size_t n_;
  State state_ = State::going;
  Basis basic_;
  std::size_t blocked_ = none; // the pair of which neither is basic, while z0 is
  bool x_enters_ = false;      // or w, of that pair
  Column cover_;
  Column perturbation_; // an infinitesimal right-hand side that decides ties
  std::optional<ExactSystem> system_;
  std::vector<std::size_t> places_; // rows of the system; its columns too, but that the last is z0
  std::optional<Values> values_;    // of q

  void end(State state) { state_ = state; }

  /// Whole numbers that look like chance, the same ones every time.
  std::vector<Rational> generic(std::uint32_t seed) const {
    std::mt19937 engine(seed);
    std::vector<Rational> numbers;
    for (std::size_t i = 0; i < n_; ++i) numbers.emplace_back(1 + (engine() >> 16U));
    return numbers;
  }

  /// Factors the matrix of what is basic, z0 last, and solves for q.
  std::optional<Values> basic_values() {
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] != 0) columns.push_back(i);
    places_ = columns;
    if (blocked_ != none) places_.push_back(blocked_);
    std::vector<ExactRow> matrix = cut(problem_, places_, columns);
    for (std::size_t k = 0; blocked_ != none && k < places_.size(); ++k)
      if (cover_[places_[k]].sign() != 0)
        matrix[k].push_back({static_cast<Index>(columns.size()), cover_[places_[k]]});
    system_.emplace(matrix);
    return solved_for(problem_.q);
  }

  /// L x + cover z0 + constant = w, where everything that is not basic is zero.
  std::optional<Values> solved_for(const Column& constant) const {
    Column right;
    for (const std::size_t i : places_) right.push_back(-constant[i]);
    const auto solution = system_->solve(right);
    if (!solution) return std::nullopt;
    Values values{Column(n_), {}, 0};
    if (blocked_ != none) values.z0 = solution->back();
    for (std::size_t k = 0; k < places_.size() && places_[k] != blocked_; ++k)
      values.x[places_[k]] = (*solution)[k];
    values.w = times(problem_, values.x, constant, cover_, values.z0);
    return values;
  }

  const Rational& of_pair(const Values& values, std::size_t i) const {
    return basic_[i] != 0 ? values.x[i] : values.w[i];
  }
  bool is_feasible() const {
    for (std::size_t i = 0; i < n_; ++i)
      if (!problem_.is_free(i) && of_pair(*values_, i).sign() < 0) return false;
    return true;
  }

  /// The right-hand side of which the present basis makes these positive values.
  Column right_hand_side_of(const std::vector<Rational>& sizes) const {
    Column x(n_);
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] != 0 && !problem_.is_free(i)) x[i] = sizes[i];
    Column column = times(problem_, x);
    for (std::size_t i = 0; i < n_; ++i)
      column[i] = (basic_[i] != 0 ? Rational(0) : sizes[i]) - column[i];
    return column;
  }

  /// z0 rises until nothing is negative; what was the last to be leaves.
  void enter_artificial(const std::vector<Rational>& sizes, const Values& ties) {
    std::pair<Rational, Rational> most;
    for (std::size_t i = 0; i < n_; ++i) {
      const Rational& value = of_pair(*values_, i);
      if (problem_.is_free(i) || value.sign() >= 0) continue;
      std::pair<Rational, Rational> need(-value / sizes[i], -of_pair(ties, i) / sizes[i]);
      if (blocked_ != none && !(most < need)) continue;
      most = std::move(need);
      blocked_ = i;
    }
    leave(blocked_);
  }

  /// What is basic of the pair leaves; its complement enters next.
  void leave(std::size_t i) {
    blocked_ = i;
    x_enters_ = basic_[i] == 0;
    basic_[i] = 0;
  }

  void step() {
    values_ = basic_values();
    if (!values_) return end(State::lost);
    Column entering(n_);
    if (!x_enters_) entering[blocked_] = -1;
    for (std::size_t i = 0; x_enters_ && i < n_; ++i)
      for (const ExactEntry& entry : problem_.rows[i])
        if (static_cast<std::size_t>(entry.column) == blocked_) entering[i] = entry.value;
    const std::optional<Values> rates = solved_for(entering);
    const std::size_t leaving = rates ? blocking_pair(*rates) : none;
    if (leaving == none) return end(State::lost);
    basic_[blocked_] = x_enters_ ? 1 : 0;
    if (leaving < n_) return leave(leaving);
    blocked_ = none;
    values_ = basic_values();
    end(values_ ? State::solved : State::lost);
  }

  /// The pair that is zero first, n_ for z0, which wins a tie; `none` on a ray. Most pivots are
  /// decided by q: the perturbation is solved for at the first tie.
  std::size_t blocking_pair(const Values& rates) const {
    std::optional<Values> ties;
    std::size_t leaving = rates.z0.sign() < 0 ? n_ : none;
    Rational least = leaving == none ? Rational(0) : values_->z0 / -rates.z0;
    for (std::size_t i = 0; i < n_; ++i) {
      if (problem_.is_free(i) || i == blocked_ || of_pair(rates, i).sign() >= 0) continue;
      Rational ratio = of_pair(*values_, i) / -of_pair(rates, i);
      if (leaving != none && (ratio > least || (leaving == n_ && ratio == least))) continue;
      if (leaving != none && ratio == least) {
        if (!ties) ties = solved_for(perturbation_);
        if (!ties) return none;
        if (of_pair(*ties, i) / -of_pair(rates, i) >=
            of_pair(*ties, leaving) / -of_pair(rates, leaving))
          continue;
      }
      leaving = i;
      least = std::move(ratio);
    }
    return leaving;
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
  // The free ones first: they are not to stay at a guess. Then the rows of pairs of which neither
  // acts, as far as the acting ones can make them vanish.
  std::vector<std::size_t> unknowns, equations;
  for (const bool is_free : {true, false})
    for (std::size_t i = 0; i < problem.size(); ++i)
      if (problem.is_free(i) == is_free && (is_free || acting[i] == Part::x)) unknowns.push_back(i);
  equations = unknowns;
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (!problem.is_free(i) && acting[i] == Part::neither) equations.push_back(i);
  Column right;
  std::vector<double> near;
  for (const std::size_t i : equations) right.push_back(-problem.q[i]);
  for (const std::size_t i : unknowns) near.push_back(guess[i]);
  const auto solution =
      solution_near(cut(problem, equations, unknowns), right, near, certify_settings.guess_bits);
  if (!solution) return std::nullopt;
  ExactAnswer answer{Column(problem.size()), {}};
  for (std::size_t j = 0; j < unknowns.size(); ++j) answer.x[unknowns[j]] = (*solution)[j];
  answer.w = times(problem, answer.x, problem.q);
  if (!solves_exactly(problem, answer)) return std::nullopt;
  return answer;
}

std::optional<ExactAnswer> answer_of_basis(const MixedProblem& problem, const Basis& basic) {
  return answer_by_pivots(problem, {basic}, 0);
}

std::optional<ExactAnswer> answer_by_pivots(const MixedProblem& problem,
                                            const std::vector<Basis>& bases,
                                            std::size_t most_pivots) {
  // A basis in the middle promises nothing: some paths from it end on rays, others are long. So all
  // of them go on by turns, and the shortest one ends the search.
  const std::uint32_t covers = most_pivots > 0 ? certify_settings.covers : 1;
  for (std::uint32_t cover = 0; cover < covers; ++cover) {
    std::vector<Pivots> paths;
    for (const Basis& basic : bases) paths.emplace_back(problem, basic).start(1 + 2 * cover);
    for (std::size_t pivots = 0;; pivots += certify_settings.pivots_by_turns) {
      for (Pivots& path : paths) {
        if (pivots > 0) path.go_on(certify_settings.pivots_by_turns);
        if (!path.is_solved()) continue;
        ExactAnswer answer = path.answer();
        if (solves_exactly(problem, answer)) return answer;
        return std::nullopt;
      }
      if (pivots >= most_pivots) break;
    }
  }
  return std::nullopt;
}

} // namespace lcpush::desktop
