// Contact problems with round friction: Newton's method on the contacts' active laws within
// proximal steps [Alart and Curnier 1991; Acary and Brogliato 2008], along a path of smoothed laws
// if need be.
//
// Every contact is scaled by what moves it, r_c = d_c x_c and u_c = v_c / d_c with the largest
// diagonal entry of D W D 1: cones stay cones, and a mass ratio between contacts is gone.
#include "contacts/contact_order.hpp"
#include "contacts/settings.hpp"
#include "dense/decompositions.hpp"
#include "lcpush/desktop/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Settings = ContactSettings;

constexpr double infinity = std::numeric_limits<double>::infinity();

class ContactSolver {
public:
  explicit ContactSolver(const ContactProblem& problem);
  ContactForces solve();

private:
  const ContactProblem& problem_;
  Index k_;
  VectorXd d_, e_; // units of forces by row, of multipliers
  double unit_;    // of all forces: the largest number of b and s
  SparseRows W_;   // scaled, eps and V give V' added
  MatrixXd V_;
  std::vector<Index> order_;      // of elimination
  VectorXd b_, s_, give_, mu_;    // scaled; give: 1 / (delta - R), of the method of multipliers
  VectorXd x_, l_;                // where we are
  VectorXd q_;                    // b and what a step's start adds: velocities are W x + q
  double tau_ = 0, smoother_ = 1; // smoothing; that of friction, times tau
  std::vector<ForceMode> held_;   // modes that the laws are held to, if any
  RowMatrix J_;                   // F' = (I - P) + P W beside -F
  ContactForces best_;

  void scale();
  VectorXd multipliers() const {
    return (product(V_.transpose(), x_) + s_ + Settings::equality * l_).cwiseProduct(give_);
  }
  void recenter();
  VectorXd velocity(const VectorXd& x) const;
  /// The law of one contact as a projection, where x - v leads: r_n = max(0, y_n), friction within
  /// the disc of mu r_n. Smoothed by tau (Chen, Harker, Kanzow, Smale): then r_n u_n = tau^2.
  Vector3d projected(Index c, const Vector3d& y, Matrix3d* derivative = nullptr) const;
  /// The same where its mode is known.
  static Vector3d projected(ForceMode mode, double mu, const Vector3d& y, Matrix3d* derivative);
  bool is_closed(Index c, const VectorXd& v) const {
    return held_.empty() ? tau_ > 0 || x_[3 * c] - v[3 * c] > 0
                         : held_[static_cast<std::size_t>(c)] != ForceMode::open;
  }
  VectorXd in_cones(VectorXd x) const;
  VectorXd residual(const VectorXd& x, const VectorXd& v) const;
  bool settle();
  std::optional<VectorXd> newton_step(const VectorXd& v, const VectorXd& F);
  void note();
  void polish();
  void follow_path();
  std::vector<ForceMode> modes() const;
  void begin_at_pyramids(VectorXd& turns);
};

double size_of(const ContactForces& answer) {
  return std::max(
      {answer.worst[0].size, answer.worst[1].size, answer.worst[3].size, answer.worst[4].size});
}

ContactSolver::ContactSolver(const ContactProblem& problem)
    : problem_(problem), k_(problem.contacts()), d_(VectorXd::Ones(3 * k_)), V_(problem.V),
      mu_(problem.mu), x_(VectorXd::Zero(3 * k_)), l_(VectorXd::Zero(problem.s.size())) {
  scale();
  order_ = contact_order(W_);
  recenter();
}

