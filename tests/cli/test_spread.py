"""lcpush spread on the command line: exit codes, keys, words that claim no more than was done."""
import json
import re
import resource
import signal
import subprocess
import time
from xml.etree import ElementTree

from tool import SCENES, SOURCE, TOOL, ToolTest, command, json_of, main
from scene_tables import finger, table

run = command("spread")


class Spread(ToolTest):
    def test_json_has_every_promised_key(self):
        result = run(SCENES / "straight_slide_point.toml", "--json", "--paths")
        self.assertEqual(result.returncode, 0)
        answer = json.loads(result.stdout)
        for key in ("status", "verdict", "laws", "pressure", "breaking", "faces", "covers", "covers_solved",
                    "complete", "enumeration", "faces_left", "failures", "residual", "push_force",
                    "twist", "contacts"):
            self.assertIn(key, answer)
        self.assertEqual(answer["verdict"], "ambiguous")
        self.assertFalse(answer["complete"])
        self.assertEqual(answer["pressure"], "pad")
        self.assertEqual(len(answer["twist"]), 6)
        low, high = answer["push_force"]["wall"]
        self.assertLess(low, high)
        self.assertAlmostEqual(high, 20.02, 6)
        for contact in answer["contacts"]:
            self.assertEqual(set(contact), {"name", "body", "normal_force", "tangential_force",
                                            "torsion"})
            self.assertLessEqual(contact["normal_force"][0], contact["normal_force"][1])
        self.assertLess(answer["residual"], 1e-9)

    def test_the_answer_of_solve_lies_within(self):
        for name in ("straight_slide_point", "rolling"):
            with self.subTest(name):
                spread = json.loads(run(SCENES / f"{name}.toml", "--json").stdout)
                solved = json_of("solve", SCENES / f"{name}.toml")
                for bounds, contact in zip(spread["contacts"], solved["contacts"]):
                    low, high = bounds["normal_force"]
                    self.assertGreaterEqual(contact["normal_force"], low - 1e-5)
                    self.assertLessEqual(contact["normal_force"], high + 1e-5)

    def test_rolling_and_held_are_both_answers_of_the_fixture(self):
        scene = SCENES / "rolling_two_answers.toml"
        low, high = json.loads(run(scene, "--covers", "2000", "--json").stdout)["twist"][5]
        self.assertAlmostEqual(low, 0, 6)
        self.assertAlmostEqual(high, 5, 6)
        solved = json_of("solve", scene)
        self.assertIs(solved["unique"]["motion"], False)

    def test_an_end_without_bound_is_null(self):
        answer = json.loads(run(SCENES / "vise.toml", "--json", "--enumerate").stdout)
        self.assertIs(answer["complete"], True)
        self.assertIsNone(answer["contacts"][0]["normal_force"][1])
        self.assertIn("no bound", run(SCENES / "vise.toml").stdout)

    def test_every_solution_is_said_only_after_enumeration(self):
        self.assertIn("every solution", run(SCENES / "coin.toml", "--enumerate").stdout)
        self.assertIn("every solution", run(SCENES / "coin.toml").stdout)
        reached = run(SCENES / "coin.toml", "--covers", "7", "-v", "--paths").stdout
        self.assertNotIn("every solution", reached)
        self.assertIn("the solutions that were reached: 1 face from 7 covering", reached)
        many = run(SCENES / "soft_fingers.toml", "--enumerate").stdout
        self.assertNotIn("every solution", many)
        self.assertIn("Not enumerated to the end", many)

    def test_the_file_s_other_pressure_law_is_named(self):
        self.assertIn('the file\'s law "pad"', run(SCENES / "straight_slide.toml", "-v").stdout)
        self.assertNotIn("he file's law", run(SCENES / "coin.toml").stdout)

    def test_the_message_comes_first_and_the_solver_s_words_with_v(self):
        text = run(SCENES / "straight_slide_point.toml").stdout
        self.assertIn("\n\nThe laws leave open how the box moves.\nThe push by wall is 18.4 to 20 N, "
                      "the sum of its normal forces.\n\n", text)
        for word in ("linear program", "residual", "from 32 covering", "faces"):
            self.assertNotIn(word, text)
            self.assertIn(word, run(SCENES / "straight_slide_point.toml", "-v", "--paths").stdout)
        # Only enumeration says what no answer does.
        reached = run(SCENES / "coin.toml", "--paths").stdout
        self.assertIn("In all answers that were reached, the cylinder moves in one way", reached)
        self.assertIn("\nThe ranges are at least these, ", reached)
        self.assertIn("The push by wall ranges at least from 18.4 to 20 N,",
                      run(SCENES / "straight_slide_point.toml", "--paths").stdout)
        self.assertIn("\nThe cylinder moves in one way, under one set of forces.\n",
                      run(SCENES / "coin.toml", "--enumerate").stdout)

    def test_text_is_at_most_80_columns_wide(self):
        for name in ("straight_slide_point", "vise", "jam"):
            for verbose in ((), ("-v",)):
                text = run(SCENES / f"{name}.toml", *verbose).stdout
                self.assertLessEqual(max(map(len, text.split("\n"))), 80, text)

    def test_a_jam_is_exit_1_and_says_who_squeezes(self):
        result = run(SCENES / "jam.toml")
        self.assertEqual(result.returncode, 1)
        self.assertIn("A jam: wall", result.stdout)
        answer = json.loads(run(SCENES / "jam.toml", "--json").stdout)
        self.assertEqual(answer["status"], "ray")
        self.assertIsNone(answer["verdict"])
        self.assertIn("jam", answer)

    def test_bad_covers_are_refused(self):
        for word in ("0", "-3", "many", "1.5", "99999999"):
            result = run(SCENES / "coin.toml", f"--covers={word}")
            self.assertEqual(result.returncode, 2, word)
            self.assertIn("--covers is a whole number", result.stderr)
            self.assertEqual(result.stdout, "")
        self.assertEqual(run().returncode, 2)
        result = run(self.file("bad.toml", "facets = 7\n"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("bad.toml:1", result.stderr)

    def test_seconds_end_it_in_time_with_what_is_found(self):
        begin = time.monotonic()
        result = run(SCENES / "two_pushers.toml", "--enumerate", "--seconds", "0.5", "--json")
        self.assertLess(time.monotonic() - begin, 20)  # it takes a minute otherwise
        answer = json.loads(result.stdout)
        self.assertEqual(answer["status"], "solved")
        self.assertIs(answer["complete"], False)
        self.assertEqual((answer["stopped"], answer["enumeration"]), ("time", "the time was up"))
        self.assertIn("--seconds is a number", run(SCENES / "coin.toml", "--seconds", "-1").stderr)
        self.assertEqual(run(SCENES / "coin.toml", "--paths", "--enumerate").returncode, 2)

    def test_a_signal_ends_it_with_what_is_found(self):
        for options, words in (((), "Interrupted before all was seen."), (("--json",), '"signal"')):
            process = subprocess.Popen(
                [TOOL, "spread", SCENES / "two_pushers.toml", "--enumerate", *options],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            out, _ = process.communicate(timeout=20)
            self.assertEqual(process.returncode, 0)
            self.assertIn(words, out)

    def test_noise_is_no_motion(self):
        legs = self.file("table.toml", table("", gravity=[0, 0, -9.81]) + table("[object]", mass=8, box=[0.8, 0.6, 0.7]) +
                         finger("legs", "rectangle", points=[2, 2], center=[0, 0, -0.35], size=[0.8, 0.6], normal=[0, 0, 1],
                                friction=0.5))
        self.assertIn("does not move; the laws leave its forces open.", run(legs).stdout)
        answer = json.loads(run(legs, "--json").stdout)
        self.assertEqual((answer["verdict"], answer["twist"]), ("same_motion", [[0, 0]] * 6))

    def test_two_default_pads_take_two_seconds_and_the_progress_grows(self):
        cube = table("", facets=8, gravity=[0, 0, -9.81]) + table("[object]", mass=0.1, box=[0.04, 0.04, 0.04])
        pads = self.file("pads.toml", cube + "".join(
            finger(f"pad{y > 0}", "rectangle", center=[0, y, 0], size=[0.02, 0.02], normal=[0, -50 * y, 0], friction=1,
                   grip_force=20) for y in (0.02, -0.02)))
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        result = run(pads, "--json")
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, 6)
        self.assertIsNone(json.loads(result.stdout)["stopped"])
        shares = [int(share) for share in re.findall(r"(\d+) % of the work", result.stderr)]
        self.assertEqual(shares, sorted(shares))

    def test_nothing_that_touches_is_a_set_of_one_answer(self):
        # Of a face without an edge there is nothing to start a linear program from.
        scene = (SCENES / "coin.toml").read_text()
        file = self.file("apart.toml", scene.replace("[0, -10, 0]", "[9.81, 0, 0]"))
        self.assertNotEqual(file.read_text(), scene)
        for options in ((), ("--break",), ("--paths",)):
            result = run(file, "--covers", "1", *options)
            self.assertEqual(result.returncode, 1 if "--break" in options else 0, result.stdout)
        self.assertIn("moves in one way", run(file, "--covers", "1").stdout)

    def test_the_breaking_force_is_a_range_too(self):
        answer = json.loads(run(SCENES / "rolling_hard_grip.toml", "--break", "--json").stdout)
        self.assertIs(answer["breaking"], True)
        self.assertIs(answer["complete"], True)
        self.assertIs(answer["falls"], False)
        low, high = answer["break_force"]["sheet"]
        self.assertAlmostEqual(low, 0, 6)
        found = json_of("break", SCENES / "rolling_hard_grip.toml", "--facets", "8")
        self.assertTrue(found["others"])
        self.assertEqual((found["breaks"], found["break_force"]), (False, None))
        for other in found["others"]:
            self.assertTrue(low - 1e-6 <= other["break_force"] <= high + 1e-6, other)
        text = run(SCENES / "rolling_hard_grip.toml", "--break").stdout
        self.assertIn("The force, which breaks nothing, of sheet is 0 to 8.08 N", text)
        self.assertIn("The cylinder does not move;", text)
        self.assertEqual(run(SCENES / "dropped.toml", "--break").returncode, 1)
        self.assertEqual(run(SCENES / "vise.toml", "--break").returncode, 2)

    def test_help_has_an_example(self):
        self.assertIn("lcpush spread fixtures/scenes/straight_slide.toml", run("--help").stdout)


class Modes(ToolTest):
    """--modes. The combinations themselves: tests/crosscheck/test_enumeration.py, by brute force."""

    def modes(self, name, *words):
        return json.loads(run(SCENES / f"{name}.toml", "--modes", "--json", *words).stdout)

    def test_solve_has_the_combination_that_is_said_to_be_its(self):
        for name, count, pads, why in (
                ("coin", 1, "rigid", "there is no choice"), ("vise", 2, "pad", "where its pivots lead"),
                ("rolling_two_answers", 2, "pad", "nor does the pad law"),
                ("pivot", 5, "pad", "the pad law does"), ("tipping", 1, "pad", "there is no choice")):
            with self.subTest(name):
                answer = self.modes(name)
                self.assertIs(answer["complete"], True)
                self.assertEqual(len(answer["combinations"]), count)
                self.assertIn(why, answer["why"])
                modes = answer["combinations"][answer["solve"] - 1]["modes"]
                words = {"stick": ("stick", "touch"), "slide": ("slip", "touch"), "separate": ("open",)}
                for contact in json_of("solve", SCENES / f"{name}.toml", "--facets", "8")["contacts"]:
                    self.assertIn(modes[contact["name"]], words[contact["mode"]])

    def test_what_points_can_do_is_what_they_do_somewhere(self):
        for name in ("vise", "pivot", "rolling_two_answers"):
            answer = self.modes(name)
            for contact in answer["contacts"]:
                does = {combination["modes"][contact["name"]] for combination in answer["combinations"]}
                self.assertEqual(does, set(contact["can"]))
                self.assertEqual(bool(contact["slips"]), "slip" in does)
        # Held, or falling: the stops rub against it.
        self.assertEqual([contact["slips"] for contact in self.modes("vise")["contacts"]], [[[0, -1, 0]]] * 2)

    def test_a_table_of_a_slope_between_sticking_and_slipping(self):
        # A block on a slope of 3/4 under gravity alone sticks or slips at friction 3/4 on either side.
        for mu, does, down in ((0.8, "stick", 0), (0.7, "slip", 10 * (0.6 - 0.7 * 0.8))):
            scene = self.file("slope.toml", table("", planar=True, gravity=[6, -8, 0]) +
                              table("[object]", mass=1, box=[0.1, 0.1, 0.1]) +
                              finger("slope", "point", center=[0, 0, 0], normal=[0, 1, 0], friction=mu))
            answer = json.loads(run(scene, "--modes", "--json").stdout)
            self.assertEqual([entry["modes"] for entry in answer["combinations"]], [{"slope.1": does}])
            for end in answer["combinations"][0]["twist"][0]:
                self.assertAlmostEqual(end, down, 9)

    def test_the_text_is_short_and_says_that_it_is_all(self):
        for name in ("coin", "rolling_two_answers", "pivot", "tipping", "straight_slide_point"):
            lines = run(SCENES / f"{name}.toml", "--modes").stdout.split("\n")
            self.assertLessEqual(len(lines), 21)
            self.assertLessEqual(max(map(len, lines)), 80)
            self.assertIn("and that is all: the other", " ".join(lines))
        ended = run(SCENES / "pivot.toml", "--modes", "--seconds", "0.5").stdout
        self.assertRegex(ended, "At least|No combination was found: the time was up")
        result = run(SOURCE / "fixtures/rays/coin_jammed.toml", "--modes")
        self.assertEqual(result.returncode, 1)
        self.assertIn("No combination of stick, slip and open obeys the laws: all", result.stdout)

    def test_a_small_picture_for_each(self):
        svg = run(SCENES / "rolling_two_answers.toml", "--modes", "--format", "svg").stdout
        kinds = [element.get("class") for element in ElementTree.fromstring(svg).iter()]
        # Two pictures of six points, and the key.
        self.assertEqual(kinds.count("mark stick") + kinds.count("mark slide"), 2 * 6 + 2)
        self.assertEqual(kinds.count("mark stick"), 4 + 2 + 1)

    def test_what_is_too_much_is_refused_with_what_to_do(self):
        for name, words, said in (("two_pushers", (), "18 contact points"), ("soft_fingers", (), "ring of points"),
                                  ("coin", ("--break",), "--modes or --break"), ("coin", ("--paths",), "--modes or --paths")):
            result = run(SCENES / f"{name}.toml", "--modes", *words)
            self.assertEqual(result.returncode, 2)
            self.assertIn(said, " ".join(result.stderr.split()))
        self.assertIn("ask with --modes", run(SCENES / "coin.toml", "--format", "svg").stderr)


class Theory(ToolTest):
    """What solve says of existence and uniqueness."""

    def solved(self, path):
        return json_of("solve", path)

    def test_a_contact_without_force_at_rest_does_not_slip(self):
        scene = self.file("locked.toml", """[object]
mass = 0.2
box = [0.1, 0.03, 0.01]
[gripper]
jaws = "locked"
""" + "".join(f"""[[finger]]
name = "{name}"
shape = "point"
center = [0, 0, {z}]
normal = {normal}
friction = 0.2
grip_force = 20
""" for name, z, normal in (("left", 0.005, [0, 0, -1]), ("right", -0.005, [0.6, 0, 0.8]))))
        self.assertEqual([contact["mode"] for contact in self.solved(scene)["contacts"]], ["stick"] * 2)

    def test_covered_scenes_say_so(self):
        text = (SCENES / "soft_fingers.toml").read_text()
        text = text.replace("[[finger]]", '[gripper]\njaws = "independent"\n[[finger]]', 1)
        answer = self.solved(self.file("independent.toml", text))
        self.assertIs(answer["existence"]["covered"], True)
        self.assertIs(answer["uniqueness"]["covered"], True)
        # A jaw's gear shares its force over the fingers as it must: neither normal is known.
        answer = self.solved(SCENES / "soft_fingers.toml")
        self.assertIs(answer["existence"]["covered"], True)
        self.assertIs(answer["uniqueness"]["covered"], False)
        answer = json_of("solve", SCENES / "straight_slide.toml", "--facets", "8")
        self.assertIs(answer["existence"]["covered"], True)
        self.assertIs(answer["uniqueness"]["covered"], False)
        self.assertEqual(answer["uniqueness"]["statement"], "none")
        self.assertIn("neighbourhood was studied (final basis)", answer["uniqueness"]["reason"])

    def test_a_jam_names_who_squeezes_and_a_runaway_what_closes_on_nothing(self):
        jam = self.solved(SCENES / "jam.toml")["existence"]
        self.assertIs(jam["covered"], False)
        self.assertRegex(jam["reason"], r"\(H2\).*stop and wall")
        runaway = self.solved(SOURCE / "fixtures/rays/runaway.toml")["existence"]
        self.assertRegex(runaway["reason"], r"\(H1\).*slider")

    def test_a_bilateral_pusher_is_mentioned(self):
        text = (SCENES / "straight_slide.toml").read_text().replace(
            "acceleration = [0.1, 0, 0]", 'acceleration = [0.1, 0, 0]\nfollow = "bilateral"')
        self.assertIn("bilateral pushers leave the common class",
                      self.solved(self.file("bilateral.toml", text))["existence"]["reason"])


main()
