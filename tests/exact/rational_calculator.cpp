// Reads lines `OPERATION a b` with fractions a and b; prints the result of each. Doubles are
// printed as 17 digits. tests/exact/rational_fuzz.py compares the lines with Python's fractions.
#include "lcpush/desktop/rational.hpp"

#include <cstdio>
#include <iostream>
#include <string>

namespace {

using lcpush::desktop::BigInteger;
using lcpush::desktop::Rational;

std::string quotient_and_remainder(const Rational& a, const Rational& b) {
  BigInteger quotient, remainder;
  BigInteger::divide(a.numerator(), b.numerator(), &quotient, &remainder);
  return quotient.text() + ' ' + remainder.text();
}

std::string in_digits(double value) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  return digits;
}

std::string answer(const std::string& operation, const Rational& a, const Rational& b) {
  if (operation == "+") return (a + b).text();
  if (operation == "-") return (a - b).text();
  if (operation == "*") return (a * b).text();
  if (operation == "/") return (a / b).text();
  if (operation == "compare") return std::to_string(Rational::compare(a, b));
  if (operation == "divide") return quotient_and_remainder(a, b);
  if (operation == "gcd") return gcd(a.numerator(), b.numerator()).text();
  if (operation == "root") return root(abs(a.numerator())).text();
  if (operation == "value") return in_digits(a.value()) + ' ' + in_digits(a.numerator().value());
  if (operation == "exact") return Rational(a.value()).text();
  return "unknown operation";
}

} // namespace

int main() {
  std::ios::sync_with_stdio(false);
  std::string operation, left, right;
  while (std::cin >> operation >> left >> right) {
    const std::optional<Rational> a = Rational::parse(left), b = Rational::parse(right);
    std::cout << (a && b ? answer(operation, *a, *b) : "no number") << '\n';
  }
}
