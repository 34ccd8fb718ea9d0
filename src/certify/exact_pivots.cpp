#include "certify/exact_pivots.hpp"

#include <cstdint>

#include "certify/exact_columns.hpp"

namespace lcpush::desktop {
namespace {

/// Small whole numbers that look like chance, the same ones every time.
class Generic {
public:
  explicit Generic(std::uint32_t seed) : state_(seed) {}
  Rational next() {
    state_ = state_ * 1664525U + 1013904223U;
    return 1000 + static_cast<int>(state_ >> 22U);
  }

private:
  std::uint32_t state_;
};

/// Lemke's method on the original rows: every pivot solves for what is basic anew.
class Pivots {
public:
  Pivots(const MixedProblem& problem, std::vector<unsigned char> basic)
      : problem_(problem), n_(problem.size()), basic_(std::move(basic)) {
    for (std::size_t i = 0; i < n_; ++i)
      if (problem_.is_free(i)) basic_[i] = 1;
  }

  /// `seed` chooses the covering vector, and with it the path.
  void start(std::uint32_t seed) {
    seed_ = seed;
    if (!evaluate(problem_.q)) return end(State::lost);
    if (is_feasible()) return end(State::solved);
    choose_cover();
    if (!append(rhs_.back())) return end(State::lost);
    enter_artificial();
    pivots_ = 1;
  }

  void go_on(std::size_t pivots) {
    for (std::size_t k = 0; k < pivots && state_ == State::going; ++k) {
      ++pivots_;
      if (!step())
        end(State::lost);
      else if (blocked_ == none)
        end(evaluate(problem_.q) ? State::solved : State::lost);
    }
  }

  bool is_solved() const { return state_ == State::solved; }
  /// Pre: solved.
  ExactAnswer answer() const { return {x_, w_, pivots_}; }

private:
  enum class State : unsigned char { going, solved, lost }; // lost: singular, or on a ray
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  const MixedProblem& problem_;
  const std::size_t n_;
  State state_ = State::going;
  std::size_t pivots_ = 0;
  std::vector<unsigned char> basic_; // is x_i (else w_i) basic?
  std::size_t blocked_ = none;       // the pair of which neither is, while z0 is
  bool x_enters_ = false;            // or w, of that pair
  std::uint32_t seed_ = 0;
  Column cover_;
  std::vector<Column> rhs_; // q, then the perturbation that decides ties
  std::optional<ExactSystem> system_;
  std::vector<std::size_t> places_;  // rows and columns of the system
  std::vector<Column> x_, w_;        // for the right-hand sides that were needed
  std::vector<Rational> artificial_; // z0 for each of them

  void end(State state) { state_ = state; }
  bool is_feasible() const {
    for (std::size_t i = 0; i < n_; ++i)
      if (!problem_.is_free(i) && (sign_at(x_, i) < 0 || sign_at(w_, i) < 0)) return false;
    return true;
  }

  /// The matrix of what is basic, z0 last.
  ExactSystem system(std::vector<std::size_t>& places) const {
    places.clear();
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] != 0) places.push_back(i);
    std::vector<std::size_t> rows = places;
    if (blocked_ != none) rows.push_back(blocked_);
    std::vector<ExactRow> matrix = cut(problem_, rows, places);
    for (std::size_t k = 0; blocked_ != none && k < rows.size(); ++k)
      if (cover_[rows[k]].sign() != 0)
        matrix[k].push_back({static_cast<Index>(places.size()), cover_[rows[k]]});
    places = rows; // of the rows; the unknowns are the same but the last
    return ExactSystem(matrix);
  }

  /// x, w and z0 with L x + cover z0 + constant = w and everything that is not basic zero but, by
  /// `right`, the rows of places_.
  bool spread(const Column& right, const Column& constant, Column& x, Column& w,
              Rational& z0) const {
    std::vector<Rational> b;
    for (std::size_t k = 0; k < places_.size(); ++k) b.push_back(right[k] - constant[places_[k]]);
    const auto solution = system_->solve(b);
    if (!solution) return false;
    const std::size_t count = blocked_ == none ? places_.size() : places_.size() - 1;
    for (std::size_t k = 0; k < count; ++k) x[places_[k]] = (*solution)[k];
    z0 = blocked_ == none ? Rational(0) : solution->back();
    w = times(problem_, x, constant, cover_, z0);
    return true;
  }

