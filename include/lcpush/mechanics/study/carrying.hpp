// [T.12] at the grip as it is: do forces within the friction cones bear the load? The least factor
// on the grip says so as well, but is a linear program; here a sum of the cones' extreme rays is
// looked for, one equation a direction of motion and an actuator.
#pragma once

#include "lcpush/mechanics/study/existence.hpp"

namespace lcpush {

namespace detail {

struct CarryingSize {
  Index rows = 0, forces = 0, rays = 0;

  constexpr Index scalars() const { return rows * forces + cone_membership_scalars(rows, rays); }
  constexpr Index integers() const { return least_squares_integers(rows, rays); }
};

} // namespace detail

template <class S> detail::CarryingSize carrying_size(const Assembly<S>& assembly) {
  const Layout<S>& layout = assembly.layout();
  detail::CarryingSize size;
  size.rows = detail::balance_rows(assembly);
  size.forces = layout.forces;
  for (const ConeGroup<S>& cone : layout.cones)
    detail::for_each_ray(cone, [&](Index, Index) { ++size.rays; });
  return size;
}

/// `memory`: of carrying_size. Post: solved, and it is carried: the forces found leave at most a
/// ten-millionth of the load; or it is not known: mostly no such forces were found.
/// Cost: O(rays) an exchange, about as many as there are rows; nothing grows with their square.
template <class S>
[[nodiscard]] Status carries_load(const Assembly<S>& assembly, const StudyMemory<S>& memory) {
  const detail::CarryingSize size = carrying_size(assembly);
  Block<S> scalars(memory.scalars);
  MatrixMap<S> forces{nullptr, 0, 0};
  scalars.seat(forces, size.rows, size.forces);
  ConeMembership<S> question(scalars.take(cone_membership_scalars(size.rows, size.rays)),
                             memory.integers, size.rows, size.rays);
  if (scalars.exhausted() || !question.fits) return Status::bad_input;
  forces.setZero();
  detail::fill_balance(assembly, forces);
  Index ray = 0;
  for (const ConeGroup<S>& cone : assembly.layout().cones)
    detail::for_each_ray(cone, [&](Index normal, Index friction) {
      question.A.col(ray) = forces.col(normal);
      if (friction != normal) question.A.col(ray) += cone.friction * forces.col(friction);
      ++ray;
    });
  const S load = detail::fill_load(assembly, question.b);
  if (!(load > S(0))) return Status::solved;
  const Index moving = size.rows - assembly.layout().actuators;
  for (Index a = 0; a < assembly.layout().actuators; ++a)
    question.b[moving + a] = assembly.factored().sums[a].target;
  const S unit = question.b.cwiseAbs().maxCoeff();
  question.b /= unit;
  const Status status = question.ask(size.rays);
  const bool is_exact = question.residual.norm() * unit <= load / S(10000000);
  return status == Status::solved && !is_exact ? Status::numerical_breakdown : status;
}

} // namespace lcpush
