#!/usr/bin/env python3
"""Fuzzes the TOML reader against Python's tomllib.

usage: toml_fuzz.py TOML_DUMP [CASES [SEED]]

Whatever the reader accepts, tomllib must accept with equal values of equal types, a byte order mark
aside; a refusal must carry file and line; nothing may crash or hang. Texts of the subset, before mutation, must be
accepted. Exits 1 at the first violation and leaves its text in a file that it names.
"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import tomllib

BATCH = 250
SECONDS_A_BATCH = 120
FRAGMENTS = [
    b'"', b'"""', b"'", b"'''", b"[", b"]", b"[[", b"]]", b"{", b"}", b"=", b",", b".", b"#", b"\n",
    b"\r\n", b"\r", b"\t", b" ", b"\\", b"\\u", b"\\u00e9", b"\\uD800", b"\\U0001F600",
    b"\\U00110000", b"\\x41", b"\\e", b"\\b", b"\x00", b"\x01", b"\x7f", b"\x1f", b"\xc3\xa9",
    b"\xc3", b"\xff", b"\xed\xa0\x80", b"\xf4\x90\x80\x80", b"\xc0\x80", b"\xe2\x80\xa8",
    b"\xc2\x85", b"\xef\xbb\xbf", b"\xef\xbf\xbf", b"\xf0\x9f\x98\x80", b"_", b"__", b"+", b"-",
    b"0", b"00", b"1_000", b"0x1F", b"0b1", b"0o7", b"1e400", b"1e-400", b"4.9e-324", b"1e5",
    b"1E+05", b"1.", b".5", b"-0", b"-0.0", b"+0.0", b"inf", b"-nan", b"true", b"false", b"True",
    b"9223372036854775807", b"9223372036854775808", b"-9223372036854775808",
    b"1979-05-27", b"07:32:00", b"1979-05-27T07:32:00Z", b"a.b = 1", b'"k" = 1', b"a = 1\n",
    b"[a]\n", b"[[a]]\n", b"[ a ]", b"[a.b]", b"{x = 1}", b"[" * 40, b"]" * 40,
]
KEYS = ["a", "b", "c", "name", "A-1", "_", "0", "1_2", "friction", "-"]


def number(rng):
    sign = rng.choice(["", "", "+", "-"])
    if rng.random() < 0.5:
        digits = str(rng.choice([0, 7, 10, rng.randrange(10**6), rng.randrange(2**63)]))
        if rng.random() < 0.3 and len(digits) > 1:
            digits = digits[0] + "_" + digits[1:]
        return sign + digits
    real = repr(rng.choice([rng.random(), rng.uniform(-1e9, 1e9), rng.lognormvariate(0, 100)]))
    real = real.lstrip("-")
    if "e" not in real and rng.random() < 0.4:
        real += rng.choice(["e", "E"]) + rng.choice(["", "+", "-"]) + f"{rng.randrange(20):02}"
    return sign + real


def string(rng):
    pieces = ["x", "é", "\t", "#", "'", "[", "=", "\\n", '\\"', "\\\\", "\\u00E9", "\\U0001f600",
              "\\u0000", "\u2028", "\x85", " ", "😀", "\\f\\b\\t\\r"]
    return '"' + "".join(rng.choice(pieces) for _ in range(rng.randrange(6))) + '"'


def array(rng, depth):
    gaps = ["", " ", "\n", " # note\n", "\r\n\t", "\n\n"]
    parts = ["["]
    for i in range(rng.randrange(4)):
        if i:
            parts.append(",")
        kind = rng.random()
        nested = kind < 0.3 and depth < 7
        element = array(rng, depth + 1) if nested else rng.choice([number, string])(rng)
        parts += [rng.choice(gaps), element, rng.choice(gaps)]
    if len(parts) > 1 and rng.random() < 0.3:
        parts += [",", rng.choice(gaps)]
    return "".join(parts) + "]"


def entries(rng):
    lines = []
    for key in rng.sample(KEYS, rng.randrange(4)):
        kind = rng.random()
        if kind < 0.35:
            value = number(rng)
        elif kind < 0.6:
            value = string(rng)
        elif kind < 0.7:
            value = rng.choice(["true", "false"])
        else:
            value = array(rng, 0)
        lines.append(f"{rng.choice(['', ' '])}{key} ={rng.choice(['', ' ', chr(9)])}{value}")
        lines[-1] += rng.choice(["", " ", " # a comment é", "#"])
    return lines + rng.choice([[], [""], ["# only a comment"]])


def document(rng):
    lines = entries(rng)
    tables = rng.sample(["object", "gripper", "t-1", "2"], rng.randrange(3))
    tables += rng.choices(["finger", "pusher"], k=rng.randrange(4))
    rng.shuffle(tables)
    for name in tables:
        spaced = rng.choice([name, f" {name}\t"])
        lines.append(f"[[{spaced}]]" if name in ("finger", "pusher") else f"[{spaced}]")
        lines += entries(rng)
    text = rng.choice(["\n", "\r\n"]).join(lines) + rng.choice(["", "\n"])
    return text.encode()


def mutate(rng, text):
    for _ in range(rng.choice([1, 1, 1, 2, 3, 8])):
        i, j = sorted(rng.randrange(len(text) + 1) for _ in range(2))
        j = min(j, i + rng.choice([1, 1, 4, 30]))
        kind = rng.randrange(6)
        if kind == 0:
            text = text[:i] + rng.choice(FRAGMENTS) + text[i:]
        elif kind == 1:
            text = text[:i] + rng.choice(FRAGMENTS) + text[j:]
        elif kind == 2:
            text = text[:i] + text[j:]
        elif kind == 3:
            text = text[:i] + text[i:j] * rng.choice([2, 3]) + text[j:]
        elif kind == 4:
            text = text[:i] + bytes([rng.randrange(256)]) + text[i + 1:]
        else:
            lines = text.split(b"\n")
            rng.shuffle(lines)
            text = b"\n".join(lines)
    return text


def expected(text):
    """What tomllib reads, or None if it refuses."""
    try:
        return tomllib.loads(text.decode("utf-8-sig"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError):
        return None


def violation(text, line, is_plain):
    """What is wrong with our `line` for `text`; None if nothing is."""
    if line.startswith("error: "):
        if not re.match(r"error: FILE:\d+: .", line):
            return "a refusal without file and line"
        return "a text of the subset was refused" if is_plain else None
    root, sections = json.loads(line)
    theirs = expected(text)
    if theirs is None:
        return "tomllib refuses it"
    # repr tells 1 from 1.0 and 0.0 from -0.0; the sorted copy ignores the order of keys.
    ours = json.dumps(root | sections, sort_keys=True)
    return None if ours == json.dumps(theirs, sort_keys=True) else "the values differ"


def stop(reason, text, line):
    handle, path = tempfile.mkstemp(suffix=".toml", prefix="toml_fuzz_")
    os.write(handle, text)
    os.close(handle)
    sys.exit(f"toml_fuzz: {reason}\n  text: {path}\n  ours: {line}")


def run_batch(program, folder, cases):
    paths = []
    for i, (text, _) in enumerate(cases):
        paths.append(os.path.join(folder, f"{i}.toml"))
        with open(paths[-1], "wb") as file:
            file.write(text)
    try:
        run = subprocess.run([program, *paths], capture_output=True, timeout=SECONDS_A_BATCH)
        output, code, noise = run.stdout, run.returncode, run.stderr.decode(errors="replace")
    except subprocess.TimeoutExpired as late:
        output, code, noise = late.stdout or b"", "timeout", ""
    lines = output.decode().split("\n")[:-1]
    for (text, is_plain), line in zip(cases, lines):
        if reason := violation(text, line, is_plain):
            stop(reason, text, line)
    if code not in (0, 2) or len(lines) != len(cases):
        culprit = cases[min(len(lines), len(cases) - 1)][0]
        stop(f"crash or hang, exit {code}\n{noise}", culprit, "nothing")
    return sum(not line.startswith("error: ") for line in lines)


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 20000
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    accepted = 0
    with tempfile.TemporaryDirectory() as folder:
        for start in range(0, count, BATCH):
            cases = []
            for i in range(start, min(start + BATCH, count)):
                text = document(rng)
                is_plain = i % 5 == 0
                cases.append((text if is_plain else mutate(rng, text), is_plain))
            accepted += run_batch(program, folder, cases)
    print(f"toml_fuzz: {count} texts, {accepted} accepted, all as tomllib reads them")


if __name__ == "__main__":
    main()
