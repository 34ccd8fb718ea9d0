"""What people get wrong, on the command line and in their first scenes: every one of these is refused with a
plain, located message that says what to do, or solved and named in a Check line."""
import os
import pathlib
import re
import shlex

from tool import SOURCE, ToolTest, main, run

SCENE = (SOURCE / "tests/scenes/box_slide.toml").read_text().split("\n", 3)[3]
WALL = SCENE[SCENE.index("[[pusher]]"):]
MATRIX = "%%MatrixMarket matrix array real general\n"

# What stands in the folder where the commands below are typed.
FILES = {
    "good.toml": SCENE, "empty.toml": "", "comments.toml": "# nothing yet\n", "zeros.toml": "\0\1\2",
    "M.mtx": MATRIX + "2 2\n2\n1\n1\n2\n", "q.mtx": MATRIX + "2 1\n-5\n-6\n",
    "packed.mtx": "\x1f\udc8b\x08",  # the first bytes of gzip
    "q3.mtx": MATRIX + "3 1\n-5\n-6\n-7\n", "empty.json": "{}", "open.json": "[1,2",
}

# The words after `lcpush`, and what the message says.
COMMANDS = [
    ("good.toml", '"good.toml" is no command', "Try: lcpush solve good.toml"),
    ("--json solve good.toml", '"--json" stands before the command', "Try: lcpush solve SCENE.toml --json"),
    ("solv good.toml", '(did you mean "solve"?)'),
    ("Solve good.toml", '(did you mean "solve"?)'),
    ("solve", "a scene file is needed; `lcpush new box -o mine.toml` writes one"),
    ("solve nofile.toml", "nofile.toml: cannot be read: No such file or directory; check the path"),
    ("solve folder", "folder: is a directory; name a file inside it"),
    ("solve empty.toml", "empty.toml:1: there is nothing in it; `lcpush new box` writes a scene"),
    ("solve comments.toml", "comments.toml:1: there is nothing in it"),
    ("solve zeros.toml", "zeros.toml:1: control character"),
    ("solve empty.json", "empty.json:1: this looks like JSON; a scene is TOML"),
    ("solve M.mtx", "M.mtx:1: this is a Matrix Market file; a scene is TOML"),
    ("solve ''", "the name of a file is empty"),
    ("solve good.toml good.toml", 'one name too many: "good.toml"'),
    ("hold good.toml --at 0.01 0 0", 'one name too many: "0"; what --at takes stands in quotes: "X Y Z"'),
    ("solve good.toml --jsn", '(did you mean "--json"?)'),
    ("solve good.toml --format", "--format needs a value: --format text|json"),
    ("solve good.toml --format xml", '--format is text or json, not "xml"'),
    ("solve good.toml --format JSON", '(did you mean "json"?)'),
    ("solve good.toml --solver lemky", '(did you mean "lemke"?)'),
    ("solve good.toml --json --json", "--format is given twice"),
    ("solve good.toml --strict=yes", "--strict takes no value"),
    ("move good.toml --pressure pad", "would take it"),
    ("solve good.toml --pusher wall", "would take it"),
    ("solve good.toml -o", "-o needs a value: -o FILE"),
    ("solve good.toml -o ''", "the file to write to has an empty name"),
    ("solve good.toml -o nofolder/x.txt", "nofolder/x.txt: cannot be written"),
    ("solve good.toml -o folder", "folder: is a directory; name a file inside it"),
    ("solve good.toml -o x.pdf", "does not write .pdf files"),
    ("break good.toml --pusher wal", '(did you mean "wall"?)'),
    ("sweep good.toml", "say what to vary: --vary PATH=FROM:TO"),
    ("sweep good.toml --vary friction=0.1:1", '(did you mean "*.friction"?)'),
    ("sweep good.toml --vary *.frction=0.1:1", '(did you mean "*.friction"?)'),
    ("sweep good.toml --vary wall.normal=0:1", '(did you mean "wall.normal[0]"?)'),
    ("sweep good.toml --vary left.grip_force", "--vary needs PATH=FROM:TO"),
    ("sweep good.toml --vary left.grip_force=5,40", 'write --vary "left.grip_force=5:40"'),
    ("sweep good.toml --vary *.grip_force=5:40:10", "--steps says how many values"),
    ("sweep good.toml --vary *.grip_force=5m:40m", "a length; N, mN or kN is meant"),
    ("sweep good.toml --vary *.grip_force=5:5", "from and to are the same"),
    ("sweep good.toml --vary *.grip_force=0:40", "good.toml:17:", "(at *.grip_force = 0)"),
    ("sweep good.toml --vary left.grip_force=5:40", "good.toml:26:", "parallel jaws share one grip_force"),
    ("sweep good.toml --vary facets=4:8", "good.toml: facets counts something", "(--each facets=4,8,16), not a range"),
    ("sweep good.toml --vary *.grip_force=5:40 --steps 0", "--steps is a whole number from 2"),
    ("sweep good.toml --vary *.grip_force=5:40 --pressure ridgid", '(did you mean "rigid"?)'),
    ("solve good.toml --set left.diameter=0.01", 'no key "diameter" (did you mean "radius", half of it?)'),
    ("solve good.toml --set left.shape=circle", '(did you mean "disc"?)'), ("move good.toml --duration 1", '(did you mean "--time"?)'),
    ("verify good.toml", "two files are needed: SCENE.toml ANSWER.json"),
    ("verify good.toml empty.json", "empty.json:1: nothing to verify"),
    ("verify good.toml open.json", "open.json:1: expected , or ] in an array"),
    ("verify empty.json good.toml", "empty.json:1: this looks like JSON; a scene is TOML"),
    ("verify - -", "standard input can be read only once"),
    ("lcp M.mtx", "two files are needed: M.mtx q.mtx"),
    ("lcp M.mtx q3.mtx", "q3.mtx: q must be 2 x 1 like M's rows, but it is 3 x 1"),
    ("lcp q.mtx M.mtx", "q.mtx: M must be square, but it is 2 x 1"),
    ("lcp M.mtx good.toml", "good.toml:1: not a Matrix Market file"),
    ("lcp --M '2 1; 1' --q '1 2'", "--M: row 2: expected 2 numbers, as in row 1, got 1"),
    ("lcp --M '2 1; 1 2' --q 1", "--q: q must be 2 x 1"),
    ("lcp --M '2 1; 1 2' --q '1 2' --free 3", "--free is a list of rows from 1 to 2"),
    ("lcp M.mtx q.mtx --lo 2 --hi 1", "--lo: row 1: the lower end 2 is above the upper end 1"),
    ("lcp M.mtx q.mtx --lo q3.mtx", "q3.mtx: --lo has 3 numbers, M has 2 rows"),
    ("lcp M.mtx q.mtx --lo '1 2 3'", "--lo: --lo has 3 numbers, M has 2 rows"),
    ("lcp M.mtx q.mtx --lo nofile.mtx", "nofile.mtx: cannot be read"),
    ("lcp M.mtx q.mtx --lo M.mtx", "M.mtx: --lo must be 2 x 1, but it is 2 x 2"),
    ("lcp M.mtx q.mtx --findex '-1 0'", "--findex needs --hi"),
    ("lcp M.mtx q.mtx --hi '1 1' --findex '-1 1'", "--findex: row 2 follows itself (rows count from 0)"),
    ("lcp M.mtx q.mtx --hi '1 1' --findex '-1 2'", "--findex: row 2 follows 2; give -1, or a row counted from 0"),
    ("lcp M.mtx q.mtx --hi '1 inf' --findex '-1 0'", "--hi: row 2 follows another row: its --hi is the friction"),
    ("lcp M.mtx q.mtx --hi '1 1' --findex '1 0'", "which follows a row itself"),
    ("lcp M.mtx q.mtx --lo -1 --hi '1 1' --findex '-1 0'", "which may be negative; its --lo must be >= 0"),
    ("lcp M.mtx q.mtx --hi 1 --free 1", "--free goes without --lo, --hi and --findex"),
    ("lcp packed.mtx q.mtx", "packed.mtx:1: the file is compressed; unpack it on the way: gunzip -c FILE"),
    ("verify good.toml empty.json --lo 0", "--lo goes with --lcp"),
    ("export good.toml", "say where to: -o DIRECTORY"),
    ("export good.toml --target mosek -o out", 'unknown option "--target"'),
    ("report good.toml -o x.png", "does not write .png files"),
    ("new", "say what is gripped: box or cylinder"),
    ('new box --pads 20', 'write "20 mm x 10 mm"'),
    ("new ball", 'the object is box or cylinder, not "ball"'),
    ("new box --push pivto", '(did you mean "pivot"?)'),
    ("new box --push roll", "a box does not roll; try: lcpush new cylinder --push roll"),
    ("example nope", "`lcpush example` lists them"),
    ("completion tcsh", "say for whom: bash, zsh, fish or man"),
]

