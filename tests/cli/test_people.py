"""What people read: one sentence first, 80 columns, and the scene that was not meant."""
import json
import pathlib
import re
import subprocess
import tempfile
import unittest

from tool import SOURCE, TOOL, main, unwrapped

from random_scenes import random_scene

SCENES = sorted((SOURCE / "fixtures" / "scenes").glob("*.toml"))
SLIDE = SOURCE / "fixtures" / "scenes" / "straight_slide.toml"
COMMANDS = ["solve", "break", "lcp", "report", "sweep", "move", "pivots", "verify", "spread", "export",
            "matrices", "play", "example", "new", "completion"]
ANSWERS = (["solve"], ["solve", "-v"], ["solve", "-v", "--solver", "hybrid"], ["break"], ["break", "-v"],
           ["solve", "--solver", "gauss-seidel", "--history"], ["matrices"])


def run(*words, text=None, data=None):
    result = subprocess.run([TOOL, *map(str, words)], cwd=SOURCE, input=text if data is None else data,
                            capture_output=True, text=data is None, timeout=120)
    if data is None:
        result.stderr = re.sub(r"lcpush: \d+ .*\n", "", result.stderr)  # progress, of a busy machine
    return result


def here(*words):
    """With the scene's path from the project's folder, which is as long as it is."""
    return run(*words[:-1], words[-1].relative_to(SOURCE))


BOX_SLIDE = (SOURCE / "tests/scenes/box_slide.toml").read_text()


def odd_scene():
    return BOX_SLIDE.replace("center = [0, 0, 0.005]", "center = [0, 0.18, 0.005]")


