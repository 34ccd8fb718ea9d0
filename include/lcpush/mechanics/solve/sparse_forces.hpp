// Which few forces give the object an expected acceleration? Nonnegative least squares over rays of
// the friction cones, in fixed memory: as many as 6 accelerations and the hand's actuators ask for.
#pragma once

#include "lcpush/lcp/nonnegative_least_squares.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush {
namespace detail {

/// Accelerations and actuators of a usual hand.
constexpr Index most_balances = 12;
template <class S> using Balance = Eigen::Matrix<S, most_balances, 1>;

/// A ray of a contact's cone: its normal force, with friction at its limit along one generator; or
/// how a soft pad's pressure tilts.
struct Ray {
  Index body = -1;
  Index point = -1;     ///< -1: of the whole pad
  Index generator = -1; ///< -1: no friction; of a pad: which tilt
  bool operator==(const Ray& other) const {
    return body == other.body && point == other.point && generator == other.generator;
  }
};

/// Forces >= 0 along rays that add up to a target, by nonnegative least squares.
template <class S> class SparseForces {
public:
  SparseForces()
      : block_({scalars_, Active::scalars(most_balances)}),
        active_(block_, {used_, most_balances}, {barred_, LeastSquaresSettings::rays_tried}) {}
  SparseForces(const SparseForces&) = delete;
  SparseForces& operator=(const SparseForces&) = delete;

  /// From the forces that there are. for_each(rest, visit) calls visit(ray, its column's product
  /// with rest) for every candidate. True: the target is met.
  template <class ForEach, class ColumnOf>
  bool solve(const Balance<S>& target, const ForEach& for_each, const ColumnOf& column_of) {
    const S met = Tolerances<S>().settled * target.norm();
    const Status status = active_.solve(target, Rays<ForEach, ColumnOf>{for_each, column_of},
                                        S(LeastSquaresSettings::ray_dependent), met);
    return status == Status::solved && !(active_.residual().norm() > met);
  }
  Index size() const { return active_.count(); }
  const Ray& ray(Index k) const { return active_.key(k); }
  const S& force(Index k) const { return active_.x(k); }

private:
  using Active = ActiveColumns<S, Ray>;
  template <class ForEach, class ColumnOf> struct Rays {
    const ForEach& for_each;
    const ColumnOf& column;

    template <class IsBarred>
    bool steepest(const VectorMap<S>& residual, const IsBarred& is_barred, Ray& best) const {
      const Balance<S> rest = residual;
      S largest = LeastSquaresSettings::rounding<S>() * rest.norm();
      for_each(rest, [&](const Ray& ray, S slope) {
        if (!(slope > largest) || is_barred(ray)) return;
        largest = slope;
        best = ray;
      });
      return best.body >= 0;
    }
  };
  S scalars_[static_cast<std::size_t>(Active::scalars(most_balances))];
  Ray used_[most_balances], barred_[LeastSquaresSettings::rays_tried];
  Block<S> block_;
  Active active_;
};

/// Forces that hold the object and the actuators independently of each other: more of them could
/// not be basic together, unless a compliance tells them apart.
template <class S> class IndependentForces {
public:
  explicit IndependentForces(const Assembly<S>& assembly) : assembly_(assembly) {}
  IndependentForces(const IndependentForces&) = delete;
  IndependentForces& operator=(const IndependentForces&) = delete;

  static constexpr Index most = most_balances;
  bool fits() const { return 6 + assembly_.factored().sums.size <= most; }

  /// Is column `force` of G, of a contact of `body`, independent of those that were taken?
  bool take(Index body, Index force) {
    const Vector6<S>& wrench = assembly_.factored().wrenches[force];
    Balance<S> row = Balance<S>::Zero();
    row.template head<6>() = wrench;
    for_each_grip(assembly_.scene(), assembly_.layout(), body, wrench,
                  [&](Index a, const S& grip) { row[6 + a] -= grip; });
    return taken_.count() < most && taken_.take(row, S(LeastSquaresSettings::force_dependent));
  }

private:
  const Assembly<S>& assembly_;
  S memory_[static_cast<std::size_t>(most * most)];
  IndependentColumns<S> taken_{{memory_, most* most}, most};
};

} // namespace detail
} // namespace lcpush
