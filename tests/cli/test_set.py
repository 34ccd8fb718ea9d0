"""--set PATH=VALUE asks about the scene whose file has that value, in every command that reads one."""
import re

from tool import SCENES, SOURCE, ToolTest, json_of, main, run, unwrapped

HELD, SLIDE = SOURCE / "docs/guide/held_block.toml", SCENES / "straight_slide.toml"
JAWS = "[[finger]]\nname = \"left\""
# what is set, what the file would have instead of what
SET = [
    ("pin.friction=0.4", "friction = 0.3", "friction = 0.4"), ("pin.friction=.4", "friction = 0.3", "friction = 0.4"), ("object.mass=0.15", '"120 g"', "0.15"),
    ("object.mass=150 g", '"120 g"', '"150 g"'), ("object.box[1]=30mm", '"40 mm"', '"30 mm"'),
    ("object.box = [80 mm, 0.04, \"2 cm\"]", '"20 mm"]', '"2 cm"]'),
    ("*.grip_force=15 N", '"20 N"', '"15 N"'), ("pin.center[1]=-0.002", '["10 mm", 0]', '["10 mm", -0.002]'),
    ("gravity[0]=1", "gravity = [0", "gravity = [1"), ("pressure=even", "gravity", 'pressure = "even"\ngravity'),
    ("gripper.jaws=locked", JAWS, JAWS.replace("[[", '[gripper]\njaws = "locked"\n[[', 1)),
    ("planar=true", "gravity", "planar = true\ngravity"), ("facets=4", "gravity", "facets = 4\ngravity"),
    ("left.center[0]=2 mm", 'on = "+z" ', 'on = "+z"\ncenter = ["2 mm", 0]'), ("pin.on=-y", 'on = "-x"', 'on = "-y"'),
    ("object.force[1]=-2 N", '"120 g"', '"120 g"\nforce = [0, -2, 0]'),
    ("pin.shift[1]=0.002", '["10 mm", 0]', '["12 mm", 0]'),
    ("pin.turn=90", '["10 mm/s", 0, 0]', '[0, "10 mm/s", 0]'),
    ("pin.tangent_turn=90", "friction = 0.3", "friction = 0.3\ntangent = [0, 0, 1]"),
]
REFUSED = [
    ("pin.fricton=1", 'no key "fricton" (did you mean "friction"?)'), ("left.mu=1", 'did you mean "friction"'),
    ("friction=1", 'no key "friction"; write *.friction for all of them or left.friction'),
    ("mass=1", "write object.mass"), ("pinn.friction=1", 'nothing is called "pinn" (did you mean "pin"?)'),
    ("*.mass=1", "no finger or pusher has a mass"), ("object.box[3]=1", "box ends at [2], counted from [0]"),
    ("object.mass[0]=1", "mass is no such list"), ("object.mass", 'takes one word: write --set "object.mass=0.4"'), ("object.mass= ", "PATH=VALUE"),
    ("pin.friction=0,4", "a decimal number has a point"), ("pin.friction=-1", "--set \"pin.friction=-1\": pusher \"pin\": friction must be >= 0"),
    ("pin.center[y]=1", "vectors are counted so"), ("left.ends[0][0]=1", "set all of it, ends=[..]"),
    ("pin.shift[3]=1", "ends at [2]"), ("left.turn=1", "neither a velocity nor an acceleration"),
    ("object.mass=3 lb", "1 lb is 0.45359237 kg"), ("object.box=[1, 2", "this [ is never closed"), ("=1", "no key"),
    ("*.friction=0.5:0.9", 'a range is written "*.friction=[0.5, 0.9]"; does an answer hold for all of it? --tolerance "*.friction=0.5:0.9"'),
    ("object.mass=50:70 g", 'written "object.mass=[50 g, 70 g]"'),
    ("left.grip_force=10", 'write --set "*.grip_force=..", or add --set gripper.jaws=independent'),
]
COMMANDS = ["solve", "break", "hold", "move --time 0.01", "sweep --vary *.friction=0.2:0.4 --steps 2", "spread --paths",
            "cone --vary wall.acceleration[1]=-1:1", "matrices", "pivots --facets 4"]


