"""Scenes with units and with contacts on faces mean the scenes in SI numbers and places, exactly."""
import math
import subprocess
import sys

from tool import SCENES, SOURCE, ToolTest, json_of, main, run, unwrapped
from scene_tables import finger, pusher, table

# (SI, the same with units); "" stands for its absence.
UNITS = [
    ("mass = 0.12", 'mass = "120 g"'), ("mass = 0.12", 'mass = "0.12 kg"'), ("mass = 0.12", 'mass = " +1.2e+2g "'),
    ("mass = 0.12", 'mass = "120e0 g"'), ("gravity = [0, -9.81, 0]", 'gravity = [0, "-9810 mm/s^2", "0 m/s^2"]'),
    ("box = [0.08, 0.04, 0.02]", 'box = ["80 mm", 0.04, "2 cm"]'),
    ("box = [0.08, 0.04, 0.02]", 'box = ["80000 um", "40 mm", "0.02 m"]'),
    ("grip_force = 20", 'grip_force = "20 N" # N'), ("grip_force = 20", 'grip_force = "0.02 kN"'),
    ("grip_force = 20", 'grip_force = "20000 mN"'), ("radius = 0.005", 'radius = "5 mm"'),
    ("center = [0.001, 0, 0.01]", 'center = ["1 mm", 0, "1 cm"]'),
    ("moment = [0, 0, 0.01]", 'moment = [0, 0, "10 N mm"]'),
    ("moment = [0, 0, 0.01]", 'moment = [0, 0, "0.01 N m"]'),
    ("ends = [[-0.04, -0.015, 0], [-0.04, 0.015, 0]]", 'ends = [["-40 mm", -0.015, 0], ["-4 cm", "15 mm", 0]]'),
    ("velocity = [0.01, 0, 0]", 'velocity = ["10 mm/s", 0, "0 cm/s"]'),
    ("box = [0.08, 0.04, 0.02]", 'box = "80 mm x 4 cm x 0.02 m"'), ("box = [0.08, 0.04, 0.02]", 'box = "80x40x20 mm"'), ("until = 0.25", 'until = "250 ms"'),
    ("gravity = [0, -9.81, 0]", 'gravity = [0, "-9.81 m/s²", "0 m/s2"]'), ("moment = [0, 0, 0.01]", 'moment = ["0 N*m", "0 Nm", "10 N·mm"]'),
    ("box = [0.08, 0.04, 0.02]", 'box = ["80000 µm", "40000 μm", "20 mm"]'),
    ("until = 0.25", 'until = "0.25 s"'), ("angular_velocity = [0, 0, 0.5]", 'angular_velocity = [0, 0, "0.5 rad/s"]'),
]
SCENE = (
    table("", gravity=[0, -9.81, 0]) + table("[object]", mass=0.12, box=[0.08, 0.04, 0.02], moment=[0, 0, 0.01]) +
    finger("2 mm", "disc", center=[0.001, 0, 0.01], radius=0.005, normal=[0, 0, -1], friction=0.5, grip_force=20) +
    finger("right", "point", center=[0.001, 0, -0.01], normal=[0, 0, 1], friction=0.5, grip_force=20) +
    pusher("wall", "line", ends=[[-0.04, -0.015, 0], [-0.04, 0.015, 0]], normal=[1, 0, 0], friction=0.3,
           velocity=[0.01, 0, 0], angular_velocity=[0, 0, 0.5], until=0.25)
)


def actuator(turn, force):
    return table("[[actuator]]", name="jaw", bodies=["right"], twists=[[0, 0, 1, 0, 0, turn]], force=force)


