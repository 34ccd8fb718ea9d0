"""Every folder is a room with one question. What it may include stands in ROOMS, and holds.

    python3 tests/contract/test_rooms.py REPO_ROOT [--sizes]      with --sizes the lines of each room, largest first

Prints FILE:LINE: what is wrong and exits 1; exits 0 if all is well, and if faults planted in a copy of
the sources are found.
"""

import pathlib
import re
import sys
import tempfile

# What everybody may include: the few types, the status of a run, the version.
GROUND = "include/lcpush"

CORE = "lcp lcp/pivots lcp/sweeps mechanics/model mechanics/paper mechanics/solve mechanics/study"
TOOLBOX = "text exact formats draw"
# A room: its question, and the rooms below it that it may include. Words without a leading src/ or
# include/lcpush/ are found in either.
ROOMS = {
    "include/lcpush/lcp": ("What is the problem, and is this its answer?", ""),
    "include/lcpush/lcp/pivots": ("How do pivots solve it?",
                                  "lcp lcp/pivots/structured"),
    "include/lcpush/lcp/pivots/structured": ("How does a pivot cost O(points)?", "lcp lcp/pivots"),
    "include/lcpush/lcp/sweeps": ("How do Gauss-Seidel sweeps solve it?", "lcp"),
    "include/lcpush/mechanics/model": ("Which laws hold between an object and what touches it?",
                                       "lcp"),
    "include/lcpush/mechanics/paper": ("How does the paper write these laws?",
                                       "lcp mechanics/model"),
    "include/lcpush/mechanics/solve": ("Which problems give the push, and the breaking force?",
                                       "lcp lcp/pivots lcp/sweeps mechanics/model"),
    "include/lcpush/mechanics/study": ("What can be said about a grasp or an answer?",
                                       "lcp lcp/pivots mechanics/model mechanics/solve"),
    "include/lcpush/c": ("What does C see?", ""),
    "include/lcpush/desktop": ("What can be asked on a desktop? One header a question.", CORE),
    "src/c": ("How is the C interface made of the core?", CORE),
    "src/commands": ("What can be asked, with which options, and how is it answered?",
                     f"{CORE} text formats desktop pivots scenes"),
    "src/calls": ("How does another language ask, and how is it told?",
                  "lcp text formats desktop scenes commands"),
    "src/lcp": ("Which solvers are compiled once?", CORE),
    "src/mechanics": ("Which laws are compiled once?", CORE),
    "src/text": ("How are numbers and lists put into words?", "desktop"),
    "src/exact": ("How are fractions and long floats computed with?", "text lcp desktop"),
    "src/formats": ("How are JSON, TOML and matrices read and written?", "text exact desktop"),
    "src/draw": ("How are shapes, plots and labels drawn? It knows no scene.", "text"),
    "src/scenes": ("What does a scene file say?", f"{CORE} {TOOLBOX} desktop"),
    "src/dense": ("How are small dense systems solved?", "lcp"),
    "src/solve": ("What happens in this push?", f"{CORE} {TOOLBOX} desktop dense scenes"),
    "src/raw": ("What solves this M and q?", f"{CORE} {TOOLBOX} desktop"),
    "src/enumerate": ("Which solutions has this M and q, all of them?", f"{CORE} {TOOLBOX} desktop"),
    "src/contacts": ("Which forces obey the laws at contacts of any bodies?",
                     f"{CORE} {TOOLBOX} desktop dense"),
    "src/sweep": ("How does the push change with a number of the scene?",
                  f"{CORE} {TOOLBOX} desktop dense scenes solve"),
    "src/spread": ("Which other answers are there?",
                   f"{CORE} {TOOLBOX} desktop dense scenes solve picture"),
    "src/verify": ("Is somebody else's answer, or motion, right?",
                   f"{CORE} {TOOLBOX} desktop dense scenes solve move"),
    "src/certify": ("What proves an answer without rounding?",
                    f"{CORE} {TOOLBOX} desktop scenes solve"),
    "src/export": ("How do other solvers get the problem?", f"{CORE} {TOOLBOX} desktop dense scenes solve"),
    "src/pivots": ("What happens at every pivot?", f"{CORE} {TOOLBOX} desktop dense scenes solve"),
    "src/cone": ("With which pushes does a pusher stick?", f"{CORE} {TOOLBOX} desktop dense scenes solve"),
    "src/hold": ("How well does the grasp hold before any push?",
                 f"{CORE} {TOOLBOX} desktop dense scenes solve"),
    "src/boxes": ("What holds for every value in a box?",
                  f"{CORE} {TOOLBOX} desktop dense scenes solve cone hold certify"),
    "src/design": ("Which numbers let a push stick for the widest box, and what does an edge align?",
                   f"{CORE} {TOOLBOX} desktop dense scenes solve move cone boxes"),
    "src/move": ("Where does the object end up in the grip?",
                 f"{CORE} {TOOLBOX} desktop dense scenes solve picture"),
    "src/plan": ("Which pushes take the object to another place in the grip?",
                 f"{CORE} {TOOLBOX} desktop dense scenes solve cone"),
    "src/picture": ("How does a grasp look from here?", f"{CORE} {TOOLBOX} desktop scenes"),
    "src/report": ("What does all this look like on a page?",
                   f"{CORE} {TOOLBOX} desktop dense scenes solve picture"),
    "src/play": ("What does the playground show, and what may its page ask?",
                 f"{CORE} {TOOLBOX} desktop scenes solve move pivots picture"),
    "src/play/wasm": ("How does a browser run the solver?", "play"),
    "src/cli": ("What do the words of a command line ask for?",
                f"{CORE} text formats desktop scenes commands"),
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
FOREIGN_DETAIL = re.compile(r"\bdetail::")
SAYS_NOTHING = re.compile(r"\b(?:struct|class|using|typename)\s+(Aim|Ask|Deed|Here|Look|Same|Told|Way)\b")


def room_of(path):
    return path.parent.as_posix()


def allowed(room):
    words = ROOMS[room][1].split()
    return {room, GROUND} | {f"{part}/{word}" for word in words for part in ("include/lcpush", "src")}


def included(root, path, name):
    """The file of ours that an include names, or None."""
    for base in (pathlib.Path("include"), pathlib.Path("src"), path.parent):
        if (root / base / name).is_file():
            return base / name
    return None


def faults_in(root, path):
    room = room_of(path)
    if room not in ROOMS and room != GROUND:
        yield 1, f"{room}/ is no room of tests/contract/test_rooms.py: say there what it asks"
        return
    is_library = path.parts[0] == "include"
    for number, line in enumerate((root / path).read_text(encoding="utf-8").splitlines(), 1):
        if not is_library and FOREIGN_DETAIL.search(line.split("//")[0]):
            yield number, "detail:: belongs to the library; ask for a public name"
        named = SAYS_NOTHING.search(line.split("//")[0])
        if named:
            yield number, f"a type called {named.group(1)}: say what it is, in the field's words"
        found = INCLUDE.match(line)
        if not found:
            continue
        name = found.group(2)
        if name.startswith("../") or "/../" in name:
            yield number, f"{name}: includes start at include/ or src/"
        target = included(root, path, name)
        if target is None or room == GROUND:
            continue
        if is_library and target.parts[0] == "src":
            yield number, f"{name}: a public header includes a private one"
        elif room_of(target) not in allowed(room):
            yield number, f"{room}/ may not include {room_of(target)}/ ({name})"


def check(root):
    paths = [path.relative_to(root) for folder in ("include", "src")
             for path in sorted((root / folder).rglob("*")) if path.suffix in (".hpp", ".cpp", ".h")]
    faults = [f"{path.as_posix()}:{number}: {what}"
              for path in paths for number, what in faults_in(root, path)]
    inhabited = {room_of(path) for path in paths}
    faults += [f"tests/contract/test_rooms.py: {room}/ is empty" for room in ROOMS
               if room not in inhabited]
    return len(paths), faults


# A file, a line put at its end, and what the check has to say of it.
PLANTED = [
    ("include/lcpush/lcp/residual.hpp", '#include "lcpush/mechanics/model/contact.hpp"',
     "may not include include/lcpush/mechanics/model/"),
    ("include/lcpush/mechanics/model/laws.hpp", '#include "lcpush/lcp/pivots/lemke.hpp"',
     "may not include include/lcpush/lcp/pivots/"),
    ("include/lcpush/desktop/push.hpp", '#include "text/wording.hpp"', "includes a private one"),
    ("src/sweep/sweep_text.cpp", '#include "spread/spread_face.hpp"', "may not include src/spread/"),
    ("src/draw/markup.cpp", '#include "lcpush/desktop/scene_io.hpp"',
     "may not include include/lcpush/desktop/"),
    ("src/solve/push.cpp", "int planted = lcpush::detail::max_rhs;", "detail::"),
    ("src/solve/push.cpp", '#include "../text/wording.hpp"', "includes start at"),
    ("src/solve/push.cpp", "template <class Ask> void planted(Ask ask);", "a type called Ask"),
]


def missed_faults(root):
    """The planted faults that the check does not see."""
    for name, line, expected in PLANTED:
        path = pathlib.Path(name)
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for part in ("include", "src"):
                for source in (root / part).rglob("*"):
                    if source.suffix in (".hpp", ".cpp", ".h"):
                        target = copy / source.relative_to(root)
                        target.parent.mkdir(parents=True, exist_ok=True)
                        target.symlink_to(source)
            text = (root / path).read_text(encoding="utf-8")
            (copy / path).unlink()
            (copy / path).write_text(f"{text}{line}\n", encoding="utf-8")
            if not any(name in fault and expected in fault for fault in check(copy)[1]):
                yield f"{name}: a planted {line!r} is not seen"


def sizes(root):
    """Lines of all files, pages and tables included, under each room and in no room of its own."""
    lines = dict.fromkeys([*ROOMS, GROUND, "src"], 0)
    for folder in ("include", "src"):
        for path in (root / folder).rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts:
                room = next(str(above) for above in path.relative_to(root).parents if str(above) in lines)
                lines[room] += path.read_bytes().count(b"\n")
    yield f"| {sum(lines.values()):,} | all |"
    for room in sorted(lines, key=lines.get, reverse=True):
        yield f"| {lines[room]:,} | {room} | {ROOMS.get(room, ['What else is needed?'])[0]} |"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]).resolve()
    if "--sizes" in sys.argv:
        print("\n".join(sizes(root)))
        return
    count, faults = check(root)
    faults = faults or list(missed_faults(root))
    if count == 0 or faults:
        sys.exit("\n".join(faults) or f"{root}: no sources there")
    print(f"{count} files in {len(ROOMS)} rooms; {len(PLANTED)} planted faults seen")


if __name__ == "__main__":
    main()
