// The directions h_i of a local form, in the space of the wrench and the shared actuators: kept, or
// read from the problem as given where memory is small. Pivots turn them: a cone slides along a
// generator, its own actuator presses it, or it yields as a spring.
#pragma once

#include "lcpush/lcp/loops.hpp"
#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush::detail {

/// What its pivots have made of a cone's directions.
template <class S> struct TurnedCone {
  const ConeGroup<S>& cone;
  Index number;
  Index normal; ///< the slot whose direction is that of the normal force as loaded, times normal_by
  Index along;  ///< the generator's slot that it slides along, -1 for none
  S normal_by;  ///< 1 as loaded
  S slip_by;    ///< the same of the slip's slot, which has no direction as loaded: 0

  /// The slot that is now in the slip's role.
  Index slip() const { return along < 0 ? cone.slip() : along; }
};

/// All of them in memory, 6 + k numbers a slot: a pass over all reads them in order.
template <class S> class KeptDirections {
public:
  static constexpr Index scalars(Index n, Index shared) { return n * (6 + shared); }
  static constexpr Index integers(Index /*cones*/, Index /*shared*/) { return 0; }

  template <class Int>
  void carve(const Problem<S>& problem, Index shared, Block<S>& scalars, Block<Int>& /*integers*/) {
    problem_ = problem.factored;
    scalars.seat(h_, problem.size, 6 + shared);
  }
  Index width() const { return h_.cols(); }
  void load(const VectorMap<S>& scale) {
    h_.setZero();
    for (const ConeGroup<S>& cone : problem_->cones)
      for (Index k = 0; k < cone.forces(); ++k)
        for (Index d = 0; d < 6; ++d) {
          const Index slot = cone.variable + k;
          h_(slot, d) = problem_->wrenches[cone.force + k][d] * scale[slot];
        }
  }
  /// The unknown of sum group `a`, scaled by `scale_of_sum`, is that of shared actuator `shared`.
  void share(Index a, Index shared, const S& scale_of_sum, const VectorMap<S>& scale) {
    const SumGroup<S>& sum = problem_->sums[a];
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const Index slot = problem_->coupled_variable[k];
      h_(slot, 6 + shared) += problem_->coupling[k] * scale_of_sum * scale[slot];
    }
  }

  /// The slot of its own actuator takes the place of the normal force's.
  void press(Index c, Index own, const S& inverse) {
    const Index normal = problem_->cones[c].variable;
    h_.row(own) = h_.row(normal) * inverse;
    h_.row(normal).setZero();
  }
  /// Motion beside a generator's direction is what the others feel; the slip's row is its force.
  void slide(Index c, Index generator) {
    const ConeGroup<S>& cone = problem_->cones[c];
    const Index slip = cone.slip();
    for (Index slot = cone.variable + cone.normals; slot < slip; ++slot)
      if (slot != generator) h_.row(slot) -= h_.row(generator);
    h_.row(slip) = -h_.row(generator);
    h_.row(generator).setZero();
  }
  /// The normal force is what a spring answers; the row of the slip feels it too.
  void yield(Index c, Index slip, const S& stiffness, const S& friction) {
    const Index normal = problem_->cones[c].variable;
    h_.row(normal) *= -stiffness;
    if (slip >= 0) h_.row(slip) = h_.row(normal) * friction;
  }

  /// h_i' v.
  template <class Turned> S dot(Index i, const Turned& /*of_cone*/, const VectorMap<S>& v) const {
    return dot_along(h_.data() + i, h_.rows(), v.data(), width());
  }
  /// sum += h_i x.
  template <class Turned>
  void add(Index i, const Turned& /*of_cone*/, const S& x, VectorMap<S>& sum) const {
    const S* h = h_.data() + i;
    for (Index k = 0; k < width(); ++k, h += h_.rows()) sum[k] += *h * x;
  }
  /// out_i += h_i' v of all slots.
  template <class TurnedOf>
  void add_dots(const TurnedOf& /*turned*/, const VectorMap<S>& velocity, VectorMap<S>& out) const {
    const Index n = h_.rows();
    const S* __restrict const h = h_.data();
    const S* const v = velocity.data();
    S* __restrict const row = out.data();
    for (Index i = 0; i < n; ++i)
      row[i] += h[i] * v[0] + h[i + n] * v[1] + h[i + 2 * n] * v[2] + h[i + 3 * n] * v[3] +
                h[i + 4 * n] * v[4] + h[i + 5 * n] * v[5];
    for (Index k = 6; k < width(); ++k)
      if (v[k] != S(0)) add_scaled(row, h + k * n, v[k], n);
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  MatrixMap<S> h_{nullptr, 0, 0};
};

