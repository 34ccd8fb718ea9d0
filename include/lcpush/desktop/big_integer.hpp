// Whole numbers of any length: the numerators and denominators of rational.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace lcpush::desktop {

/// The operators that follow from T's +, -, *, ==, compare(), negate() and text().
template <class T> class Arithmetic {
  friend bool operator!=(const T& a, const T& b) { return !(a == b); }
  friend bool operator<(const T& a, const T& b) { return T::compare(a, b) < 0; }
  friend bool operator>(const T& a, const T& b) { return T::compare(a, b) > 0; }
  friend bool operator<=(const T& a, const T& b) { return T::compare(a, b) <= 0; }
  friend bool operator>=(const T& a, const T& b) { return T::compare(a, b) >= 0; }
  friend T& operator+=(T& a, const T& b) { return b.sign() == 0 ? a : a = a + b; }
  friend T& operator-=(T& a, const T& b) { return b.sign() == 0 ? a : a = a - b; }
  friend T& operator*=(T& a, const T& b) { return a = a * b; }
  friend std::ostream& operator<<(std::ostream& out, const T& a) { return out << a.text(); }
  friend T operator-(T a) {
    a.negate();
    return a;
  }
  friend T abs(T a) { return a.sign() < 0 ? -std::move(a) : a; }
};

/// Sign and magnitude. One of less than 2^64 needs no heap; moving never does.
class BigInteger : Arithmetic<BigInteger> {
public:
  using Limb = std::uint64_t;

  BigInteger() = default;
  template <class I, std::enable_if_t<std::is_integral_v<I>, int> = 0>
  BigInteger(I value) { // NOLINT: implicit on purpose
    const bool is_negative = std::is_signed_v<I> && value < I{0};
    small_ = is_negative ? Limb{0} - static_cast<Limb>(value) : static_cast<Limb>(value);
    size_ = small_ == 0 ? 0 : is_negative ? -1 : 1;
  }
  BigInteger(const BigInteger& other) { *this = other; }
  BigInteger(BigInteger&& other) noexcept
      : small_(other.small_), heap_(std::move(other.heap_)), capacity_(other.capacity_),
        size_(other.size_) {
    other.forget();
  }
  BigInteger& operator=(const BigInteger& other);
  BigInteger& operator=(BigInteger&& other) noexcept {
    if (this == &other) return *this;
    small_ = other.small_;
    heap_ = std::move(other.heap_);
    capacity_ = other.capacity_;
    size_ = other.size_;
    other.forget();
    return *this;
  }

  /// Decimal digits after an optional minus sign; nullopt for anything else. Cost: quadratic.
  static std::optional<BigInteger> parse(std::string_view text);
  /// Decimal digits. Cost: quadratic.
  std::string text() const;
  /// The nearest double, ties to even; infinite beyond its range.
  double value() const;

  int sign() const { return size_ < 0 ? -1 : size_ > 0 ? 1 : 0; }
  bool is_zero() const { return size_ == 0; }
  bool is_one() const { return size_ == 1 && low() == 1; }
  bool is_odd() const { return (low() & 1U) != 0; }
  /// Bits of the magnitude; 0 for 0.
  std::size_t bit_length() const;

  void negate() { size_ = -size_; }

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b);
  /// Towards zero, and the remainder has the sign of a. Pre: b != 0.
  friend BigInteger operator/(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator%(const BigInteger& a, const BigInteger& b);
  /// Of the magnitude; the sign stays.
  friend BigInteger operator<<(const BigInteger& a, std::size_t bits);
  friend BigInteger operator>>(const BigInteger& a, std::size_t bits);

  /// Both parts of a / b at once; either may be nullptr or &a or &b. Pre: b != 0.
  static void divide(const BigInteger& a, const BigInteger& b, BigInteger* quotient,
                     BigInteger* remainder);
  /// The remainder in 0..modulus-1, of negative numbers too. Pre: modulus != 0.
  Limb modulo(Limb modulus) const;
  /// >= 0; that of 0 and b is |b|. Cost: quadratic, by Lehmer's method.
  friend BigInteger gcd(const BigInteger& a, const BigInteger& b);
  /// The largest whole number whose square is not above a. Pre: a >= 0.
  friend BigInteger root(const BigInteger& a);

  /// < 0, 0 or > 0 as a is below, equal to or above b.
  static int compare(const BigInteger& a, const BigInteger& b);
  friend bool operator==(const BigInteger& a, const BigInteger& b) { return compare(a, b) == 0; }

private:
  Limb small_ = 0;
  std::unique_ptr<Limb[]> heap_;
  std::uint32_t capacity_ = 0; ///< of heap_
  std::int32_t size_ = 0;      ///< limbs in use, negative for a negative number

  const Limb* limbs() const { return heap_ ? heap_.get() : &small_; }
  Limb* limbs() { return heap_ ? heap_.get() : &small_; }
  std::size_t count() const { return static_cast<std::size_t>(size_ < 0 ? -size_ : size_); }
  Limb low() const { return size_ == 0 ? 0 : limbs()[0]; } ///< of the magnitude
  void forget() {
    heap_.reset();
    capacity_ = 0;
    size_ = 0;
  }

  Limb* room(std::size_t count);
  void finish(std::size_t count, bool is_negative);
  /// `magnitude` is a number of 128 bits.
  template <class Wide> static BigInteger of_two_limbs(Wide magnitude, bool is_negative);
  static BigInteger sum(const BigInteger& a, const BigInteger& b, bool b_negative);
};

} // namespace lcpush::desktop
