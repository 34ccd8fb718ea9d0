"""`lcpush new` writes scenes of one's own object that look right and answer in every command."""
import os
import pty
import re
import subprocess

from tool import TOOL, ToolTest, json_of, main, run, unwrapped

# object, options, what the scene then has
MADE = [
    ("box", '--size "80 mm x 40 mm x 20 mm" --mass "120 g" --pads "20 mm x 10 mm" --push slide',
     ['box = ["80 mm", "40 mm", "20 mm"]', 'mass = "120 g"', 'size = ["20 mm", "10 mm"]', 'along = "y"']),
    ("box", "--size 0.08X0.04x0.02 --pads 8mm --push pivot", ["box = [0.08, 0.04, 0.02]", 'radius = "4 mm"']),
    ("box", '--size "3 × 2 × 1 cm" --mass 30g --grip 20N', ['box = ["3 cm", "2 cm", "1 cm"]', 'grip_force = "20 N"']),
    ("box", '--size "800 mm*400mm x 0.2 m" --mass "150 kg" --friction 0.8', ['"0.2 m"]', "friction = 0.8"]),
    ("cylinder", '--size "15 mm x 12 cm" --mass "0.1 kg"', ['cylinder_radius = "7.5 mm"', 'cylinder_length = "12 cm"']),
    ("cylinder", '--pads "8 mm" --push pivot', ['"-4 mm"']), ("cylinder", '--mass "0.3 kg" --push roll', ['axis = "z"']),
    ("box", "--push none", ['on = "-z"']),
]
REFUSED = [
    ("box --size 80x40x20", "these are metres"), ("box --mass 120", "and their units"),
    ('box --size "3 in x 2 in x 1 in"', '"in" is not read, 1 in is 25.4 mm; m, cm, mm or um'),
    ('box --size "80 mm x 40 mm"', 'a box has three edges, "80 mm x 40 mm x 20 mm"'),
    ('cylinder --size "1 mm x 2 mm x 3 mm"', "a cylinder has a diameter and a length"),
    ('box --size "80 mm x 40 x 20"', "write the unit of each"), ('box --size "80,5 mm x 1 mm x 2 mm"', "a point in decimals"),
    ('box --size "80 mm x x 20 mm"', 'write "'), ('box --size "big"', 'write "'), ('box --size "0 m x 1 m x 1 m"', "more than 0"),
    ('box --mass "1 lb"', "1 lb is 0.45359237 kg"), ('box --mass "20 mm"', "a length; kg or g is meant"),
    ('box --mass "1 kg x 2 kg"', "one number is meant"), ('box --mass ""', "--mass is empty"),
    ('box --pads "50 mm"', "larger than where they press, 100 mm x 30 mm"), ('box --pads "1 mm x 1 mm x 1 mm"', "a pad has two"),
    ("box --friction 50", "neither percent nor an angle"), ("box --friction half", "a coefficient such as 0.5"),
    ('box --grip "2 kg"', "a mass; N, mN or kN is meant"), ("box --push fall", "slide, pivot, roll or none"),
    ("cylinder --push roll --friction 1.2", "so rough do not let it roll; 0.3 would"), ("box --push roll --mass 1kg", "a box does not roll"), ("bx", 'not "bx" (did you mean "box"?)'), ("", "box or cylinder"),
]
COMMANDS = ["solve", "break", "hold", "move --time 0.05", "sweep --vary *.friction=0.3:0.5 --steps 2", "spread --paths",
            "matrices", "cone", 'plan --to "0.001 0 0"', "report", "play", "export"]


def words(text):
    return [part.strip('"') for part in re.findall(r'"[^"]*"|\S+', text)]


