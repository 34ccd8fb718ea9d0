// Contact problems with round friction: block Gauss-Seidel, then Newton's method on the contacts'
// active laws within proximal steps [Alart and Curnier 1991; Acary and Brogliato 2008].
//
// Every contact is scaled by what moves it, r_c = d_c x_c and u_c = v_c / d_c with the largest
// diagonal entry of D W D 1: cones stay cones, and a mass ratio between contacts is gone.
#include "contacts/settings.hpp"
#include "lcpush/desktop/contacts.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = ContactProblem::Sparse;
using Settings = ContactSettings;

class ContactSolver {
public:
  explicit ContactSolver(const ContactProblem& problem);
  ContactForces solve();

private:
  const ContactProblem& problem_;
  Index k_;
  VectorXd d_, e_;  // units of forces by row, of multipliers
  double unit_ = 1; // of all forces: the largest number of b and s
  Sparse W_;        // scaled, V (delta - R)^-1 V' added
  std::vector<Matrix3d> W_cc_;
  Eigen::MatrixXd V_;
  VectorXd b_, s_, R_, mu_; // scaled
  VectorXd x_, l_;          // where we are
  VectorXd center_;         // of the proximal step, with its multipliers
  VectorXd q_;              // b and what the centre adds: velocities are W x + eps x + q
  // Weight of the proximal term; smoothing; that of friction, times tau.
  double eps_ = 0, tau_ = 0, smoother_ = 1;
  ContactForces best_;

  void scale();
  void recenter(double eps);
  VectorXd multipliers() const {
    return (V_.transpose() * x_ + s_ + Settings::equality * l_)
        .cwiseQuotient(VectorXd::Constant(R_.size(), Settings::equality) - R_);
  }
  VectorXd velocity(const VectorXd& x) const { return W_ * x + eps_ * x + q_; }
  /// The law of one contact as a projection, where x - v leads: r_n = max(0, y_n), friction within
  /// the disc of mu r_n. Smoothed by tau (Chen, Harker, Kanzow, Smale): then r_n u_n = tau^2.
  Vector3d projected(Index c, const Vector3d& y, Matrix3d* derivative = nullptr) const;
  VectorXd residual(const VectorXd& x, const VectorXd& v) const {
    VectorXd F(x.size());
    for (Index c = 0; c < k_; ++c)
      F.segment<3>(3 * c) =
          x.segment<3>(3 * c) - projected(c, x.segment<3>(3 * c) - v.segment<3>(3 * c));
    return F;
  }
  void solve_contact(Index c);
  void sweep(Index count);
  bool settle();
  VectorXd newton_step(const VectorXd& v, const VectorXd& F) const;
  double note();
  void polish();
  void follow_path();
  static double size_of(const ContactForces& answer) {
    return std::max(
        {answer.worst[0].size, answer.worst[1].size, answer.worst[3].size, answer.worst[4].size});
  }
};

ContactSolver::ContactSolver(const ContactProblem& problem)
    : problem_(problem), k_(problem.contacts()), mu_(problem.mu) {
  scale();
  x_ = VectorXd::Zero(3 * k_);
  l_ = VectorXd::Zero(R_.size());
  recenter(0);
}

void ContactSolver::scale() {
  const ContactProblem& p = problem_;
  d_ = VectorXd::Ones(3 * k_);
  for (Index c = 0; c < k_; ++c) {
    double w = 0;
    for (Index i = 3 * c; i < 3 * c + 3; ++i) w = std::max(w, p.W.coeff(i, i));
    if (w > 0) d_.segment<3>(3 * c).setConstant(1 / std::sqrt(w));
  }
  V_ = d_.asDiagonal() * p.V;
  e_ = VectorXd::Ones(p.s.size());
  for (Index a = 0; a < e_.size(); ++a)
    if (const double size = V_.col(a).norm(); size > 0) e_[a] = 1 / size;
  V_ = V_ * e_.asDiagonal();
  R_ = p.R.cwiseProduct(e_.cwiseAbs2());
  b_ = d_.cwiseProduct(p.b);
  s_ = e_.cwiseProduct(p.s);
  unit_ = std::max(b_.cwiseAbs().maxCoeff(), s_.size() > 0 ? s_.cwiseAbs().maxCoeff() : 0.0);
  if (!(unit_ > 0)) unit_ = 1;
  b_ /= unit_;
  s_ /= unit_;
  W_ = d_.asDiagonal() * p.W * d_.asDiagonal();
  if (e_.size() > 0) {
    const VectorXd give = (VectorXd::Constant(R_.size(), Settings::equality) - R_).cwiseInverse();
    const Eigen::MatrixXd stiff = V_ * give.asDiagonal() * V_.transpose();
    W_ += Sparse(stiff.sparseView());
  }
  for (Index c = 0; c < k_; ++c) {
    Matrix3d block;
    for (Index j = 0; j < 3; ++j)
      for (Index i = 0; i < 3; ++i) block(i, j) = W_.coeff(3 * c + i, 3 * c + j);
    W_cc_.push_back(block);
  }
}

