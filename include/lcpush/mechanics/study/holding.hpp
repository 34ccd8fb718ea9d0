// [T.12] Holding: the smallest factor on the grip forces at which statics lets the hand and its
// environment, all at rest, hold the object. A linear program over the forces f and the factor phi:
//
//   minimise phi    G f + w = 0,   Q_a(f) = phi tau_a (actuators of fingers) or tau_a (others),
//                   mu_i lambda_i - sum_j beta_ij >= 0,   f >= 0,   phi >= 0.
//
// Every state of rest under [T.1] to [T.5], whatever the pressure law, is a point of it. It has few
// equations and many forces: b(phi) = b_0 + phi t has to lie in the cone of the friction cones'
// extreme rays. Where it does not, what least squares leave of it, r, is a plane between the two,
// and no phi below the one that brings b into that plane holds: the next to be asked.
#pragma once

#include "lcpush/lcp/cone_membership.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush {

template <class S> struct Holding {
  S factor{0}; ///< phi: no smaller one holds
  S unit{0};   ///< the factor that makes the largest grip force equal to the load; 0: there is none
};

/// Equations: one a direction of motion and an actuator; columns: one an extreme ray, at most.
constexpr Index holding_rows(const AssemblySize& size) { return 6 + size.actuators; }
constexpr Index holding_columns(const AssemblySize& size) {
  return size.points + size.pulls + 2 * size.generators;
}
constexpr Index holding_scalars(const AssemblySize& size) {
  const Index m = holding_rows(size);
  return m * (size.forces() + 2) + cone_membership_scalars(m, holding_columns(size));
}
constexpr Index holding_integers(const AssemblySize& size) {
  return least_squares_integers(holding_rows(size), holding_columns(size));
}

/// Of [T.12], and of the existence lemma's conditions.
template <class S> struct StudyMemory {
  Span<S> scalars;    ///< holding_scalars, existence_scalars
  Span<int> integers; ///< holding_integers, existence_integers
};

/// Does the actuator drive a finger, so that phi scales it?
template <class S> bool grips(const Scene<S>& scene, Index actuator) {
  for (const Drive<S>& drive : scene.drives)
    if (drive.actuator == actuator && scene.bodies[drive.body].role == Role::finger) return true;
  return false;
}

