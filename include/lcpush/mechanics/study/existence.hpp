// Does the existence lemma [T.8] hold for a scene (theory.md 5.3, 5.4)?
//
//   (H1) fails if   s' >= 0, sum s' = 1,   sum_a W(n_i)' J_a s'_a <= 0 at every contact
//                   has a solution for the massless actuators;
//   (H2) fails if   f in the cones,   G f = 0,   Q_a(f) = 0,   P(f) = 1
//                   has one: a squeeze that no actuator feels and that the prescribed motions
//                   tighten.
//
// A cone is what its extreme rays span, W(n_i) + mu_i W(d_ij), so that both ask whether a point
// lies in a finitely generated cone: least squares answer yes with the point, or no with the
// residual, which proves it. Asked for contacts without compliance: that covers the literal laws
// and, as compliance only takes squeezes away, every first round of the pads.
#pragma once

#include "lcpush/lcp/cone_membership.hpp"
#include "lcpush/mechanics/study/study_memory.hpp"

namespace lcpush {

enum class Existence {
  not_known,         ///< a linear program failed, or the memory is too small
  proved,            ///< an answer exists for every load and grip force
  closes_on_nothing, ///< (H1) fails
  can_be_squeezed,   ///< (H2) fails
  may_retreat,       ///< they hold, but an actuator could end at its bound (5.4)
};

namespace detail {

template <class S> bool is_massless(const Assembly<S>& assembly, Index actuator) {
  return !(assembly.factored().sums[actuator].inertia > S(0));
}

/// Does another massless actuator move one of its bodies? Then (H1) has to weigh them up.
template <class S> bool shares_a_body(const Assembly<S>& assembly, Index actuator) {
  const Span<const Drive<S>>& drives = assembly.scene().drives;
  for (const Drive<S>& mine : drives) {
    if (mine.actuator != actuator) continue;
    for (const Drive<S>& other : drives)
      if (other.body == mine.body && other.actuator != actuator &&
          is_massless(assembly, other.actuator))
        return true;
  }
  return false;
}

/// visit(cone, offset, coefficient) for each force that the actuator feels; offsets below
/// cone.normals are normal forces.
template <class S, class Visit>
void for_each_load(const Assembly<S>& assembly, Index actuator, const Visit& visit) {
  const FactoredProblem<S>& factored = assembly.factored();
  const SumGroup<S>& sum = factored.sums[actuator];
  for (Index k = sum.first; k < sum.first + sum.count; ++k) {
    const Index variable = factored.coupled_variable[k], i = cone_of(factored.cones, variable);
    visit(i, variable - factored.cones[i].variable, factored.coupling[k]);
  }
}

/// Does it feel normal forces alone, and closes on all that it feels? Then a squeeze that it does
/// not feel has no force at those contacts.
template <class S> bool only_closes(const Assembly<S>& assembly, Index actuator) {
  bool only = true;
  for_each_load(assembly, actuator, [&](Index i, Index offset, const S& load) {
    only = only && offset < assembly.factored().cones[i].normals && load > S(0);
  });
  return only;
}

template <class S> bool closes_on_something(const Assembly<S>& assembly, Index actuator) {
  bool closes = false;
  for_each_load(assembly, actuator, [&](Index i, Index offset, const S& load) {
    closes = closes || (offset < assembly.factored().cones[i].normals && load > S(0));
  });
  return closes;
}

} // namespace detail

/// Rows and columns of the two questions' matrices.
struct ExistenceSize {
  Index closing_rows = 0, closing_columns = 0, squeeze_rows = 7, squeeze_columns = 0;
  Index points = 0;

