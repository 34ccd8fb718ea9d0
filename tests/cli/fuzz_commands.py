"""Mutated scenes, matrices and answers through every command of the tool.

Usage: fuzz_commands.py TOOL REPO_ROOT [CASES [SEED [KEEP_DIRECTORY]]]
Longer by hand: fuzz_commands.py build/release/lcpush . 5000 7 found

Each case is a fixture in which numbers, signs, lines or sections are changed, under some options of
some command. Whatever it is, the tool ends by itself with exit status 0, 1 or 2, within 10 s of
processor time and 1 GB, says why on at most 80 columns a line, and never says "solved" with a NaN.
What breaks that is kept in KEEP_DIRECTORY. The seed decides everything.
"""
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

TOOL, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
CASES = int(sys.argv[3]) if len(sys.argv) > 3 else 300
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 1
KEEP = pathlib.Path(sys.argv[5]) if len(sys.argv) > 5 else None
SECONDS, BYTES, WIDEST = 10, 1 << 30, 80
# A sanitizer reserves address space and takes several times as long.
IS_SANITIZED = b"__asan_init" in TOOL.read_bytes()

SCENES = [p.read_text() for folder in ("scenes", "rays", "regressions")
          for p in sorted((ROOT / "fixtures" / folder).glob("*.toml"))]
RAW = [(p.read_text(), pathlib.Path(str(p).replace(".M.", ".q.")).read_text())
       for p in sorted((ROOT / "fixtures/textbook").glob("*.M.mtx"))]
NUMBER = re.compile(r"(?<![\w.#\"])-?\d+(?:\.\d+)?(?:e-?\d+)?(?![\w.\"])")
WORDS = ["0", "-0.0", "nan", "inf", "-inf", "1e308", "-1e-320", "1e-17", "", "true", "[]", "2/7",
         "99999999999999999999", "1e999", "\"x\"", "[[1]]", "100000", "2000", "256", "1e7"]


def mutated_number(rng, word):
    kind = rng.choice([0, 1, 2, 3, 3, 3, 4, 4, 5])
    if kind == 0:
        return rng.choice(WORDS)
    if kind == 1:
        return word[1:] if word.startswith("-") else "-" + word
    if kind == 2:
        return "0"
    try:
        value = float(word)
    except ValueError:
        return word
    if kind == 3:
        return repr(value * 10.0 ** rng.randint(-12, 12))
    if kind == 4:
        return repr(value * rng.choice([0.5, 2, 3, 1.0000001, 1e-17, -1]))
    return str(round(value * 10 ** rng.randint(0, 4)))


def mutated(rng, text, most=3):
    """Numbers, lines and sections, a few at a time."""
    for _ in range(rng.randint(1, most)):
        lines = text.split("\n")
        kind = rng.randrange(10) if rng.random() < 0.3 else 0
        at = rng.randrange(len(lines))
        numbers = list(NUMBER.finditer(text))
        if kind < 6 and numbers:
            match = rng.choice(numbers)
            text = text[:match.start()] + mutated_number(rng, match.group()) + text[match.end():]
            continue
        if kind == 6:
            del lines[at]
        elif kind == 7:
            lines.insert(rng.randrange(len(lines)), lines[at])
        elif kind == 8:
            other = rng.randrange(len(lines))
            lines[at], lines[other] = lines[other], lines[at]
        else:
            sections = re.split(r"\n(?=\[)", text)
            rng.shuffle(sections)
            sections += sections[-1:] * rng.choice([0, 0, 1, 30])
            text = "\n".join(sections)
            continue
        text = "\n".join(lines)
    return text


def option(rng, name, values):
    return [name, rng.choice(values)] if rng.random() < 0.3 else []


def flag(rng, *names):
    return [rng.choice(names)] if rng.random() < 0.3 else []


PATHS = ["*.grip_force=1:30", "*.friction=0:1", "object.mass=0.1:5", "gravity[1]=-20:20",
         "*.shift[0]=0:0.01", "*.turn=0:90", "nothing=1:2", "object.mass=1:1e300",
         "*.friction=0:1e9"]
LAWS = ["pad", "even", "rigid", "none"]


