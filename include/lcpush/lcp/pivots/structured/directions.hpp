// The directions h_i of a local form, in the space of the wrench and the shared actuators: kept, or
// read from the problem's wrenches where memory is small. Both know the pivots that turn them: a
// cone that slides along a generator, that its own actuator presses, or that yields as a spring.
#pragma once

#include "lcpush/lcp/loops.hpp"
#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush::detail {

/// Rows of a matrix, one a slot: a pass over all of them reads memory in order.
template <class S> class KeptRows {
public:
  void carve(Index n, Index width, Block<S>& scalars) { scalars.seat(h_, n, width); }
  Index width() const { return h_.cols(); }
  void clear() { h_.setZero(); }
  S& at(Index i, Index k) { return h_(i, k); }

  /// The slot of its own actuator takes the place of the normal force's.
  void press(Index normal, Index own, const S& inverse) {
    h_.row(own) = h_.row(normal) * inverse;
    h_.row(normal).setZero();
  }
  /// Motion beside a generator's direction is what the others feel; the slip's row is its force.
  void slide(const ConeGroup<S>& cone, Index generator) {
    const Index slip = cone.slip();
    for (Index slot = cone.variable + cone.normals; slot < slip; ++slot)
      if (slot != generator) h_.row(slot) -= h_.row(generator);
    h_.row(slip) = -h_.row(generator);
    h_.row(generator).setZero();
  }
  /// The normal force is what a spring answers; the row of the slip feels it too.
  void yield(Index normal, Index slip, const S& stiffness, const S& friction) {
    h_.row(normal) *= -stiffness;
    if (slip >= 0) h_.row(slip) = h_.row(normal) * friction;
  }

  S dot(Index i, const S* v) const { return dot_along(h_.data() + i, h_.rows(), v, width()); }
  /// sum += h_i x.
  void add(Index i, const S& x, S* sum) const {
    const S* h = h_.data() + i;
    for (Index k = 0; k < width(); ++k, h += h_.rows()) sum[k] += *h * x;
  }
  /// out_i += h_i' v, the columns from `first` on.
  void add_dots(Index first, const S* v, S* out) const {
    for (Index k = first; k < width(); ++k)
      if (v[k] != S(0)) add_scaled(out, h_.data() + k * h_.rows(), v[k], h_.rows());
  }
  const S* data() const { return h_.data(); }

private:
  MatrixMap<S> h_{nullptr, 0, 0};
};

