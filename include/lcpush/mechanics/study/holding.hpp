// [T.19] Which grip holds the load, and how much more it holds: without heap, in a bounded number
// of steps. Linear programs whose rows are the object's balance and the actuators' forces, and
// whose columns are the extreme rays of the fingers' friction pyramids. A pyramid of g facets has
// at least cos(pi / g) of the cone's friction: the grasp holds no less than it says.
#pragma once

#include <limits>

#include "lcpush/lcp/revised_simplex.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"
#include "lcpush/mechanics/study/study_memory.hpp"

namespace lcpush {

template <class S> struct Held {
  /// solved: forces that hold so much were found, and a motion that more would drive; or a squeeze
  /// that bears any amount. does_not_hold: a motion was found that no contact resists. pivot_limit,
  /// numerical_breakdown: not known. bad_input: see `reason`.
  Status status = Status::bad_input;
  Reason reason = Reason::none; ///< unsupported or memory_too_small
  S value{0};                   ///< what was asked for; infinite: any amount
  /// How the object gives way beyond the value, or because nothing holds it, [1; 1/m]: its largest
  /// part, angles times Scales::length, is 1. Zeros if it does not.
  Vector6<S> twist = Vector6<S>::Zero();
  Index exchanges = 0;
};

/// The extreme rays of the fingers' pyramids as columns: none is stored, each is made of two of G.
template <class S> class FingerRays {
public:
  explicit FingerRays(const Assembly<S>& assembly)
      : assembly_(assembly), scene_(assembly.scene()), layout_(assembly.layout()) {
    for_each([&](Index, Index, Index, Index) { ++count_; });
  }

  Index count() const { return count_; }
  Index moving() const { return scene_.planar ? 3 : 6; } ///< rows of the object, then the actuators
  Index rows() const { return moving() + layout_.actuators; }
  Index axis(Index row) const { return balance_axis(scene_, row); }
  const Body<S>& body(Index point) const { return scene_.bodies[layout_.body[point]]; }

  void write(Index j, const Span<S>& column) const {
    for_each([&](Index ray, Index point, Index normal, Index friction) {
      if (ray == j) write(point, force(point, normal, friction), column);
    });
  }
  /// What a force at the point does, in the assembly's units. Pre: zeros.
  void write(Index point, const Vector6<S>& force, const Span<S>& column) const {
    for (Index row = 0; row < moving(); ++row) column[row] = force[axis(row)];
    for_each_drive(point, [&](Index row, const Vector6<S>& twist) {
      column[row] += laws::grip_coefficient(twist, force);
    });
  }

  /// By how y moves the object against each point's body.
  template <class Visit> void for_each_product(const Span<S>& y, const Visit& visit) const {
    Vector6<S> motion;
    Index of = -1;
    for_each([&](Index ray, Index point, Index normal, Index friction) {
      if (point != of) {
        motion.setZero();
        for (Index row = 0; row < moving(); ++row) motion[axis(row)] = y[row];
        for_each_drive(point,
                       [&](Index row, const Vector6<S>& twist) { motion += y[row] * twist; });
        of = point;
      }
      visit(ray, S(force(point, normal, friction).dot(motion)));
    });
  }

private:
  const Assembly<S>& assembly_;
  const Scene<S>& scene_;
  const Layout<S>& layout_;
  Index count_ = 0;

  template <class Visit> void for_each(const Visit& visit) const {
    Index ray = 0;
    for (Index i = 0; i < layout_.points; ++i)
      if (body(i).role == Role::finger)
        detail::for_each_ray(layout_.cones[i], [&](Index normal, Index friction) {
          visit(ray++, i, normal, friction);
        });
  }
  /// visit(row, twist) for the actuators that move the point's body.
  template <class Visit> void for_each_drive(Index point, const Visit& visit) const {
    for (const Drive<S>& drive : scene_.drives)
      if (drive.body == layout_.body[point])
        visit(moving() + drive.actuator,
              laws::drive_twist(drive, layout_.reach[drive.actuator], layout_.scales));
  }
  Vector6<S> force(Index point, Index normal, Index friction) const {
    const Span<const Vector6<S>>& G = assembly_.factored().wrenches;
    if (normal == friction) return G[normal];
    return G[normal] + layout_.cones[point].friction * G[friction];
  }
};

/// Bytes that Holding takes, wherever they begin.
template <class S> constexpr Index holding_bytes(Index actuators) {
  const Index rows = 6 + actuators;
  return static_cast<Index>(sizeof(S)) * (rows + 6) * rows +
         static_cast<Index>(sizeof(Index)) * (rows + 2);
}

/// An assembled scene at rest, its pushers left out. Any pressure will do: under `pad` that is the
/// law only where no normal is a sum of others; else pads are refused, and so is round friction.
/// Locked fingers squeeze with any force. Cost of an exchange, of which a question takes no more
/// than it is told to: O(rows (forces + rows^2)).
template <class S> class Holding {
public:
  /// Pre: the assembly outlives this, and is not used otherwise meanwhile.
  Holding(const Assembly<S>& assembly, Arena memory) : assembly_(assembly), rays_(assembly) {
    m_.inverse = memory.zeros<S>(rays_.rows() * rays_.rows());
    memory.fill(rays_.rows(), m_.b, m_.e, m_.x, m_.y, m_.step, m_.column, m_.basis);
    if (memory.exhausted())
      refused_ = Reason::memory_too_small;
    else if (!is_statics())
      refused_ = Reason::unsupported;
  }

  /// The least, or the largest, factor >= 0 on all grip forces that holds the load.
  [[nodiscard]] Held<S> least_grip(Index exchanges) { return grip(S(1), exchanges); }
  [[nodiscard]] Held<S> most_grip(Index exchanges) { return grip(S(-1), exchanges); }

  /// The largest t >= 0 for which the grip as it is holds the load and t times `wrench`, [N; N m]
  /// at the centre of mass; in a planar scene what lies in the plane.
  [[nodiscard]] Held<S> margin(const Vector6<S>& wrench, Index exchanges) {
    if (!demand()) return {Status::bad_input, refused_};
    const Scales<S>& scales = assembly_.layout().scales;
    for (Index row = 0; row < rays_.moving(); ++row)
      m_.e[row] = wrench[rays_.axis(row)] / (scales.force * length_of(row));
    return ask(S(-1), false, exchanges);
  }

private:
  const Assembly<S>& assembly_;
  FingerRays<S> rays_;
  SimplexMemory<S> m_;
  Reason refused_ = Reason::none;

  /// m, of a row that is a moment.
  S length_of(Index row) const {
    return rays_.axis(row) < 3 ? S(1) : assembly_.layout().scales.length;
  }

  /// [T.19]: is the scene's law that any pressure will do?
  bool is_statics() {
    const Scene<S>& scene = assembly_.scene();
    Index normals = 0;
    for (Index i = 0; i < assembly_.layout().points; ++i) {
      if (rays_.body(i).role != Role::finger) continue;
      if (has_round_friction(scene, rays_.body(i))) return false;
      if (scene.pressure != Pressure::pad) continue;
      if (normals == rays_.rows()) return false;
      S* const normal = m_.inverse.data + normals * rays_.rows();
      rays_.write(i, assembly_.factored().wrenches[assembly_.layout().cones[i].force],
                  {normal, rays_.rows()});
      if (!make_orthogonal(normal, normals++)) return false;
    }
    return true;
  }

  /// To the unit columns before it, twice for the digits; false: it is a sum of them.
  bool make_orthogonal(S* column, Index count) const {
    const Index rows = rays_.rows();
    const auto squares = [&] { return detail::dot_along(column, 1, column, rows); };
    const S dependent = Tolerances<S>().independent * Eigen::numext::sqrt(squares());
    for (Index k = 0; k < 2 * count; ++k) {
      const S* const unit = m_.inverse.data + k % count * rows;
      detail::add_scaled(column, unit, S(-detail::dot_along(unit, 1, column, rows)), rows);
    }
    const S left = Eigen::numext::sqrt(squares());
    for (Index row = 0; row < rows; ++row) column[row] /= left;
    return left > dependent;
  }

  /// What the fingers have to do with the grip as it is; false: refused.
  bool demand() {
    if (refused_ != Reason::none) return false;
    const Scene<S>& scene = assembly_.scene();
    const Vector6<S> load = laws::load(scene, assembly_.layout().scales);
    for (Index row = 0; row < rays_.rows(); ++row) {
      const Index a = row - rays_.moving();
      const bool is_idle = a >= 0 && !grips(scene, a);
      m_.b[row] = a < 0     ? S(-load[rays_.axis(row)])
                  : is_idle ? S(0)
                            : assembly_.factored().sums[a].target;
      m_.e[row] = S(0);
    }
    return true;
  }

  Held<S> grip(S cost, Index exchanges) {
    if (!demand()) return {Status::bad_input, refused_};
    for (Index row = rays_.moving(); row < rays_.rows(); ++row) {
      m_.e[row] = -m_.b[row];
      m_.b[row] = S(0);
    }
    return ask(cost, true, exchanges);
  }

  Held<S> ask(S cost, bool with_factor, Index exchanges) {
    Held<S> held;
    RevisedSimplex<S, FingerRays<S>> program(rays_, m_);
    held.status = program.minimise(cost, with_factor, exchanges, held.value);
    held.exchanges = program.exchanges();
    if (held.status == Status::ray) {
      held.status = Status::solved;
      held.value = std::numeric_limits<S>::infinity();
    } else if (held.status == Status::solved || held.status == Status::does_not_hold) {
      write_twist(held.twist);
    }
    return held;
  }

  /// The load drives the dual backwards.
  void write_twist(Vector6<S>& twist) const {
    S size(0);
    for (Index row = 0; row < rays_.moving(); ++row)
      size = Eigen::numext::maxi(size, S(Eigen::numext::abs(m_.y[row])));
    for (Index row = 0; size > S(0) && row < rays_.moving(); ++row)
      twist[rays_.axis(row)] = -m_.y[row] / (size * length_of(row));
  }
};

} // namespace lcpush