# What is typed instead of what, its line, what the message says.
REFUSED = [
    ('mass = "20 mm"', "mass = 0.12", 3, 'object: mass = "20 mm": a length; kg or g is meant'),
    ('box = ["8 cm", "40 g", 1]', "box = [0.08, 0.04, 0.02]", 4,
     'entry 2 of box = "40 g": a mass; m, cm, mm or um is meant'),
    ('box = "80 mm x 40 g x 20 mm"', "box = [0.08, 0.04, 0.02]", 4, 'entry 2 of box = "40 g": a mass'),
    ('box = "80 mm x 40 mm"', "box = [0.08, 0.04, 0.02]", 4, "box must be a list of 3 numbers, got a list of 2"),
    ('mass = "2 lb"', "mass = 0.12", 3, '"lb" is not read, 1 lb is 0.45359237 kg; kg or g is meant'),
    ('mass = "2 oz"', "mass = 0.12", 3, "1 oz is 28.349523125 g; kg or g"),
    ('radius = "2 in"', "radius = 0.005", 10, 'finger "2 mm": radius = "2 in": "in" is not read, 1 in is 25.4 mm'),
    ('grip_force = "2 lbf"', "grip_force = 20", 13, "1 lbf is 4.4482216152605 N; N, mN or kN is meant"),
    ('mass = "2 KG"', "mass = 0.12", 3, 'the unit "KG" is unknown; kg or g is meant'),
    ('mass = "0.12"', "mass = 0.12", 3, 'the unit is missing; write 0.12 without quotes, or "0.12 kg"'),
    ('box = "80x40x20"', "box = [0.08, 0.04, 0.02]", 4, 'write 80 without quotes, or "80 mm"'),
    ('mass = "heavy"', "mass = 0.12", 3, 'mass must be a number, got the text "heavy"'),
    ('mass = "1e400 g"', "mass = 0.12", 3, "too large or too small"),
    ('moment = [0, 0, "1 N/m"]', "moment = [0, 0, 0.01]", 5, '"N/m" is unknown; N m or N mm is meant'),
    ('moment = [0, 0, "1 N"]', "moment = [0, 0, 0.01]", 5, "a force; N m or N mm is meant"),
    ('friction = "0.5 N"', "friction = 0.5", 12, "friction must be a number"),
    ('velocity = ["10 mm/s^2", 0, 0]', "velocity = [0.01, 0, 0]", 27, "an acceleration; m/s, cm/s or mm/s is meant"),
    ('angular_velocity = "30 deg/s"', "angular_velocity = [0, 0, 0.5]", 28, "must be a list of 3 numbers"),
    ("mass = 120g", "mass = 0.12", 3, 'a number with a unit is a text; write "120 g"'),
    ("mass = 120 g # so", "mass = 0.12", 3, 'write "120 g"'),
    ("box = [80 mm, 40 mm, 20 mm]", "box = [0.08, 0.04, 0.02]", 4, 'write "80 mm"'),
    ("box = [0.08, 0.04, 1e-3m]", "box = [0.08, 0.04, 0.02]", 4, 'write "1e-3 m"'),
    ("moment = [0, 0, 10 N mm]", "moment = [0, 0, 0.01]", 5, 'write "10 N mm"'),
]


def matrices(text):
    return run("matrices", "-", "--json", text=text).stdout


class SceneTest(ToolTest):
    def certified(self, text):
        scene, proof = self.file("scene.toml", text), self.path / "proof.json"
        self.assertEqual(run("solve", scene, "--certify", proof).returncode, 0)
        checked = subprocess.run([sys.executable, SOURCE / "docs/check/lcpush_check.py", proof, scene],
                                 capture_output=True, text=True)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)