class New(ToolTest):
    def test_no_file_of_ones_own_is_written_over(self):
        path = self.path / "mine.toml"
        run("new", "box", "-o", path)
        text = path.read_text()
        for command, said in (("new box", "exists already"), (f"solve {path}", "which is read"),
                              (f"report {path}", "which is read")):
            result = run(*command.split(), "-o", path)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(said, result.stderr)
            self.assertEqual(path.read_text(), text)

    def test_in_a_plane_an_edge_across_it_is_no_doubt(self):
        path = self.path / "edge.toml"
        path.write_text(run("new", "box", "--push", "slide", "--mass", "120 g").stdout.replace('along = "y"', 'along = "z"'))
        result = run("solve", path)
        self.assertEqual(result.returncode, 0)
        self.assertNotIn("unique", result.stdout)

    def test_every_command_answers(self):
        for kind, options, parts in MADE:
            scene = self.path / "mine.toml"
            scene.unlink(missing_ok=True)
            made = run("new", kind, *words(options), "-o", scene)
            self.assertEqual(made.returncode, 0, made.stderr)
            for part in parts: self.assertIn(part, scene.read_text())
            pushes, rolls = "none" not in options, "roll" in options
            for command in COMMANDS if pushes else ["solve", "hold", "report"]:
                name, *rest = words(command)
                if rolls and name == "cone": rest = ["--vary", "sheet.velocity[0]=0.001:0.02"]
                if rolls and name == "plan": continue  # its fingers press in the plane
                with self.subTest(kind + options, command=command):
                    if name in ("report", "play", "export"): rest = ["-o", self.path / name]
                    result = run(name, scene, *rest, *(["--strict"] if name not in ("play", "export") else []))
                    self.assertIn(result.returncode, (0, 1) if name == "plan" or rolls and name == "hold" else (0,), result.stdout + result.stderr)
                    self.assertNotIn("Check:", result.stderr)
            answer = self.file("answer.json", run("solve", scene, "--json").stdout)
            self.assertEqual(run("verify", scene, answer).returncode, 0)

    def test_it_moves_as_named(self):
        for push, column, least in (("slide", 0, 0.05), ("pivot", 5, 0.05)):
            text = run("new", "box", "--push", push, "--size", "80 mm x 40 mm x 20 mm").stdout
            twist = json_of("solve", "-", text=text)["object"]["acceleration"]
            self.assertGreater(abs(twist[column]), least / 10, push)

    def test_what_slides_goes_straight(self):
        for words in (("cylinder",), ("cylinder", "--size", "12 mm x 150 mm", "--friction", "0.3"), ("box", "--size", "200 mm x 20 mm x 10 mm")):
            self.assertIn(" slides along x, every finger point slips and wall sticks.", unwrapped(run("solve", "-", text=run("new", *words).stdout).stdout))

    def test_a_cylinder_rolls_whatever_its_fingertips(self):
        for friction in ("0.15", "0.4", "0.7", "0.95"):
            text = run("new", "cylinder", "--push", "roll", "--friction", friction).stdout
            solved = json_of("solve", "-", text=text)
            self.assertLess(solved["object"]["acceleration"][3 + 2] * 0.02, 0.011, friction)
            self.assertGreater(abs(solved["object"]["acceleration"][3 + 2]) * 0.02, 0.0099, friction)

    def test_light_parts_in_a_hard_grip_solve(self):
        """The points of a disc that lie beside the centre of the turn hardly slip."""
        for mass, grip in (("8 g", "20 N"), ("20 g", "40 N"), ("50 g", "80 N")):
            text = run("new", "box", "--size", "20 mm x 12 mm x 11 mm", "--mass", mass, "--grip", grip, "--push", "pivot").stdout
            self.assertEqual(json_of("solve", "-", text=text)["friction"]["settled"], True)

    def test_what_is_refused(self):
        for typed, said in REFUSED:
            with self.subTest(typed):
                result = run("new", *words(typed))
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn(said, unwrapped(result.stderr))

    def test_a_terminal_is_asked(self):
        ours, theirs = pty.openpty()
        scene = self.path / "asked.toml"
        os.write(ours, f"cylinder\npivot\n10 mm x 40 mm\n120\n8 g\n8 mm\n\n\n{scene}\n".encode())
        tool = subprocess.run([TOOL, "new"], stdin=theirs, stdout=theirs, stderr=theirs, timeout=60)
        said = unwrapped(os.read(ours, 10000).decode())
        self.assertEqual(tool.returncode, 0, said)
        self.assertIn("Box or cylinder? [box]", said)
        self.assertIn("and their units How heavy? [8.5 g]", said)  # asked again
        self.assertIn("next: lcpush solve", said)
        same = run("new", "cylinder", "--size", "10 mm x 40 mm", "--mass", "8 g", "--pads", "8 mm", "--push", "pivot")
        self.assertEqual(scene.read_text(), same.stdout)


main()
