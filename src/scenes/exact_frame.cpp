#include "scenes/exact_frame.hpp"

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/mechanics/model/patch.hpp"

#include <vector>

namespace lcpush::desktop {
namespace {

/// v / |v| if |v| is a fraction.
std::optional<Vector3<Rational>> exact_unit(const Vector3<Rational>& v) {
  const std::optional<Rational> length = exact_root(v.squaredNorm());
  if (!length) return std::nullopt;
  return Vector3<Rational>(v / *length);
}

/// The axis that default_tangent takes.
Vector3<Rational> least_aligned_axis(const Vector3<Rational>& normal) {
  Index axis = 0;
  for (Index i = 1; i < 3; ++i)
    if (abs(normal[i]) < abs(normal[axis])) axis = i;
  return Vector3<Rational>::Unit(axis);
}

template <class S>
void sample(bool is_disc, const Vector3<S>& center, const Vector3<S>& t, const Vector3<S>& o,
            const S& radius, Span<Vector3<S>> points) {
  is_disc ? sample_disc<S>(center, t, o, radius, points)
          : sample_ring<S>(center, t, o, radius, points);
}

} // namespace

ContactFrame<double> contact_frame(const Vector3<double>& normal,
                                   const std::optional<Vector3<double>>& direction) {
  const Vector3<double> n = normal.normalized();
  return {n, direction ? tangent_along<double>(n, direction->normalized()) : default_tangent(n)};
}

ContactFrame<Rational> contact_frame(const Vector3<Rational>& normal,
                                     const std::optional<Vector3<Rational>>& direction) {
  std::optional<Vector3<double>> rounded_direction;
  if (direction) rounded_direction = as_doubles(*direction);
  const ContactFrame<double> rounded = contact_frame(as_doubles(normal), rounded_direction);
  const std::optional<Vector3<Rational>> n = exact_unit(normal);
  // Projected along the normal as typed, the tangent does not depend on the normal's root.
  const Vector3<Rational> along = direction ? *direction : least_aligned_axis(normal);
  const std::optional<Vector3<Rational>> t =
      exact_unit(along * normal.squaredNorm() - normal * normal.dot(along));
  return {n ? *n : Vector3<Rational>(rounded.normal.cast<Rational>()),
          t ? *t : Vector3<Rational>(rounded.tangent.cast<Rational>()), n.has_value(),
          t.has_value()};
}

bool sample_round(bool is_disc, const Vector3<double>& center, const ContactFrame<double>& frame,
                  double radius, Span<Vector3<double>> points) {
  sample<double>(is_disc, center, frame.tangent, cross(frame.normal, frame.tangent), radius,
                 points);
  return true;
}

bool sample_round(bool is_disc, const Vector3<Rational>& center,
                  const ContactFrame<Rational>& frame, const Rational& radius,
                  Span<Vector3<Rational>> points) {
  const Vector3<Rational> t = frame.tangent, o = cross(frame.normal, frame.tangent);
  if (points.size == 1 || (!is_disc && (points.size == 2 || points.size == 4))) {
    sample<Rational>(is_disc, center, t, o, radius, points);
    return true;
  }
  // In the plane's own coordinates: the points stay in the plane, exactly.
  std::vector<Vector3<double>> rounded(static_cast<std::size_t>(points.size));
  sample<double>(is_disc, Vector3<double>::Zero(), Vector3<double>::UnitX(),
                 Vector3<double>::UnitY(), radius.value(), {rounded.data(), points.size});
  for (Index i = 0; i < points.size; ++i) {
    const Vector3<double>& p = rounded[static_cast<std::size_t>(i)];
    points[i] = center + t * Rational(p[0]) + o * Rational(p[1]);
  }
  return false;
}

} // namespace lcpush::desktop

namespace lcpush {

template <> desktop::Rational circle_cosine<desktop::Rational>(Index j, Index g) {
  using desktop::Rational;
  j = ((j % g) + g) % g;
  if (2 * j > g) j = g - j; // now 0..180 degrees
  if (4 * j > g) return -circle_cosine<Rational>(g / 2 - j, g);
  if (6 * j == g) return Rational(1) / Rational(2);
  return Rational(circle_cosine<double>(j, g));
}

} // namespace lcpush
