"""The command line: exit codes, messages, JSON, and that bad input writes nothing."""
import json
import os
import re
import subprocess
import unittest

from tool import SOURCE, TOOL, ToolTest, main, run, unwrapped

from scene_tables import finger

SLIDE = SOURCE / "fixtures/scenes/straight_slide.toml"
SLIDE_TEXT = SLIDE.read_text()


class Commands(ToolTest):
    def scene(self, *changes):
        text = SLIDE_TEXT
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        file = self.path / "scene.toml"
        file.write_text(text)
        return file

    def test_solve_json_has_every_promised_key(self):
        answer = json.loads(run("solve", SLIDE, "--json").stdout)
        for key in ("status", "solver", "pivots", "sweeps", "unique", "residual", "object",
                    "contacts", "bodies"):
            self.assertIn(key, answer)
        self.assertEqual(set(answer["residual"]), {"max", "newton", "normal", "cone",
                         "dissipation", "grip", "rigidity", "pusher"})
        self.assertEqual([c["name"] for c in answer["contacts"]][-2:], ["wall.1", "wall.2"])
        self.assertAlmostEqual(answer["object"]["acceleration"][0], 0.1, 9)

    def test_break_json_has_every_promised_key(self):
        answer = json.loads(run("break", SLIDE, "--json").stdout)
        for key in ("status", "holds_without_push", "smallest_grip", "break_force", "force",
                    "moment", "inertia_force", "twist", "valid_to", "residual"):
            self.assertIn(key, answer)
        self.assertAlmostEqual(answer["break_force"], 20, 8)
        self.assertAlmostEqual(answer["inertia_force"][0], 0.2, 6)
        self.assertAlmostEqual(answer["twist"][0], 1, 6)

    def test_same_input_same_bytes(self):
        first = run("solve", SLIDE, "--json")
        self.assertEqual(first.stdout, run("solve", SLIDE, "--json").stdout)

    def test_a_dropped_object_is_its_own_status(self):
        file = self.scene(("acceleration = [0.1", "acceleration = [-0.1"),
                          ("friction = 0.5", "friction = 0"), ("friction = 0.5", "friction = 0"))
        result = run("break", file, "--json")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(json.loads(result.stdout)["status"], "does_not_hold")
        self.assertIn("NOT hold", run("break", file).stdout)

    def test_a_jam_is_a_ray_with_names(self):
        stop = ('\n[[finger]]\nname = "stop"\nshape = "point"\ncenter = [0.05, 0, 0]\n'
                'normal = [-1, 0, 0]\nfriction = 0.3\n')
        text = SLIDE_TEXT.replace("[[pusher]]", stop + "[[pusher]]")
        file = self.path / "jam.toml"
        file.write_text(text)
        result = run("solve", file, "--json")
        self.assertEqual(result.returncode, 1, result)
        answer = json.loads(result.stdout)
        self.assertEqual(answer["status"], "ray")
        self.assertIn("normal of stop.1", [entry["name"] for entry in answer["ray"]])
        broken = json.loads(run("break", file, "--json").stdout)
        self.assertEqual(broken["status"], "ray")
        self.assertIn("normal of stop.1", [entry["name"] for entry in broken["ray"]])

    def test_a_velocity_whose_inertia_tells_is_said_to_be_taken_as_an_acceleration(self):
        for speed, is_told in ((0.01, False), (10, True)):
            fast = re.sub(r"(?m)^acceleration = .*$", f"velocity = [{speed}, 0, 0]", SLIDE_TEXT)
            said = run("solve", "-", text=fast).stdout
            self.assertEqual("velocity is taken as an acceleration" in said, is_told, said)

    def test_a_push_too_slow_for_the_precision_is_not_called_solved(self):
        for speed in ("1e-10", "1e-12"):
            result = run("solve", self.scene(("acceleration = [0.1", f"acceleration = [{speed}")))
            self.assertEqual(result.returncode, 1, result.stdout)
            self.assertIn("too slow", result.stdout)

    def test_fingers_on_actuators_hold_without_a_force_controlled_pusher(self):
        text = SLIDE_TEXT.replace("grip_force = 20", "#").replace(
            "acceleration = [0.1, 0, 0]", "normal_force = 5") + """
[[actuator]]
name = "hand"
bodies = ["left", "right"]
twists = [[0, 0, -1, 0, 0, 0], [0, 0, 1, 0, 0, 0]]
force = 40
"""
        file = self.path / "hand.toml"
        file.write_text(text)
        answer = json.loads(run("solve", file, "--json").stdout)
        self.assertEqual(answer["status"], "solved")
        self.assertTrue(answer["holds_without_push"])

    def test_lcp_solves_inline_and_from_files(self):
        result = run("lcp", "--M", "2 1; 1 2", "--q", "-5 -6", "--json")
        self.assertEqual(result.returncode, 0)
        z = json.loads(result.stdout)["z"]
        self.assertAlmostEqual(z[0], 4 / 3, 12)
        self.assertAlmostEqual(z[1], 7 / 3, 12)
        run("export", SLIDE, "-o", self.path / "out")
        names = (self.path / "out/names.txt").read_text().splitlines()
        free = ",".join(line.split("\t")[0] for line in names if "closing" in line)
        result = run("lcp", self.path / "out/M.mtx", self.path / "out/q.mtx", "--free", free, "--json")
        answer = json.loads(result.stdout)
        self.assertEqual(answer["status"], "solved")
        normals = [k for k, line in enumerate(names) if "normal of wall" in line]
        self.assertAlmostEqual(sum(answer["z"][k] for k in normals) * 40, 20.02, 9)  # of 2 F

    def test_an_unsolvable_lcp_ends_in_a_ray(self):
        result = run("lcp", "--M", "0 -1; 1 0", "--q", "-5 6", "--json")
        self.assertEqual(result.returncode, 1)
        answer = json.loads(result.stdout)
        self.assertEqual(answer["status"], "ray")
        self.assertEqual(len(answer["ray"]), 2)
        self.assertTrue(run("lcp", "--M", "-1", "--q", "-1").stdout.startswith("There is no solution: "))
        solvable = run("pivots", "--M", "0 1; 1 0", "--q", "-1 -1")
        self.assertIn("need not mean that there is no solution", unwrapped(solvable.stdout))

    def test_the_name_of_a_file_says_its_format(self):
        for words, name, begin in ((("solve", SLIDE), "a.json", "{"), (("solve", SLIDE), "b.JSON", "{"), (("move", SLIDE, "--time", 0.01), "a.csv", "time,"),
                                   (("move", SLIDE, "--time", 0.01), "a.html", "<!DOCTYPE"), (("hold", SLIDE), "a.svg", "<svg"),
                                   (("solve", SLIDE), "a.txt", "Straight"), (("solve", SLIDE, "--solver", "gauss-seidel", "--history"), "h.csv", ""),
                                   (("lcp", "--all", "--M", "2 1; 1 2", "--q", "-1 -1"), "all.svg", "<svg")):
            out = self.path / name
            self.assertEqual(run(*words, "-o", out).returncode, 0)
            self.assertTrue(out.read_text().startswith(begin), name)
        self.is_refused(run("solve", SLIDE, "-o", self.path / "a.svg"), "solve writes text or json, not svg")
        self.assertEqual(run("solve", SLIDE, "-o", "-").stdout, run("solve", SLIDE).stdout)

    def test_how_feet_share_a_load_is_said_to_be_open(self):
        """Of a crate that is its own mirror image no answer may look as if it were not."""
        head = 'gravity = [0, 0, -9.81]\n[object]\nmass = 20\nbox = [0.6, 0.4, 0.3]\n'
        foot = '[[finger]]\nname = "{}"\nshape = "point"\ncenter = [{}, {}, -0.15]\nnormal = [0, 0, 1]\nfriction = 0.4\npoints_on = "object"\n'
        rod = '[[pusher]]\nname = "rod"\nshape = "point"\non = "-x"\nfriction = 0\nvelocity = [0.1, 0, 0]\n'
        feet = [foot.format(name, x, y) for name, x, y in (("fl", 0.3, 0.2), ("fr", 0.3, -0.2), ("rl", -0.3, 0.2), ("rr", -0.3, -0.2))]
        said = "The laws leave open how fl, fr, rl and rr share their load"
        self.assertIn(said, unwrapped(run("solve", "-", text=head + "".join(feet) + rod).stdout))
        three = head + "".join(feet[:2]) + foot.format("rear", -0.3, 0) + rod
        self.assertNotIn("leave open", unwrapped(run("solve", "-", text=three).stdout))
        side = '[[finger]]\nname = "{}"\nshape = "point"\ncenter = [{}, -0.0141, 0]\nnormal = [{}, 1, 0]\nfriction = {}\n'
        for friction, is_open in ((0.3, True), (0, False)):  # a cylinder in a V: rough sides may squeeze it
            v = ('gravity = [0, -9.81, 0]\nplanar = true\n[object]\nmass = 0.3\ncylinder_radius = 0.02\ncylinder_length = 0.05\n'
                 'axis = "z"\n' + side.format("l", -0.0141, 1, friction) + side.format("r", 0.0141, -1, friction))
            self.assertEqual("how l and r share their load" in unwrapped(run("solve", "-", text=v).stdout), is_open, friction)
        # A mug between a thumb and two fingers: which of the two bears it is open, of one finger not.
        tip = lambda name, x, z, force: finger(name, "point", center=[x, 0, z], normal=[-1 if x > 0 else 1, 0, 0], friction=0.5, grip_force=force)
        mug = ('gravity = [0, 0, -9.81]\n[gripper]\njaws = "independent"\n[object]\nmass = 0.3\ncylinder_radius = 0.04\n'
               "cylinder_length = 0.09\n" + tip("thumb", 0.04, 0.01, 10))
        said = unwrapped(run("solve", "-", text=mug + tip("index", -0.04, 0.025, 5) + tip("middle", -0.04, -0.005, 5)).stdout)
        self.assertIn("The laws leave open how index and middle share their friction", said)
        self.assertNotIn("leave open", run("solve", "-", text=mug + tip("index", -0.04, 0.01, 10)).stdout)

    def test_what_a_palm_drives_over_a_table_slides(self):
        """The palm moves along its face, too, but most of all it closes: nothing tips."""
        text = ('gravity = [0, -9.81, 0]\n[object]\nmass = 3\nbox = [0.2, 0.06, 0.1]\n[[finger]]\nname = "table"\nshape = "rectangle"\n'
                'on = "-y"\nalong = "x"\nsize = [0.2, 0.1]\npoints = [2, 2]\nfriction = 0.2\npoints_on = "object"\n[[pusher]]\nname = "palm"\n'
                'shape = "line"\non = "-x"\nalong = "y"\nlength = 0.04\nfriction = 0.8\nnormal_force = 90\nacceleration = [0, 0, 0.2]\n')
        self.assertIn("the box slides and turns counter-clockwise about y", unwrapped(run("solve", "-", text=text).stdout))

    def test_output_file_is_written_whole_or_not_at_all(self):
        out = self.path / "answer.json"
        self.assertEqual(run("solve", SLIDE, "--json", "-o", out).returncode, 0)
        self.assertEqual(json.loads(out.read_text())["status"], "solved")
        self.is_refused(run("solve", self.path / "missing.toml", "-o", self.path / "no.txt"), "missing.toml")
        self.assertFalse((self.path / "no.txt").exists())
        self.is_refused(run("solve", SLIDE, "-o", self.path / "no/such/folder.txt"), "cannot be written")
        self.is_refused(run("solve", SLIDE, "-o", self.path), "is a directory")

    def test_every_command_has_help_with_an_example(self):
        overview = run("--help").stdout
        for command in ("solve", "break", "lcp", "export"):
            self.assertIn(command, overview)
            result = run(command, "--help")
            self.assertEqual(result.returncode, 0)
            self.assertIn("Example:\n  lcpush " + command, result.stdout)

    def test_hostile_files_are_refused_quickly(self):
        file = self.path / "hostile"
        for content in (b"", b"[" * 100000, bytes(range(256)) * 100, SLIDE_TEXT.encode()[:300]):
            file.write_bytes(content)
            self.is_refused(run("solve", file), re.escape(str(file)))
            self.is_refused(run("lcp", file, file), re.escape(str(file)))
        file.write_text("%%MatrixMarket matrix array real general\n1000000000 1000000000\n1\n")
        self.is_refused(run("lcp", file, file), "hostile:2")
        self.is_refused(run("solve", self.path), "is a directory")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_full_disk_is_reported(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([TOOL, "solve", str(SLIDE)], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(result.returncode, 2)


main()