class Units(SceneTest):
    def test_the_same_numbers(self):
        self.assertIn('"M"', matrices(SCENE))
        for si, typed in UNITS:
            with self.subTest(typed):
                self.assertIn(si, SCENE)
                self.assertEqual(matrices(SCENE.replace(si, typed)), matrices(SCENE))

    def test_the_guides_example_is_its_file(self):
        example = (SOURCE / "docs/guide/held_block.toml").read_text()
        self.assertIn(f"```toml\n{example}```", (SOURCE / "docs/guide/scenes.md").read_text())

    def test_the_same_fractions(self):
        """And the checker that shares no code reads them so."""
        text = SCENE
        for si, typed in UNITS:
            text = text.replace(si, typed)
        exact = [run("pivots", "-", "--exact", "--json", text=t).stdout for t in (SCENE, text)]
        self.assertEqual(exact[0], exact[1])
        self.assertNotIn("irrational: a", exact[0])
        self.certified(text)

    def test_degrees(self):
        turns = SCENE.replace("0, 0.5]", '0, "-30 deg/s"]')
        typed = turns.replace('"-30 deg/s"', "-0.523598775598298873077")
        self.assertEqual(matrices(turns), matrices(typed))
        self.assertIn("the angular_velocity of pusher \\\"wall\\\" is irrational",
                      run("pivots", "-", "--exact", "--json", text=turns).stdout)
        self.certified(turns)
        self.assertEqual(matrices(turns), matrices(turns.replace("30 deg", "30°")))
        plane = [matrices("planar = true\n" + SCENE.replace("[0, 0, 0.5]", value))
                 for value in ('"0.5 rad/s"', "[0, 0, 0.5]")]
        self.assertEqual(plane[0], plane[1])

    def test_actuators(self):
        for turn, force, said in [(0, "20 N", None), (0, "2 N m", "a moment; N, mN or kN"), (1, "2 N m", None),
                                  (1, "2 N", None)]:
            text = SCENE.replace("grip_force = 20\n", "") + actuator(turn, force)
            result = run("matrices", "-", text=text)
            self.assertEqual(result.returncode, 2 if said else 0, result.stderr)
            self.assertIn(said or "", result.stderr)

    def test_what_is_refused(self):
        for new, old, line, said in REFUSED:
            with self.subTest(new):
                self.assertIn(old, SCENE)
                result = run("matrices", "-", text=SCENE.replace(old, new, 1))
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertTrue(result.stderr.startswith(f"standard input:{line}: "), result.stderr)
                self.assertIn(said, result.stderr.replace("\n", " "))

    def test_sweeps_speak_si(self):
        swept = [json_of("sweep", "-", "--vary", "object.mass=0.1:0.2", "--steps", 3, text=t)
                 for t in (SCENE, SCENE.replace("mass = 0.12", 'mass = "120 g"'))]
        self.assertEqual(swept[0], swept[1])


def on_faces(object_, bodies):
    return f"[object]\nmass = 0.2\n{object_}\n" + "".join(
        f"[[{role}]]\nname = \"{i}\"\nfriction = 0.5\n{shape}\n{place}\n"
        for i, (role, shape, place) in enumerate(bodies))


# (on with center, normal with center) of a box of 0.1, 0.04, 0.3 around [0.01, 0.02, 0.03]
BOX = 'box = ["100 mm", 0.04, 0.3]\ncenter_of_mass = [0.01, "2 cm", 0.03]'
FACES = [
    ('on = "+x"', "normal = [-1, 0, 0]\ncenter = [0.06, 0.02, 0.03]"),
    ('on = "-x"\ncenter = [0, 0]', "normal = [1, 0, 0]\ncenter = [-0.04, 0.02, 0.03]"),
    ('on = "+y"\ncenter = ["1 mm", 0.002]', "normal = [0, -1, 0]\ncenter = [0.011, 0.04, 0.032]"),
    ('on = "-y"\ncenter = [0.001, 0.002]', "normal = [0, 1, 0]\ncenter = [0.011, 0, 0.032]"),
    ('on = "+z"\ncenter = [0.001, -0.002]', "normal = [0, 0, -1]\ncenter = [0.011, 0.018, 0.18]"),
    ('center = [0.001, -0.002]\non = "-z"', "normal = [0, 0, 1]\ncenter = [0.011, 0.018, -0.12]"),
]
SHAPES = ['shape = "disc"\nradius = "2 mm"', 'shape = "rectangle"\nsize = [0.004, "2 mm"]', 'shape = "point"',
          'shape = "ring"\nradius = 0.001\npoints = 4']