/// All of them: 6 + k numbers a slot.
template <class S> class KeptDirections {
public:
  static constexpr Index scalars(Index n, Index /*cones*/, Index shared) {
    return n * (6 + shared);
  }
  static constexpr Index integers(Index /*cones*/) { return 0; }

  template <class Int>
  void carve(const FactoredProblem<S>& problem, Index n, Index shared, Block<S>& scalars,
             Block<Int>& /*integers*/) {
    problem_ = &problem;
    n_ = n;
    rows_.carve(n, 6 + shared, scalars);
  }
  Index width() const { return rows_.width(); }
  void load(const VectorMap<S>& scale) {
    rows_.clear();
    for (const ConeGroup<S>& cone : problem_->cones)
      for (Index k = 0; k < cone.forces(); ++k)
        for (Index d = 0; d < 6; ++d) {
          const Index slot = cone.variable + k;
          rows_.at(slot, d) = problem_->wrenches[cone.force + k][d] * scale[slot];
        }
  }
  void couple(Index slot, Index shared, const S& x) { rows_.at(slot, 6 + shared) += x; }

  void press(Index c, Index own, const S& inverse) {
    rows_.press(problem_->cones[c].variable, own, inverse);
  }
  void slide(Index c, Index generator) { rows_.slide(problem_->cones[c], generator); }
  void yield(Index c, Index slip, const S& stiffness, const S& friction) {
    rows_.yield(problem_->cones[c].variable, slip, stiffness, friction);
  }

  /// Of slot i, of cone c: h_i' v, and sum += h_i x.
  S dot(Index i, Index /*c*/, const VectorMap<S>& v) const { return rows_.dot(i, v.data()); }
  void add(Index i, Index /*c*/, const S& x, VectorMap<S>& sum) const {
    rows_.add(i, x, sum.data());
  }
  /// out_i += h_i' v.
  void add_dots(const VectorMap<S>& velocity, VectorMap<S>& out) const {
    const S* __restrict const h = rows_.data();
    const S* const v = velocity.data();
    S* __restrict const row = out.data();
    for (Index i = 0, n = n_; i < n; ++i)
      row[i] += h[i] * v[0] + h[i + n] * v[1] + h[i + 2 * n] * v[2] + h[i + 3 * n] * v[3] +
                h[i + 4 * n] * v[4] + h[i + 5 * n] * v[5];
    rows_.add_dots(6, v, row);
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  Index n_ = 0;
  KeptRows<S> rows_;
};

/// What the shared actuators feel, and no wrench: that is put together from the forces of its cone
/// as they were loaded.
template <class S, class Int> class ReadDirections {
public:
  static constexpr Index scalars(Index n, Index cones, Index shared) {
    return n * shared + 2 * cones;
  }
  static constexpr Index integers(Index cones) { return 3 * cones; }

  void carve(const FactoredProblem<S>& problem, Index n, Index shared, Block<S>& scalars,
             Block<Int>& integers) {
    problem_ = &problem;
    couplings_.carve(n, shared, scalars);
    for (Span<S>* span : {&normal_by_, &slip_by_}) *span = scalars.take(problem.cones.size);
    for (Span<Int>* span : {&normal_at_, &slides_along_, &opposite_})
      *span = integers.take(problem.cones.size);
  }
  Index width() const { return 6 + couplings_.width(); }
  void load(const VectorMap<S>& scale) {
    new (&scale_) VectorMap<S>(scale);
    couplings_.clear();
    for (Index c = 0; c < problem_->cones.size; ++c) {
      normal_at_[c] = static_cast<Int>(problem_->cones[c].variable);
      normal_by_[c] = S(1);
      slip_by_[c] = S(0);
      slides_along_[c] = -1;
      opposite_[c] = static_cast<Int>(opposite(problem_->cones[c]));
    }
  }
  void couple(Index slot, Index shared, const S& x) { couplings_.at(slot, shared) += x; }

  void press(Index c, Index own, const S& inverse) {
    couplings_.press(problem_->cones[c].variable, own, inverse);
    normal_at_[c] = static_cast<Int>(own);
    normal_by_[c] = inverse;
  }
  void slide(Index c, Index generator) {
    couplings_.slide(problem_->cones[c], generator);
    slides_along_[c] = static_cast<Int>(generator);
  }
  void yield(Index c, Index slip, const S& stiffness, const S& friction) {
    couplings_.yield(problem_->cones[c].variable, slip, stiffness, friction);
    normal_by_[c] = -stiffness;
    slip_by_[c] = -stiffness * friction;
  }

  S dot(Index i, Index c, const VectorMap<S>& v) const {
    S sum = couplings_.dot(i, v.data() + 6);
    for_each_wrench(i, c, [&](const S* w, const S& x) { sum += x * dot_along(w, 1, v.data(), 6); });
    return sum;
  }
  void add(Index i, Index c, const S& x, VectorMap<S>& sum) const {
    couplings_.add(i, x, sum.data() + 6);
    for_each_wrench(i, c,
                    [&](const S* w, const S& part) { add_scaled(sum.data(), w, S(part * x), 6); });
  }
  void add_dots(const VectorMap<S>& v, VectorMap<S>& out) const {
    const S v0 = v[0], v1 = v[1], v2 = v[2], v3 = v[3], v4 = v[4], v5 = v[5];
    const auto feels = [&](const S* w, Index slot) {
      return scale_[slot] * (w[0] * v0 + w[1] * v1 + w[2] * v2 + w[3] * v3 + w[4] * v4 + w[5] * v5);
    };
    for (Index c = 0; c < problem_->cones.size; ++c) {
      const ConeGroup<S>& cone = problem_->cones[c];
      const Index along = slides_along_[c], first = cone.variable + cone.normals;
      const S* w = problem_->wrenches[cone.force].data();
      const S presses = feels(w, cone.variable);
      out[normal_at_[c]] += normal_by_[c] * presses;
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
      out[slip(c)] += slip_by_[c] * presses;
    }
    couplings_.add_dots(0, v.data() + 6, out.data());
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  KeptRows<S> couplings_;
  VectorMap<S> scale_{nullptr, 0};
  // Of cones. The loaded wrench of the normal force, times normal_by_, is that of normal_at_, and
  // times slip_by_ that of the slip's slot. slides_along_: a generator's slot, -1 for none.
  // opposite_: generator j + opposite_ is the opposite of generator j, unless 0.
  Span<S> normal_by_, slip_by_;
  Span<Int> normal_at_, slides_along_, opposite_;

  Index opposite(const ConeGroup<S>& cone) const {
    const Index half = cone.generators / 2;
    const Vector6<S>* const w = &problem_->wrenches[cone.force + cone.normals];
    for (Index j = 0; j < half; ++j)
      if (w[j] != -w[j + half]) return 0;
    return half;
  }

  /// In this role: where the cone slides, the generator's slot.
  Index slip(Index c) const {
    return slides_along_[c] < 0 ? problem_->cones[c].slip() : Index(slides_along_[c]);
  }
  /// visit(wrench, x) for the wrenches that slot i's is a sum of.
  template <class Visit> void for_each_wrench(Index i, Index c, const Visit& visit) const {
    const ConeGroup<S>& cone = problem_->cones[c];
    const Index along = slides_along_[c];
    const auto show = [&](Index slot, const S& x) {
      visit(problem_->wrenches[cone.force + slot - cone.variable].data(), S(scale_[slot] * x));
    };
    if (i == normal_at_[c]) return show(cone.variable, normal_by_[c]);
    if (cone.generators > 0 && i == slip(c)) return show(cone.variable, slip_by_[c]);
    if (i != cone.slip()) show(i, S(1));
    if (along >= 0 && i >= cone.variable + cone.normals) show(along, S(-1));
  }
};

} // namespace lcpush::detail