void ContactSolver::scale() {
  const ContactProblem& p = problem_;
  for (Index c = 0; c < k_; ++c) {
    const double w =
        std::max({p.W(3 * c, 3 * c), p.W(3 * c + 1, 3 * c + 1), p.W(3 * c + 2, 3 * c + 2)});
    if (w > 0) d_.segment<3>(3 * c).setConstant(1 / std::sqrt(w));
  }
  e_ = VectorXd::Ones(l_.size());
  for (Index a = 0; a < e_.size(); ++a) {
    V_.col(a) = V_.col(a).cwiseProduct(d_);
    if (const double size = V_.col(a).norm(); size > 0) e_[a] = 1 / size;
    V_.col(a) *= e_[a];
  }
  b_ = p.b.cwiseProduct(d_);
  s_ = p.s.cwiseProduct(e_);
  unit_ = std::max(b_.cwiseAbs().maxCoeff(), s_.size() > 0 ? s_.cwiseAbs().maxCoeff() : 0.0);
  if (!(unit_ > 0)) unit_ = 1;
  b_ /= unit_;
  s_ /= unit_;
  give_ = (Settings::equality - (p.R.array() * e_.array().square())).inverse();
  W_.cols = 3 * k_;
  W_.entries.reserve(p.W.entries.size() + static_cast<std::size_t>(W_.cols));
  for (Index i = 0; i < 3 * k_; ++i) {
    VectorXd row = product(V_, V_.row(i).transpose().cwiseProduct(give_));
    row[i] += Settings::eps;
    for (const SparseEntry& entry : p.W.row(i))
      row[entry.column] += d_[i] * entry.value * d_[entry.column];
    W_.add_row(row);
  }
}

/// The next proximal step starts from here; multipliers follow, as those of the method of
/// multipliers do.
void ContactSolver::recenter() {
  l_ = multipliers();
  q_ = b_ - Settings::eps * x_ + product(V_, (s_ + Settings::equality * l_).cwiseProduct(give_));
}

VectorXd ContactSolver::velocity(const VectorXd& x) const {
  VectorXd v = q_;
  for (Index i = 0; i < v.size(); ++i)
    for (const SparseEntry& entry : W_.row(i)) v[i] += entry.value * x[entry.column];
  return v;
}

Vector3d ContactSolver::projected(Index c, const Vector3d& y, Matrix3d* derivative) const {
  if (!held_.empty()) return projected(held_[static_cast<std::size_t>(c)], mu_[c], y, derivative);
  const double root = std::hypot(y[0], 2 * tau_), t = y.tail<2>().norm();
  const double n = root > 0 ? (y[0] > 0 ? (y[0] + root) / 2 : 2 * tau_ * tau_ / (root - y[0])) : 0;
  const double most = mu_[c] * n, gap = std::hypot(most - t, 2 * smoother_ * tau_);
  const double larger = (most + t + gap) / 2; // max(most, t), smoothed
  const double share = larger > 0 ? most / larger : 1;
  if (derivative != nullptr) {
    Matrix3d& P = *derivative;
    P.setZero();
    P(0, 0) = root > 0 ? (1 + y[0] / root) / 2 : 0;
    const double up = gap > 0 ? (1 + (most - t) / gap) / 2 : 1; // d larger / d most
    const Eigen::Vector2d along =
        t > 0 ? Eigen::Vector2d(y.tail<2>() / t) : Eigen::Vector2d::Zero();
    const double by_most = larger > 0 ? t / larger * (1 - share * up) : 0;
    const double by_t = larger > 0 ? share * (1 - t / larger * (1 - up)) : 0;
    P.bottomLeftCorner<2, 1>() = mu_[c] * P(0, 0) * by_most * along;
    P.bottomRightCorner<2, 2>() =
        share * Eigen::Matrix2d::Identity() + (by_t - share) * along * along.transpose();
  }
  return {n, y[1] * share, y[2] * share};
}

Vector3d ContactSolver::projected(ForceMode mode, double mu, const Vector3d& y,
                                  Matrix3d* derivative) {
  Matrix3d P = Matrix3d::Identity();
  Vector3d r = y;
  if (mode == ForceMode::open) {
    P.setZero();
    r.setZero();
  } else if (const double t = y.tail<2>().norm(); mode == ForceMode::slip && t > 0) {
    const Eigen::Vector2d along = y.tail<2>() / t;
    r.tail<2>() = mu * y[0] * along;
    P.bottomLeftCorner<2, 1>() = mu * along;
    P.bottomRightCorner<2, 2>() =
        mu * y[0] / t * (Eigen::Matrix2d::Identity() - along * along.transpose());
  }
  if (derivative != nullptr) *derivative = P;
  return r;
}