CYLINDERS = [
    ("x", 'on = "+x"\ncenter = [0.001, 0.002]', "normal = [-1, 0, 0]\ncenter = [0.05, 0.001, 0.002]"),
    ("y", 'on = "-y"\ncenter = [0.001, 0.002]', "normal = [0, 1, 0]\ncenter = [0.001, -0.05, 0.002]"),
    ("z", 'on = "-z"', "normal = [0, 0, 1]\ncenter = [0, 0, -0.05]"),
]
# Edges along faces: the same as lines between ends, of faces of 0.1, 0.04, 0.3 and of a cylinder's end.
EDGES = [
    (BOX, 'on = "-x"\nalong = "y"', "[[-0.04, 0, 0.03], [-0.04, 0.04, 0.03]]", "[1, 0, 0]"),
    (BOX, 'on = "-x"\nalong = "z"\ncenter = ["5 mm", 0.1]\nlength = "60 mm"',
     "[[-0.04, 0.025, 0.1], [-0.04, 0.025, 0.16]]", "[1, 0, 0]"),
    (BOX, 'on = "+y"\nalong = "x"\nlength = 0.06\ncenter = [0.03, -0.02]\npoints = 3',
     "[[0.01, 0.04, 0.01], [0.06, 0.04, 0.01]]\npoints = 3", "[0, -1, 0]"),  # clipped at x = 0.06
    (BOX, 'on = "-z"\nalong = "y"\ncenter = [0.02, 0]', "[[0.03, 0, -0.12], [0.03, 0.04, -0.12]]", "[0, 0, 1]"),
    ('cylinder_radius = 0.02\ncylinder_length = "10 cm"\naxis = "x"', 'on = "+x"\nalong = "z"',
     "[[0.05, 0, -0.02], [0.05, 0, 0.02]]", "[-1, 0, 0]"),
    ('cylinder_radius = 0.02\ncylinder_length = "10 cm"', 'on = "-z"\nalong = "x"\ncenter = [0.01, 0]\nlength = 0.03',
     "[[-0.005, 0, -0.05], [0.02, 0, -0.05]]", "[0, 0, 1]"),
]
HOLD = 'normal = [0, 0, -1]\ncenter = [0, 0, 0.05]'
LINE, RECTANGLE = 'shape = "line"', 'shape = "rectangle"\nsize = [0.004, "2 mm"]'
EDGE_REFUSED = [
    (BOX, LINE, 'on = "-x"', "missing key \"along\""), (BOX, LINE, 'on = "-x"\nalong = "x"', '"y" or "z", got "x"'),
    (BOX, LINE, 'on = "-x"\nalong = "y"\nends = [[0, 0, 0], [1, 0, 0]]', "its ends are those of the face; remove"),
    (BOX, LINE, 'on = "-x"\nalong = "y"\ncenter = [0.1, 0]\nlength = 0.01', "beside the face, which goes from -0.02 to"),
    (BOX, LINE, 'on = "-x"\nalong = "y"\ncenter = [0.01, 0]', "as long as the face along y; give a length"),
    (BOX, LINE, 'normal = [1, 0, 0]\nends = [[0, 0, 0], [0, 1, 0]]\nalong = "y"', "along goes with a face"),
    (BOX, SHAPES[0], 'on = "-x"\nalong = "y"', 'along goes with the shapes "line" and "rectangle"'),
    (BOX, RECTANGLE, 'on = "-x"\nalong = "y"\ntangent = [0, 0, 1]', "remove one of the two"),
    (BOX, RECTANGLE, 'on = "-x"\nlength = 0.1', 'length goes with the shape "line"'),
    ("cylinder_radius = 0.02\ncylinder_length = 0.1", LINE, 'on = "+z"\nalong = "x"\ncenter = [0, 0.01]', "through its middle"),
]
CYLINDER = 'cylinder_radius = 0.02\ncylinder_length = "10 cm"\naxis = "%s"'
ON_REFUSED = [
    (BOX, 'on = "+z"\nnormal = [0, 0, -1]', 10, "gives the normal, into that face; remove normal or on"),
    (BOX, 'on = "+z"\ncenter = [0, 0, 0.01]', 10, "an offset in the face, [along x, along y]; give these two, or"),
    (BOX, 'on = "top"', 9, 'on must be "+x", "-x", "+y", "-y", "+z" or "-z", got "top"'),
    (BOX, 'face = "+z"', 9, 'unknown key "face" (did you mean "on"?)'),
    (BOX, 'on = "+z"\ncenter = 3', 10, "center must be a list of 2 numbers"),
    ("inertia = [1, 1, 1]\n", 'on = "+z"', 9, "on needs an [object] with a box, a cylinder or a ball"),
    ("sphere_radius = 0.1\n", 'on = "+z"\ncenter = [0, 1e-3]', 9, 'on a ball on places a "point" without an offset'),
    (CYLINDER % "x", 'on = "+z"', 10, 'flat faces are "+x" and "-x"; on its side, remove on and give normal and center = [x, y, z]'),
]


