#include "cone/limit_surface.hpp"
#include "cone/settings.hpp"

#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/mechanics/solve/pad_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace lcpush::desktop {
namespace {

using Triangle = std::array<Vector3<double>, 3>;

/// What every finger point presses with, N: the grip forces are across the plane, so no motion in
/// it changes them.
std::vector<double> normal_forces(const SceneFile& file) {
  AssembledScene assembled(file.view());
  pad_preload(assembled.assembly, assembled.work.pressure);
  std::vector<double> forces;
  for (Index i = 0; i < assembled.scene.points.size; ++i)
    forces.push_back(assembled.work.pressure.preload[i] * assembled.assembly.layout().scales.force);
  return forces;
}

/// The least coordinate of `ray` in the triangle's corners, over the largest; < 0: it passes by.
double room_inside(const Triangle& t, const Vector3<double>& ray) {
  const double side = cross<double>(t[0], t[1]).dot(t[2]) < 0 ? -1 : 1;
  const Vector3<double> parts =
      side * Vector3<double>(cross<double>(t[1], t[2]).dot(ray), cross<double>(t[2], t[0]).dot(ray),
                             cross<double>(t[0], t[1]).dot(ray));
  return parts.minCoeff() /
         std::max(parts.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
}

} // namespace

Vector3<double> turned(const Vector3<double>& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
}

Vector3<double> beside(const Vector3<double>& v) {
  const Vector3<double> along = v.normalized();
  const Vector3<double> a =
      cross<double>(along, Vector3<double>::Unit(least_aligned_axis(along))).normalized();
  return v +
         v.norm() * cone_settings.same_twist * (a + cone_settings.aside * cross<double>(along, a));
}

Vector6<double> spatial_twist(const Vector3<double>& twist, double length) {
  Vector6<double> v = Vector6<double>::Zero();
  v[0] = twist[0];
  v[1] = twist[1];
  v[5] = twist[2] / length;
  return v;
}

Vector6<double> spatial_wrench(const Vector3<double>& wrench, double length) {
  return spatial_twist({wrench[0], wrench[1], wrench[2] * length * length}, length);
}

GripPoints::GripPoints(const SceneFile& file) : is_round_(file.is_round) {
  const Scene<double> scene = file.view();
  const std::vector<double> forces = normal_forces(file);
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    const Body<double>& body = file.bodies[b];
    if (body.role != Role::finger || !(body.friction > 0)) continue;
    const Index axes = body.torsion_radius > 0 ? 3 : 2;
    const Index count = is_round_ ? axes : generator_count(scene, body);
    for (const Index i : points_of(body)) {
      Point point{
          scene.points[i], b, body.friction * forces[static_cast<std::size_t>(i)], {}, body.normal};
      if (!(point.limit > 0)) continue;
      for (Index k = 0; k < count; ++k)
        point.friction.push_back(
            is_round_ ? generator_along(body, Vector3<double>(Vector3<double>::Unit(k)))
                      : generator(body, k, scene.facets));
      points_.push_back(std::move(point));
    }
  }
}

LimitSurface::LimitSurface(const GripPoints& grip, double length, const Vector3<double>& center,
                           double angle, const std::vector<bool>& touches)
    : is_round_(grip.is_round_) {
  const auto& points = grip.points_;
  for (std::size_t first = 0, end = 0; first < points.size(); first = end) { // patch by patch
    double whole = 0, touching = 0;
    for (; end < points.size() && points[end].body == points[first].body; ++end) {
      whole += points[end].limit;
      touching += touches.empty() || touches[end] ? points[end].limit : 0;
    }
    touches_everywhere_ = touches_everywhere_ && touching > 0;
    for (std::size_t i = first; i < end; ++i)
      if (touches.empty() || touches[i])
        add(points[i], whole / touching, length, turned(points[i].place - center, -angle));
  }
}

void LimitSurface::add(const GripPoints::Point& point, double share, double length,
                       const Vector3<double>& at) {
  points_.push_back({wrenches_.size(), point.friction.size()});
  for (const Generator<double>& d : point.friction) {
    Vector6<double> w = wrench_column<double>(at, d.force);
    w.tail<3>() += d.torque * point.normal;
    wrenches_.push_back(share * point.limit * planar_wrench(w, length));
  }
}

Vector3<double> LimitSurface::resistance(const Vector3<double>& twist) const {
  Vector3<double> sum = Vector3<double>::Zero();
  for (const PointFriction& point : points_) {
    const Vector3<double>* w = &wrenches_[point.first];
    if (is_round_) {
      Vector3<double> along = Vector3<double>::Zero(), direction = Vector3<double>::Zero();
      for (std::size_t k = 0; k < point.count; ++k)
        direction[static_cast<Index>(k)] = w[k].dot(twist);
      const double speed = direction.norm();
      if (!(speed > 0)) continue;
      for (std::size_t k = 0; k < point.count; ++k)
        along += direction[static_cast<Index>(k)] / speed * w[k];
      sum += along;
    } else {
      std::size_t best = 0;
      double most = w[0].dot(twist);
      for (std::size_t k = 1; k < point.count; ++k)
        if (const double power = w[k].dot(twist); power > most) {
          most = power;
          best = k;
        }
      sum += w[best];
    }
  }
  return sum;
}