def scene_case(rng, folder):
    """Words of the command line; the files that it names are written."""
    scene = folder / "scene.toml"
    scene.write_text(mutated(rng, rng.choice(SCENES)))
    output = ["-o", str(folder / "out")]
    form = lambda *names: option(rng, "--format", names)
    command = rng.choice(["solve", "break", "spread", "sweep", "report", "export", "matrices",
                          "pivots", "verify", "sweep", "report"])
    words = [command, str(scene)]
    if command in ("solve", "break"):
        words += form("text", "json", "csv", "x") + flag(rng, "-v", "--strict")
        words += option(rng, "--pressure", LAWS)
    elif command == "spread":
        words += flag(rng, "--break", "--paths", "-v", "--json")
        words += option(rng, "--covers", ["1", "2", "0", "40"]) + option(rng, "--seconds", ["0.1", "1"])
    elif command == "sweep":
        for _ in range(rng.choice([1, 1, 1, 2, 3])):
            words += ["--vary", rng.choice(PATHS)]
        words += option(rng, "--steps", ["1", "2", "7", "60", "x"]) + option(rng, "--pressure", LAWS)
        words += option(rng, "--each", ["facets=4,8,16", "facets=0", "*.friction=0,1", "points=2"])
        words += form("text", "csv", "json", "svg") + flag(rng, "-v")
    elif command == "report":
        words += output + option(rng, "--vary", PATHS) + option(rng, "--steps", ["1", "9"])
        words += form("html", "svg") + option(rng, "--picture", ["front", "top", "side", "x"])
    elif command == "export":
        words += output
    elif command == "matrices":
        words += flag(rng, "--json", "--strict")
    elif command == "pivots":
        words += form("text", "json", "latex", "svg", "html") + option(rng, "--facets", ["4", "5", "256"])
        words += flag(rng, "--exact", "--first-row", "--z0-last", "--as-solved")
        words += option(rng, "--max-pivots", ["1", "50"]) + option(rng, "--pressure", LAWS)
    else:
        answer = folder / "answer.json"
        subprocess.run([TOOL, "solve", scene, "--json", "-o", answer], capture_output=True,
                       timeout=600, check=False)
        text = answer.read_text() if answer.exists() else '{"twist": [0, 0, 0, 0, 0, 0]}'
        answer.write_text(mutated(rng, rng.choice([text, "[" * 200, '{"a":' * 50, text])))
        words += [str(answer)] + flag(rng, "--json", "-v") + option(rng, "--tolerance", ["1", "0"])
    return words


def raw_case(rng, folder):
    M, q = rng.choice(RAW)
    answer = {"z": [rng.choice([0, 1, -1, 1e300, 0.5]) for _ in range(rng.randint(0, 6))]}
    for name, text in (("M.mtx", M), ("q.mtx", q), ("answer.json", json.dumps(answer))):
        (folder / name).write_text(mutated(rng, text, 2) if rng.random() < 0.7 else text)
    files = [str(folder / "M.mtx"), str(folder / "q.mtx")]
    command = rng.choice(["lcp", "lcp", "pivots", "verify"])
    if command == "verify":
        return ["verify", "--lcp", *files, str(folder / "answer.json")] + flag(rng, "--json", "-v")
    words = [command, *files]
    if command == "lcp":
        return words + option(rng, "--solver", ["lemke", "gauss-seidel", "hybrid"]) + \
            option(rng, "--free", ["1", "2,1", "9"]) + flag(rng, "--json", "--history")
    return words + flag(rng, "--exact", "--first-row", "--z0-last", "--as-solved") + \
        option(rng, "--format", ["html", "json", "latex", "svg"]) + option(rng, "--cover", ["1,2", "1,1,1,1"])


def limit():
    seconds = SECONDS * (8 if IS_SANITIZED else 1)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    if not IS_SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def complaint(words):
    """What is wrong, or an empty text."""
    result = subprocess.run([TOOL, *words], capture_output=True, stdin=subprocess.DEVNULL,
                            preexec_fn=limit, check=False)
    out, err = (b.decode(errors="replace") for b in (result.stdout, result.stderr))
    if result.returncode not in (0, 1, 2):
        return f"exit status {result.returncode}: {err[-600:]}"
    if result.returncode == 2 and not err.strip():
        return "no reason"
    if "bad_alloc" in err or "out of memory" in err:
        return err
    # A typed word may be long.
    wide = [line for line in err.split("\n") if len(line) > WIDEST and " " in line.strip()]
    if wide:
        return f"{len(wide[0])} columns: {wide[0]}"
    if result.returncode == 0 and re.search(r"\bnan\b", out) and "--format" not in words:
        return "an answer of nan"
    return ""


def main():
    failures = 0
    for case in range(CASES):
        rng = random.Random(f"{SEED}:{case}")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            words = (raw_case if rng.random() < 0.2 else scene_case)(rng, folder)
            wrong = complaint(words)
            if not wrong:
                continue
            failures += 1
            print(f"case {SEED}:{case}: lcpush {' '.join(words)}\n  {wrong}", flush=True)
            if KEEP is not None:
                kept = KEEP / f"{SEED}_{case}"
                shutil.copytree(folder, kept, dirs_exist_ok=True)
                line = " ".join(words).replace(str(folder), ".")
                (kept / "command.txt").write_text(f"lcpush {line}\n{wrong}\n")
    print(f"{CASES} cases of seed {SEED}, {failures} wrong")
    return 1 if failures else 0


if __name__ == "__main__":
    os.environ["ASAN_OPTIONS"] = "detect_leaks=0:allocator_may_return_null=1"
    sys.exit(main())