class Faces(SceneTest):
    def equal(self, object_, short, typed, role, shape, hold=None):
        texts = [on_faces(object_, [("finger", 'shape = "point"\ngrip_force = 3', hold or typed),
                                    (role, shape, place)]) for place in (short, typed)]
        with self.subTest(texts[0]):
            answers = [matrices(text) for text in texts]
            self.assertIn('"M"', answers[1])
            self.assertEqual(*answers)
            exact = [run("pivots", "-", "--exact", "--max-pivots", "1", "--json", text=text).stdout for text in texts]
            self.assertIn('"fractions"', exact[0])
            self.assertEqual(*exact)

    def test_six_faces_and_the_ends_of_cylinders(self):
        for short, typed in FACES:
            self.equal(BOX, short, typed, "finger", SHAPES[0])
        for shape in SHAPES:
            self.equal(BOX, *FACES[2], "pusher", shape + "\nacceleration = [0.1, 0, 0]")
        for axis, short, typed in CYLINDERS:
            self.equal(CYLINDER % axis, short, typed, "finger", SHAPES[0])
        self.equal('sphere_radius = "20 mm"', 'on = "-z"', "normal = [0, 0, 1]\ncenter = [0, 0, -0.02]", "finger", SHAPES[2])

    def test_the_checker_knows_faces(self):
        places = [places[0] for places in FACES]
        text = on_faces(BOX, [("finger", SHAPES[0] + "\ngrip_force = 3", places[i]) for i in (4, 5)] +
                        [("pusher", SHAPES[2] + "\nvelocity = [0.1, 0, 0]", places[1])])
        self.certified(text)

    def test_a_centre_of_mass_that_takes_all_contacts_along_is_asked_about(self):
        both = [("finger", SHAPES[0] + "\ngrip_force = 3", FACES[i][0]) for i in (4, 5)]
        typed = [("finger", SHAPES[0] + "\ngrip_force = 3", FACES[4][1]), both[1]]
        for bodies, asks in ((both, True), (typed, False)):
            self.assertEqual("moves nothing" in unwrapped(run("hold", "-", text=on_faces(BOX, bodies)).stderr), asks)

    def test_what_is_refused(self):
        for object_, place, line, said in ON_REFUSED:
            with self.subTest(place):
                result = run("matrices", "-", text=on_faces(object_, [("finger", SHAPES[2], place)]))
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertTrue(result.stderr.startswith(f"standard input:{line}: "), result.stderr)
                self.assertIn(said, result.stderr.replace("\n", " "))
        for object_, shape, place, said in [(BOX, 'shape = "points"', 'on = "+z"', "has none; give normal instead")] + EDGE_REFUSED:
            with self.subTest(place):
                result = run("matrices", "-", text=on_faces(object_, [("finger", shape, place)]))
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn(said, unwrapped(result.stderr))

    def test_edges_along_faces(self):
        motion = "\nacceleration = [0.1, 0.1, 0.2]"
        for object_, short, ends, normal in EDGES:
            self.equal(object_, short, f"normal = {normal}\nends = {ends}", "pusher", LINE + motion, HOLD)
        for axis, tangent in (("y", "[0, 1, 0]"), ("z", "[0, 0, 1]")):
            self.equal(BOX, f'on = "-x"\nalong = "{axis}"', f"{FACES[1][1]}\ntangent = {tangent}", "pusher", RECTANGLE + motion, HOLD)
        self.certified(on_faces(BOX, [("finger", SHAPES[0] + "\ngrip_force = 3", FACES[i][0]) for i in (4, 5)] + [
            ("pusher", LINE + "\nvelocity = [0.1, 0, 0]", EDGES[1][1]),
            ("pusher", LINE + "\nvelocity = [0, 0.1, 0]", 'on = "-y"\nalong = "x"'),
            ("pusher", RECTANGLE + "\nvelocity = [-0.1, 0, 0]", 'on = "+x"\nalong = "z"')]))

    def test_an_edge_beyond_the_face_is_cut_where_it_then_stands(self):
        face = {"object": 'box = [0.1, 0.08, 0.02]', "place": 'on = "-x"\nalong = "y"\nlength = "200 mm"'}
        text = (SOURCE / "fixtures/scenes/straight_slide.toml").read_text()
        text = text.replace("box = [0.1, 0.03, 0.01]", face["object"]).replace('on = "-x"\nalong = "y"', face["place"])
        self.assertIn(face["place"], text)
        places = []
        for shift in (0, -0.06, -0.13):
            answer = json_of("solve", "-", "--set", f"wall.shift[1]={shift}", text=text)
            places.append([c["position"][1] for c in answer["contacts"] if c["body"] == "wall"])
        for found, ends in zip(places, ((-0.04, 0.04), (-0.04, 0.04), (-0.04, -0.03))):
            for at, end in zip(found, ends):
                self.assertAlmostEqual(at, end, 9)

    def test_sweeps_move_the_face(self):
        """A box that grows takes its contacts along; offsets are numbers of the scene; shifts are the scene's."""
        motion, pads = SHAPES[2] + "\nacceleration = [0.1, 0, 0]", [
            ("finger", SHAPES[0] + "\ngrip_force = 3", FACES[i][0]) for i in (2, 3)]

        def pushed(box, place, vary, which):
            text = "gravity = [0, 0, -9.81]\n" + on_faces(box, pads + [("pusher", motion, place)])
            return json_of("sweep", "-", "--vary", vary, "--steps", 2, text=text)["points"][which]["force"]

        for path, value, x, y, z in [
                ("object.box[0]", 0.2, -0.09, 0.02, 0.03), ("2.center[1]", 0.01, -0.04, 0.02, 0.04),
                ("2.center[0]", 0.01, -0.04, 0.03, 0.03), ("2.shift[0]", 0.01, -0.03, 0.02, 0.03),
                ("2.shift[2]", 0.01, -0.04, 0.02, 0.04), ("2.tangent_turn", 90, -0.04, 0.02, 0.03)]:
            box = BOX.replace('"100 mm"', "0.2") if "box" in path else BOX
            short = pushed(BOX, 'on = "-x"', f"{path}=0.1:{value}" if "box" in path else f"{path}=0:{value}", 1)
            typed = pushed(box, f"normal = [1, 0, 0]\ncenter = [{x}, {y}, {z}]", "2.friction=0.5:0.6", 0)
            for one, other in zip(short, typed):
                self.assertAlmostEqual(one, other, 5, path)
        plot = run("sweep", "-", "--vary", "2.center[1]=0:0.01", "--steps", 2, "--format", "svg",
                   text=on_faces(BOX, pads + [("pusher", motion, 'on = "-x"')])).stdout
        self.assertIn("center of 2 along z, m", plot)