VectorXd ContactSolver::in_cones(VectorXd x) const {
  for (Index c = 0; c < k_; ++c) x.segment<3>(3 * c) = projected(c, x.segment<3>(3 * c));
  return x;
}

VectorXd ContactSolver::residual(const VectorXd& x, const VectorXd& v) const {
  VectorXd F = x;
  for (Index c = 0; c < k_; ++c)
    F.segment<3>(3 * c) -= projected(c, x.segment<3>(3 * c) - v.segment<3>(3 * c));
  return F;
}

/// dx with F + F' dx = 0; open contacts go to 0, which leaves the others' rows.
std::optional<VectorXd> ContactSolver::newton_step(const VectorXd& v, const VectorXd& F) {
  VectorXd dx = VectorXd::Zero(3 * k_);
  std::vector<Index> place(static_cast<std::size_t>(k_), -1), active;
  for (const Index c : order_) {
    if (is_closed(c, v)) {
      place[static_cast<std::size_t>(c)] = 3 * static_cast<Index>(active.size());
      active.push_back(c);
    } else {
      dx.segment<3>(3 * c) = -x_.segment<3>(3 * c);
    }
  }
  const Index n = 3 * static_cast<Index>(active.size());
  J_.setZero(n, n + 1);
  for (const Index c : active) {
    const Index at = place[static_cast<std::size_t>(c)];
    Matrix3d P;
    (void)projected(c, x_.segment<3>(3 * c) - v.segment<3>(3 * c), &P);
    J_.block<3, 3>(at, at) = Matrix3d::Identity() - P;
    J_.col(n).segment<3>(at) = -F.segment<3>(3 * c);
    for (Index m = 0; m < 3; ++m)
      for (const SparseEntry& entry : W_.row(3 * c + m)) {
        const Index to = place[static_cast<std::size_t>(entry.column / 3)];
        if (to >= 0)
          J_.col(to + entry.column % 3).segment<3>(at) += P.col(m) * entry.value;
        else
          J_.col(n).segment<3>(at) -= P.col(m) * (entry.value * dx[entry.column]);
      }
  }
  const auto found = eliminate(J_);
  if (!found || !found->allFinite()) return std::nullopt;
  for (std::size_t a = 0; a < active.size(); ++a)
    dx.segment<3>(3 * active[a]) = found->col(0).segment<3>(3 * static_cast<Index>(a));
  return dx;
}

/// Newton's method on the smoothed laws. A step turns friction along a tangent of its circle, far
/// outside of which the residual of a slow slip is nothing: it goes back to the cones. Where no
/// shorter step gains anything the whole one is taken: on the smoothed path that leads over folds.
bool ContactSolver::settle() {
  VectorXd v = velocity(x_), F = residual(x_, v);
  const auto go = [&](VectorXd x, double most) {
    if (tau_ == 0) x = in_cones(x);
    VectorXd at_x = velocity(x), left = residual(x, at_x);
    if (!(left.norm() < most)) return false;
    x_.swap(x);
    v.swap(at_x);
    F.swap(left);
    return true;
  };
  for (int step = 0; step < Settings::newton_steps; ++step) {
    const double before = F.norm(), small = Settings::settled * (1 + x_.norm());
    if (before <= tau_ * Settings::near_path || (step > 0 && before <= small)) return true;
    const auto dx = newton_step(v, F);
    if (!dx) return false;
    bool falls = false;
    double t = 1;
    for (int half = 0; half < Settings::halvings && !falls; ++half, t /= 2)
      falls = go(x_ + t * *dx, (1 - Settings::decrease * t) * before);
    if (falls) continue;
    if (tau_ == 0) return before <= small;
    if (!go(x_ + *dx, infinity)) return false;
  }
  return false;
}

/// Judges where we are, in given units, and keeps the best.
void ContactSolver::note() {
  const VectorXd r = d_.cwiseProduct(in_cones(x_)) * unit_;
  const VectorXd l = e_.cwiseProduct(multipliers()) * unit_;
  ContactForces now = judge_contacts(problem_, r, Settings::solved, &l);
  if (best_.r.size() == 0 || size_of(now) < size_of(best_)) best_ = std::move(now);
}