# In the guide's first scene: what is written, for what, the line (0: none), and what the message says.
SCENES = [
    ("Friction = 0.5", "friction = 0.5", 16, '(did you mean "friction"?)'),
    ("mu = 0.5", "friction = 0.5", 16, '(did you mean "friction"?)'),
    ("gripforce = 20 ", "grip_force = 20 ", 17, '(did you mean "grip_force"?)'),
    ("grip = 20 ", "grip_force = 20 ", 17, '(did you mean "grip_force"?)'),
    ("force = 20 ", "grip_force = 20 ", 17, '(did you mean "grip_force"?)'),
    ("position = [0, 0, 0.005]", "center = [0, 0, 0.005]", 13, '(did you mean "center"?)'),
    ("accelerate = [", "acceleration = [", 34, '(did you mean "acceleration"?)'),
    ("grip_force = 5\nacceleration", "acceleration", 34, '"grip_force"; it goes with [[finger]]'),
    ("acceleration = [0, 0, 1]", "grip_force = 20 ", 17, "; it goes with [[pusher]] or [[actuator]]"),
    ("facets = 8\nmass =", "mass =", 4, '"facets"; it stands at the top, before the first table'),
    ("size = [0.1", "box = [0.1", 5, '(did you mean "box"?)'),
    ("zzz = 1\nmass =", "mass =", 4, "; the keys here are mass, box"),
    ("mass = 0.2 kg", "mass = 0.2", 4, 'write "0.2 kg"'),
    ('mass = "0.2"', "mass = 0.2", 4, "the unit is missing; write 0.2 without quotes"),
    ("mass = 0,2", "mass = 0.2", 4, "a decimal number has a point"),
    ('mass = "0,2 kg"', "mass = 0.2", 4, 'write "0.2 kg", with a point in decimals'),
    ('box = "100 40 20"', "box = [0.1, 0.03, 0.01]", 5, "several numbers are a list"),
    ('friction = "0.3"', "friction = 0.3", 33, 'got the text "0.3"; write 0.3'),
    ('friction = "30 %"', "friction = 0.3", 33, 'got the text "30 %"; write 0.3'),
    ("mass = 1/5", "mass = 0.2", 4, '"1/5" is not a decimal number'),
    ("mass: 0.2", "mass = 0.2", 4, 'expected = after "mass"'),
    ("mass = 0.2\nmass = 0.3", "mass = 0.2", 5, "first given on line 4"),
    ("", "mass = 0.2", 3, 'missing key "mass"; add for example mass = 0.2  # kg'),
    ("[0, -9,81, 0]", "[0, -9.81, 0]", 1, "a decimal number has a point"),
    ("gravity = 9.81", "gravity = [0, -9.81, 0]", 1, "gravity must be a list of 3 numbers, got 9.81; write [0, -9.81, 0]"),
    ("friction = -0.3", "friction = 0.3", 33, "friction must be >= 0"),
    ("grip_force = -20 ", "grip_force = 20 ", 17, "grip_force must be > 0"),
    ("normal = [1, 0]", "normal = [1, 0, 0]", 32, "normal must be a list of 3 numbers"),
    ("normal = [0, 0, 0]", "normal = [1, 0, 0]", 32, "normal must not be zero"),
    ("normal = (1, 0, 0)", "normal = [1, 0, 0]", 32, "a list has [square brackets]"),
    ("normal = [1 0 0]", "normal = [1, 0, 0]", 32, "expected , or ] in the list"),
    ('"circle"', '"disc"', 12, 'shape must be "point", "line", "disc"'),
    ('"dics"', '"disc"', 12, '(did you mean "disc"?)'),
    ("center = [-0.05, 0, 0]", "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]", 31,
     'center does not go with the shape "line", which takes ends'),
    ("", "acceleration = [0.1, 0, 0]", 28, "missing the motion; add velocity"),
    ("acceleration = 0.1", "acceleration = [0.1, 0, 0]", 34, "acceleration must be a list of 3 numbers"),
    ("[finger]", "[[finger]]", 19, "write [[finger]] in both places"),
    ("[[object]]", "[object]", 3, "there is only one object; write [object]"),
    ("[[fingers]]", "[[finger]]", 10, '(did you mean "finger"?)'),
    ('"left"', '"right"', 20, "names must be unique"),
    (WALL + WALL, WALL, 36, "names must be unique"),
    ("“left”", '"left"', 11, 'a text needs "double quotes"'),
    ("'left'", '"left"', 11, 'use "double quotes"'),
    ("planar = True\ngravity", "gravity", 1, '(did you mean "true"?)'),
    ("facets = 7\ngravity", "gravity", 1, "facets must be even"),
    ('"paralel"', '"parallel"', 8, '(did you mean "parallel"?)'),
]