# A pose, gravity turned back into the object's axes.
TILTS = [
    ('tilt = "90 deg about z"', "[-9.81, -2, 3]"), ('tilt = "-90 deg about x"', "[2, -3, -9.81]"),
    ("rotation = [0, 0, 2, 3.141592653589793]", "[-2, 9.81, 3]"), ('rotation = [1, 1, 1, "120 deg"]', "[-9.81, 3, 2]"),
    ('rotation = [1, -1, 1, "0 deg"]', "[2, -9.81, 3]"),
]
TILT_REFUSED = [
    ('tilt = "20 deg"', 'such as "20 deg about z"'), ('tilt = "20 about z"', "tilt has no unit"), ("tilt = 20", "such as"),
    ('tilt = "20 mm about z"', "a length; rad or deg is meant"), ('tilt = "20 deg about w"', 'write rotation = [x, y, z, "20 deg"]'),
    ('tilt = "1 deg about z"\nrotation = [0, 0, 1, 1]', "keep one of the two"), ("rotation = [0, 0, 0, 1]", "this axis is zero"),
    ("rotation = [0, 0, 1]", "a list of 4 numbers"), ("velocity = [1, 2]", "a list of 3 numbers"),
]
SLOPE = """gravity = [0, "-9.81 m/s^2", 0]
planar = true
[object]
mass = "100 g"
box = ["80 mm", "40 mm", "20 mm"]
%s
[[finger]]
name = "table"
shape = "line"
on = "-y"
along = "x"
friction = %g
"""


