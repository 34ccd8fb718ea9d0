#include "spread/spread_face.hpp"

namespace lcpush::desktop {
namespace {

constexpr double far = 1000; // units of force, for what has no end

Face::Point point_of(Simplex::Ending ending) {
  switch (ending) {
  case Simplex::Ending::found: return Face::Point::found;
  case Simplex::Ending::none: return Face::Point::none;
  case Simplex::Ending::unbounded: return Face::Point::unbounded;
  case Simplex::Ending::failed: break;
  }
  return Face::Point::failed;
}

} // namespace

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

/// Rows: balance of accelerations, then of actuators, then the signs of the motion, then p <= 1.
/// Columns: free motions, p, edges, what each sign has left.
void Face::assemble(const ModeMotions& motions) {
  const bool rests = instant_ == Instant::at_rest, any = instant_ == Instant::any_push;
  const Index balances = problem_.load().size(), a = problem_.moving();
  const Index signs = rests ? 0 : motions.signs.rows();
  const Index bounded = signs + (any ? 1 : 0), edges = static_cast<Index>(edges_.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(balances + bounded, first_edge_ + edges + bounded);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(A.rows());
  b.head(balances) = problem_.load();
  if (!rests) {
    Eigen::MatrixXd kinetic = span_.topRows(balances);
    kinetic.bottomRows(balances - a) =
        problem_.inertia().asDiagonal() * span_.middleRows(a, balances - a);
    A.topLeftCorner(balances, first_edge_) = kinetic.leftCols(first_edge_);
    A.block(balances, 0, signs, first_edge_) = motions.signs.leftCols(first_edge_);
    if (!any) {
      b.head(balances) -= problem_.push() * kinetic.col(moving_);
      b.tail(signs) = -problem_.push() * motions.signs.col(moving_);
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
  program_.emplace(A, b, moving_);
}

Face::Answer Face::whole(const Eigen::VectorXd& v) const {
  Answer answer;
  answer.z = Eigen::VectorXd::Zero(problem_.layout().size);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const double along = std::max(v[first_edge_ + static_cast<Index>(k)], 0.0);
    answer.z[edges_[k].normal] += along;
    if (edges_[k].friction >= 0) answer.z[edges_[k].friction] += edges_[k].mu * along;
  }
  if (instant_ == Instant::at_rest) return answer;
  answer.push = instant_ == Instant::any_push ? v[moving_] : problem_.push();
  Eigen::VectorXd y(moving_ + 1);
  y << v.head(moving_), answer.push;
  const Eigen::VectorXd x = span_ * y;
  answer.z.tail(problem_.actuators()) = x.segment(problem_.moving(), problem_.actuators());
  return answer;
}

Face::Point Face::find_point() {
  if (!program_) return Point::none;
  const Point ending = point_of(program_->find_point());
  corners_ = program_->point();
  count_ = 1;
  return ending;
}

bool Face::find_inner_point(std::vector<bool>& carries) {
  constexpr double force = 1e-7; // of the scene's
  carries.assign(edges_.size(), true);
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const Index column = first_edge_ + static_cast<Index>(k);
    if (corners_[column] > count_ * force) continue;
    Answer ignored;
    c[column] = -1;
    const Point ending = minimise(c, ignored);
    c[column] = 0;
    if (ending == Point::failed) return false;
    carries[k] = ending == Point::unbounded || program_->point()[column] > force;
  }
  return true;
}

Face::Point Face::minimise(const Eigen::VectorXd& c, Answer& answer) {
  const Point ending = point_of(program_->minimise(c));
  if (ending == Point::failed) return ending;
  Eigen::VectorXd v = program_->point();
  if (ending == Point::unbounded) v += far * program_->ray();
  corners_ += ending == Point::unbounded ? program_->point() + program_->ray() : v;
  ++count_;
  answer = whole(v);
  return ending;
}

Face::Point Face::lowest(const Eigen::VectorXd& f, Answer& answer) {
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  for (std::size_t k = 0; k < edges_.size(); ++k)
    c[first_edge_ + static_cast<Index>(k)] =
        f[edges_[k].normal] + (edges_[k].friction < 0 ? 0 : edges_[k].mu * f[edges_[k].friction]);
  return minimise(c, answer);
}

Face::Point Face::largest_push(Answer& answer) {
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  c[moving_] = -1;
  return minimise(c, answer);
}

} // namespace lcpush::desktop