namespace detail {

/// Row by row, the component of a wrench that has to balance: x, y and the turn in the plane.
template <class S> Index balance_axis(const Scene<S>& scene, Index row) {
  return scene.planar && row == 2 ? 5 : row;
}

/// Extreme rays of a point's cone: visit(normal, friction), columns of G, equal without friction.
template <class S, class Visit>
void for_each_ray(const ConeGroup<S>& cone, const Visit& visit, bool smooth = false) {
  for (Index normal = cone.force; normal < cone.force + cone.normals; ++normal) {
    if (smooth || cone.generators == 0) visit(normal, normal);
    for (Index j = 0; !smooth && j < cone.generators; ++j)
      visit(normal, cone.force + cone.normals + j);
  }
}

template <class S> Index count_rays(const Layout<S>& layout) {
  Index rays = 0;
  for (const ConeGroup<S>& cone : layout.cones) for_each_ray(cone, [&](Index, Index) { ++rays; });
  return rays;
}

/// Does b(phi) lie in the cone of the extreme rays? Loads and forces are measured in the load, so
/// that the numbers are about 1, and phi in load over grip.
template <class S> class BalanceQuestion {
public:
  BalanceQuestion(const Assembly<S>& assembly, const StudyMemory<S>& memory)
      : assembly_(assembly), moving_(assembly.scene().planar ? 3 : 6),
        rows_(moving_ + assembly.layout().actuators), rays_(count_rays(assembly.layout())),
        block_(memory.scalars), cone_(take_cone(memory)) {
    if (!fits()) return;
    fill_loads();
    fill_rays();
  }

  bool fits() const { return !block_.exhausted() && cone_.fits; }
  const S& load() const { return load_; }
  const S& grip() const { return grip_; }

  /// As ConeMembership::ask.
  Status ask(const S& phi) {
    cone_.b = fixed_ + phi * scaled_;
    return cone_.ask(rays_);
  }
  // Unless forces were found, of the plane of the residual:
  /// Does it exclude every larger phi as well?
  bool is_parallel() const {
    const S flat = S(64) * Eigen::NumTraits<S>::epsilon() * cone_.residual.norm() * scaled_.norm();
    return !(slope() < -flat);
  }
  /// Is it known where it ends? To a ten-millionth, as rounding lets rays touch it.
  bool is_sharp() const { return cone_.steepest <= -slope() / S(10000000); }
  /// The least phi that it does not exclude.
  S next() const { return -cone_.residual.dot(fixed_) / slope(); }
  /// What the forces found leave of the balance, over the load.
  S open() const { return cone_.residual.norm(); }

private:
  const Assembly<S>& assembly_;
  Index moving_, rows_, rays_;
  Block<S> block_;
  MatrixMap<S> forces_{nullptr, 0, 0};
  VectorMap<S> fixed_{nullptr, 0}, scaled_{nullptr, 0}; // b_0 and t
  ConeMembership<S> cone_;
  S load_{0}, grip_{0};

  S slope() const { return cone_.residual.dot(scaled_); }
  ConeMembership<S> take_cone(const StudyMemory<S>& memory) {
    block_.seat(forces_, rows_, assembly_.layout().forces);
    for (VectorMap<S>* map : {&fixed_, &scaled_}) block_.seat(*map, rows_);
    return {block_.take(cone_membership_scalars(rows_, rays_)), memory.integers, rows_, rays_};
  }

  void fill_loads() {
    using Eigen::numext::abs, Eigen::numext::maxi;
    const Scene<S>& scene = assembly_.scene();
    const Vector6<S> load = laws::load(scene, assembly_.layout().scales);
    fixed_.setZero();
    scaled_.setZero();
    for (Index row = 0; row < moving_; ++row) fixed_[row] = -load[balance_axis(scene, row)];
    for (Index a = 0; a < assembly_.layout().actuators; ++a) {
      const S& target = assembly_.factored().sums[a].target;
      (grips(scene, a) ? scaled_ : fixed_)[moving_ + a] = target;
    }
    for (Index row = 0; row < rows_; ++row) {
      load_ = maxi(load_, S(abs(fixed_[row])));
      grip_ = maxi(grip_, S(abs(scaled_[row])));
    }
    if (load_ > S(0)) fixed_ /= load_;
    if (grip_ > S(0)) scaled_ /= grip_;
  }

  /// G f in the first rows (in the plane only if the scene is planar), Q_a(f) in those after them.
  void fill_rays() {
    const Layout<S>& layout = assembly_.layout();
    const FactoredProblem<S>& factored = assembly_.factored();
    forces_.setZero();
    for (Index j = 0; j < layout.forces; ++j)
      for (Index row = 0; row < moving_; ++row)
        forces_(row, j) = factored.wrenches[j][balance_axis(assembly_.scene(), row)];
    for (Index a = 0; a < layout.actuators; ++a) {
      const SumGroup<S>& sum = factored.sums[a];
      for (Index k = sum.first; k < sum.first + sum.count; ++k) {
        const Index variable = factored.coupled_variable[k];
        const ConeGroup<S>& cone = layout.cones[cone_of(layout.cones, variable)];
        forces_(moving_ + a, cone.force + variable - cone.variable) += factored.coupling[k];
      }
    }
    Index ray = 0;
    for (const ConeGroup<S>& cone : layout.cones)
      for_each_ray(cone, [&](Index normal, Index friction) {
        auto column = cone_.A.col(ray++);
        column = forces_.col(normal);
        if (friction != normal) column += cone.friction * forces_.col(friction);
      });
  }
};

} // namespace detail

/// The least factor on the forces of the actuators that drive a finger. Pushers of the assembled
/// scene are at rest and bear what they must. Post: solved (no factor below holding.factor holds);
/// does_not_hold (no factor holds at all); both proved, by forces and by planes that are checked on
/// the rays themselves; bad_input (memory too small), or nothing is known.
/// Cost: a few least squares, each O(rays) an exchange.
template <class S>
[[nodiscard]] Status find_holding(const Assembly<S>& assembly, const StudyMemory<S>& memory,
                                  Holding<S>& holding) {
  constexpr int most_questions = 60;
  holding = {};
  detail::BalanceQuestion<S> question(assembly, memory);
  if (!question.fits()) return Status::bad_input;
  if (!(question.load() > S(0))) return Status::solved; // nothing to hold
  if (question.grip() > S(0)) holding.unit = question.load() / question.grip();
  S phi(0);
  for (int k = 0; k < most_questions; ++k) {
    const Status status = question.ask(phi);
    holding.factor = phi * holding.unit;
    const bool is_open = status == Status::numerical_breakdown; // too near for a strict proof
    if (status != Status::ray && !is_open) return status;
    if (question.is_parallel()) return is_open ? status : Status::does_not_hold;
    if (!question.is_sharp()) return Status::numerical_breakdown;
    const S next = question.next();
    if (!(next > phi)) return Status::numerical_breakdown; // nothing but rounding is left
    phi = next;
  }
  return Status::pivot_limit;
}

/// Does the grip as it is carry the load? `memory` as for find_holding. Post: solved, and it does:
/// the forces found leave at most a ten-millionth of the load; or it is not known.
template <class S>
[[nodiscard]] Status carries_load(const Assembly<S>& assembly, const StudyMemory<S>& memory) {
  detail::BalanceQuestion<S> question(assembly, memory);
  if (!question.fits()) return Status::bad_input;
  if (!(question.load() > S(0))) return Status::solved;
  const Status status = question.ask(question.grip() / question.load());
  const bool is_exact = question.open() <= S(1) / S(10000000);
  return status == Status::solved && !is_exact ? Status::numerical_breakdown : status;
}

} // namespace lcpush