def turned(v, axis, angle):
    """Rodrigues."""
    a = [x / math.dist(axis, [0, 0, 0]) for x in axis]
    across = [a[1]*v[2] - a[2]*v[1], a[2]*v[0] - a[0]*v[2], a[0]*v[1] - a[1]*v[0]]
    along = sum(x * y for x, y in zip(a, v))
    return [x * math.cos(angle) + c * math.sin(angle) + n * along * (1 - math.cos(angle)) for x, c, n in zip(v, across, a)]


class Poses(SceneTest):
    text = SCENE.replace("[0, -9.81, 0]", "[2, -9.81, 3]")

    def test_quarter_turns(self):
        for pose, gravity in TILTS:
            with self.subTest(pose):
                typed = matrices(self.text.replace("[2, -9.81, 3]", gravity).replace("moment = [0, 0, 0.01]\n", ""))
                tilted = matrices(self.text.replace("moment = [0, 0, 0.01]", pose))
                self.assertIn('"w"', typed)
                self.assertEqual(typed, tilted)

    def test_contacts_of_the_scene(self):
        """A wall that stays in the scene while the object turns is one that turns the other way."""
        for axis, degrees in (([0, 0, 1], 20), ([1, -2, 0.5], -35), ([0, 1, 0], 170)):
            def there(v): return str(turned(v, axis, math.radians(degrees)))
            pose = f'rotation = {axis}'.replace("]", f', "{degrees} deg"]')
            wall = self.text.replace("until = 0.25", 'frame = "scene"').replace("[[-0.04, -0.015, 0], [-0.04, 0.015, 0]]",
                f"[{there([-0.04, -0.015, 0])}, {there([-0.04, 0.015, 0])}]").replace(
                "[1, 0, 0]", there([1, 0, 0])).replace("[0.01, 0, 0]", there([0.01, 0, 0])).replace("[0, 0, 0.5]", there([0, 0, 0.5]))
            wall = wall.replace("[2, -9.81, 3]", there([2, -9.81, 3])).replace(
                "moment = [0, 0, 0.01]", f"moment = {there([0, 0, 0.01])}\n{pose}")
            answers = [json_of("solve", "-", text=text) for text in (wall, self.text)]
            for one, other in zip(*(sum((b["force"] + b["moment"] for b in a["bodies"]), a["object"]["acceleration"]) for a in answers)):
                self.assertAlmostEqual(one, other, 6)

    def test_fractions(self):
        for pose in ('tilt = "20 deg about y"', 'rotation = [1, -2, 0.5, "200 deg"]'):
            text = self.text.replace("moment = [0, 0, 0.01]", pose).replace("until = 0.25", "torsion_radius = 0.001").replace(
                'shape = "line"\nends = [[-0.04, -0.015, 0], [-0.04, 0.015, 0]]', 'shape = "point"\ncenter = [-0.04, 0, 0]')
            self.certified(text.replace("torsion_radius = 0.001", 'frame = "scene"'))
            self.assertIn("the rotation of the object is irrational", run("pivots", "-", "--exact", "--json", text=text).stdout)

    def test_slopes_and_sliding(self):
        for degrees, friction in ((20, 0.5), (30, 0.5), (-40, 0.3)):
            answer = json_of("solve", "-", text=SLOPE % (f'tilt = "{degrees} deg about z"', friction))
            angle = math.radians(abs(degrees))
            falls = max(0, 9.81 * (math.sin(angle) - friction * math.cos(angle)))
            self.assertAlmostEqual(answer["object"]["acceleration"][0], math.copysign(falls, -degrees), 9)
        for speed, friction in ((0.2, 0.3), (-0.1, 0.5)):
            text = SLOPE % (f'velocity = ["{1000 * speed} mm/s", 0, 0]', friction)
            frames = json_of("move", "-", "--time", 0.5, "--tolerance", 1e-6, text=text)["frames"]
            self.assertAlmostEqual(frames[0]["twist"][0], speed)
            self.assertAlmostEqual(frames[-1]["position"][0], speed * abs(speed) / (2 * friction * 9.81), 5)
            self.assertIn("The object is taken at rest", run("solve", "-", text=text).stderr)

    def test_what_is_refused(self):
        for pose, said in TILT_REFUSED:
            result = run("matrices", "-", text=self.text.replace("moment = [0, 0, 0.01]", pose))
            self.assertEqual((result.returncode, result.stdout), (2, ""), pose)
            self.assertIn(said, unwrapped(result.stderr))
        for old, new, said in [('normal = [0, 0, -1]\n', 'on = "+z"\nframe = "scene"\n', "on is a face of the object"),
                               ("until = 0.25", 'frame = "world"', 'frame must be "object" or "scene"')]:
            result = run("matrices", "-", text=self.text.replace("center = [0.001, 0, 0.01]\n", "").replace(old, new)
                         if "on =" in new else self.text.replace(old, new))
            self.assertIn(said, unwrapped(result.stderr))
        self.assertIn("out of the x-y plane", run("matrices", "-", text=SLOPE % ("velocity = [0, 0, 1]", 1)).stderr)


