#include "lcpush/desktop/rational.hpp"
#include "text/limits.hpp"
#include "text/whole_number.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

/// numerator 2^exponent.
Rational scaled_by_two(BigInteger numerator, int exponent) {
  if (exponent >= 0) return {numerator << static_cast<std::size_t>(exponent), 1};
  return {std::move(numerator), BigInteger(1) << static_cast<std::size_t>(-exponent)};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view take_digits(std::string_view& text) {
  const auto end =
      static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
  const std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  return digits;
}

/// The whole of `text` as an exponent with an optional sign.
std::optional<int> read_exponent(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (text.empty() || !is_digit(text.front())) return std::nullopt;
  }
  const std::optional<int> exponent = whole_number<int>(text);
  if (!exponent || *exponent > limits::fraction_exponent || *exponent < -limits::fraction_exponent)
    return std::nullopt;
  return exponent;
}

/// `text` without a sign.
std::optional<Rational> read_magnitude(std::string_view text) {
  std::string digits(take_digits(text));
  if (!text.empty() && text.front() == '/') {
    text.remove_prefix(1);
    const std::string_view below = take_digits(text);
    const std::optional<BigInteger> above = BigInteger::parse(digits);
    const std::optional<BigInteger> denominator = BigInteger::parse(below);
    if (!text.empty() || !above || !denominator || denominator->is_zero()) return std::nullopt;
    return Rational(*above, *denominator);
  }
  int exponent = 0;
  if (!text.empty() && text.front() == '.') {
    text.remove_prefix(1);
    const std::string_view decimals = take_digits(text);
    digits += decimals;
    exponent = -static_cast<int>(decimals.size());
  }
  if (!text.empty() && (text.front() == 'e' || text.front() == 'E')) {
    const std::optional<int> typed = read_exponent(text.substr(1));
    if (!typed) return std::nullopt;
    exponent += *typed;
    text = {};
  }
  const std::optional<BigInteger> number = BigInteger::parse(digits);
  if (!text.empty() || !number) return std::nullopt;
  const auto power =
      *BigInteger::parse('1' + std::string(static_cast<std::size_t>(std::abs(exponent)), '0'));
  return exponent < 0 ? Rational(*number, power) : Rational(*number * power, 1);
}

/// The square root of a whole number if it is whole.
std::optional<BigInteger> whole_root(const BigInteger& a) {
  BigInteger x = root(a);
  if (x * x != a) return std::nullopt;
  return x;
}

} // namespace

Rational::Rational(double value) {
  assert(std::isfinite(value));
  constexpr int bits = 53;
  int exponent = 0;
  const double size = std::ldexp(std::frexp(std::abs(value), &exponent), bits);
  *this = scaled_by_two(static_cast<std::uint64_t>(size), exponent - bits);
  if (value < 0) negate();
}

Rational::Rational(BigInteger numerator, BigInteger denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  assert(!denominator_.is_zero());
  if (denominator_.sign() < 0) {
    numerator_.negate();
    denominator_.negate();
  }
  if (denominator_.is_one()) return;
  const BigInteger divisor = gcd(numerator_, denominator_);
  if (divisor.is_one()) return;
  numerator_ = numerator_ / divisor;
  denominator_ = denominator_ / divisor;
}

Rational Rational::unreduced(BigInteger numerator, BigInteger denominator) {
  Rational result;
  result.numerator_ = std::move(numerator);
  result.denominator_ = std::move(denominator);
  return result;
}

Rational::Rational(const Rational&) = default;
Rational::Rational(Rational&&) noexcept = default;
Rational& Rational::operator=(const Rational&) = default;
Rational& Rational::operator=(Rational&&) noexcept = default;
Rational::~Rational() = default;

std::optional<Rational> Rational::parse(std::string_view text) {
  if (text.size() > limits::fraction_characters) return std::nullopt;
  const bool has_sign = !text.empty() && (text.front() == '-' || text.front() == '+');
  const bool is_negative = has_sign && text.front() == '-';
  if (has_sign) text.remove_prefix(1);
  if (text.empty() || !(is_digit(text.front()) || text.front() == '.')) return std::nullopt;
  std::optional<Rational> number = read_magnitude(text);
  if (number && is_negative) number->negate();
  return number;
}

std::string Rational::text() const {
  const Rational lowest(numerator_, denominator_);
  return lowest.numerator_.text() + (lowest.is_whole() ? "" : '/' + lowest.denominator_.text());
}

