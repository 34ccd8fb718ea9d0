// The forces behind the expected motion, as a first basis: who presses, who sticks, who slides.
#pragma once

#include "lcpush/mechanics/solve/few_forces.hpp"

namespace lcpush {
namespace detail {

/// The forces that let the object follow its leader, at no more points than there are equations:
/// who presses, and who holds by friction. First friction may be anything, which says where the
/// pressure is; then it is looked for there, inside the cones of what is rigid.
template <class S> class ExpectedForces {
public:
  /// `by_forces`: what the forces add to the object's fall. `preload`: of soft pads.
  /// `active`: the flags of predict_modes, where the slides are noted.
  ExpectedForces(const Assembly<S>& assembly, const Vector6<S>& by_forces, const S* preload,
                 Span<unsigned char> active)
      : assembly_(assembly), by_forces_(by_forces), preload_(preload), active_(active) {
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
  const Assembly<S>& assembly_;
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
    FewForces<S> loose, tight;
    const auto anywhere = [&](const auto& visit) {
      for_each_normal(visit);
      for_each_sticking([&](Index b, Index i) {
        for (Index k = 0; k < cone(i).generators; ++k)
          visit(Ray{b, i, k}, column(b, cone(i).force + cone(i).normals + k));
      });
    };
    // Pressure first: friction is for what it leaves.
    const auto pressed_only = [&](const auto& visit) { for_each_normal(visit); };
    if (!loose.solve(target, pressed_only) && !loose.solve(target, anywhere)) return false;
    find_most_loaded(loose);
    const auto where_loaded = [&](const auto& visit) {
      for_each_normal([&](const Ray& ray, const Balance<S>& force) {
        const bool sticks = ray.point >= 0 && opposed(ray.point) < 0;
        if (!sticks || pressure(loose, ray.body, ray.point) > S(0)) visit(ray, force);
      });
      for_each_sticking([&](Index b, Index i) {
        const S share = is_soft(b) ? S(0) : cone(i).friction;
        if (is_soft(b) ? !is_most_loaded(b, i) : !(pressure(loose, b, i) > S(0))) return;
        for (Index k = 0; k < cone(i).generators; ++k) {
          Balance<S> ray = column(b, cone(i).force + cone(i).normals + k);
          if (share > S(0)) ray = column(b, cone(i).force) + share * ray;
          visit(Ray{b, i, k}, ray);
        }
      });
    };
    const auto pressed_there = [&](const auto& visit) {
      where_loaded([&](const Ray& ray, const Balance<S>& force) {
        if (ray.generator < 0 || ray.point < 0) visit(ray, force);
      });
    };
    if (!tight.solve(target, pressed_there) && !tight.solve(target, where_loaded)) return false;
    for (Index p = 0; p < pads_; ++p)
      if (!can_be(tight, pad_of_[p])) return false;
    mark(tight);
    return true;
  }

  const ConeGroup<S>& cone(Index i) const { return assembly_.factored().cones[i]; }
  const Body<S>& body(Index b) const { return assembly_.scene().bodies[b]; }
  /// Its points share their force as their compliance says.
  bool is_soft(Index b) const { return cone(body(b).first_point).compliance > S(0); }
  bool is_preloaded(Index b) const {
    return is_driven(assembly_.scene(), b) || body(b).preload > S(0);
  }
  S share(Index b, Index i) const {
    return is_preloaded(b) ? preload_[i] : weight_of(assembly_.scene(), body(b), i);
  }

  /// What a unit of the force adds to the object's acceleration and to the actuators' sums.
  Balance<S> column(Index b, Index force) const {
    const Vector6<S>& wrench = assembly_.factored().wrenches[force];
    Balance<S> column = Balance<S>::Zero();
    column.template head<6>() = assembly_.factored().mobility.lazyProduct(wrench);
    for (const Drive<S>& drive : assembly_.scene().drives)
      if (drive.body == b)
        column[6 + drive.actuator] -= laws::grip_coefficient(
            drive, wrench, assembly_.layout().reach[drive.actuator], assembly_.layout().scales);
    return column;
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

  /// Lean k of a pad's pressure, at a point: evenly, or four ways.
  S lean(Index p, Index i, Index k) const {
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
        for (const Index k : {0, 1, 3}) columns.col(k) += force * lean(p, i, k);
      }
      columns.col(2) = -columns.col(1);
      columns.col(4) = -columns.col(3);
    }
    return true;
  }

  template <class Visit> void for_each_normal(const Visit& visit) const {
    for (Index p = 0; p < pads_; ++p)
      for (Index k = 0; k < leans; ++k)
        visit(Ray{pad_of_[p], -1, k}, Balance<S>(pad_columns_.col(p * leans + k)));
    for_each_point([&](Index b, Index i) {
      if (!is_soft(b)) visit(Ray{b, i, -1}, pressed(b, i));
    });
  }
  template <class Visit> void for_each_sticking(const Visit& visit) const {
    for_each_point([&](Index b, Index i) {
      if (opposed(i) < 0) visit(b, i);
    });
  }
  template <class Visit> void for_each_point(const Visit& visit) const {
    for (Index b = 0; b < assembly_.scene().bodies.size; ++b)
      for (Index i = body(b).first_point; i < body(b).first_point + body(b).point_count; ++i)
        if (!moves_away(b, i)) visit(b, i);
  }

  /// The normal force that `few` gives a point.
  S pressure(const FewForces<S>& few, Index b, Index i, bool rays = false) const {
    S sum(0);
    for (Index k = 0; k < few.size(); ++k) {
      const Ray& ray = few.ray(k);
      if (ray.body != b) continue;
      if (ray.point < 0) sum += few.force(k) * share(b, i) * lean(pad(b), i, ray.generator);
      if (ray.point == i && (ray.generator < 0 || rays)) sum += few.force(k);
    }
    return sum;
  }
  /// The two points of every pad that press most: they can hold most by friction.
  void find_most_loaded(const FewForces<S>& few) {
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
  bool can_be(const FewForces<S>& few, Index b) const {
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
  void mark(const FewForces<S>& few) const {
    for (Index b = 0; b < assembly_.scene().bodies.size; ++b)
      for (Index i = body(b).first_point; i < body(b).first_point + body(b).point_count; ++i)
        active_[cone(i).variable] = pressure(few, b, i, !is_soft(b)) > S(0) ? 1 : 0;
    IndependentForces<S> forces(assembly_);
    for_each_point([&](Index b, Index i) {
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
