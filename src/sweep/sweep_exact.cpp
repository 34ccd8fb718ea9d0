// Exact segments: a basis, how far it holds, and the next one by a step of the parametric path.
#include <utility>

#include "lcpush/lcp/pivots/parametric.hpp"
#include "sweep/settings.hpp"
#include "sweep/sweep_pieces.hpp"

namespace lcpush::desktop {
namespace {

class ExactWalk {
public:
  ExactWalk(SweepSolver& solver, Question question, const Progress& progress)
      : solver_(solver), question_(question), progress_(progress) {}

  /// Ends early with what there is.
  std::vector<Piece> run() {
    try {
      walk();
    } catch (const Stopped&) {
    }
    return std::move(pieces_);
  }

private:
  void walk() {
    measure_directions();
    if (!start_at(0) && !start_beyond() && !find_later_start()) return;
    Index steps = 0;
    while (step() && static_cast<Index>(pieces_.size()) < SweepSettings::most_pieces &&
           ++steps < SweepSettings::steps_a_piece * SweepSettings::most_pieces)
      continue;
    const double end = pieces_.empty() ? 0 : pieces_.back().to;
    if (end < 1 - SweepSettings::shortest_segment)
      pieces_.push_back({end, 1, SegmentKind::unsolved}); // gave up: say so
  }

  SweepSolver& solver_;
  Question question_;
  const Progress& progress_;
  std::vector<Piece> pieces_;
  Eigen::VectorXd rest_step_, push_step_; // change of q over the range, times F
  bool moves_push_ = false;
  std::vector<double> scalars_;
  std::vector<int> integers_;

  Basis basis_;
  Status failure_ = Status::bad_input; // of the last cold solve that failed
  double astray_ = -1;           // where a fresh start has been made because a piece was no answer
  double t_ = 0, reference_ = 0; // where the present piece begins; where Lemke stands

  void go_to(double t) { solver_.go_to(value_at(solver_.variations().front(), t)); }
  Assembly<double>& assembly() { return solver_.point().assembly; }

  /// In SI units q is linear, and in the scene's own units it is so up to the unit of force.
  void measure_directions() {
    const auto right_hand_sides = [&](double t) {
      go_to(t);
      const Problem<double> problem = assembly().breaking_problem();
      const double F = assembly().layout().scales.force;
      return std::pair<Eigen::VectorXd, Eigen::VectorXd>(
          F * Eigen::Map<const Eigen::VectorXd>(problem.q, problem.size),
          F * Eigen::Map<const Eigen::VectorXd>(problem.push, problem.size));
    };
    const auto first = right_hand_sides(0), last = right_hand_sides(1);
    const auto step = [](const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
      const double rounding = SweepSettings::rounding_of_steps() * from.cwiseAbs().maxCoeff();
      Eigen::VectorXd by = to - from;
      if (by.cwiseAbs().maxCoeff() <= rounding) by.setZero();
      return by;
    };
    rest_step_ = step(first.first, last.first);
    push_step_ = step(first.second, last.second);
    moves_push_ = question_ == Question::breaking && !push_step_.isZero(0);
  }

  /// From where Lemke stands.
  ParametricPath<double> path() {
    const Problem<double> problem = solver_.point().problem(question_);
    const Index n = problem.size;
    scalars_.resize(static_cast<std::size_t>(parametric_scalars(n)));
    integers_.resize(static_cast<std::size_t>(parametric_integers(n)));
    ParametricPath<double> path({scalars_.data(), parametric_scalars(n)},
                                {integers_.data(), parametric_integers(n)});
    Eigen::VectorXd direction = moves_push_ ? push_step_ : rest_step_;
    if (question_ == Question::push) direction += push_step_;
    direction /= assembly().layout().scales.force;
    (void)path.init(solver_.lemke(), problem, direction.data(), moves_push_);
    return path;
  }

  bool start_at(double t) {
    go_to(t);
    if (!solver_.has(question_)) return false;
    const Status status = solver_.solve_cold(question_, basis_);
    if (status != Status::solved) {
      failure_ = status;
      return false;
    }
    reference_ = t;
    return true;
  }

  /// A fresh solve a little beyond t_, and back to where its basis begins.
  bool start_beyond() {
    for (const double h : SweepSettings::beyond) {
      if (t_ + h > 1 || !start_at(t_ + h)) continue;
      double back = 0;
      const bool ends = path().holds_back_to(back);
      if (!ends || reference_ + back <= t_ + SweepSettings::shortest_segment ||
          h == SweepSettings::beyond[2])
        return true;
    }
    return false;
  }

