"""lcpush export --format mjcf and sdf: the XML says what the scene says, or the command says what it cannot."""
import tomllib
import xml.etree.ElementTree as xml

from tool import SOURCE, ToolTest, main, run

CANONICAL = sorted((SOURCE / "fixtures/canonical").glob("*.toml"))
NOT_IN_MJCF = {"released"}
FILES = {"mjcf": "scene.xml", "sdf": "scene.sdf"}


def numbers(text):
    return [float(word) for word in text.split()]


class Engines(ToolTest):
    def export(self, scene, form):
        result = run("export", scene, "--format", form, "-o", self.path)
        self.assertEqual(result.returncode, 0, result.stderr)
        return xml.parse(self.path / FILES[form]).getroot()

    def refusal(self, text, form="mjcf"):
        scene = self.path / "refused.toml"
        scene.write_text(text)
        result = run("export", scene, "--format", form, "-o", self.path / "none")
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertFalse((self.path / "none").exists())
        return result.stderr

    def near(self, got, expected):
        self.assertEqual(len(got), len(expected))
        for a, b in zip(got, expected):
            self.assertAlmostEqual(a, b, delta=1e-12 * (1 + abs(b)))

    def test_mjcf_has_the_scenes_mass_inertia_gravity_friction_and_speed(self):
        self.assertGreater(len(CANONICAL), 30)
        for path in (p for p in CANONICAL if p.stem not in NOT_IN_MJCF):
            with self.subTest(path=path.name):
                scene, root = tomllib.loads(path.read_text()), self.export(path, "mjcf")
                thing = scene["object"]
                self.near(numbers(root.find("option").get("gravity")), scene.get("gravity", [0, 0, 0]))
                inertial = root.find("worldbody/body[@name='object']/inertial")
                self.near([float(inertial.get("mass"))], [thing["mass"]])
                if "box" in thing:  # m (b^2 + c^2) / 12
                    squares = [x * x for x in thing["box"]]
                    moments = [thing["mass"] * (sum(squares) - s) / 12 for s in squares]
                    self.near(numbers(inertial.get("fullinertia")), [*moments, 0, 0, 0])
                bodies = scene.get("finger", []) + scene.get("pusher", [])
                pairs = root.findall("contact/pair")
                for body in bodies:
                    own = [p for p in pairs if body["name"] + "_" in p.get("geom1") + p.get("geom2")]
                    mu = body["friction"]
                    self.assertTrue(own)
                    for pair in own:
                        self.near(numbers(pair.get("friction")), [mu, mu, mu * body.get("torsion_radius", 0), 0, 0])
                speeds = numbers(root.find("keyframe/key").get("qvel"))
                linear = thing.get("velocity", [0, 0, 0])
                angular = thing.get("angular_velocity", [0, 0, 0])
                self.near(speeds[:3] if scene.get("planar") else speeds[:6],
                          [0, 0, 0] if scene.get("planar") else linear + angular)

    def test_mjcf_moves_and_presses_as_the_scene_does(self):
        root = self.export(SOURCE / "fixtures/canonical/cylinder_under_palm.toml", "mjcf")
        carrier = root.find("worldbody/body[@name='palm_carrier']")
        self.near(numbers(carrier.find("joint").get("axis")), [1, 0, 0])
        self.near(numbers(carrier.find("body/joint").get("axis")), [0, -1, 0])
        mass = float(carrier.find("inertial").get("mass"))
        self.near(numbers(root.find("keyframe/key").get("ctrl")), [5, 0.2])
        self.near(numbers(root.find("keyframe/key").get("act")), [0])
        servo = root.find("actuator/general[@joint='palm_carrier']")  # force = ma + k (activation - speed)
        gain = float(servo.get("gainprm"))
        self.near(numbers(servo.get("biasprm")), [mass * 0.2, 0, -gain])
        self.assertLess(20 / gain, 1e-7)  # m/s that a grip of 20 N takes from its speed
        root = self.export(SOURCE / "fixtures/canonical/wedge.toml", "mjcf")
        self.near(numbers(root.find("keyframe/key").get("act")), [0.05])
        self.near(numbers(root.find("keyframe/key").get("ctrl")), [0])
        root = self.export(SOURCE / "fixtures/scenes/straight_slide.toml", "mjcf")
        self.assertEqual(len(root.findall("actuator/general")), 1)
        root = self.export(SOURCE / "fixtures/scenes/rolling.toml", "mjcf")  # parallel jaws: twice the grip, one joint
        self.assertEqual(root.find("equality/joint").get("polycoef"), "0 1 0 0 0")
        self.near(numbers(root.find("keyframe/key").get("ctrl"))[:1], [8])

    def test_points_touch_where_the_scenes_points_are(self):
        root = self.export(SOURCE / "docs/guide/held_box.toml", "mjcf")
        for name, sign in (("left", 1), ("right", -1)):
            for geom in root.findall(f"worldbody/body[@name='{name}']/geom"):
                x, y, z = numbers(geom.get("pos"))
                self.assertAlmostEqual(abs(z) - float(geom.get("size").split()[0]), 0.02, delta=1e-12)
                self.assertGreater(sign * z, 0)
                self.assertLessEqual(x * x + y * y, 0.005 ** 2 * 1.001)

    def test_sdf_has_the_same_numbers(self):
        root = self.export(SOURCE / "fixtures/canonical/bowling_ball.toml", "sdf")
        self.near(numbers(root.findtext("world/gravity")), [0, -9.81, 0])
        link = root.find("world/model[@name='object']/link")
        self.near([float(link.findtext("inertial/mass"))], [0.5])
        self.near([float(link.findtext(f"inertial/inertia/{i}")) for i in ("ixx", "iyy", "izz", "ixy")],
                  [0.4 * 0.5 * 0.05 ** 2] * 3 + [0])
        table = root.find("world/model[@name='table']/link/collision")
        self.near([float(table.findtext("surface/friction/ode/mu"))], [0.2])
        self.assertEqual(table.findtext("surface/contact/collide_bitmask"),
                         link.findtext("collision/surface/contact/collide_bitmask"))
        self.near(numbers(root.findtext("world/state/model[@name='object']/link/velocity")), [2, 0, 0, 0, 0, 0])
        root = self.export(SOURCE / "fixtures/canonical/wedge.toml", "sdf")
        self.near(numbers(root.findtext("world/state/model[@name='wedge']/link/velocity")), [-0.05, 0, 0, 0, 0, 0])

    def test_what_a_format_cannot_say_is_refused_by_name(self):
        held = (SOURCE / "docs/guide/held_box.toml").read_text()
        self.assertIn('pressure law (pressure = "even")', self.refusal('pressure = "even"\n' + held))
        released = (SOURCE / "fixtures/canonical/released.toml").read_text()
        self.assertIn('comes or goes at a time ("hand")', self.refusal(released))
        self.assertIn('("left"): use --format mjcf', self.refusal(held, "sdf"))
        tray = (SOURCE / "fixtures/canonical/tray_slips.toml").read_text()
        self.assertIn('("tray"): use --format mjcf', self.refusal(tray, "sdf"))
        self.assertIn("planar", self.refusal((SOURCE / "fixtures/canonical/fence.toml").read_text(), "sdf"))
        named = run("export", SOURCE / "docs/guide/held_box.toml", "--format", "mjcf", "-o", self.path / "scene.xml")
        self.assertEqual(named.returncode, 2)
        self.assertFalse((self.path / "scene.xml").exists())


if __name__ == "__main__":
    main()
