"""lcpush sweep: formats, exit codes, messages."""
import csv
import io
import json
import xml.etree.ElementTree as ElementTree

from tool import SCENES, SOURCE, ToolTest, command, main, unwrapped
from scene_tables import finger, pusher, table

run = command("sweep")
# Rubber pads of default points, pushed by a table's edge.
BLOCK = (
    table("", facets=8, gravity=[0, -9.81, 0]) +
    table("[object]", mass=0.12, box=[0.08, 0.04, 0.02]) +
    finger("left", "rectangle", center=[0, 0, 0.01], size=[0.02, 0.01], normal=[0, 0, -1], friction=0.8,
        grip_force=20) +
    finger("right", "rectangle", center=[0, 0, -0.01], size=[0.02, 0.01], normal=[0, 0, 1], friction=0.8,
        grip_force=20) +
    pusher("edge", "line", ends=[[-0.04, -0.01, -0.01], [-0.04, -0.01, 0.01]], normal=[1, 0, 0], friction=0.4,
        acceleration=[0.1, 0, 0])
)
SVG = "{http://www.w3.org/2000/svg}"


def flat(text):
    """Without the ends of lines that wrapping has made."""
    return unwrapped(text)


class Sweep(ToolTest):
    def setUp(self):
        super().setUp()
        self.slide = self.path / "slide.toml"
        self.slide.write_text('pressure = "rigid"\n' +
                              (SCENES / "straight_slide.toml").read_text())

    def answer(self, *words, code=0):
        result = run(*words, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads(result.stdout)

    def refused(self, pattern, *words):
        self.is_refused(run(*words), pattern)

    def test_segments_have_every_promised_key_and_cover_the_range(self):
        answer = self.answer(self.slide, "--vary", "*.grip_force=2:30")
        self.assertEqual(answer["parameter"], "*.grip_force")
        self.assertEqual(answer["points"], [])
        segments = answer["segments"]
        self.assertEqual((segments[0]["from"], segments[-1]["to"]), (2, 30))
        for before, after in zip(segments, segments[1:]):
            self.assertEqual(before["to"], after["from"])
            self.assertIsInstance(before["change"], str)
        self.assertIsNone(segments[-1]["change"])
        for segment in segments:
            self.assertEqual(segment["kind"], "exact")
            self.assertEqual([len(segment[k]) for k in ("break_force", "force", "twist")], [2] * 3)
            self.assertEqual([len(v) for v in segment["force"] + segment["twist"]], [3, 3, 6, 6])
            self.assertLess(segment["residual"], 1e-9)
        self.assertAlmostEqual(segments[-1]["from"], 6.54, 9)
        self.assertAlmostEqual(segments[-1]["break_force"][1], 30, 8)

    def test_a_slow_fall_is_a_fall_in_a_sweep_as_in_a_break(self):
        # Two fingers of 2 N carry 1.962 N from a friction of 0.4905 on.
        rows = list(csv.DictReader(io.StringIO(
            run(SCENES / "dropped.toml", "--facets", "8", "--vary", "*.friction=0.4904:0.4906",
                "--format", "csv").stdout)))
        near = [(float(row["*.friction"]), row["break_force"]) for row in rows]
        self.assertTrue(any(0.4904717 < friction < 0.4905 - 1e-6 for friction, _ in near), near)
        for friction, force in near:
            if abs(friction - 0.4905) > 1e-7:
                self.assertEqual(force != "", friction > 0.4905, (friction, force))
            self.assertGreaterEqual(float(force or 0), -1e-9, friction)

    def test_stopped_early_it_has_what_there_is(self):
        pads = self.file("block.toml", BLOCK)
        for varied in (["*.friction=0.3:0.9", "--steps", 400], ["*.grip_force=15:30", "--steps", 9999],
                       ["*.friction=0.3:0.9", "--vary", "*.grip_force=15:30", "--steps", 9]):
            with self.subTest(varied):
                words = ["--vary", *varied, "--seconds", "0.1"]
                result = run(pads, *words, "--json")
                answer = json.loads(result.stdout)
                self.assertEqual((result.returncode, answer["stopped"], answer["complete"]),
                                 (1, "time", False))
                self.assertIn("stopped after 0.1 s of processor time; what there was",
                              flat(result.stderr))
                reached = (answer["points"] or answer["segments"])[-1]
                if "second_value" not in reached:
                    self.assertEqual(answer["to"], reached.get("value") or reached["to"])
                for extra in ((), ("--format", "csv"), ("--format", "svg")):
                    self.assertGreater(len(run(pads, *words, *extra).stdout), 100)
                self.assertIn("More was not looked at before the time was up.",
                              flat(run(pads, *words).stdout))

    def test_two_default_pads_take_seconds(self):
        # The tool's own limit is of processor time, and several times as long in a sanitized one.
        for facets in ("8", '"round"'):
            with self.subTest(facets=facets):
                result = run(self.file("block.toml", BLOCK.replace("8", facets, 1)), "--vary",
                             "edge.shift[1]=-0.009:0.029", "--seconds", 6)
                self.assertEqual(result.returncode, 0, result.stderr)

    def test_rounding_is_zero_in_every_format(self):
        answer = self.answer(SCENES / "two_pushers.toml", "--vary", "*.friction=0.1:0.9", "--steps", 5,
                             "--pusher", "upper")
        numbers = [abs(x) for point in answer["points"] for key in ("force", "twist", "break_twist")
                   for x in point[key] or ()]
        numbers += [abs(point["break_force"] or 0) for point in answer["points"]]
        self.assertTrue(all(x == 0 or x > 1e-9 for x in numbers), sorted(numbers)[:9])

    def test_other_pushers_are_left_out_and_it_says_so(self):
        scene = (SCENES / "two_pushers.toml").read_text()
        alone = self.file("alone.toml", scene[:scene.rindex("[[pusher]]")])
        for words in (("sweep", "--vary", "*.friction=0.2:0.9", "--steps", "3"),
                      ("cone", "--vary", "upper.acceleration[1]=-0.1:0.1")):
            with self.subTest(words[0]):
                both = command(words[0])(SCENES / "two_pushers.toml", "--pusher", "upper", *words[1:])
                self.assertEqual(both.stdout, command(words[0])(alone, *words[1:]).stdout)
                self.assertIn("upper alone pushes; lower is left out.", both.stderr)

    def test_points_come_with_steps(self):
        answer = self.answer(self.slide, "--vary", "*.grip_force=10:30", "--steps", "5")
        self.assertEqual([p["value"] for p in answer["points"]], [10, 15, 20, 25, 30])
        self.assertEqual(len(answer["segments"]), 1)
        for point in answer["points"]:
            self.assertAlmostEqual(point["break_force"], point["value"], 8)
            self.assertEqual(len(point["force"]), 3)
            self.assertEqual(len(point["twist"]), 6)
            self.assertEqual(len(point["modes"]), len(answer["contacts"]))
            self.assertEqual(set(point["modes"]), {"slide", "stick"})

    def test_what_is_not_linear_is_sampled(self):
        answer = self.answer(self.slide, "--vary", "wall.friction=0.2:0.6", "--steps", "3")
        self.assertEqual(answer["segments"], [])
        self.assertEqual([p["value"] for p in answer["points"] if not p["refined"]],
                         [0.2, 0.4, 0.6])

    def test_csv_reads_back(self):
        rows = list(csv.DictReader(io.StringIO(
            run(self.slide, "--vary", "*.grip_force=2:30", "--format", "csv").stdout)))
        self.assertAlmostEqual(float(rows[-1]["break_force"]), 30, 12)
        self.assertAlmostEqual(float(rows[-1]["force_x"]), 30.02, 9)
        self.assertIn("wall sticks", rows[-3]["change"])
        self.assertEqual(len(rows) % 2, 0)

    def test_svg_is_well_formed_and_says_what_it_shows(self):
        for words in (("--vary", "*.grip_force=2:30"),
                      ("--vary", "*.friction=0.1:0.9", "--steps", "5"),
                      ("--vary", "*.friction=0.1:0.9", "--vary", "wall.turn=-20:20", "--steps", "3")):
            text = run(self.slide, *words, "--format", "svg").stdout
            tree = ElementTree.fromstring(text)
            self.assertEqual(tree.get("role"), "img")
            self.assertIn("push by wall over", tree.find(SVG + "title").text)
            self.assertGreater(len(tree.find(SVG + "desc").text), 40)
            self.assertIn("prefers-color-scheme: dark", text)
            self.assertNotIn("nan", text.replace("finance", ""))
        line = ElementTree.fromstring(
            run(self.slide, "--vary", "*.grip_force=2:30", "--format", "svg").stdout)
        marks = [e.find(SVG + "title").text for e in line.iter(SVG + "g")]
        self.assertEqual(marks, ["6.54 N (as prescribed at 6.52 N): wall sticks"])

    def test_a_map_has_two_values_a_point(self):
        answer = self.answer(self.slide, "--vary", "*.grip_force=10:20", "--vary",
                             "wall.friction=0.4:0.5", "--steps", "2")
        self.assertEqual(answer["second_parameter"], "wall.friction")
        self.assertEqual([(p["value"], p["second_value"]) for p in answer["points"]],
                         [(10, 0.4), (20, 0.4), (10, 0.5), (20, 0.5)])

    def test_several_curves_are_one_object(self):
        answer = self.answer(self.slide, "--vary", "wall.shift[1]=-0.005:0.005", "--each",
                             "facets=4,8", "--steps", "3")
        self.assertEqual(list(answer), ["warnings", "curves"])
        self.assertEqual([(c["each"], c["each_value"], c["label"]) for c in answer["curves"]],
                         [("facets", 4, "facets = 4"), ("facets", 8, "facets = 8")])
        answer = self.answer(self.slide, SCENES / "straight_slide_point.toml", "--vary",
                             "wall.shift[1]=-0.005:0.005", "--steps", "3")
        self.assertEqual([c["each"] for c in answer["curves"]], [None, None])
        self.assertIn("point pusher", answer["curves"][1]["label"])
        rows = list(csv.DictReader(io.StringIO(
            run(self.slide, "--vary", "*.grip_force=20:30", "--each", "facets=4,8", "--format",
                "csv").stdout)))
        self.assertEqual({row["curve"] for row in rows}, {"facets = 4", "facets = 8"})

    def test_several_curves_stand_side_by_side(self):
        words = (self.slide, "--vary", "*.grip_force=10:30", "--each")
        text = run(*words, "facets=4,8").stdout
        self.assertRegex(text, r"\n  \*.grip_force  facets = 4  facets = 8\n  10 +10 +10\n  12 +12 +12\n")
        # Between breakpoints on the segment's line; where the grasp does not hold there is none.
        text = run(self.slide, "--vary", "*.grip_force=1:11", "--each", "*.friction=0.1,0.5").stdout
        self.assertRegex(text, r"\n  9 +- +9\n")
        self.assertRegex(text, r"\n  11 +0.\d+ +11\n")
        numbered = run(*words, "*.friction=" + ",".join(f"0.{k}0001" for k in range(1, 9))).stdout
        self.assertIn("the curves in the order above:", flat(numbered))
        sampled = run(self.slide, "--vary", "wall.friction=0.3:0.6", "--each", "facets=4,8",
                      "--steps", "4").stdout
        self.assertRegex(sampled, r"\n  0.4 +20 +20\n")
        for each in (text, numbered, sampled):
            self.assertLessEqual(max(map(len, each.split("\n"))), 80, each)

    def test_zeros_of_the_motion_are_told_in_words_and_numbers(self):
        words = (SCENES / "straight_slide_point.toml", "--facets", "8", "--vary",
                 "wall.shift[1]=-0.008:0.004", "--steps", "13")
        [zero] = [z for z in self.answer(*words)["zeros"] if z["of"] == "twist[5]"]
        self.assertAlmostEqual(zero["from"], -0.05 * 1.962 / 20.02, 10)
        self.assertEqual((zero["to"], zero["jumps"]), (zero["from"], False))
        self.assertIn("twist[5], the object's acceleration about z, is zero at wall.shift[1] = "
                      "-0.0049001 ", flat(run(*words, "-v").stdout))
        text = run(*words).stdout
        self.assertIn("the turn of the box about z goes from + to - at wall.shift[1] = -0.0049 m\n", text)
        self.assertRegex(text, r"\n  -0\.006 .* 0\.721\n  -0\.004 .* -0\.777\n")  # signed

    def test_values_are_told_in_the_unit_that_was_typed(self):
        words = (SCENES / "straight_slide_point.toml", "--facets", "8", "--steps", "13", "--vary")
        metres, typed = (*words, "wall.shift[1]=-0.008:0.004"), (*words, "wall.shift[1]=-8:4 mm")
        for extra in ("csv", "json"):
            self.assertEqual(*(run(*each, "--format", extra).stdout for each in (metres, typed)))
        text, full = run(*typed).stdout, run(*typed, "-v").stdout
        self.assertIn("As wall.shift[1] goes from -8 to 4 mm, the force of wall that breaks the grasp changes by "
                      "6.5 % at most: it grows from 19.6 to 20 N (at -4.9 mm)", flat(text))
        for each in (text, full): self.assertRegex(each, r"\n  wall\.shift\[1\] mm .*\n  -8 ")
        svg = run(*typed, "--format", "svg", "--show", "twist[5]").stdout
        self.assertIn(">shift of wall along y, mm</text>", svg)
        self.assertIn("At -4.9 mm: acceleration about z is zero.", svg)

    def test_a_contact_that_leaves_the_object_on_the_way_is_told(self):
        for end, said in ("6 mm", "it reaches 6 mm beyond the box"), ("60 mm", "lies 60 mm outside of the box"), ("1 mm", ""):
            words = (self.slide, "--vary", f"wall.shift[1]=0:{end}", "--steps", 2, "--facets", 4)
            checks = flat(run(*words).stderr)
            self.assertEqual("Check: " in checks, said != "", checks)
            self.assertIn(said and f"at wall.shift[1] = {end}, pusher \"wall\": ", checks)
            self.assertIn(said, checks)
            self.assertEqual(len(self.answer(*words)["warnings"]), 1 if said else 0)

    def test_it_says_how_little_the_force_changes(self):
        for course, said in (("0.3:0.5", "grows from"), ("0.3:0.303", "hardly changes: it grows from")):
            text = flat(run(self.slide, "--vary", f"*.friction={course}").stdout)
            self.assertIn("breaks the grasp " + said, text)

    def test_show_chooses_what_is_drawn(self):
        words = (self.slide, "--vary", "*.friction=0.3:0.9", "--steps", "5", "--format", "svg")
        tree = ElementTree.fromstring(run(*words, "--show", "twist[0],force[1]").stdout)
        texts = [e.text for e in tree.iter(SVG + "text")]
        self.assertIn("acceleration along x, m/s^2", texts)
        self.assertIn("push along y, N", texts)
        self.assertEqual(len([e for e in tree.iter(SVG + "rect") if e.get("class") == "frame"]), 2)

    def test_a_map_tells_where_another_motion_is_an_answer(self):
        answer = self.answer(SCENES / "rolling_two_answers.toml", "--pressure", "rigid", "--vary",
                             "*.grip_force=7:10", "--vary", "sheet.friction=0.5:0.9", "--steps", "9")
        marked = [(p["value"], p["second_value"]) for p in answer["points"] if p["bistable"]]
        self.assertTrue(marked)
        for grip, sheet in marked:  # 2 mu_f F between m g and T*
            self.assertTrue(4.905 <= 0.6 * grip <= sheet * 4.905 / (1 - 0.3 * sheet))

    def test_the_message_comes_first(self):
        text = run(self.slide, "--vary", "*.grip_force=2:30").stdout
        self.assertIn(
            "As *.grip_force goes from 2 to 30 N, the force of wall that breaks the grasp\n"
            "grows from 0.333 to 30 N, by 1 to 8.76 N per N.\n", text)
        self.assertLess(text.index("goes from"), text.index("break N"))
        text = run(self.slide, "--vary", "*.grip_force=30:2").stdout
        self.assertIn("falls from 30 to 0.333 N, by 1 to 8.76 N per N.", text)

    def test_a_turning_point_and_a_plateau_are_named(self):
        height = run(SCENES / "straight_slide_point.toml", "--facets", "8", "--vary",
                     "wall.shift[1]=-0.008:0.004").stdout
        self.assertIn("grows from 19.6 to 20 N (at -0.0049 m) and falls to 18.7 N.", flat(height))
        plateau = run(SOURCE / "docs/studies/guided_slide.toml", "--vary", "wall.turn=-40:40")
        self.assertIn("grows from 19.1 to 20 N (from -4.8 to 4.8 degrees) and falls to 19.1 N.",
                      flat(plateau.stdout))

    def test_where_the_grasp_does_not_hold_the_message_says_so(self):
        drop = self.path / "drop.toml"
        drop.write_text(self.slide.read_text().replace("friction = 0.3", "friction = 0"))
        for ends in ("1:4", "4:1"):
            text = run(drop, "--vary", f"*.grip_force={ends}").stdout
            self.assertIn("\nUp to 1.96 N the grasp does not hold the box: it moves before it is "
                          "pushed.\n", text)
        text = run(drop, "--vary", "*.grip_force=1:1.5").stdout
        self.assertIn("In the whole range the grasp does not hold the box", text)
        self.assertIn("the push by wall, as prescribed,", flat(text))
        self.assertNotIn("-0", run(drop, "--vary", "*.grip_force=1:4", "--pressure", "pad").stdout)

    def test_two_answers_are_told_where_they_matter(self):
        words = (SCENES / "rolling_two_answers.toml", "--pressure", "rigid", "--vary",
                 "*.grip_force=7:10")
        moves, forces = self.answer(*words)["bistable"]
        self.assertTrue(moves["motion"])
        self.assertFalse(forces["motion"])
        self.assertGreater(forces["force_share"], 0.5)
        self.assertGreater(forces["force_difference"], 4)
        self.assertIn("From 8.36 to 8.61 N there are two answers: on the way back the cylinder moves "
                      "in another way", flat(run(*words).stdout))

    def test_a_lost_sample_says_so_and_nothing_of_forces(self):
        words = (SOURCE / "fixtures/rays/coin_jammed.toml", "--vary", "*.friction=0:0.5",
                 "--steps", "9")
        answer = self.answer(*words, code=1)
        changes = [p["change"] for p in answer["points"] if p["change"]]
        self.assertEqual(changes[-1], "from here on no answer is found (ray)")
        self.assertIn(" on there is no answer (ray).\n", run(*words).stdout)

    def test_text_is_at_most_80_columns_wide(self):
        for words in (("straight_slide", "*.grip_force=2:30"), ("pivot", "edge.shift[0]=0:0.03"),
                      ("rolling_two_answers", "*.grip_force=7:10"), ("jam", "*.grip_force=1:2"),
                      ("straight_slide", "wall.angular_acceleration[2]=-4.00001:4.12345"),
                      ("pivot", "edge.acceleration[1]=-0.1:0.123456")):
            for verbose in ((), ("-v",)):
                text = run(SCENES / f"{words[0]}.toml", "--vary", words[1], *verbose).stdout
                self.assertLessEqual(max(map(len, text.split("\n"))), 80, (words, text))
                if not verbose:
                    self.assertLessEqual(text.count("\n"), 40, text)

    def test_output_goes_to_a_file_and_messages_to_stderr(self):
        file = self.path / "slide.svg"
        result = run(self.slide, "--vary", "*.grip_force=6:8", "--format", "svg", "-o", file)
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        ElementTree.parse(file)

    def test_bad_input_says_what_is_possible(self):
        self.refused(r"say what to vary", self.slide)
        self.refused(r'called "wall.fricton" \(did you mean "wall.friction"\?\)', self.slide,
                     "--vary", "wall.fricton=0:1")
        self.refused(r"gravity\[\.\.\]", self.slide, "--vary", "nothing=0:1")
        for text in ("*.friction", "*.friction=1", "=1:2", "*.friction=1:x", "*.friction=1:1",
                     "*.friction=0.1:inf", "*.friction=:1"):
            self.refused(r"lcpush sweep: |nothing to vary", self.slide, "--vary", text)
        self.refused(r"--steps", self.slide, "--vary", "*.friction=0:1", "--steps", "1")
        self.refused(r"3 times", self.slide, *(["--vary", "*.friction=0:1"] * 3))
        self.refused(r"slide.toml:\d+: .*friction must be.*at \*.friction = -1", self.slide,
                     "--vary", "*.friction=1:-1")
        self.refused(r"--pusher upper or lower", SCENES / "two_pushers.toml", "--vary",
                     "gravity[1]=0:1")
        self.refused(r"--show goes with", self.slide, "--vary", "*.friction=0:1", "--show", "force")
        self.refused(r'nothing to show is called "twits\[5\]" \(did you mean "twist\[5\]"\?\)',
                     self.slide, "--vary", "*.friction=0:1", "--format", "svg", "--show", "twits[5]")
        self.refused(r"break_twist\[5\] is known at points alone: add --steps", self.slide, "--vary",
                     "*.grip_force=9:20", "--format", "svg", "--show", "break_twist[5]")
        self.refused(r"--each needs", self.slide, "--vary", "*.friction=0:1", "--each", "facets")
        self.refused(r"facets must be even", self.slide, "--vary", "*.friction=0:1", "--each",
                     "facets=7")
        self.refused(r"facets counts something", self.slide, "--vary", "facets=4:16")
        self.refused(r"a map is of one scene", self.slide, "--vary", "*.friction=0:1", "--vary",
                     "wall.turn=0:1", "--each", "facets=4,8")
        for second in ("*.friction=0.2:1", "wall.friction=0.2:1"):
            self.refused(r"wall.friction would change nothing: (wall|\*).friction is given",
                         self.slide, "--vary", "wall.friction=0.1:1", "--vary", second, "--steps", "3")
            self.refused(r"wall.friction would change nothing", self.slide, "--vary", second,
                         "--each", "wall.friction=0.1,1")
        self.refused(r"--format is", self.slide, "--vary", "*.friction=0:1", "--format", "png")


main()
