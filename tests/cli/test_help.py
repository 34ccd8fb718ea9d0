"""What a newcomer types: the bare command, the examples of every --help, near misses; what is written says so."""
import re
import shlex

from tool import SCENES, SOURCE, ToolTest, main, run, unwrapped

OVERVIEW = run().stderr
COMMANDS = re.findall(r"^(?:[a-z]+| ) +([a-z]+)  ", OVERVIEW, flags=re.M)
SLIDE = SCENES / "straight_slide.toml"
MISSES = [  # words, what is said instead
    (["pivots", "coin"], "there is no file \"coin\", but a shipped scene of this name: `lcpush example coin -o coin.toml` writes it"),
    (["certify"], "is no command but an option, of solve, break, cone and lcp Try: lcpush solve SCENE.toml --certify FILE"),
    (["gallery"], "an option, of play Try: lcpush play --gallery"),
    *((["sweep", SLIDE, "--vary", *words], 'write --vary "edge.friction=5:25"') for words in (
        ["edge.friction", "5", "25"], ["edge.friction", "5:25"], ["edge.friction=5", "25"], ["edge.friction=5,25"])),
    (["cone", SLIDE, "--vary", "wall.turn", "-5", "5"], 'write --vary "wall.turn=-5:5"'),
    (["sweep", SLIDE, "--vary", "edge.friction", SLIDE], "--vary needs PATH=FROM:TO"),
]
LABELS = [  # what varies in the straight slide, the plot's axis
    ("*.grip_force=2:30", "grip force, N"), ("wall.friction=0.1:0.3", "friction of wall"),
    ("wall.shift[1]=0:0.01", "shift of wall along y, m"), ("object.mass=0.1:0.3", "mass of the object, kg"),
    ("gravity[1]=-9:-1", "gravity along y, m/s^2"), ("wall.turn=-10:10", "turn of wall, degrees"),
    ("left.points[0][1]=-0.005:0.005", "points of left no. 1 along y, m"),
]


def examples(name):
    """Its commands; a line that goes on ends in a backslash."""
    text = run(name, "--help").stdout
    block = re.search(r"^Examples?:\n(.*?)\n\n", text, flags=re.M | re.S)
    return block[1].replace("\\\n", " ").splitlines() if block else []


class HelpTest(ToolTest):
    def test_the_overview_fits_a_terminal(self):
        lines = OVERVIEW.splitlines()
        self.assertLessEqual(len(lines), 24)
        self.assertLessEqual(max(map(len, lines)), 80)
        groups = re.findall(r"^([a-z]+) +[a-z]+  ", OVERVIEW, flags=re.M)
        self.assertEqual(groups, ["start", "ask", "look", "check", "teach"])
        page = (SOURCE / "docs/guide/commands.md").read_text()
        self.assertEqual(re.findall(r"^\| .*?\| `lcpush (\w+)", page, flags=re.M), COMMANDS)  # so does the page

    def test_examples_run_as_they_stand(self):
        for name in ("fixtures", "docs"):
            (self.path / name).symlink_to((SOURCE / name).resolve())
        count = 0
        for name in COMMANDS:
            self.assertTrue(examples(name), name)
            for line in examples(name):
                with self.subTest(line=line):
                    words = shlex.split(line)
                    self.assertEqual(words[0], "lcpush")
                    if words[-1].startswith("~"):  # a place that need not be there
                        words[-1] = self.path / "there"
                    result = run(*words[1:], cwd=self.path)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    self.assertNotIn("Check:", result.stderr)
                    count += 1
        self.assertGreater(count, 20)

    def test_near_misses_are_told_what_to_write(self):
        for words, said in MISSES:
            with self.subTest(words=words):
                self.is_refused(run(*words), re.escape(said))

    def test_what_is_to_be_looked_at_is_named_when_written(self):
        page, mine = self.path / "page.html", self.path / "mine.toml"
        for words in (["report", SLIDE], ["play"], ["move", SLIDE, "--time", "0.01", "--format", "html"]):
            said = unwrapped(run(*words, "-o", page).stderr)
            said = said[max(said.find("Wrote"), 0):]  # after progress
            self.assertEqual(said, f"Wrote {page}; open it in a browser.")
        for words, next_one in ("new box", "solve"), ("new box --push none", "hold"), ("example coin", "solve"), ("example vise", "hold"):
            mine.unlink(missing_ok=True)
            said = unwrapped(run(*words.split(), "-o", mine).stderr)
            self.assertEqual(said, f"Wrote {mine}; next: lcpush {next_one} {mine}")
        self.assertEqual(run("solve", SLIDE, "--json", "-o", page).stderr, "")

    def test_axes_of_sweeps_are_words_with_units(self):
        for vary, label in LABELS:
            with self.subTest(vary=vary):
                svg = run("sweep", SLIDE, "--vary", vary, "--steps", "2", "--format", "svg").stdout
                self.assertIn(f">{label}</text>", svg)
        svg = run("sweep", SLIDE, "--vary", "wall.turn=-10:10", "--steps", "2", "--show",
                  "force[0],twist[5],break_force", "--format", "svg").stdout
        for label in ("force, N", "acceleration about z, rad/s^2"):
            self.assertIn(f">{label}</text>", svg)
        # Beside its axis it would run into the next panel's in a phone's large letters.
        self.assertNotRegex(svg, r"rotate[^<>]*>acceleration about z")

    def test_pivots_of_many_unknowns_are_sentences(self):
        brief = run("pivots", SCENES / "straight_slide_point.toml").stdout
        self.assertLess(len(brief.splitlines()), 500)
        self.assertIn("-v prints all", brief)
        self.assertGreater(len(run("pivots", SCENES / "straight_slide_point.toml", "-v").stdout.splitlines()), 9999)
        self.assertIn("[1]", run("pivots", SCENES / "coin.toml").stdout)


main()