# The same, but solved: what the Check line names.
DOUBTS = [
    ("box = [100, 30, 10]", "box = [0.1, 0.03, 0.01]", 3, "lengths are in m"),
    ("mass = 200 ", "mass = 0.2 ", 3, "heavier than any material"),
    ("[0, -9810, 0]", "[0, -9.81, 0]", 1, "more than on any planet"),
    ("friction = 30", "friction = 0.3", 33, "neither percent nor an angle"),
    ("center = [0, 0, 5]", "center = [0, 0, 0.005]", 13, "positions are in m"),
    ("radius = 5 ", "radius = 0.005 ", 13, "positions are in m"),
    ("center = [0, 0.18, 0.005]", "center = [0, 0, 0.005]", 13, "outside of the box"),
    ("normal = [0, 0, 1]", "normal = [0, 0, -1]", 14, "points out of the box"),
    ("normal = [-1, 0, 0]", "normal = [1, 0, 0]", 32, "points out of the box; normals point into "
     "the object, here [1, 0, 0]"),
    ("acceleration = [-0.1, 0, 0]", "acceleration = [0.1, 0, 0]", 34, "moves away from the object"),
    ("acceleration = [1e6, 0, 0]", "acceleration = [0.1, 0, 0]", 34, "accelerations are in m/s^2"),
    ("velocity = [-0.1, 0, 0]", "acceleration = [0.1, 0, 0]", 34, "turn its velocity round"),
    ("velocity = [1e6, 0, 0]", "acceleration = [0.1, 0, 0]", 34, "velocities are in m/s"),
    ("[[-0.05, -0.015, 0], [0.05, -0.015, 0]]", "[[-0.05, -0.015, 0], [-0.05, 0.015, 0]]", 32,
     "one contact touches one face"),
]

