"""lcpush sweep: formats, exit codes, messages."""
import csv
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

TOOL, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCENES = SOURCE / "fixtures/scenes"
SVG = "{http://www.w3.org/2000/svg}"


def run(*words):
    return subprocess.run([TOOL, "sweep", *map(str, words)], capture_output=True, text=True,
                          timeout=100)


class Sweep(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        self.slide = self.path / "slide.toml"
        self.slide.write_text('pressure = "rigid"\n' +
                              (SCENES / "straight_slide.toml").read_text())

    def answer(self, *words, code=0):
        result = run(*words, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads(result.stdout)

    def refused(self, pattern, *words):
        result = run(*words)
        self.assertEqual(result.returncode, 2, result)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, pattern)

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
        self.assertEqual(float(rows[-1]["break_force"]), 30)
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
        self.assertIn("at breaking: wall sticks", marks)

    def test_a_map_has_two_values_a_point(self):
        answer = self.answer(self.slide, "--vary", "*.grip_force=10:20", "--vary",
                             "wall.friction=0.4:0.5", "--steps", "2")
        self.assertEqual(answer["second_parameter"], "wall.friction")
        self.assertEqual([(p["value"], p["second_value"]) for p in answer["points"]],
                         [(10, 0.4), (20, 0.4), (10, 0.5), (20, 0.5)])

    def test_several_curves_are_one_object(self):
        answer = self.answer(self.slide, "--vary", "wall.shift[1]=-0.005:0.005", "--each",
                             "facets=4,8", "--steps", "3")
        self.assertEqual(list(answer), ["curves"])
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

    def test_zeros_of_the_motion_are_told_in_words_and_numbers(self):
        words = (SCENES / "straight_slide_point.toml", "--vary", "wall.shift[1]=-0.008:0.004",
                 "--steps", "13")
        [zero] = [z for z in self.answer(*words)["zeros"] if z["of"] == "twist[5]"]
        self.assertAlmostEqual(zero["from"], -0.05 * 1.962 / 20.02, 10)
        self.assertEqual((zero["to"], zero["jumps"]), (zero["from"], False))
        self.assertIn("twist[5], the object's acceleration about z, is zero at wall.shift[1] = "
                      "-0.0049001\n", run(*words).stdout)

    def test_show_chooses_what_is_drawn(self):
        words = (self.slide, "--vary", "*.friction=0.3:0.9", "--steps", "5", "--format", "svg")
        tree = ElementTree.fromstring(run(*words, "--show", "twist[0],force[1]").stdout)
        texts = [e.text for e in tree.iter(SVG + "text")]
        self.assertIn("twist[0] in m/s^2", texts)
        self.assertIn("force[1] in N", texts)
        self.assertEqual(len([e for e in tree.iter(SVG + "rect") if e.get("class") == "frame"]), 2)

    def test_a_map_tells_where_another_motion_is_an_answer(self):
        answer = self.answer(SCENES / "rolling_two_answers.toml", "--vary", "*.grip_force=7:10",
                             "--vary", "sheet.friction=0.5:0.9", "--steps", "9")
        marked = [(p["value"], p["second_value"]) for p in answer["points"] if p["bistable"]]
        self.assertTrue(marked)
        for grip, sheet in marked:  # 2 mu_f F between m g and T*
            self.assertTrue(4.905 <= 0.6 * grip <= sheet * 4.905 / (1 - 0.3 * sheet))

    def test_text_names_the_breakpoints(self):
        text = run(self.slide, "--vary", "*.grip_force=6:8").stdout
        self.assertIn("at *.grip_force = 6.52: as prescribed: wall sticks", text)
        self.assertIn("at *.grip_force = 6.54: at breaking: wall sticks", text)

    def test_a_range_without_answers_exits_with_1(self):
        answer = self.answer(SCENES / "jam.toml", "--vary", "left.grip_force=1:2", code=1)
        self.assertIs(answer["complete"], False)
        self.assertEqual(answer["segments"][0]["status"], "ray")
        self.assertIsNone(answer["segments"][0]["force"])
        self.assertEqual(answer["segments"][0]["break_force"], [None, None])

    def test_output_goes_to_a_file_and_messages_to_stderr(self):
        file = self.path / "slide.svg"
        result = run(self.slide, "--vary", "*.grip_force=6:8", "--format", "svg", "-o", file)
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        ElementTree.parse(file)

    def test_same_input_same_bytes(self):
        words = (self.slide, "--vary", "*.grip_force=2:30", "--json")
        self.assertEqual(run(*words).stdout, run(*words).stdout)

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
        self.refused(r"--format is", self.slide, "--vary", "*.friction=0:1", "--format", "png")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
