// The forces behind the expected motion, as a first basis: who presses, who sticks, who slides.
#pragma once

#include "lcpush/mechanics/solve/force_columns.hpp"
#include "lcpush/mechanics/solve/sparse_forces.hpp"

namespace lcpush {
namespace detail {

/// The forces that let the object follow its leader, at no more points than there are equations:
/// who presses, and who holds by friction. First friction may be anything, which says where the
/// pressure is; then it is looked for there, inside the cones of what is rigid.
template <class S> class ExpectedForces : ForceColumns<S> {
  using Base = ForceColumns<S>;
  using Base::assembly_, Base::cone, Base::body, Base::wrench, Base::is_soft, Base::seen_by,
      Base::column;

public:
  /// `by_forces`: what the forces add to the object's fall. `preload`: of soft pads.
  /// `active`: the flags of predict_modes, where the slides are noted.
  ExpectedForces(const Assembly<S>& assembly, const Vector6<S>& by_forces, const S* preload,
                 Span<unsigned char> active)
      : Base(assembly), by_forces_(by_forces), preload_(preload), active_(active) {
    const S unit = S(1) + by_forces.cwiseAbs().maxCoeff();
    still_ = S(256) * Eigen::NumTraits<S>::epsilon() * unit;
  }

  /// False if there are none; then pushers and stops have no friction noted.
  bool find() {
    note_slides();
    if (find_noted()) return true;
    for (Index b = 0; b < assembly_.scene().bodies.size; ++b)
      for (Index i = body(b).first_point; i < body(b).first_point + body(b).point_count; ++i)
        for (Index k = cone(i).normals; !is_driven(assembly_.scene(), b) && k < cone(i).size(); ++k)
          active_[cone(i).variable + k] = 0;
    return false;
  }

private:
  static constexpr Index most_pads = 4, leans = 5;
  Vector6<S> by_forces_;
  const S* preload_;
  Span<unsigned char> active_;
  S still_;
  Index pads_ = 0;
  Index pad_of_[most_pads];
  Index most_loaded_[most_pads][2];
  Vector3<S> centre_[most_pads];
  Eigen::Matrix<S, most_balances, most_pads * leans> pad_columns_;

  bool find_noted() {
    const Index sums = assembly_.factored().sums.size;
    if (6 + sums > most_balances || !load_pads()) return false;
    Balance<S> target = Balance<S>::Zero();
    for (Index k = 0; k < 6; ++k)
      target[k] = assembly_.factored().mobility.row(k).isZero(S(0)) ? S(0) : by_forces_[k];
    for (Index a = 0; a < sums; ++a) target[6 + a] = -assembly_.factored().sums[a].target;
    SparseForces<S> loose, tight;
    const auto loose_column = [&](const Ray& ray) { return ray_column(ray, false); };
    // Pressure first: friction is for what it leaves.
    const auto pressed_only = [&](const Balance<S>& rest, const auto& visit) {
      for_each_normal(rest, visit);
    };
    const auto anywhere = [&](const Balance<S>& rest, const auto& visit) {
      for_each_normal(rest, visit);
      for_each_sticking(
          rest, false, [](Index, Index) { return true; }, visit);
    };
    if (!loose.solve(target, pressed_only, loose_column) &&
        !loose.solve(target, anywhere, loose_column))
      return false;
    find_most_loaded(loose);
    const auto tight_column = [&](const Ray& ray) { return ray_column(ray, true); };
    const auto pressed_there = [&](const Balance<S>& rest, const auto& visit) {
      for_each_normal(rest, [&](const Ray& ray, S slope) {
        const bool sticks = ray.point >= 0 && opposed(ray.point) < 0;
        if (!sticks || pressure(loose, ray.body, ray.point) > S(0)) visit(ray, slope);
      });
    };
    const auto where_loaded = [&](const Balance<S>& rest, const auto& visit) {
      pressed_there(rest, visit);
      for_each_sticking(
          rest, true,
          [&](Index b, Index i) {
            return is_soft(b) ? is_most_loaded(b, i) : pressure(loose, b, i) > S(0);
          },
          visit);
    };
    if (!tight.solve(target, pressed_there, tight_column) &&
        !tight.solve(target, where_loaded, tight_column))
      return false;
    for (Index p = 0; p < pads_; ++p)
      if (!can_be(tight, pad_of_[p])) return false;
    mark(tight);
    return true;
  }

  bool is_preloaded(Index b) const {
    return is_driven(assembly_.scene(), b) || body(b).preload > S(0);
  }
  S share(Index b, Index i) const {
    return is_preloaded(b) ? preload_[i] : weight_of(assembly_.scene(), body(b), i);
  }

  /// Column of a ray. `at_limit`: a rigid point's friction comes with the pressure that bears it.
  Balance<S> ray_column(const Ray& ray, bool at_limit) const {
    if (ray.point < 0) return pad_columns_.col(pad(ray.body) * leans + ray.generator);
    if (ray.generator < 0) return pressed(ray.body, ray.point);
    const ConeGroup<S>& of = cone(ray.point);
    const Balance<S> friction = column(ray.body, of.force + of.normals + ray.generator);
    if (!at_limit || is_soft(ray.body)) return friction;
    return column(ray.body, of.force) + of.friction * friction;
  }
  /// A normal force, with the friction of a point that slides.
  Balance<S> pressed(Index b, Index i) const {
    const Index against = opposed(i);
    Balance<S> sum = column(b, cone(i).force);
    if (against >= 0)
      sum += cone(i).friction * column(b, cone(i).force + cone(i).normals + against);
    return sum;
  }
  Index pad(Index b) const {
    Index p = 0;
    while (pad_of_[p] != b) ++p;
    return p;
  }
  S rate(Index i, Index k) const {
    return assembly_.factored().wrenches[cone(i).force + k].dot(by_forces_) +
           assembly_.problem().q[cone(i).variable + k];
  }
  /// The generator most opposed to a point's slip is active, with the slip itself.
  void note_slides() const {
    for (Index i = 0; i < assembly_.layout().points; ++i) {
      S slip = -still_;
      Index against = -1;
      for (Index k = cone(i).normals; k < cone(i).forces(); ++k) {
        active_[cone(i).variable + k] = 0;
        const S r = rate(i, k);
        if (!(r < slip)) continue;
        slip = r;
        against = k;
      }
      if (cone(i).generators > 0) active_[cone(i).slip()] = against < 0 ? 0 : 1;
      if (against >= 0) active_[cone(i).variable + against] = 1;
    }
  }
  /// That generator; -1: none, the point sticks.
  Index opposed(Index i) const {
    if (cone(i).generators == 0 || active_[cone(i).slip()] == 0) return -1;
    Index k = 0;
    while (active_[cone(i).variable + cone(i).normals + k] == 0) ++k;
    return k;
  }
  bool moves_away(Index b, Index i) const {
    return !is_preloaded(b) && !is_soft(b) && rate(i, 0) > still_;
  }

  /// Tilt k of a pad's pressure, at a point: evenly, or four ways.
  S tilt(Index p, Index i, Index k) const {
    const Body<S>& pad = body(pad_of_[p]);
    const Vector3<S> arm =
        (assembly_.scene().points[i] - centre_[p]) / assembly_.layout().scales.length;
    const S along = arm.dot(k < 3 ? pad.tangent : cross(pad.normal, pad.tangent));
    return k == 0 ? S(1) : k % 2 == 1 ? along : S(-along);
  }

  bool load_pads() {
    const Scene<S>& scene = assembly_.scene();
    for (Index b = 0; b < scene.bodies.size; ++b) {
      if (!is_soft(b)) continue;
      if (pads_ == most_pads || preload_ == nullptr) return false;
      const Index p = pads_++, first = body(b).first_point;
      pad_of_[p] = b;
      centre_[p].setZero();
      S total(0);
      for (Index i = first; i < first + body(b).point_count; ++i) {
        centre_[p] += share(b, i) * scene.points[i];
        total += share(b, i);
      }
      if (!(total > S(0))) return false;
      centre_[p] /= total;
      auto columns = pad_columns_.template middleCols<leans>(p * leans);
      columns.setZero();
      for (Index i = first; i < first + body(b).point_count; ++i) {
        const Balance<S> force = share(b, i) * pressed(b, i);
        for (const Index k : {0, 1, 3}) columns.col(k) += force * tilt(p, i, k);
      }
      columns.col(2) = -columns.col(1);
      columns.col(4) = -columns.col(3);
    }
    return true;
  }

  template <class Visit> void for_each_normal(const Balance<S>& rest, const Visit& visit) const {
    for (Index p = 0; p < pads_; ++p)
      for (Index k = 0; k < leans; ++k)
        visit(Ray{pad_of_[p], -1, k}, S(pad_columns_.col(p * leans + k).dot(rest)));
    for (Index b = 0; b < assembly_.scene().bodies.size; ++b) {
      if (is_soft(b)) continue;
      const Vector6<S> seen = seen_by(b, rest);
      for_each_point(b, [&](Index i) {
        const Index against = opposed(i), first = cone(i).force;
        S slope = wrench(first).dot(seen);
        if (against >= 0)
          slope += cone(i).friction * wrench(first + cone(i).normals + against).dot(seen);
        visit(Ray{b, i, -1}, slope);
      });
    }
  }
  /// The friction of points that stick, where `takes_part(body, point)`; as ray_column has it.
  template <class Visit, class TakesPart>
  void for_each_sticking(const Balance<S>& rest, bool at_limit, const TakesPart& takes_part,
                         const Visit& visit) const {
    for (Index b = 0; b < assembly_.scene().bodies.size; ++b) {
      const Vector6<S> seen = seen_by(b, rest);
      const bool with_pressure = at_limit && !is_soft(b);
      for_each_point(b, [&](Index i) {
        if (opposed(i) >= 0 || !takes_part(b, i)) return;
        const Index normal = cone(i).force, first = normal + cone(i).normals;
        const S pressed = with_pressure ? S(wrench(normal).dot(seen)) : S(0);
        const S part = with_pressure ? cone(i).friction : S(1);
        for (Index k = 0; k < cone(i).generators; ++k)
          visit(Ray{b, i, k}, pressed + part * wrench(first + k).dot(seen));
      });
    }
  }
  template <class Visit> void for_each_point(Index b, const Visit& visit) const {
    for (Index i = body(b).first_point; i < body(b).first_point + body(b).point_count; ++i)
      if (!moves_away(b, i)) visit(i);
  }

  /// The normal force that `few` gives a point.
  S pressure(const SparseForces<S>& few, Index b, Index i, bool rays = false) const {
    S sum(0);
    for (Index k = 0; k < few.size(); ++k) {
      const Ray& ray = few.ray(k);
      if (ray.body != b) continue;
      if (ray.point < 0) sum += few.force(k) * share(b, i) * tilt(pad(b), i, ray.generator);
      if (ray.point == i && (ray.generator < 0 || rays)) sum += few.force(k);
    }
    return sum;
  }
  /// The two points of every pad that press most: they can hold most by friction.
  void find_most_loaded(const SparseForces<S>& few) {
    for (Index p = 0; p < pads_; ++p) {
      const Body<S>& pad = body(pad_of_[p]);
      S most[2] = {S(0), S(0)};
      most_loaded_[p][0] = most_loaded_[p][1] = -1;
      for (Index i = pad.first_point; i < pad.first_point + pad.point_count; ++i) {
        const S here = pressure(few, pad_of_[p], i);
        if (!(here > most[1])) continue;
        const bool is_first = here > most[0];
        most[1] = is_first ? most[0] : here;
        most_loaded_[p][1] = is_first ? most_loaded_[p][0] : i;
        if (is_first) {
          most[0] = here;
          most_loaded_[p][0] = i;
        }
      }
    }
  }
  /// Does a pad press all over, and hold no more by friction than all of it can?
  bool can_be(const SparseForces<S>& few, Index b) const {
    S limit(0), friction(0);
    for (Index i = body(b).first_point; i < body(b).first_point + body(b).point_count; ++i) {
      const S here = pressure(few, b, i);
      if (here < S(0)) return false;
      limit += cone(i).friction * here;
    }
    for (Index k = 0; k < few.size(); ++k)
      if (few.ray(k).body == b && few.ray(k).point >= 0) friction += few.force(k);
    return friction <= limit;
  }
  bool is_most_loaded(Index b, Index i) const {
    const Index* const most = most_loaded_[pad(b)];
    return most[0] == i || most[1] == i;
  }

  /// Who presses and sticks as `few` says; all that slide do so whether they press or not.
  void mark(const SparseForces<S>& few) const {
    for (Index b = 0; b < assembly_.scene().bodies.size; ++b)
      for (Index i = body(b).first_point; i < body(b).first_point + body(b).point_count; ++i)
        active_[cone(i).variable] = pressure(few, b, i, !is_soft(b)) > S(0) ? 1 : 0;
    IndependentForces<S> forces(assembly_);
    for (Index b = 0; b < assembly_.scene().bodies.size; ++b)
      for_each_point(b, [&](Index i) {
        if (!is_soft(b) && active_[cone(i).variable] != 0) (void)forces.take(b, cone(i).force);
      });
    for (Index k = 0; k < few.size(); ++k) {
      const Ray& ray = few.ray(k);
      if (ray.point < 0 || ray.generator < 0 || !(few.force(k) > S(0))) continue;
      const Index friction = cone(ray.point).normals + ray.generator;
      if (forces.take(ray.body, cone(ray.point).force + friction))
        active_[cone(ray.point).variable + friction] = 1;
    }
  }
};

} // namespace detail
} // namespace lcpush