  constexpr Index scalars() const {
    const Index closing = of(closing_rows, closing_columns);
    const Index squeeze = of(squeeze_rows, squeeze_columns);
    return closing > squeeze ? closing : squeeze;
  }
  constexpr Index integers() const {
    const Index m = closing_rows > squeeze_rows ? closing_rows : squeeze_rows;
    const Index n = closing_columns > squeeze_columns ? closing_columns : squeeze_columns;
    return points + least_squares_integers(m, n);
  }

private:
  static constexpr Index of(Index m, Index n) { return cone_membership_scalars(m, n); }
};

template <class S> ExistenceSize existence_size(const Assembly<S>& assembly) {
  ExistenceSize size;
  size.points = assembly.layout().points;
  Index normals = 0;
  for (const ConeGroup<S>& cone : assembly.layout().cones) {
    normals += cone.normals;
    size.squeeze_columns += cone.normals * (cone.generators > 0 ? cone.generators : 1);
  }
  for (Index a = 0; a < assembly.layout().actuators; ++a) {
    if (!detail::only_closes(assembly, a)) ++size.squeeze_rows;
    if (detail::is_massless(assembly, a) && detail::shares_a_body(assembly, a)) ++size.closing_rows;
  }
  if (size.closing_rows > 0) size.closing_columns = normals + size.closing_rows;
  return size;
}

namespace detail {

/// (H1). An actuator that shares no body has to close on something by itself. For the others, ones
/// lie in the cone of the contacts' rows (W(n_i)' J_a)_a and of the negative axes, or the residual
/// is a closing on nothing. Post: solved, `witness` is one, per actuator; ray, there is none.
template <class S>
Status find_idle_closing(const Assembly<S>& assembly, const ExistenceSize& size,
                         const StudyMemory<S>& memory, S* witness) {
  const Index actuators = assembly.layout().actuators;
  for (Index a = 0; a < actuators; ++a) witness[a] = S(0);
  for (Index a = 0; a < actuators; ++a) {
    if (!is_massless(assembly, a) || shares_a_body(assembly, a) || closes_on_something(assembly, a))
      continue;
    witness[a] = S(1);
    return Status::solved;
  }
  if (size.closing_rows == 0) return Status::ray;
  ConeMembership<S> question(memory.scalars, memory.integers, size.closing_rows,
                             size.closing_columns);
  if (!question.fits) return Status::bad_input;
  question.b.setOnes();
  const Index normals = size.closing_columns - size.closing_rows;
  Index row = 0;
  for (Index a = 0; a < actuators; ++a) {
    if (!is_massless(assembly, a) || !shares_a_body(assembly, a)) continue;
    for_each_load(assembly, a, [&](Index i, Index offset, const S& load) {
      Index column = offset;
      for (Index before = 0; before < i; ++before)
        column += assembly.factored().cones[before].normals;
      if (offset < assembly.factored().cones[i].normals) question.A(row, column) += load;
    });
    question.A(row, normals + row) = S(-1);
    ++row;
  }
  const Status status = question.ask(size.closing_columns);
  row = 0;
  for (Index a = 0; status == Status::ray && a < actuators; ++a)
    if (is_massless(assembly, a) && shares_a_body(assembly, a))
      witness[a] = question.residual[row++] / question.residual.sum();
  return status == Status::ray ? Status::solved : status == Status::solved ? Status::ray : status;
}

/// (H2): of the rays that no actuator closes on, is there a sum with G f = 0, Q_a(f) = 0, P(f) = 1?
/// `smooth`: of normal forces alone, which proves that there is no answer.
/// Post: solved, `witness` is a squeeze, per column of G; ray, there is none.
template <class S>
Status find_tightened_squeeze(const Assembly<S>& assembly, const ExistenceSize& size,
                              const StudyMemory<S>& memory, S* witness, bool smooth = false) {
  const Scene<S>& scene = assembly.scene();
  const Layout<S>& layout = assembly.layout();
  const FactoredProblem<S>& factored = assembly.factored();
  S fastest(0);
  for (const Body<S>& body : scene.bodies)
    fastest = Eigen::numext::maxi(fastest, S(laws::prescribed(body, layout.scales).norm()));
  if (!(fastest > S(0))) return Status::ray; // nothing moves: P = 0
  Block<int> integers(memory.integers);
  const Span<int> is_closed_on = integers.take(layout.points);
  ConeMembership<S> question(memory.scalars, integers.take(memory.integers.size - layout.points),
                             size.squeeze_rows, size.squeeze_columns);
  if (!question.fits || integers.exhausted()) return Status::bad_input;
  for (int& mark : is_closed_on) mark = 0;
  for (Index a = 0; a < layout.actuators; ++a)
    if (only_closes(assembly, a))
      for_each_load(assembly, a, [&](Index i, Index, const S&) { is_closed_on[i] = 1; });
  const auto for_each_free_ray = [&](const auto& visit) {
    Index column = 0;
    for (Index i = 0; i < layout.points; ++i)
      if (is_closed_on[i] == 0)
        for_each_ray(
            layout.cones[i],
            [&](Index normal, Index friction) { visit(column++, i, normal, friction); }, smooth);
  };
  const auto mu = [&](Index i, Index normal, Index friction) {
    return normal == friction ? S(0) : layout.cones[i].friction;
  };
  Index columns = 0;
  for_each_free_ray([&](Index column, Index i, Index normal, Index friction) {
    const Vector6<S> ray =
        factored.wrenches[normal] + mu(i, normal, friction) * factored.wrenches[friction];
    for (Index row = 0; row < (scene.planar ? 3 : 6); ++row)
      question.A(row, column) = ray[balance_axis(scene, row)];
    question.A(6, column) =
        ray.dot(laws::prescribed(scene.bodies[layout.body[i]], layout.scales)) / fastest;
    columns = column + 1;
  });
  Index row = 7;
  for (Index a = 0; a < layout.actuators; ++a) {
    if (only_closes(assembly, a)) continue;
    for (Index j = 0; j < layout.forces; ++j) witness[j] = S(0);
    for_each_load(assembly, a, [&](Index i, Index offset, const S& load) {
      witness[layout.cones[i].force + offset] += load;
    });
    for_each_free_ray([&](Index column, Index i, Index normal, Index friction) {
      question.A(row, column) = witness[normal] + mu(i, normal, friction) * witness[friction];
    });
    ++row;
  }
  question.b[6] = S(1);
  const Status status = question.ask(columns);
  for (Index j = 0; j < layout.forces; ++j) witness[j] = S(0);
  if (status != Status::solved) return status;
  for_each_free_ray([&](Index column, Index i, Index normal, Index friction) {
    witness[normal] += question.x[column];
    if (normal != friction) witness[friction] += mu(i, normal, friction) * question.x[column];
  });
  return status;
}

} // namespace detail

/// 5.4: no actuator can end at its symbolic bound. A massless one has a force, alone drives its
/// bodies, and moves each of their contacts along the normal.
template <class S> bool cannot_retreat(const Assembly<S>& assembly) {
  const Scene<S>& scene = assembly.scene();
  for (const Drive<S>& drive : scene.drives) {
    const Actuator<S>& actuator = scene.actuators[drive.actuator];
    if (actuator.inertia > S(0)) continue;
    if (!(actuator.force > S(0))) return false;
    for (const Drive<S>& other : scene.drives)
      if (other.body == drive.body && other.actuator != drive.actuator) return false;
    const Body<S>& body = scene.bodies[drive.body];
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const Vector3<S> motion = acceleration_at(scene.points[i], drive.twist);
      const S slack = S(64) * Eigen::NumTraits<S>::epsilon() * motion.norm();
      if (!(Eigen::numext::abs(motion.dot(body.normal)) > slack)) return false;
    }
  }
  return true;
}

