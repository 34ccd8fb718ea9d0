#!/usr/bin/env python3
"""Fuzzes host::Rational and host::BigInteger against Python's fractions.

usage: rational_fuzz.py RATIONAL_CALCULATOR [CASES [SEED]]

Every result must be Python's, digit for digit. Exits 1 at the first that is not.
"""
import math
import random
import subprocess
import sys
from fractions import Fraction

OPERATIONS = ["+", "-", "*", "/", "compare", "divide", "gcd", "root", "value", "exact"]
LIMB = 64


def whole(rng, bits):
    """Up to `bits` bits: any, long runs of equal bits, or next to a power of two."""
    kind = rng.randrange(5)
    if kind <= 1:
        return rng.getrandbits(bits)
    if kind == 2:  # runs of whole limbs: what makes a quotient's digit come out too large
        limbs = [0, 1, 2**LIMB - 1, 2**LIMB - 2, 2 ** (LIMB - 1), 2 ** (LIMB - 1) - 1]
        return sum(rng.choice(limbs) << (LIMB * k) for k in range(-(-bits // LIMB)))
    if kind == 3:
        return abs((1 << rng.randrange(bits + 1)) + rng.randrange(-2, 3))
    value, length = 0, 0
    while length < bits:
        run = rng.randrange(1, 100)
        value = (value << run) | (rng.choice([0, (1 << run) - 1]))
        length += run
    return value


def size(rng):
    return rng.choice([8, 31, 63, 64, 65, 127, 128, 129, 192, 400, 1000, 2500, 5000])


def fraction(rng):
    above, below = whole(rng, size(rng)), whole(rng, size(rng)) or 1
    return Fraction(rng.choice([1, -1]) * above, rng.choice([1, 1, below]))


def pair(rng):
    """Two fractions; their parts often share divisors, and differ little or by much."""
    a, b = fraction(rng), fraction(rng)
    kind = rng.randrange(6)
    if kind == 0:
        common = whole(rng, size(rng)) or 1
        a, b = Fraction(a.numerator * common, a.denominator), b * common
    elif kind == 1:
        common = whole(rng, size(rng)) or 1
        a, b = a / common, b / common
    elif kind == 2:
        b = -a if rng.random() < 0.3 else a + Fraction(rng.randrange(-2, 3), a.denominator)
    elif kind == 3:
        b *= Fraction(2) ** rng.randrange(-1200, 1200)
        a *= Fraction(2) ** rng.randrange(-1200, 1200)
    elif kind == 4:  # half-way between two doubles, and next to it
        a = Fraction(math.ldexp(2 * rng.getrandbits(53) + 1, rng.randrange(-1100, 900)))
        a = a / 2 + rng.choice([0, 0, 1, -1]) * Fraction(1, 2 ** rng.randrange(2000, 3000))
        a = a / 2 ** rng.randrange(0, 3)
    return a, b


def as_double(a):
    try:
        return a.numerator / a.denominator  # correctly rounded
    except OverflowError:
        return math.inf if a > 0 else -math.inf


def expected(operation, a, b):
    p, q = a.numerator, b.numerator
    if operation == "+":
        return str(a + b)
    if operation == "-":
        return str(a - b)
    if operation == "*":
        return str(a * b)
    if operation == "/":
        return str(a / b)
    if operation == "compare":
        return str((a > b) - (a < b))
    if operation == "divide":
        quotient = abs(p) // abs(q) * (1 if (p < 0) == (q < 0) else -1)
        return f"{quotient} {p - quotient * q}"
    if operation == "gcd":
        return str(math.gcd(p, q))
    if operation == "root":
        return str(math.isqrt(abs(p)))
    if operation == "value":
        return "%.17g %.17g" % (as_double(a), as_double(Fraction(p)))
    return str(Fraction(as_double(a)))


def main():
    calculator = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 12000
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    rng = random.Random(seed)
    cases = []
    while len(cases) < count:
        a, b = pair(rng)
        operation = rng.choice(OPERATIONS)
        if operation in ("/", "divide") and b == 0:
            continue
        if operation == "exact" and math.isinf(as_double(a)):
            continue
        cases.append((operation, a, b))
    lines = "".join(f"{operation} {a} {b}\n" for operation, a, b in cases)
    run = subprocess.run([calculator], input=lines, capture_output=True, text=True, timeout=120)
    answers = run.stdout.splitlines()
    for (operation, a, b), answer in zip(cases, answers):
        wanted = expected(operation, a, b)
        if answer.replace("-0 ", "0 ") != wanted.replace("-0 ", "0 "):
            print(f"{operation}\n  {a}\n  {b}\ngives\n  {answer}\ninstead of\n  {wanted}")
            return 1
    if run.returncode != 0 or len(answers) != count:
        print(f"{calculator} ended with {run.returncode} after {len(answers)} of {count} answers")
        return 1
    print(f"{count} results agree (seed {seed})")
    return 0


if __name__ == "__main__":
    sys.exit(main())