/// The next proximal step starts from here, its weight `eps`; multipliers follow, as those of the
/// method of multipliers do.
void ContactSolver::recenter(double eps) {
  if (R_.size() > 0) l_ = multipliers();
  eps_ = eps;
  center_ = x_;
  q_ = b_ - eps * center_;
  if (R_.size() > 0)
    q_ += V_ * (s_ + Settings::equality * l_)
                   .cwiseQuotient(VectorXd::Constant(R_.size(), Settings::equality) - R_);
}

Vector3d ContactSolver::projected(Index c, const Vector3d& y, Matrix3d* derivative) const {
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

/// One contact while all others stay: open, sticking, or some steps towards its slip.
void ContactSolver::solve_contact(Index c) {
  Vector3d v = q_.segment<3>(3 * c) + eps_ * x_.segment<3>(3 * c);
  for (Index i = 0; i < 3; ++i)
    for (Sparse::InnerIterator entry(W_, 3 * c + i); entry; ++entry)
      v[i] += entry.value() * x_[entry.col()];
  const Matrix3d A = W_cc_[static_cast<std::size_t>(c)] + eps_ * Matrix3d::Identity();
  Vector3d x = x_.segment<3>(3 * c);
  const Vector3d free = v - A * x;
  const double size = A.cwiseAbs().rowwise().sum().maxCoeff();
  if (free[0] >= 0) {
    x_.segment<3>(3 * c).setZero();
    return;
  }
  if (!(size > 0)) return; // nothing that it does moves it
  Eigen::FullPivLU<Matrix3d> lu(A);
  lu.setThreshold(Settings::singular);
  const Vector3d sticks = lu.solve(-free);
  if (sticks[0] >= 0 && sticks.tail<2>().norm() <= mu_[c] * sticks[0] &&
      (A * sticks + free).norm() <= Settings::singular * free.norm()) {
    x_.segment<3>(3 * c) = sticks;
    return;
  }
  for (int step = 0; step < Settings::local_steps; ++step) {
    x = projected(c, x - (A * x + free) / size);
    if (A(0, 0) > 0) // the normal force that closes the contact, and friction within its cone
      x[0] = std::max(0.0, x[0] - (A.row(0).dot(x) + free[0]) / A(0, 0));
    const double t = x.tail<2>().norm();
    if (t > mu_[c] * x[0]) x.tail<2>() *= mu_[c] * x[0] / t;
  }
  x_.segment<3>(3 * c) = x;
}

void ContactSolver::sweep(Index count) {
  for (Index k = 0; k < count; ++k)
    for (Index c = 0; c < k_; ++c) solve_contact(k % 2 == 0 ? c : k_ - 1 - c);
}

/// dx with F + F' dx = 0; open contacts go to 0, which leaves the others' rows.
VectorXd ContactSolver::newton_step(const VectorXd& v, const VectorXd& F) const {
  VectorXd dx = VectorXd::Zero(3 * k_);
  std::vector<Index> place(static_cast<std::size_t>(k_), -1), active;
  for (Index c = 0; c < k_; ++c) {
    if (tau_ > 0 || x_[3 * c] - v[3 * c] > 0) {
      place[static_cast<std::size_t>(c)] = static_cast<Index>(active.size());
      active.push_back(c);
    } else {
      dx.segment<3>(3 * c) = -x_.segment<3>(3 * c);
    }
  }
  const Index n = 3 * static_cast<Index>(active.size());
  const VectorXd known = W_ * dx;
  VectorXd rhs(n);
  const bool is_dense =
      static_cast<double>(W_.nonZeros()) > Settings::dense_share * static_cast<double>(W_.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(is_dense ? n : 0, is_dense ? n : 0);
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Index i, Index j, double value) {
    if (is_dense)
      J(i, j) += value;
    else if (value != 0)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
  };
  for (const Index c : active) {
    const Index at = 3 * place[static_cast<std::size_t>(c)];
    const Vector3d y = x_.segment<3>(3 * c) - v.segment<3>(3 * c);
    Matrix3d P; // F' = (I - P) + P W
    (void)projected(c, y, &P);
    const Matrix3d own = Matrix3d::Identity() - P + eps_ * P;
    for (Index j = 0; j < 3; ++j)
      for (Index i = 0; i < 3; ++i) add(at + i, at + j, own(i, j));
    for (Index m = 0; m < 3; ++m)
      for (Sparse::InnerIterator entry(W_, 3 * c + m); entry; ++entry) {
        const Index to = place[static_cast<std::size_t>(entry.col() / 3)];
        if (to < 0) continue;
        for (Index i = 0; i < 3; ++i)
          add(at + i, 3 * to + entry.col() % 3, P(i, m) * entry.value());
      }
    rhs.segment<3>(at) = -F.segment<3>(3 * c) - P * known.segment<3>(3 * c);
  }
  if (n == 0) return dx;
  VectorXd found;
  if (is_dense) {
    found = Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>>(J).solve(rhs);
  } else {
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(A);
    if (lu.info() != Eigen::Success) return VectorXd::Constant(3 * k_, std::nan(""));
    found = lu.solve(rhs);
  }
  for (std::size_t a = 0; a < active.size(); ++a)
    dx.segment<3>(3 * active[a]) = found.segment<3>(3 * static_cast<Index>(a));
  return dx;
}

/// Newton's method on the smoothed laws. Where no shorter step gains anything the whole one is
/// taken: on the smoothed path that leads over folds; at its end sweeps go on.
bool ContactSolver::settle() {
  int stuck = 0;
  for (int step = 0; step < Settings::newton_steps && stuck <= Settings::patience; ++step) {
    const VectorXd v = velocity(x_), F = residual(x_, v);
    const double before = F.norm(), small = Settings::settled * (1 + x_.norm());
    if (before <= tau_ * Settings::near_path || (step > 0 && before <= small)) return true;
    const VectorXd dx = newton_step(v, F);
    if (!dx.allFinite()) return false;
    bool falls = false;
    double t = 1;
    for (int half = 0; half < Settings::halvings && !falls; ++half, t /= 2) {
      const VectorXd trial = x_ + t * dx;
      falls = residual(trial, velocity(trial)).norm() < (1 - Settings::decrease * t) * before;
      if (falls) x_ = trial;
    }
    if (falls) continue;
    if (tau_ > 0) {
      x_ += dx;
    } else if (before <= small) {
      return true;
    } else {
      ++stuck;
      sweep(Settings::sweeps_between);
    }
  }
  return false;
}

/// Judges where we are, in given units, and keeps the best; its residual, the largest of all laws.
double ContactSolver::note() {
  VectorXd r(3 * k_), l;
  for (Index c = 0; c < k_; ++c) r.segment<3>(3 * c) = projected(c, x_.segment<3>(3 * c));
  r = d_.cwiseProduct(r) * unit_;
  if (R_.size() > 0) l = e_.cwiseProduct(multipliers()) * unit_;
  const ContactForces now = judge_contacts(problem_, r, Settings::solved, &l);
  const double size = size_of(now);
  if (best_.r.size() == 0 || size < size_of(best_)) best_ = now;
  return size;
}

/// The laws themselves, to rounding.
void ContactSolver::polish() {
  tau_ = 0;
  for (int k = 0; k < Settings::patience; ++k) {
    const double best = size_of(best_);
    recenter(Settings::eps);
    const bool settled = settle();
    if (note() <= Settings::aimed_at || (settled && size_of(best_) >= best)) return;
  }
}

/// From a smoothing that everything flows through to none, in steps that shorten where Newton's
/// method does not follow. Among many forces it leads to those in the middle.
void ContactSolver::follow_path() {
  double falls = Settings::falls, tau = 1;
  VectorXd last = VectorXd::Zero(3 * k_);
  for (int k = 0, failed = 0; k < Settings::outer && failed <= Settings::failures; ++k) {
    x_ = last;
    recenter(Settings::eps);
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

ContactForces ContactSolver::solve() {
  const double work = Settings::sweep_work / static_cast<double>(1 + W_.nonZeros());
  const auto most = std::min(Settings::most_sweeps, static_cast<Index>(work));
  double left = note();
  for (Index done = 0; done < most && left > Settings::aimed_at; done += Settings::sweeps_between) {
    sweep(Settings::sweeps_between);
    recenter(0);
    left = note();
  }
  if (left > Settings::aimed_at) polish();
  for (const double smoother : Settings::smoothers) {
    if (best_.is_good) break;
    smoother_ = smoother;
    follow_path();
    polish();
  }
  return best_;
}

} // namespace

ContactForces solve_contacts(const ContactProblem& problem) {
  return ContactSolver(problem).solve();
}

} // namespace lcpush::desktop