/// Put together from the wrenches and couplings of the cone's forces as they were loaded. The
/// generators of a cone have one scale.
template <class S, class Int> class ReadDirections {
public:
  ReadDirections() {}
  static constexpr Index scalars(Index /*n*/, Index /*shared*/) { return 0; }
  static constexpr Index integers(Index cones, Index shared) {
    return cones + shared * (2 + cones);
  }

  void carve(const Problem<S>& problem, Index shared, Block<S>& /*scalars*/, Block<Int>& integers) {
    problem_ = problem.factored;
    first_sum_ = problem.free_begin;
    shared_ = shared;
    opposite_ = integers.take(problem_->cones.size);
    sum_ = integers.take(shared);
    entries_ = integers.take(shared * (problem_->cones.size + 1));
  }
  Index width() const { return 6 + shared_; }
  void load(const VectorMap<S>& scale) {
    new (&scale_) VectorMap<S>(scale);
    for (Index c = 0; c < problem_->cones.size; ++c)
      opposite_[c] = static_cast<Int>(opposite(problem_->cones[c]));
  }
  void share(Index a, Index shared, const S& /*scale_of_sum*/, const VectorMap<S>& /*scale*/) {
    const SumGroup<S>& sum = problem_->sums[a];
    sum_[shared] = static_cast<Int>(a);
    Index e = 0;
    for (Index c = 0; c <= problem_->cones.size; ++c) {
      const Index begin = c < problem_->cones.size ? problem_->cones[c].variable : first_sum_;
      while (e < sum.count && problem_->coupled_variable[sum.first + e] < begin) ++e;
      first_entries(c)[shared] = static_cast<Int>(e);
    }
  }
  // The turned cone says it all.
  void press(Index, Index, const S&) {}
  void slide(Index, Index) {}
  void yield(Index, Index, const S&, const S&) {}

  S dot(Index i, const TurnedCone<S>& turned, const VectorMap<S>& v) const {
    S sum(0);
    for_each_force(i, turned, [&](Index slot, const S& x) {
      S felt = dot_along(wrench(slot, turned.cone), 1, v.data(), 6);
      for_each_coupling(turned.number, [&](Index k, Index coupled, Index entry) {
        if (coupled == slot) felt += coupling(k, entry) * v[k];
      });
      sum += x * felt;
    });
    return sum;
  }
  void add(Index i, const TurnedCone<S>& turned, const S& x, VectorMap<S>& sum) const {
    for_each_force(i, turned, [&](Index slot, const S& part) {
      add_scaled(sum.data(), wrench(slot, turned.cone), S(part * x), 6);
      for_each_coupling(turned.number, [&](Index k, Index coupled, Index entry) {
        if (coupled == slot) sum[k] += part * x * coupling(k, entry);
      });
    });
  }
  template <class TurnedOf>
  void add_dots(const TurnedOf& turned_of, const VectorMap<S>& v, VectorMap<S>& out) const {
    const S v0 = v[0], v1 = v[1], v2 = v[2], v3 = v[3], v4 = v[4], v5 = v[5];
    const auto feels = [&](const S* w, Index slot) {
      return scale_[slot] * (w[0] * v0 + w[1] * v1 + w[2] * v2 + w[3] * v3 + w[4] * v4 + w[5] * v5);
    };
    for (Index c = 0; c < problem_->cones.size; ++c) {
      const TurnedCone<S> turned = turned_of(c);
      const ConeGroup<S>& cone = turned.cone;
      const Index along = turned.along, first = cone.variable + cone.normals;
      const S* w = wrench(cone.variable, cone);
      add_felt(turned, cone.variable, feels(w, cone.variable), out);
      for_each_coupling(c, [&](Index k, Index slot, Index entry) {
        add_felt(turned, slot, S(scale_[slot] * coupling(k, entry) * v[k]), out);
      });
      if (cone.normals == 2) out[first - 1] += feels(w += 6, first - 1);
      if (cone.generators == 0) continue;
      const S moves = along < 0 ? S(0) : feels(w + 6 * (along - first + 1), along);
      for (Index i = first; i < cone.slip() - opposite_[c]; ++i) {
        const S here = feels(w += 6, i);
        if (i != along) out[i] += here - moves;
        const Index across = i + opposite_[c];
        if (across != i && across != along) out[across] += -here - moves;
      }
      out[cone.slip()] -= moves;
    }
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  Index first_sum_ = 0, shared_ = 0;
  LCPUSH_SEATED(VectorMap<S>, scale_);
  // Of cones: generator j + opposite_ is the opposite of generator j, unless 0.
  LCPUSH_SEATED(Span<Int>, opposite_);
  LCPUSH_SEATED(Span<Int>, sum_);     // of shared actuators: the sum group
  LCPUSH_SEATED(Span<Int>, entries_); // of cones and them: first_entries

  /// Of each shared actuator, where in its couplings those of the cone's forces begin; they end
  /// where the next cone's begin.
  Int* first_entries(Index c) const { return entries_.data + c * shared_; }
  Index opposite(const ConeGroup<S>& cone) const {
    const Index half = cone.generators / 2;
    const Vector6<S>* const w = &problem_->wrenches[cone.force + cone.normals];
    for (Index j = 0; j < half; ++j)
      if (w[j] != -w[j + half]) return 0;
    return half;
  }

  // As given, of a force's slot.
  const S* wrench(Index slot, const ConeGroup<S>& cone) const {
    return problem_->wrenches[cone.force + slot - cone.variable].data();
  }
  /// visit(k, slot, entry): entry k of a direction, the force's slot, and where its coupling is.
  template <class Visit> void for_each_coupling(Index c, const Visit& visit) const {
    const Int* const begin = first_entries(c);
    for (Index k = 0; k < shared_; ++k) {
      if (begin[k] == begin[k + shared_]) continue;
      const Index first = problem_->sums[sum_[k]].first, end = first + begin[k + shared_];
      for (Index e = first + begin[k]; e < end; ++e)
        visit(6 + k, Index(problem_->coupled_variable[e]), e);
    }
  }
  /// Scaled, but for the force.
  S coupling(Index k, Index entry) const {
    return problem_->coupling[entry] * scale_[first_sum_ + sum_[k - 6]];
  }
  /// What a force as given feels is what the slots feel whose directions it is part of.
  void add_felt(const TurnedCone<S>& turned, Index slot, const S& x, VectorMap<S>& out) const {
    const ConeGroup<S>& cone = turned.cone;
    if (slot == cone.variable) {
      out[turned.normal] += turned.normal_by * x;
      if (cone.generators > 0) out[turned.slip()] += turned.slip_by * x;
    } else if (slot != turned.along) {
      out[slot] += x;
    } else {
      for (Index i = cone.variable + cone.normals; i <= cone.slip(); ++i)
        if (i != slot) out[i] -= x;
    }
  }

  /// visit(slot, x) for the forces as given that slot i's direction is a sum of.
  template <class Visit>
  void for_each_force(Index i, const TurnedCone<S>& turned, const Visit& visit) const {
    const ConeGroup<S>& cone = turned.cone;
    const auto show = [&](Index slot, const S& x) { visit(slot, S(scale_[slot] * x)); };
    if (i == turned.normal) return show(cone.variable, turned.normal_by);
    if (cone.generators > 0 && i == turned.slip()) return show(cone.variable, turned.slip_by);
    if (i != cone.slip()) show(i, S(1));
    if (turned.along >= 0 && i >= cone.variable + cone.normals) show(turned.along, S(-1));
  }
};

} // namespace lcpush::detail
