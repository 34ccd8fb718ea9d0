// What a contact force does to the object and to the hand's actuators, and what a change of those
// is worth to it.
#pragma once

#include "lcpush/mechanics/solve/sparse_forces.hpp"

namespace lcpush {
namespace detail {

/// The forces of an assembled scene as columns over accelerations and actuators.
template <class S> class ForceColumns {
public:
  explicit ForceColumns(const Assembly<S>& assembly) : assembly_(assembly) {}

protected:
  const Assembly<S>& assembly_;

  const Vector6<S>& wrench(Index force) const { return assembly_.factored().wrenches[force]; }
  const ConeGroup<S>& cone(Index i) const { return assembly_.factored().cones[i]; }
  const Body<S>& body(Index b) const { return assembly_.scene().bodies[b]; }
  /// Its points share their force as their compliance says.
  bool is_soft(Index b) const { return cone(body(b).first_point).compliance > S(0); }

  /// What a unit of the force adds to the object's acceleration and to the actuators' sums.
  Balance<S> column(Index b, Index force) const {
    Balance<S> column = Balance<S>::Zero();
    column.template head<6>() = assembly_.factored().mobility.lazyProduct(wrench(force));
    for_each_grip(assembly_.scene(), assembly_.layout(), b, wrench(force),
                  [&](Index a, const S& grip) { column[6 + a] -= grip; });
    return column;
  }
  /// column(b, force)' rest is the force's wrench times this.
  Vector6<S> seen_by(Index b, const Balance<S>& rest) const {
    Vector6<S> sum = assembly_.factored().mobility.transpose().lazyProduct(rest.template head<6>());
    for (const Drive<S>& drive : assembly_.scene().drives)
      if (drive.body == b)
        sum -= rest[6 + drive.actuator] *
               laws::drive_twist(drive, assembly_.layout().reach[drive.actuator],
                                 assembly_.layout().scales);
    return sum;
  }
};

} // namespace detail
} // namespace lcpush