  /// After t_ nothing was found: the next value that has an answer. The piece in between is
  /// unsolved.
  bool find_later_start() {
    double none = t_, found = -1;
    for (Index k = 1; k <= SweepSettings::probes && found < 0; ++k) {
      const double t = k == SweepSettings::probes
                           ? 1
                           : t_ + (1 - t_) * static_cast<double>(k) / SweepSettings::probes;
      if (start_at(t))
        found = t;
      else
        none = t;
    }
    Piece gap{t_, 1, SegmentKind::unsolved};
    gap.at_from.status = gap.at_to.status = failure_;
    if (found < 0) {
      pieces_.push_back(gap);
      return false;
    }
    while (true) {
      double back = 0;
      if (!path().holds_back_to(back)) back = -reference_;
      found = std::max(reference_ + back, none);
      if (found - none <= SweepSettings::gap_width) break;
      const double middle = (none + found) / 2;
      if (!start_at(middle)) {
        none = middle;
        if (!start_at(found + std::min(SweepSettings::merge_distance, (1 - found) / 2))) break;
      }
    }
    gap.to = found;
    pieces_.push_back(gap);
    t_ = found;
    return true;
  }

  /// The piece from t_ to `end`, solved and checked just inside its ends. False if it is no answer.
  bool add_piece(double end) {
    const double length = end - t_;
    const double first = t_ + SweepSettings::inside_segment * length,
                 last = end - SweepSettings::inside_segment * length;
    const auto at = [&](double t) {
      go_to(t);
      return solver_.on_basis(question_, basis_);
    };
    // Not the very middle: there a motion that changes its sign vanishes.
    const DetailedAnswer a = at(first), b = at(last),
                         middle = at(t_ + SweepSettings::near_middle * length);
    for (const DetailedAnswer* answer : {&a, &b, &middle})
      if (!answer->is_known()) return false;
    Piece piece{t_, end, SegmentKind::exact, on_line(a, first, b, last, t_),
                on_line(a, first, b, last, end)};
    for (DetailedAnswer* answer : {&piece.at_from, &piece.at_to}) {
      answer->status = middle.status;
      answer->contacts = middle.contacts;
      answer->breaks = middle.breaks;
      answer->residual = std::max(a.residual, std::max(b.residual, middle.residual));
    }
    pieces_.push_back(std::move(piece));
    return true;
  }

  /// One piece, and on to the next. False at the end of the range.
  bool step() {
    ParametricPath<double> path = this->path();
    const PathStep<double> step = path.advance(SweepSettings::shortest_segment);
    const double end = step.end == PathEnd::unbounded ? 1 : std::min(1.0, reference_ + step.until);
    if (end - t_ > SweepSettings::shortest_segment && !add_piece(end)) {
      // Rounding has led the path astray, and what it found is not believed: start afresh, once.
      if (t_ != astray_ && start_beyond()) {
        astray_ = t_;
        return true;
      }
      failure_ = Status::numerical_breakdown;
      return find_later_start();
    }
    if (end >= 1 - SweepSettings::shortest_segment) return false;
    t_ = std::max(t_, end);
    progress_(t_);
    if (step.end == PathEnd::forward) {
      Basis next(basis_.size());
      for (std::size_t i = 0; i < next.size(); ++i)
        next[i] = path.is_active(static_cast<Index>(i)) ? 1 : 0;
      const double until = step.next_ends ? std::min(1.0, reference_ + step.next_until) : 1;
      const double middle = t_ + std::max((until - t_) / 2, SweepSettings::shortest_segment);
      go_to(middle);
      if (solver_.stand_on(question_, next)) {
        basis_ = next;
        reference_ = middle;
        if (!pieces_.empty() && step.jumps) pieces_.back().path = PathBreak::jump;
        return true;
      }
    }
    if (!pieces_.empty())
      pieces_.back().path = step.end == PathEnd::turned_back ? PathBreak::turned_back
                            : step.end == PathEnd::ray       ? PathBreak::ray
                                                             : PathBreak::none;
    return start_beyond() || find_later_start();
  }
};

} // namespace

std::vector<Piece> exact_pieces(SweepSolver& solver, Question question, const Progress& progress) {
  return ExactWalk(solver, question, progress).run();
}

} // namespace lcpush::desktop