class Set(ToolTest):
    def test_as_if_the_file_had_it(self):
        text = HELD.read_text()
        for given, old, new in SET:
            with self.subTest(given):
                self.assertIn(old, text)
                answer = run("solve", "-", "--set", given, text=text)
                lines = answer.stdout.split("\n")
                self.assertEqual(lines[0], f"standard input, with {given}")
                typed = run("solve", "-", text=text.replace(old, new))
                self.assertIn("\n".join(lines[2:14]), typed.stdout.replace("\n\n\n", "\n"), answer.stderr)
                self.assertEqual(json_of("solve", HELD, "--set", given)["set"], [given])

    def test_several_values_and_titles(self):
        answer = run("solve", SLIDE, "--set", "wall.friction=0.1", "--set=wall.friction=0.4", "--set", "title=A \"b\"")
        self.assertTrue(answer.stdout.startswith('A "b", with wall.friction=0.1, wall.friction=0.4\n'), answer.stdout)
        both = run("solve", HELD, "--set", "left.grip_force=10", "--set", "right.grip_force=10")
        self.assertIn("a parallel jaw, 10 N a finger", both.stdout)
        alone = run("solve", HELD, "--set", "left.grip_force=10", "--set", "gripper.jaws=independent")
        self.assertEqual(alone.returncode, 0, alone.stderr)

    def test_what_lies_on_a_face_turns(self):
        text = run("new", "box", "--size", "80 mm x 40 mm x 20 mm").stdout.replace("planar = true", "# -------------")
        for given, old, new in (("wall.turn=90", '["10 mm/s", 0, 0]', '[0, "10 mm/s", 0]'),
                                ("wall.tangent_turn=90", 'along = "y"', 'along = "y"\ntangent = [0, 0, 1]')):
            set_, typed = json_of("matrices", "-", "--set", given, text=text), json_of("matrices", "-", text=text.replace(old, new))
            self.assertEqual(set_["G_bar"], typed["G_bar"])
            for one, other in zip(sum(set_["v"]["values"], []), sum(typed["v"]["values"], [])): self.assertAlmostEqual(one, other)

    def test_what_is_refused(self):
        for given, said in REFUSED:
            with self.subTest(given):
                answer = run("solve", HELD, "--set", given)
                self.assertEqual((answer.returncode, answer.stdout), (2, ""))
                self.assertIn(said, unwrapped(answer.stderr))
        for words, said in [(["--certify", "p.json"], "change that instead of --set"), (["--set"], "PATH=VALUE")]:
            self.is_refused(run("solve", HELD, "--set", "object.mass=1", *words), said)
        self.is_refused(run("sweep", SLIDE, "--vary", "left.grip_force=5:9"), r'change both as "\*.grip_force"')

    def test_every_command(self):
        def plain(words):
            return re.sub(r'"(title|set)": .*|, with .*"', "", run(*words, "--json").stdout)

        for words in COMMANDS:
            with self.subTest(words):
                words = [words.split()[0], SLIDE, *words.split()[1:]]
                answers = [plain([*words, "--set", f"object.mass={value}"]) for value in (0.2, 0.3)]
                self.assertEqual(json_of(*words, "--set", "*.friction=0.4")["set"], ["*.friction=0.4"])
                self.assertTrue(answers[0] != answers[1])
                same = plain([*words, "--set", "wall.friction=0.3"])
                self.assertTrue(same.split() == plain(words).split())
        changed = ["--set", "*.friction=0.4"]
        for words in (["report", SLIDE, "-o"], ["play", SLIDE, "-o"]):
            page = self.path / "page.html"
            run(*words, page, *changed)
            self.assertIn("with *.friction=0.4", page.read_text())
        answer = self.path / "answer.json"
        run("solve", SLIDE, "--json", *changed, "-o", answer)
        self.assertEqual([run("verify", SLIDE, answer, *w).returncode for w in (changed, [])], [0, 1])
        for folder, words in (("a", changed), ("b", [])): run("export", SLIDE, "-o", self.path / folder, *words)
        self.assertNotEqual(*((self.path / folder / "M.mtx").read_text() for folder in "ab"))


main()