bool LimitSurface::is_solid() const {
  Matrix3<double> sum = Matrix3<double>::Zero();
  for (const Vector3<double>& w : wrenches_) sum += w * w.transpose();
  const Vector3<double> x = sum.col(0), y = sum.col(1), z = sum.col(2);
  return x.dot(cross(y, z)) > cone_settings.flat * std::pow(sum.trace() / 3, 3);
}

bool LimitSurface::is_empty() const {
  return std::all_of(wrenches_.begin(), wrenches_.end(),
                     [](const Vector3<double>& w) { return w.isZero(0); });
}

double LimitSurface::share_of(const Vector3<double>& load) const {
  if (!(load.norm() > 0)) return 0;
  return 1 / crossing(Vector3<double>::Zero(), load).force;
}

// Portal refinement: a triangle of the body's points that the ray pierces goes out, corner by
// corner, to where the body ends along its normal. A polytope's facet is reached in finitely many
// steps. Grips are symmetric, and rays through their corners and edges are the rule: one beside it,
// that rounding cannot take to another facet, meets a facet that the ray meets too.
Crossing LimitSurface::crossing(const Vector3<double>& load,
                                const Vector3<double>& direction) const {
  constexpr int most_steps = cone_settings.most_steps;
  const auto reach = [&](const Vector3<double>& n) -> Vector3<double> {
    return resistance(n) - load;
  };
  const Vector3<double> ray = beside(direction.normalized());
  Triangle t{reach(ray), {}, {}};
  Vector3<double> n = cross<double>(t[0], ray);
  if (n.norm() <= cone_settings.same_twist * t[0].norm())
    n = cross<double>(ray, Vector3<double>::Unit(least_aligned_axis(ray)));
  t[1] = reach(n);
  n = cross<double>(t[0], t[1]);
  if (n.dot(ray) < 0) {
    std::swap(t[0], t[1]);
    n = -n;
  }
  for (int k = 0; k < most_steps; ++k) { // turn the third corner until the ray is inside
    t[2] = reach(n);
    if (cross<double>(t[2], t[0]).dot(ray) < 0) {
      t[1] = t[2];
    } else if (cross<double>(t[1], t[2]).dot(ray) < 0) {
      t[0] = t[2];
    } else {
      break;
    }
    n = cross<double>(t[0], t[1]);
  }
  for (int k = 0; k < most_steps; ++k) {
    n = cross<double>(t[1] - t[0], t[2] - t[0]).normalized();
    if (n.dot(ray) < 0) n = -n;
    const Vector3<double> s = reach(n);
    const double height = n.dot(t[0]);
    const double slack = is_round_ ? cone_settings.smooth_slack : cone_settings.facet_slack;
    if (n.dot(s) - height <= slack * (n.dot(s) + load.norm())) break;
    Triangle next = t;
    double room = -2;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Triangle tried = t;
      tried[corner] = s;
      if (const double inside = room_inside(tried, ray); inside > room) {
        room = inside;
        next = tried;
      }
    }
    t = next;
  }
  n /= n.dot(direction);
  if (is_round_) n = polished(load, direction, n);
  return {power(n) - load.dot(n), n};
}

/// Newton's method for the least of power(V) - load' V over the twists with direction' V = 1.
Vector3<double> LimitSurface::polished(const Vector3<double>& load,
                                       const Vector3<double>& direction,
                                       Vector3<double> twist) const {
  const Vector3<double> ray = direction.normalized();
  const Vector3<double> a =
      cross<double>(ray, Vector3<double>::Unit(least_aligned_axis(ray))).normalized();
  Eigen::Matrix<double, 3, 2> plane;
  plane << a, cross<double>(ray, a);
  const auto excess = [&](const Vector3<double>& v) { return power(v) - load.dot(v); };
  double value = excess(twist);
  for (int k = 0; k < cone_settings.newton_steps; ++k) {
    Matrix3<double> curvature = Matrix3<double>::Zero();
    for (const PointFriction& point : points_) {
      Matrix3<double> squares = Matrix3<double>::Zero();
      Vector3<double> along = Vector3<double>::Zero();
      double speed = 0;
      for (std::size_t j = point.first; j < point.first + point.count; ++j) {
        const double part = wrenches_[j].dot(twist);
        squares += wrenches_[j] * wrenches_[j].transpose();
        along += part * wrenches_[j];
        speed += part * part;
      }
      speed = std::sqrt(speed);
      if (speed > 0) curvature += (squares - along * along.transpose() / (speed * speed)) / speed;
    }
    const Eigen::Vector2d slope = plane.transpose() * (resistance(twist) - load);
    const Eigen::Matrix2d H = plane.transpose() * curvature * plane;
    const Eigen::Vector2d step = solved(H, -slope);
    if (!step.allFinite() || !(step.norm() > cone_settings.newton_step * twist.norm())) break;
    double part = 1;
    Vector3<double> next = twist + plane * step;
    while (part > cone_settings.newton_part && excess(next) > value)
      next = twist + plane * ((part /= 2) * step);
    if (excess(next) > value) break;
    twist = next;
    value = excess(twist);
  }
  return twist;
}

} // namespace lcpush::desktop