# Nothing is wrong with these: words after `lcpush`, a scene on standard input.
RIGHT = [
    ("solve -", SCENE), ("solve -", SCENE.replace("\n", "\r\n")), ("solve -", SCENE.replace(" = ", "\t=\t")),
    ("solve - --strict", SCENE), ("help solve", ""), ("solve --help", ""), ("-h", ""), ("help", ""),
    ("version", ""), ("--version", ""), ("example straight_slide.toml", ""),
    ("example fixtures/scenes/pivot.toml", ""), ("sweep - --vary '*.grip_force = 5 : 40' --steps 2", SCENE),
    ("sweep - --vary *.grip_force=40:5 --steps 2", SCENE), ("lcp M.mtx q.mtx", ""),
]


class Mistakes(ToolTest):
    def setUp(self):
        super().setUp()
        (self.path / "folder").mkdir()
        for name, text in FILES.items():
            (self.path / name).write_text(text, errors="surrogateescape")
        self.names = sorted(os.listdir(self.path))

    def run_tool(self, words, text=""):
        result = run(*shlex.split(words), text=text, cwd=self.path)
        result.stderr = re.sub(r"lcpush: \d+ .*\n", "", result.stderr)  # progress, of a busy machine
        printed_scene = words.startswith("example")
        for line in ((result.stdout if not printed_scene else "") + result.stderr).splitlines():
            if " " in line.strip():  # one word is not broken
                self.assertLessEqual(len(line), 80, f"{words}: {line}")
        return result

    def test_the_command_line(self):
        for words, *said in COMMANDS:
            with self.subTest(words):
                result = self.run_tool(words)
                self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                for part in said:
                    self.assertIn(part, result.stderr.replace("\n", " "))
                self.assertEqual(sorted(os.listdir(self.path)), self.names)

    def changed(self, new, old):
        self.assertIn(old, SCENE)
        return SCENE.replace(old, new, 1)

    def test_scenes_that_are_refused(self):
        for new, old, line, said in SCENES:
            with self.subTest(new):
                result = self.run_tool("solve -", self.changed(new, old))
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertTrue(result.stderr.startswith(f"standard input:{line}: "), result.stderr)
                self.assertIn(said, result.stderr.replace("\n", " "))

    def test_what_takes_too_long_ends_and_says_so(self):
        slow = self.changed("facets = 64\n[object]", "[object]")
        words = 'report - --vary "*.friction=0:1e9" -o curve.html --seconds 0.2'
        result = self.run_tool(words, slow)
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertIn("stopped after 0.2 s of processor time; what there was by then is written; "
                      "--seconds 2 gives it more", result.stderr.replace("\n", " "))
        self.assertIn("<svg", pathlib.Path(self.path, "curve.html").read_text())
        os.remove(os.path.join(self.path, "curve.html"))

    def test_scenes_that_were_not_meant(self):
        for new, old, line, said in DOUBTS:
            with self.subTest(new):
                result = self.run_tool("solve -", self.changed(new, old))
                self.assertIn(result.returncode, (0, 1))
                self.assertTrue(result.stderr.startswith(f"Check: standard input:{line}: "), result.stderr)
                self.assertIn(said, result.stderr.replace("\n", " "))
                strict = self.run_tool("solve - --strict", self.changed(new, old))
                self.assertEqual((strict.returncode, strict.stdout), (2, ""))

    def test_what_is_right_is_not_named(self):
        for words, text in RIGHT:
            with self.subTest(words):
                result = self.run_tool(words, text)
                self.assertEqual((result.returncode, result.stderr), (0, ""))


main()