  bool evaluate(const std::vector<Column>& rhs) {
    factor();
    if (system_->is_singular()) return false;
    for (const Column& q : rhs)
      if (!append(q)) return false;
    return true;
  }
  void factor() {
    system_.emplace(system(places_));
    x_.clear();
    w_.clear();
    artificial_.clear();
  }
  bool append(const Column& q) {
    x_.emplace_back(n_);
    w_.emplace_back(n_);
    artificial_.emplace_back(0);
    return spread(Column(places_.size()), q, x_.back(), w_.back(), artificial_.back());
  }

  /// A column that is the given positive numbers in terms of the present basis.
  Column positive_here(Generic generic) const {
    Column x(n_), size(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      size[i] = generic.next();
      if (basic_[i] != 0 && !problem_.is_free(i)) x[i] = size[i];
    }
    Column column = times(problem_, x);
    for (std::size_t i = 0; i < n_; ++i)
      column[i] = (basic_[i] != 0 ? Rational(0) : size[i]) - column[i];
    return column;
  }
  void choose_cover() {
    cover_ = positive_here(Generic(seed_));
    rhs_ = problem_.q;
    rhs_.push_back(positive_here(Generic(seed_ + 1)));
  }

  /// The pair's value in terms of the basis.
  const std::vector<Column>& values(std::size_t i) const { return basic_[i] != 0 ? x_ : w_; }

  /// z0 rises until nothing is negative; what was the last to be leaves.
  void enter_artificial() {
    Generic sizes(seed_);
    std::vector<Rational> most;
    for (std::size_t i = 0; i < n_; ++i) {
      const Rational size = sizes.next();
      if (problem_.is_free(i) || sign_at(values(i), i) >= 0) continue;
      std::vector<Rational> need;
      for (const Column& column : values(i)) need.push_back(-column[i] / size);
      if (blocked_ != none && !(most < need)) continue;
      most = std::move(need);
      blocked_ = i;
    }
    x_enters_ = basic_[blocked_] == 0;
    basic_[blocked_] = 0;
  }

  /// One pivot; false on a ray.
  bool step() {
    factor();
    if (system_->is_singular() || !append(rhs_.front())) return false;
    Column constant(n_), right(places_.size()), dx(n_), dw;
    Rational dz0;
    if (x_enters_) {
      for (std::size_t i = 0; i < n_; ++i)
        for (const ExactEntry& entry : problem_.rows[i])
          if (static_cast<std::size_t>(entry.column) == blocked_) constant[i] = entry.value;
    } else {
      right.back() = 1;
    }
    if (!spread(right, constant, dx, dw, dz0)) return false;
    const auto falls = [&](std::size_t i) -> const Rational& {
      return i == n_ ? dz0 : basic_[i] != 0 ? dx[i] : dw[i];
    };
    const auto ratio = [&](std::size_t i, std::size_t k) {
      return (i == n_ ? artificial_[k] : values(i)[k][i]) / -falls(i);
    };
    std::size_t leaving = none;
    std::vector<Rational> least, mine;
    // Most pivots are decided by q: the other right-hand sides are solved for at the first tie.
    const auto blocks_before = [&](std::size_t i) {
      mine.clear();
      for (std::size_t k = 0; k < rhs_.size(); ++k) {
        if (k == x_.size() && !append(rhs_[k])) return false;
        if (k == least.size()) least.push_back(ratio(leaving, k));
        mine.push_back(ratio(i, k));
        if (mine[k] != least[k]) return mine[k] < least[k];
      }
      return false;
    };
    for (std::size_t k = 0; k <= n_; ++k) {
      const std::size_t i = k == 0 ? n_ : k - 1; // z0 first: it wins a tie
      if (i < n_ && (problem_.is_free(i) || i == blocked_)) continue;
      if (falls(i).sign() >= 0 || (leaving != none && !blocks_before(i))) continue;
      leaving = i;
      least.swap(mine);
    }
    if (leaving == none) return false;
    basic_[blocked_] = x_enters_ ? 1 : 0;
    blocked_ = leaving == n_ ? none : leaving;
    if (blocked_ == none) return true;
    x_enters_ = basic_[blocked_] == 0;
    basic_[blocked_] = 0;
    return true;
  }
};

} // namespace