/// Reads the assembled scene's laws, not its loads. Pre: `size` is existence_size(assembly).
/// `witness`, of the larger of forces and actuators, receives what shows that (H1) or (H2) fails:
/// closings per actuator, or forces per column.
/// Cost: O(forces) an exchange of the least squares, about as many as there are rows.
template <class S>
[[nodiscard]] Existence study_existence(const Assembly<S>& assembly, const ExistenceSize& size,
                                        const StudyMemory<S>& memory, S* witness) {
  const Status closing = detail::find_idle_closing(assembly, size, memory, witness);
  if (closing == Status::solved) return Existence::closes_on_nothing;
  if (closing != Status::ray) return Existence::not_known;
  const Status squeeze = detail::find_tightened_squeeze(assembly, size, memory, witness);
  if (squeeze == Status::solved) return Existence::can_be_squeezed;
  if (squeeze != Status::ray) return Existence::not_known;
  return cannot_retreat(assembly) ? Existence::proved : Existence::may_retreat;
}

/// Squeezes of normal forces alone that (H2) forbids: they prove that there is no answer, and
/// friction is no part of it. Post: solved, `witness` is one, per column of G; ray, there is none.
template <class S>
[[nodiscard]] Status find_smooth_squeeze(const Assembly<S>& assembly, const ExistenceSize& size,
                                         const StudyMemory<S>& memory, S* witness) {
  return detail::find_tightened_squeeze(assembly, size, memory, witness, true);
}

} // namespace lcpush