class People(unittest.TestCase):
    def fits(self, text, what):
        for line in text.splitlines():
            self.assertLessEqual(len(line), 80, f"{what}: {line}")

    def test_help_fits_80_columns(self):
        self.fits(run("--help").stdout, "--help")
        for command in COMMANDS:
            help_text = run(command, "--help").stdout
            self.assertIn("Usage: lcpush " + command, help_text)
            self.fits(help_text, command)

    def test_answers_fit_80_columns(self):
        for scene in SCENES[::2]:
            for command in (*ANSWERS, ["pivots"]):
                self.fits(here(*command, scene).stdout, f"{command} {scene.stem}")

    def test_spreads_and_sweeps_fit_80_columns(self):
        for name in ("pivot", "rolling_two_answers", "tipping"):
            scene = SOURCE / "fixtures" / "scenes" / (name + ".toml")
            for command in (["spread"], ["spread", "-v"],
                            ["sweep", "-v", "--vary", "gravity[1]=-10:-5", "--pressure", "rigid"]):
                self.fits(here(*command, scene).stdout, f"{command} {name}")

    def test_random_scenes_fit_80_columns_and_nothing_is_odd_about_them(self):
        for seed in range(3):
            for command in (*ANSWERS, ["pivots"]):
                result = run(*command, "-", text=random_scene(seed))
                self.assertIn(result.returncode, (0, 1), result.stderr)
                self.assertNotIn("Check", result.stderr, f"{command} {seed}")
                self.fits(result.stdout, f"{command} {seed}")
        for seed in range(12, 42):
            result = run("matrices", "-", "--strict", text="facets = 8\n" + random_scene(seed))
            self.assertEqual((result.returncode, result.stderr), (0, ""), random_scene(seed))

    def test_the_first_sentence_says_how_hard_which_way_and_what_moves(self):
        lines = run("solve", SLIDE).stdout.split("\n\n")
        self.assertEqual(unwrapped(lines[1]),
                         "Push with 20.1 N (20 N along x and 1.96 N up): the box slides along x, "
                         "every finger point slips and wall sticks.")
        for word in ("other paths", "(H1)", "pivots", "residual"):
            self.assertNotIn(word, run("solve", SLIDE).stdout)
            self.assertIn(word, run("solve", "-v", SLIDE).stdout)

    def test_every_shipped_scene_begins_with_a_sentence(self):
        starts = ("Push with ", "Nothing pushes: ", "No answer", "The grasp breaks at ",
                  "The grasp does not hold ", "The push does not break the grasp: ")
        for scene in SCENES:
            for command in ("solve", "break"):
                result = run(command, scene)
                if result.returncode == 2:
                    continue  # nothing that pushes, or several: said on stderr
                text = result.stdout.split("\n\n")[1]
                self.assertTrue(text.startswith(starts), f"{command} {scene.stem}: {text}")

    def test_a_turn_about_an_axis_far_away_is_a_slide(self):
        # normals typed to seven digits
        text = SLIDE.read_text().replace("normal = [0, 0, -1]", "normal = [0.0000003, 0, -1]")
        self.assertIn("slides along x", unwrapped(run("solve", "-", text=text).stdout))

    def test_where_nothing_moves_rounding_is_not_shown(self):
        scene = BOX_SLIDE
        result = run("solve", "-", text=scene[:scene.index("[[pusher]]")])
        self.assertIn("Nothing pushes: the box does not move in the grip", result.stdout)
        self.assertNotRegex(result.stdout, r"e-|opening")

    def test_a_push_that_moves_nothing_breaks_nothing(self):
        scene = BOX_SLIDE.replace("acceleration = [0.1, 0, 0]", "acceleration = [0, 0, 0.1]")
        text = unwrapped(run("break", "-", text=scene).stdout)
        self.assertIn("The push does not break the grasp: wall slides along the box, which does not move.", text)
        self.assertNotIn("breaks at", text)

    def test_two_answers_are_told_with_both_numbers(self):
        text = unwrapped(run("break", SOURCE / "fixtures/scenes/rolling_two_answers.toml").stdout)
        mine = re.search(r"breaks at ([0-9.]+) N", text)[1]
        other = next(force for force in re.search(r"unique: for instance ([0-9.]+) or ([0-9.]+) N", text).groups()
                     if force != mine)
        self.assertRegex(mine + other, "[0-9]")
        text = text.replace(f"{other} or {mine} N", f"{mine} or {other} N")
        self.assertIn(f"not unique: for instance {mine} or {other} N. Both obey the laws, which leave open how "
                      "contacts share pressure and friction. See: lcpush spread", text)

    def test_an_odd_scene_is_named_after_the_answer_and_in_json(self):
        result = run("solve", "-", text=odd_scene())
        self.assertEqual(result.returncode, 0)
        self.assertTrue(result.stderr.startswith("Check: standard input:16: finger \"left\""))
        self.fits(result.stderr, "Check")
        for command in (["solve"], ["break"], ["spread"], ["matrices"],
                        ["sweep", "--vary", "object.mass=0.1:0.2", "--steps", "2"]):
            answer = json.loads(run(*command, "-", "--json", text=odd_scene()).stdout)
            (warning,) = answer["warnings"]
            self.assertEqual((warning["code"], warning["line"]), ("outside_object", 16))
        self.assertEqual(json.loads(run("solve", SLIDE, "--json").stdout)["warnings"], [])

    def test_strict_makes_it_an_error(self):
        result = run("solve", "-", "--strict", text=odd_scene())
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("standard input:16:", result.stderr)
        self.assertEqual(run("solve", SLIDE, "--strict").returncode, 0)

    def test_every_example_is_the_shipped_file(self):
        listed = re.findall(r"^  (\S+)  ", run("example").stdout, flags=re.M)
        self.assertLessEqual(max(map(len, run("example").stdout.splitlines())), 80)
        self.assertEqual(listed, [scene.stem for scene in SCENES])
        for scene in SCENES:
            self.assertEqual(run("example", scene.stem).stdout, scene.read_text())
        self.assertIn('did you mean "pivot"', run("example", "pivt").stderr)

    def test_a_new_scene_solves_at_once_and_moves_as_asked(self):
        for thing, push, verb in (("box", "slide", "slides"), ("box", "pivot", "pivots"),
                                  ("cylinder", "slide", "slides"), ("cylinder", "pivot", "pivots"),
                                  ("cylinder", "roll", "rolls")):
            scene = run("new", thing, "--push", push).stdout
            result = run("solve", "-", "--strict", text=scene)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn(f"the {thing} {verb}", unwrapped(result.stdout))
        self.assertEqual(run("new", "box", "--push", "roll").returncode, 2)

    def test_a_box_tips_where_a_cylinder_rolls(self):
        for shape, verb in (("box = [0.1, 0.1, 0.1]", "tips"),
                            ("cylinder_radius = 0.05\ncylinder_length = 0.1", "rolls")):
            text = f"""planar = true
gravity = [0, -9.81, 0]
[object]
mass = 1
{shape}
[[pusher]]
name = "cart"
shape = "points"
points = [[0, -0.05, 0]]
normal = [0, 1, 0]
friction = 0.5
acceleration = [0.8, 0, 0]
"""
            self.assertIn(f" {verb} counter-clockwise about z", unwrapped(run("solve", "-", text=text).stdout))
            self.assertIn(f" {verb} ", run("move", "-", "--time", 0.1, text=text).stdout)

    def test_what_other_programs_write_is_understood_or_named(self):
        self.assertEqual(run("solve", "-", data=b"\xef\xbb\xbf" + SLIDE.read_bytes()).returncode, 0)
        comma = SLIDE.read_text().replace("friction = 0.3", "friction = 0,3")
        self.assertIn("a decimal number has a point", run("solve", "-", text=comma).stderr)
        self.assertIn("a scene is TOML", run("solve", "-", text='{"object": 1}').stderr)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "x.pdf")
            result = run("report", SLIDE, "-o", path)
            self.assertEqual(result.returncode, 2)
            self.assertIn("does not write .pdf", result.stderr)
            self.assertFalse(path.exists())

    def test_completions_name_every_command_and_option(self):
        for reader in ("bash", "zsh", "fish", "man"):
            script = run("completion", reader).stdout.replace("\\-", "-")
            for command in COMMANDS:
                self.assertIn(command, script)
            for option in ("--vary", "--strict", "--format") if reader != "fish" else ("-l vary",):
                self.assertIn(option, script)
        self.assertEqual(subprocess.run(["bash", "-n"], text=True,
                                        input=run("completion", "bash").stdout).returncode, 0)


main()