bool solves_exactly(const MixedProblem& problem, const ExactAnswer& answer) {
  for (std::size_t k = 0; k < problem.q.size(); ++k) {
    const Column product = times(problem, answer.x[k]);
    for (std::size_t i = 0; i < problem.size(); ++i)
      if (product[i] + problem.q[k][i] != answer.w[k][i]) return false;
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const bool rests = sign_at(answer.w, i) == 0;
    if (problem.is_free(i) ? !rests
                           : sign_at(answer.x, i) < 0 || sign_at(answer.w, i) < 0 ||
                                 (!rests && sign_at(answer.x, i) != 0))
      return false;
  }
  return true;
}

std::optional<ExactAnswer> answer_near(const MixedProblem& problem, const std::vector<Part>& acting,
                                       const std::vector<std::vector<double>>& guess) {
  // The free ones first: they are not to stay at a guess. Then the rows of pairs of which neither
  // acts, as far as the acting ones can make them vanish.
  std::vector<std::size_t> unknowns, equations;
  for (const bool is_free : {true, false})
    for (std::size_t i = 0; i < problem.size(); ++i)
      if (problem.is_free(i) == is_free && (is_free || acting[i] == Part::x)) unknowns.push_back(i);
  equations = unknowns;
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (!problem.is_free(i) && acting[i] == Part::neither) equations.push_back(i);
  const std::vector<ExactRow> rows = cut(problem, equations, unknowns);
  ExactAnswer answer;
  for (std::size_t k = 0; k < problem.q.size(); ++k) {
    Column right;
    std::vector<double> near;
    for (const std::size_t i : equations) right.push_back(-problem.q[k][i]);
    for (const std::size_t i : unknowns) near.push_back(guess[k][i]);
    const auto solution = solution_near(rows, right, near);
    if (!solution) return std::nullopt;
    Column x(problem.size());
    for (std::size_t j = 0; j < unknowns.size(); ++j) x[unknowns[j]] = (*solution)[j];
    Column w = times(problem, x);
    for (std::size_t i = 0; i < problem.size(); ++i) w[i] += problem.q[k][i];
    answer.x.push_back(std::move(x));
    answer.w.push_back(std::move(w));
  }
  if (!solves_exactly(problem, answer)) return std::nullopt;
  return answer;
}

std::optional<ExactAnswer> answer_from_bases(const MixedProblem& problem,
                                             const std::vector<Basis>& bases,
                                             std::size_t most_pivots) {
  // A basis in the middle promises nothing: some paths from it end on rays, others are long. So all
  // of them go on by turns, and the shortest one ends the search.
  constexpr std::uint32_t covers = 4;
  constexpr std::size_t turn = 6;
  for (std::uint32_t cover = 0; cover < covers; ++cover) {
    std::vector<Pivots> paths;
    for (const Basis& basic : bases) paths.emplace_back(problem, basic).start(1 + 2 * cover);
    for (std::size_t pivots = 0;; pivots += turn) {
      for (const Pivots& path : paths)
        if (path.is_solved()) {
          ExactAnswer answer = path.answer();
          return solves_exactly(problem, answer) ? std::optional(std::move(answer)) : std::nullopt;
        }
      if (pivots >= most_pivots) break;
      for (Pivots& path : paths) {
        path.go_on(std::min(turn, most_pivots - pivots));
        if (path.is_solved()) break;
      }
    }
  }
  return std::nullopt;
}

} // namespace lcpush::desktop
