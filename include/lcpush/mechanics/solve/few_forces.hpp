// Which few forces give the object an expected acceleration? Nonnegative least squares over rays of
// the friction cones, in fixed memory: as many as 6 accelerations and the hand's actuators ask for.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush {
namespace detail {

/// Accelerations and actuators of a usual hand.
constexpr Index most_balances = 12;
template <class S> using Balance = Eigen::Matrix<S, most_balances, 1>;

/// A ray of a contact's cone: its normal force, with friction at its limit along one generator; or
/// how a soft pad's pressure leans.
struct Ray {
  Index body = -1;
  Index point = -1;     ///< -1: of the whole pad
  Index generator = -1; ///< -1: no friction; of a pad: which lean
  bool operator==(const Ray& other) const {
    return body == other.body && point == other.point && generator == other.generator;
  }
};

/// Minimises |sum of columns x - target| over x >= 0, as NonnegativeLeastSquares does (lcp/), for
/// columns that are computed when they enter. [Lawson, Hanson 1974, ch. 23]
template <class S> class FewForces {
public:
  /// for_each(rest, visit) calls visit(ray, its column's product with rest) for every candidate.
  /// True: the target is met.
  template <class ForEach, class ColumnOf>
  bool solve(const Balance<S>& target, const ForEach& for_each, const ColumnOf& column_of) {
    const S met = Tolerances<S>().settled * target.norm();
    for (int step = 0; step < 8 * static_cast<int>(most_balances); ++step) {
      const Balance<S> rest = residual(target);
      if (!(rest.norm() > met)) return true;
      if (!let_in(target, rest, for_each, column_of)) return false;
    }
    return false;
  }
  Index size() const { return count_; }
  const Ray& ray(Index k) const { return rays_[k]; }
  const S& force(Index k) const { return x_[k]; }

private:
  static constexpr Index most_barred = 8;
  Eigen::Matrix<S, most_balances, most_balances> columns_, Q_, R_;
  Balance<S> x_ = Balance<S>::Zero(), z_ = Balance<S>::Zero();
  Ray rays_[most_balances];
  Ray barred_[most_barred];
  Index count_ = 0, barred_count_ = 0;

  static S rounding() { return S(1000) * Eigen::NumTraits<S>::epsilon(); }

  Balance<S> residual(const Balance<S>& target) const {
    Balance<S> rest = target;
    for (int sweep = 0; sweep < 2; ++sweep)
      for (Index k = 0; k < count_; ++k) rest -= Q_.col(k).dot(rest) * Q_.col(k);
    return rest;
  }
  bool is_barred(const Ray& ray) const {
    for (Index k = 0; k < count_; ++k)
      if (rays_[k] == ray) return true;
    for (Index k = 0; k < barred_count_; ++k)
      if (barred_[k] == ray) return true;
    return false;
  }

  /// The candidate that lessens the residual most steeply comes into use; those that it makes
  /// negative leave.
  template <class ForEach, class ColumnOf>
  bool let_in(const Balance<S>& target, const Balance<S>& rest, const ForEach& for_each,
              const ColumnOf& column_of) {
    barred_count_ = 0;
    while (count_ < most_balances && barred_count_ < most_barred) {
      Ray best;
      S steepest = rounding() * rest.norm();
      for_each(rest, [&](const Ray& ray, S slope) {
        if (!(slope > steepest) || is_barred(ray)) return;
        steepest = slope;
        best = ray;
      });
      if (best.body < 0) return false;
      if (append(best, column_of(best))) {
        find_least_squares(target);
        if (z_[count_ - 1] > S(0)) {
          move_there(target);
          return true;
        }
        --count_;
      }
      barred_[barred_count_++] = best;
    }
    return false;
  }

  /// Orthogonal to those in use, twice for the digits. False: it depends on them.
  bool append(const Ray& ray, const Balance<S>& column) {
    Balance<S> rest = column;
    R_.col(count_).setZero();
    for (int sweep = 0; sweep < 2; ++sweep)
      for (Index k = 0; k < count_; ++k) {
        const S part = Q_.col(k).dot(rest);
        R_(k, count_) += part;
        rest -= part * Q_.col(k);
      }
    const S size = rest.norm();
    if (!(size > S(1) / S(100000) * column.norm())) return false;
    columns_.col(count_) = column;
    Q_.col(count_) = rest / size;
    R_(count_, count_) = size;
    x_[count_] = S(0);
    rays_[count_++] = ray;
    return true;
  }

  void find_least_squares(const Balance<S>& target) {
    for (Index k = count_ - 1; k >= 0; --k) {
      S sum = Q_.col(k).dot(target);
      for (Index l = k + 1; l < count_; ++l) sum -= R_(k, l) * z_[l];
      z_[k] = sum / R_(k, k);
    }
  }

  /// From x towards z as far as nothing turns negative; what reaches zero leaves. Every turn but
  /// the last lets one leave.
  void move_there(const Balance<S>& target) {
    const auto reach = [&](Index k) { return S(x_[k] / (x_[k] - z_[k])); };
    const auto blocks = [&](Index k) { return !(z_[k] > S(0)) && x_[k] > z_[k]; };
    for (Index turn = 0; turn <= most_balances; ++turn) {
      S share(1);
      for (Index k = 0; k < count_; ++k)
        if (blocks(k) && reach(k) < share) share = reach(k);
      const bool arrives = !(share < S(1));
      const Index before = count_;
      count_ = 0;
      for (Index k = 0; k < before; ++k) {
        const bool leaves = !arrives && blocks(k) && !(reach(k) > share);
        const S moved = arrives ? S(z_[k]) : S(x_[k] + share * (z_[k] - x_[k]));
        const Ray ray = rays_[k];
        const Balance<S> column = columns_.col(k);
        if (leaves) continue;
        if (arrives) {
          x_[k] = moved;
          ++count_;
        } else if (append(ray, column)) {
          x_[count_ - 1] = moved;
        }
      }
      if (arrives) return;
      find_least_squares(target);
    }
  }
};

/// Forces that hold the object and the actuators independently of each other: more of them could
/// not be basic together, unless a compliance tells them apart.
template <class S> class IndependentForces {
public:
  explicit IndependentForces(const Assembly<S>& assembly) : assembly_(assembly) {}

  /// As many as a hand that is usual has: 6 accelerations and its actuators.
  static constexpr Index most = 12;
  bool fits() const { return 6 + assembly_.factored().sums.size <= most; }

  /// Is column `force` of G, of a contact of `body`, independent of those that were taken?
  bool take(Index body, Index force) {
    const Vector6<S>& wrench = assembly_.factored().wrenches[force];
    Eigen::Matrix<S, most, 1> row = Eigen::Matrix<S, most, 1>::Zero();
    row.template head<6>() = wrench;
    for (const Drive<S>& drive : assembly_.scene().drives)
      if (drive.body == body)
        row[6 + drive.actuator] -= laws::grip_coefficient(
            drive, wrench, assembly_.layout().reach[drive.actuator], assembly_.layout().scales);
    const S size = row.norm();
    for (Index l = 0; l < rank_; ++l) row -= taken_.col(l).dot(row) * taken_.col(l);
    const S rest = row.norm();
    if (rank_ == most || !(rest > size / S(1000))) return false;
    taken_.col(rank_++) = row / rest;
    return true;
  }

private:
  const Assembly<S>& assembly_;
  Eigen::Matrix<S, most, most> taken_;
  Index rank_ = 0;
};

} // namespace detail
} // namespace lcpush
