#include "scenes/exact_frame.hpp"

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/mechanics/model/patch.hpp"

#include <map>
#include <string>
#include <utility>

namespace lcpush::desktop {
namespace {

struct ExactUnit {
  Vector3<Rational> vector;
  bool is_exact;
};

/// v / |v|; if that is irrational, every coordinate cut off after 15 decimals.
ExactUnit exact_unit(const Vector3<Rational>& v) {
  const Rational square = v.squaredNorm();
  if (const std::optional<Rational> length = exact_root(square)) return {v / *length, true};
  const BigInteger decimals = 1'000'000'000'000'000;
  Vector3<Rational> unit;
  for (Index i = 0; i < 3; ++i) {
    const Rational share = v[i] * v[i] / square;
    unit[i] = {root(share.numerator() * decimals * decimals / share.denominator()), decimals};
    if (v[i].sign() < 0) unit[i].negate();
  }
  return {unit, false};
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
  const ExactUnit n = exact_unit(normal);
  // Projected along the normal as typed, the tangent does not depend on the normal's root.
  const Vector3<Rational> along =
      direction ? *direction : Vector3<Rational>::Unit(least_aligned_axis(n.vector));
  const ExactUnit t = exact_unit(along * normal.squaredNorm() - normal * normal.dot(along));
  return {n.vector, t.vector, n.is_exact, t.is_exact};
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
  // In the plane's own coordinates: the points stay in the plane, exactly.
  sample<Rational>(is_disc, center, frame.tangent, cross(frame.normal, frame.tangent), radius,
                   points);
  return points.size == 1 || (!is_disc && (points.size == 2 || points.size == 4));
}

// A convergent of its continued fraction or what lies between two.
Rational simplest_near(const Rational& x, const BigInteger& most) {
  BigInteger p0 = 0, q0 = 1, p1 = 1, q1 = 0, n = x.numerator(), d = x.denominator();
  while (!d.is_zero()) {
    const BigInteger whole = n / d, q2 = q0 + whole * q1;
    if (q2 > most) break;
    BigInteger p2 = p0 + whole * p1;
    p0 = std::exchange(p1, std::move(p2));
    q0 = std::exchange(q1, q2);
    BigInteger rest = n - whole * d;
    n = std::exchange(d, std::move(rest));
  }
  if (d.is_zero()) return {p1, q1};
  const BigInteger k = (most - q0) / q1;
  const Rational between{p0 + k * p1, q0 + k * q1}, convergent{p1, q1};
  return abs(convergent - x) <= abs(between - x) ? convergent : between;
}

} // namespace lcpush::desktop

namespace lcpush {

namespace {

using desktop::Rational;

// 40 decimals: far beyond what decides which fraction is the nearest.
constexpr int circle_decimals = 40;

/// floor(10^40 tan(pi j / g)) for 0 < 4 j <= g, by Taylor's series in whole numbers.
desktop::BigInteger scaled_half_tangent(Index j, Index g) {
  using desktop::BigInteger;
  const BigInteger unit = *BigInteger::parse("1" + std::string(circle_decimals, '0'));
  const BigInteger pi = *BigInteger::parse("31415926535897932384626433832795028841971");
  const BigInteger angle = pi * j / g;
  BigInteger sums[2] = {0, 0}; // of the even and the odd terms: cosine and sine
  BigInteger term = unit;
  for (int k = 0; !term.is_zero(); ++k) {
    sums[k % 2] += k % 4 < 2 ? term : -term;
    term = term * angle / unit / (k + 1);
  }
  return sums[1] * unit / sums[0];
}

/// The simplest fraction near it; kept, as every scene with a disc asks for the same ones.
const Rational& half_tangent(Index j, Index g) {
  thread_local std::map<std::pair<Index, Index>, Rational> known;
  const auto [found, is_new] = known.try_emplace({j, g});
  if (is_new)
    found->second = desktop::simplest_near(
        {scaled_half_tangent(j, g),
         *desktop::BigInteger::parse("1" + std::string(circle_decimals, '0'))});
  return found->second;
}

} // namespace

template <> Rational circle_sine<Rational>(Index j, Index g) {
  const Index turned = ((8 * j % (8 * g)) + 8 * g) % (8 * g); // in 8 g steps a turn
  if (turned % (2 * g) != g) return circle_cosine<Rational>(4 * j - g, 4 * g);
  // At 45 degrees no fraction is both: the sine belongs to the cosine's own half angle.
  const Rational cosine = circle_cosine<Rational>(1, 8);
  const Rational t_square = (1 - cosine) / (1 + cosine);
  const Rational sine = *desktop::exact_root(t_square) * (1 + cosine);
  return turned < 4 * g ? sine : -sine;
}

template <> Rational circle_cosine<Rational>(Index j, Index g) {
  j = ((j % g) + g) % g;
  if (2 * j > g) j = g - j; // now 0..180 degrees
  if (4 * j > g) return -circle_cosine<Rational>(g / 2 - j, g);
  if (4 * j == g) return 0;
  if (j == 0) return 1;
  // Up to 45 degrees from the half angle; beyond, the sine of what is left.
  const bool is_small = 8 * j <= g;
  const Rational& t = is_small ? half_tangent(j, g) : half_tangent(g - 4 * j, 4 * g);
  const Rational square = t * t;
  return is_small ? (1 - square) / (1 + square) : 2 * t / (1 + square);
}

} // namespace lcpush