/// The laws themselves, to rounding.
void ContactSolver::polish() {
  tau_ = 0;
  for (int k = 0; k < Settings::patience; ++k) {
    const double best = best_.r.size() > 0 ? size_of(best_) : infinity;
    recenter();
    const bool settled = settle();
    note();
    if (size_of(best_) <= Settings::aimed_at || (settled && size_of(best_) >= best)) return;
  }
}

/// From a smoothing that everything flows through to none, in steps that shorten where Newton's
/// method does not follow. Among many forces it leads to those in the middle.
void ContactSolver::follow_path() {
  double falls = Settings::falls, tau = 1;
  VectorXd last = VectorXd::Zero(3 * k_);
  for (int k = 0, failed = 0; k < Settings::outer && failed <= Settings::failures; ++k) {
    x_ = last;
    recenter();
    tau_ = tau * (k > 0 ? falls : 1);
    if (settle()) {
      tau = tau_;
      last = x_;
      falls = std::max(Settings::falls, falls * falls);
    } else {
      ++failed;
      falls = std::sqrt(falls);
    }
    if (tau < Settings::last_tau) return;
  }
}

/// The modes that the laws lead to from where we are.
std::vector<ForceMode> ContactSolver::modes() const {
  std::vector<ForceMode> result;
  const VectorXd y = x_ - velocity(x_);
  for (Index c = 0; c < k_; ++c)
    result.push_back(y[3 * c] <= 0                                         ? ForceMode::open
                     : y.segment<2>(3 * c + 1).norm() <= mu_[c] * y[3 * c] ? ForceMode::stick
                                                                           : ForceMode::slip);
  return result;
}

/// Pyramids' answers have mostly the modes of round cones, however long the path there is. With
/// these held, and whole steps, Newton's method turns the friction; then come the modes there.
/// `turns`: of the pyramids; afterwards so that each has an edge against its slip, as round cones
/// do.
void ContactSolver::begin_at_pyramids(VectorXd& turns) {
  const ContactForces start = solve_contact_pyramids(problem_, Settings::facets, turns);
  turns.resize(k_);
  for (Index c = 0; c < k_; ++c) {
    const bool slips = start.modes[static_cast<std::size_t>(c)] == ForceMode::slip;
    const auto along = slips ? Eigen::Vector2d(-start.u.segment<2>(3 * c + 1))
                             : Eigen::Vector2d(start.r.segment<2>(3 * c + 1));
    turns[c] = std::atan2(along.y(), along.x());
  }
  x_ = start.r.cwiseQuotient(d_) / unit_;
  l_ = start.l.cwiseQuotient(e_) / unit_;
  tau_ = 0;
  std::vector<ForceMode> next = start.modes;
  for (int round = 0; round < Settings::patience && next != held_; ++round) {
    held_ = next;
    bool is_there = false;
    for (int step = 0; step < Settings::newton_steps && !is_there; ++step) {
      recenter();
      const VectorXd v = velocity(x_);
      const auto dx = newton_step(v, residual(x_, v));
      if (!dx) break;
      x_ = in_cones(x_ + *dx);
      is_there = dx->norm() <= Settings::eps * x_.norm();
    }
    next = modes();
  }
  held_.clear();
}

ContactForces ContactSolver::solve() {
  polish();
  for (const double smoother : Settings::smoothers) {
    if (best_.is_good) break;
    smoother_ = smoother;
    follow_path();
    polish();
  }
  VectorXd turns;
  for (Index k = 0; !best_.is_good && k < Settings::most_turns; ++k) {
    if (Settings::facets * k_ > Settings::pyramid_sides) break;
    begin_at_pyramids(turns);
    polish();
  }
  if (!best_.is_good) best_.none = contradiction(problem_, best_.r);
  if (!best_.is_good && best_.none.size() == 0) best_.none = find_contradiction(problem_);
  return best_;
}

} // namespace

ContactForces solve_contacts(const ContactProblem& problem) {
  return ContactSolver(problem).solve();
}

} // namespace lcpush::desktop
