#include "spread/spread_face.hpp"

#include <algorithm>

#include "dense/decompositions.hpp"
#include "spread/settings.hpp"

namespace lcpush::desktop {
Face::Face(const LiteralProblem& problem, const FaceModes& modes, const ModeMotions& motions,
           Instant instant)
    : problem_(problem), instant_(instant) {
  if (!motions.possible && instant != Instant::at_rest) return;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const std::vector<ConeEdge> edges = problem.edges_of(static_cast<Index>(i), modes[i]);
    edges_.insert(edges_.end(), edges.begin(), edges.end());
  }
  if (instant != Instant::at_rest) {
    span_ = motions.span;
    moving_ = span_.cols() - 1;
  }
  first_edge_ = moving_ + (instant == Instant::any_push ? 1 : 0);
  assemble(motions);
}

Face::Face(const Face& rest, const ModeMotions& motions, const std::vector<bool>& carries)
    : problem_(rest.problem_), instant_(Instant::begins), span_(motions.span),
      moving_(span_.cols() - 1), first_edge_(moving_) {
  for (const bool carrying : {true, false})
    for (std::size_t k = 0; k < carries.size(); ++k)
      if (carries[k] == carrying) edges_.push_back(rest.edges_[k]);
  assemble(motions, std::count(carries.begin(), carries.end(), true));
}

/// Rows: balance of accelerations, then of actuators, then the signs of the motion, then p <= 1.
/// Columns: free motions, p, edges, of which the first `carrying` have no sign, what each sign has
/// left.
void Face::assemble(const ModeMotions& motions, Index carrying) {
  const bool rests = instant_ == Instant::at_rest, any = instant_ == Instant::any_push;
  const Index balances = problem_.load().size(), a = problem_.moving();
  const Index signs = rests ? 0 : motions.signs.rows();
  const Index bounded = signs + (any ? 1 : 0), edges = static_cast<Index>(edges_.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(balances + bounded, first_edge_ + edges + bounded);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(A.rows());
  if (instant_ != Instant::begins) b.head(balances) = problem_.load();
  if (!rests) {
    Eigen::MatrixXd kinetic = span_.topRows(balances);
    kinetic.bottomRows(balances - a) =
        problem_.inertia().asDiagonal() * span_.middleRows(a, balances - a);
    A.topLeftCorner(balances, first_edge_) = kinetic.leftCols(first_edge_);
    A.block(balances, 0, signs, first_edge_) = motions.signs.leftCols(first_edge_);
    if (!any) {
      b.head(balances) -= push() * kinetic.col(moving_);
      b.tail(signs) = -push() * motions.signs.col(moving_);
    } else {
      A(A.rows() - 1, moving_) = -1;
      b[A.rows() - 1] = -1;
    }
  }
  for (Index k = 0; k < edges; ++k) {
    const Eigen::VectorXd effect = effect_of(problem_, edges_[static_cast<std::size_t>(k)]);
    A.col(first_edge_ + k).head(a) = -effect.head(a);
    A.col(first_edge_ + k).segment(a, balances - a) = effect.tail(balances - a);
  }
  A.bottomRightCorner(bounded, bounded).diagonal().setConstant(-1);
  for (Index r = 0; r < balances; ++r) {
    const double size = A.row(r).lpNorm<Eigen::Infinity>(); // 0 without columns
    if (!(size > 0)) continue;
    A.row(r) /= size;
    b[r] /= size;
  }
  work_ += static_cast<double>(A.size());
  program_.emplace(A, b, moving_ + carrying);
}

Face::Answer Face::whole(const Eigen::VectorXd& v) const {
  Answer answer;
  answer.z = Eigen::VectorXd::Zero(problem_.layout().size);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    double along = v[first_edge_ + static_cast<Index>(k)];
    if (instant_ != Instant::begins) along = std::max(along, 0.0);
    answer.z[edges_[k].normal] += along;
    if (edges_[k].friction >= 0) answer.z[edges_[k].friction] += edges_[k].mu * along;
  }
  if (instant_ == Instant::at_rest) return answer;
  answer.push = instant_ == Instant::any_push ? v[moving_] : push();
  Eigen::VectorXd y(moving_ + 1);
  y << v.head(moving_), answer.push;
  const Eigen::VectorXd x = product(span_, y);
  answer.z.tail(problem_.actuators()) = x.segment(problem_.moving(), problem_.actuators());
  return answer;
}

Face::Ending Face::find_point() {
  if (!program_) return Ending::none;
  const Ending ending = program_->find_point();
  corners_ = program_->point();
  count_ = 1;
  return ending;
}

Face::Ending Face::find_own_point(const ModeMotions& motions) {
  const double least =
      std::max(SpreadSettings::own_answer * problem_.push(), SpreadSettings::nothing);
  const Index first = first_edge_ + static_cast<Index>(edges_.size());
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  for (std::size_t k = 0; k < motions.strict.size(); ++k) {
    const Index column = first + static_cast<Index>(k); // what the sign has left
    if (!motions.strict[k] || corners_[column] > count_ * least) continue;
    Answer ignored;
    c[column] = -1;
    const Ending ending = minimise(c, ignored);
    c[column] = 0;
    if (ending == Ending::failed) return ending;
    if (ending == Ending::found && !(program_->point()[column] > least)) return Ending::none;
  }
  return Ending::found;
}

bool Face::find_inner_point(std::vector<bool>& carries) {
  constexpr double force = SpreadSettings::carries;
  carries.assign(edges_.size(), true);
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const Index column = first_edge_ + static_cast<Index>(k);
    if (corners_[column] > count_ * force) continue;
    Answer ignored;
    c[column] = -1;
    const Ending ending = minimise(c, ignored);
    c[column] = 0;
    if (ending == Ending::failed) return false;
    carries[k] = ending == Ending::unbounded || program_->point()[column] > force;
  }
  return true;
}

Face::Ending Face::minimise(const Eigen::VectorXd& c, Answer& answer) {
  const Ending ending = program_->minimise(c);
  if (ending == Ending::failed) return ending;
  Eigen::VectorXd v = program_->point();
  if (ending == Ending::unbounded) v += SpreadSettings::far * program_->ray();
  corners_ += ending == Ending::unbounded ? program_->point() + program_->ray() : v;
  ++count_;
  answer = whole(v);
  return ending;
}

Face::Ending Face::lowest(const Eigen::VectorXd& f, Answer& answer) {
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  for (std::size_t k = 0; k < edges_.size(); ++k)
    c[first_edge_ + static_cast<Index>(k)] =
        f[edges_[k].normal] + (edges_[k].friction < 0 ? 0 : edges_[k].mu * f[edges_[k].friction]);
  return minimise(c, answer);
}

Face::Ending Face::slowest(Index k, double sign, Answer& answer) {
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  c.head(moving_) = sign * span_.row(k).head(moving_).transpose();
  return minimise(c, answer);
}

double Face::motion(Index k) const {
  return span_.row(k).head(moving_).dot(program_->point().head(moving_)) +
         span_(k, moving_) * push();
}

Face::Ending Face::largest_push(Answer& answer) {
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  c[moving_] = -1;
  return minimise(c, answer);
}

} // namespace lcpush::desktop