class UnitsOnTheCommandLine(ToolTest):
    def test_a_number_with_a_unit_is_the_bare_number_in_si(self):
        for command, scene, bare, units in [
                ("sweep", "pivot.toml", ("--vary", "edge.shift[0]=0:0.03"), ("--vary", "edge.shift[0]=0:30 mm")),
                ("sweep", "pivot.toml", ("--vary", "edge.shift[0]=-0.004:0.03"), ("--vary", "edge.shift[0]=-4:30 mm")),
                ("sweep", "pivot.toml", ("--vary", "edge.turn=0:30"), ("--vary", "edge.turn=0:30 deg")),
                ("sweep", "pivot.toml", ("--vary", "edge.friction=0:1", "--each", "object.mass=0.1,0.2"),
                 ("--vary", "edge.friction=0:1", "--each", "object.mass=100 g,0.2kg")),
                ("move", "pivot.toml", ("--time", "0.1", "--stop-after", "0.002", "--step", "0.002"),
                 ("--time", "100 ms", "--stop-after", "2mm", "--step", "2 ms")),
                ("hold", "straight_slide.toml", ("--at", "0.01 0 -0.02"), ("--at", "10 mm 0 -20mm")),
                ("hold", "straight_slide.toml", ("--tolerance", "object.mass=0.1:0.12"),
                 ("--tolerance", "object.mass=100:120 g"))]:
            with self.subTest(units):
                self.assertEqual(json_of(command, SCENES / scene, *units), json_of(command, SCENES / scene, *bare))
        square = SOURCE / "docs/guide/square.toml"
        self.assertEqual(json_of("cone", square, "--pusher", "east", "--twist", "-10 mm/s, 2 mm/s, 0 deg/s")["edges"],
                         json_of("cone", square, "--pusher", "east", "--twist", "-0.01 0.002 0")["edges"])

    def test_another_dimension_is_refused_with_what_is_meant(self):
        for words, said in [
                (("sweep", "--vary", "edge.shift[0]=0:30 g"), "a mass; m, cm, mm or um is meant"),
                (("sweep", "--vary", "edge.friction=0:1 mm"), "a length; a number without a unit is meant"),
                (("move", "--time", "3 kg"), '--time "3 kg": a mass; s or ms is meant'),
                (("hold", "--tolerance", "object.mass=1:2 mm"), "a length; kg or g is meant"),
                (("hold", "--at", "1 mm 2 N 3 mm"), "a force; m, cm, mm or um is meant")]:
            result = run(words[0], SCENES / "pivot.toml", *words[1:])
            self.assertEqual(result.returncode, 2)
            self.assertIn(said, unwrapped(result.stderr))


main()