double Rational::value() const {
  constexpr std::size_t exact_bits = 53;
  constexpr int smallest_exponent = -1074;
  if (denominator_.is_one()) return numerator_.value();
  const std::size_t above = numerator_.bit_length(), below = denominator_.bit_length();
  if (above <= exact_bits && below <= exact_bits) // one rounding
    return numerator_.value() / denominator_.value();
  const auto difference = static_cast<std::ptrdiff_t>(above) - static_cast<std::ptrdiff_t>(below);
  if (difference > 1025) return numerator_.sign() < 0 ? -HUGE_VAL : HUGE_VAL;
  if (difference < -1080) return numerator_.sign() < 0 ? -0.0 : 0.0;
  const auto scaled = [](const BigInteger& a, int bits) {
    return bits > 0 ? a << static_cast<std::size_t>(bits) : a;
  };
  // 2^exponent <= |value| < 2^(exponent + 1)
  int exponent = static_cast<int>(difference);
  const BigInteger size = abs(numerator_);
  if (scaled(size, -exponent) < scaled(denominator_, exponent)) --exponent;
  // |value| in units of its last bit, whose weight is 2^last.
  const int last = std::max(exponent - static_cast<int>(exact_bits) + 1, smallest_exponent);
  const BigInteger divisor = scaled(denominator_, last);
  BigInteger units, rest;
  BigInteger::divide(scaled(size, -last), divisor, &units, &rest);
  const int half = BigInteger::compare(rest << 1U, divisor);
  if (half > 0 || (half == 0 && units.is_odd())) units += 1;
  const double result = std::ldexp(units.value(), last);
  return numerator_.sign() < 0 ? -result : result;
}

std::size_t Rational::bit_length() const {
  return std::max(numerator_.bit_length(), denominator_.bit_length());
}

/// By divisors of the denominators, which are shorter than the result's. [Knuth, TAOCP 4.5.1]
Rational Rational::sum(const Rational& a, const Rational& b, bool subtract) {
  const auto add = [subtract](const BigInteger& x, const BigInteger& y) {
    return subtract ? x - y : x + y;
  };
  if (b.sign() == 0) return a;
  if (a.sign() == 0) return subtract ? -b : b;
  if (a.is_whole() && b.is_whole()) return unreduced(add(a.numerator_, b.numerator_), 1);
  if (a.denominator_ == b.denominator_) return {add(a.numerator_, b.numerator_), a.denominator_};
  const BigInteger common = gcd(a.denominator_, b.denominator_);
  if (common.is_one())
    return unreduced(add(a.numerator_ * b.denominator_, b.numerator_ * a.denominator_),
                     a.denominator_ * b.denominator_);
  const BigInteger rest = a.denominator_ / common;
  BigInteger numerator = add(a.numerator_ * (b.denominator_ / common), b.numerator_ * rest);
  if (numerator.is_zero()) return {};
  const BigInteger divisor = gcd(numerator, common);
  if (divisor.is_one()) return unreduced(std::move(numerator), rest * b.denominator_);
  return unreduced(numerator / divisor, rest * (b.denominator_ / divisor));
}

/// (a / b) (c / d), each in lowest terms, b and d > 0.
Rational Rational::product(const BigInteger& a, const BigInteger& b, const BigInteger& c,
                           const BigInteger& d) {
  if (a.is_zero() || c.is_zero()) return {};
  const auto without = [](const BigInteger& x, const BigInteger& divisor) {
    return divisor.is_one() ? x : x / divisor;
  };
  const BigInteger g = gcd(a, d), h = gcd(c, b);
  return unreduced(without(a, g) * without(c, h), without(b, h) * without(d, g));
}

Rational operator/(const Rational& a, const Rational& b) {
  assert(b.sign() != 0);
  Rational result =
      Rational::product(a.numerator_, a.denominator_, b.denominator_, abs(b.numerator_));
  if (b.sign() < 0) result.negate();
  return result;
}

int Rational::compare(const Rational& a, const Rational& b) {
  if (a.sign() != b.sign()) return a.sign() < b.sign() ? -1 : 1;
  if (a.sign() == 0) return 0;
  if (a.denominator_ == b.denominator_) return BigInteger::compare(a.numerator_, b.numerator_);
  // a product has the sum of its factors' bits, or one less
  const std::size_t left = a.numerator_.bit_length() + b.denominator_.bit_length();
  const std::size_t right = b.numerator_.bit_length() + a.denominator_.bit_length();
  if (left + 1 < right) return -a.sign();
  if (right + 1 < left) return a.sign();
  return BigInteger::compare(a.numerator_ * b.denominator_, b.numerator_ * a.denominator_);
}

std::optional<Rational> exact_root(const Rational& a) {
  const std::optional<BigInteger> above = whole_root(a.numerator());
  if (!above) return std::nullopt;
  const std::optional<BigInteger> below = whole_root(a.denominator());
  if (!below) return std::nullopt;
  return Rational(*above, *below);
}

Rational sqrt(const Rational& a) {
  assert(a.sign() >= 0);
  if (std::optional<Rational> exact = exact_root(a)) return std::move(*exact);
  return Rational(std::sqrt(a.value()));
}

} // namespace lcpush::desktop
