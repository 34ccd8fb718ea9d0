"""lcpush verify --trajectory: the forces that a motion's frames carry, judged by the laws alone."""
import csv
import io
import json

from tool import SCENES, SOURCE, ToolTest, main, run, unwrapped

PIVOT, STROKES = SCENES / "pivot.toml", SOURCE / "docs/guide/two_strokes.toml"
EACH_STEP = ("--step", 0.005, "--frames", 201)
# They do not move: the coin's table is not where a motion needs it, and the jam has no first step.
STILL = {"coin", "coin_from_above", "jam"}
# Two points hold 1.4 N of the 4.9 N that it weighs.
FALLING, FALL = SOURCE / "docs/guide/falling_box.toml", 7.01


class Forces(ToolTest):
    def verdict(self, scene, motion, *words):
        """The motion: frames, an object with frames, or the text of a file."""
        if isinstance(motion, list):
            motion = {"frames": motion}
        text = motion if isinstance(motion, str) else json.dumps(motion)
        path = self.file("motion.txt", text)
        result = run("verify", scene, "--trajectory", path, "--json", *words)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        report = json.loads(result.stdout)
        self.assertEqual(result.returncode, 0 if report["verdict"] == "follows" else 1)
        self.said = run("verify", scene, "--trajectory", path, *words).stdout
        return report

    def laws(self, report):
        return {law["law"]: law for law in report["forces"]["laws"]}

    def frames(self, scene, *words):
        return json.loads(run("move", scene, *words, "--json").stdout)["frames"]

    def broken(self, report):
        return [law["law"] for law in report["forces"]["laws"] if law["off"] > report["tolerance"]]

    def keeps_every_law(self, scene, name, format, *words):
        """To rounding in fixed steps; else ends are extrapolated, and the forces are the last step's."""
        most = (1e-5, 1e-7) if "--step" in words else (1e-2, 1e-2)
        report = self.verdict(scene, run("move", scene, *words, "--format", format).stdout)
        self.assertEqual(report["verdict"], "follows", name)
        for law, worst in self.laws(report).items():
            self.assertLess(worst["off"], most[law != "gap"], (name, law))
        self.assertGreater(report["forces"]["frames"], 0, name)
        return report

    def fall(self, friction=0.7, normal=1.0, speeds=True, head_only=False):
        """The exact fall of FALLING, as a file that somebody else has written."""
        names = ("left.1", "right.1")
        head = ["time", "x", "y", "z", "qw", "qx", "qy", "qz"] + \
            ["vx", "vy", "vz", "wx", "wy", "wz"] * speeds + \
            [f"{name}.{part}" for name in names for part in ("normal", "fx", "fy", "fz")]
        rows = [head]
        for k in range(0 if head_only else 21):
            t = k / 400
            row = [t, 0, -FALL * t * t / 2, 0, 1, 0, 0, 0] + [0, -FALL * t, 0, 0, 0, 0] * speeds
            for _ in names:
                row += [normal, 0, friction * normal, 0]
            rows.append(row)
        return "\n".join(",".join(map(str, row)) for row in rows)

    def test_its_own_motions_keep_every_law(self):
        for k, scene in enumerate(sorted(SCENES.glob("*.toml"))):
            if scene.stem in STILL:
                continue
            if k % 2 == 0:
                self.keeps_every_law(scene, scene.stem, "json")
            else:
                report = self.keeps_every_law(scene, scene.stem, "csv", *EACH_STEP)
                if scene.stem != "lever":  # whose steps are halved
                    self.assertGreater(report["forces"]["balanced"], 2, scene.stem)

    def test_other_hands_and_frictions_keep_them_too(self):
        for scene, old, new in (
                ("three_finger_hand", "# N\n", "\ninertia = 0.3\n"), ("tipping", "title", "pressure = \"even\"\ntitle"),
                ("soft_fingers", "title", "facets = \"round\"\ntitle"), ("soft_fingers", "title", "facets = 4\ntitle"),
                ("straight_slide", "acceleration", "follow = \"bilateral\"\nacceleration"),
                ("straight_slide", "acceleration = [0.1, 0, 0]",
                 "velocity = [0.01, 0, 0]\nangular_velocity = [0, 0, 0.5]"),
                ("pivot", "acceleration", "normal_force = 3 # "),
                ("straight_slide", "mass", "force = [0.3, 0.2, 0.1]\nat = [0.01, 0.003, 0]\nmass")):
            text = (SCENES / f"{scene}.toml").read_text()
            changed = self.file("changed.toml", text.replace(old, new))
            self.assertNotEqual(text, changed.read_text())
            for words in ((), EACH_STEP):
                self.keeps_every_law(changed, (scene, new), "json", *words)

    def test_pads_that_close_each_by_itself_keep_them_too(self):
        text = (SCENES / "straight_slide_point.toml").read_text()
        tilting = text.replace('on = "-x"', 'on = "-x"\ncenter = [0, 0.002]').replace("title", 'pressure = "even"\ntitle')
        self.assertIn("0.002", tilting)
        scene = self.file("tilting.toml", tilting)
        self.keeps_every_law(scene, "pads", "json", "--time", 0.05, "--step", 0.001, "--frames", 51)

    def test_both_formats_say_the_same(self):
        reports = [self.verdict(PIVOT, run("move", PIVOT, *EACH_STEP, "--format", format).stdout)
                   for format in ("json", "csv")]
        self.assertEqual(*reports)
        self.assertEqual((reports[0]["forces"]["frames"], reports[0]["forces"]["balanced"]), (200, 200))
        self.assertIsNone(reports[0]["forces"]["broken"])
        self.assertIn("every law is kept", unwrapped(self.said))

    def test_csv_has_what_json_has(self):
        scene = SCENES / "soft_fingers.toml"
        rows = list(csv.DictReader(io.StringIO(run("move", scene, "--frames", 5, "--format", "csv").stdout)))
        frames = self.frames(scene, "--frames", 5)
        self.assertTrue(any(contact["torsion"] for contact in frames[-1]["contacts"]))
        for row, frame in zip(rows, frames):
            self.assertEqual(float(row["step"]), frame["step"])
            for contact in frame["contacts"]:
                name = contact["name"]
                self.assertEqual([float(row[f"{name}.f{k}"]) for k in "xyz"], contact["friction_force"])
                self.assertEqual(float(row[f"{name}.torsion"]), contact["torsion"])
            for body in frame["bodies"]:
                for key in ("closing", "closing_speed"):
                    cell = row[f"{body['name']}.{key}"]
                    self.assertEqual(float(cell) if cell else None, body[key])

    def test_what_is_planted_is_named(self):
        frames = self.frames(PIVOT, "--time", 0.4, "--step", 0.005, "--frames", 81)
        self.assertEqual(self.verdict(PIVOT, frames)["verdict"], "follows")

        def scaled(key, factor):
            def plant(contact):
                value = contact[key]
                contact[key] = [factor * x for x in value] if isinstance(value, list) else factor * value
            return plant
        left, edge = 0, -2  # the edge slips; which of its points presses changes
        for contact, plant, law, words in (
                (left, scaled("normal_force", -1), "normal", "pulls with"),
                (left, scaled("friction_force", 1.1), "cone", "and its cone ends at"),
                (left, lambda c: c["friction_force"].__setitem__(2, 1.0), "cone", "across the contact plane"),
                (edge, scaled("friction_force", -1), "dissipation", "drives its slip with"),
                (edge, scaled("friction_force", 0.3), "dissipation", "opposes its slip with"),
                (left, lambda c: c.__setitem__("gap", 1e-3), "gap", "across a gap of 1 mm"),
                (left, scaled("normal_force", 1.2), "dissipation", "opposes its slip")):
            spoilt = json.loads(json.dumps(frames))
            chosen = spoilt[40]["contacts"][contact]
            self.assertGreater(chosen["normal_force"], 0.1)
            plant(chosen)
            report = self.verdict(PIVOT, spoilt)
            self.assertEqual((report["verdict"], report["forces"]["broken"]), ("wrong_forces", law), words)
            worst = self.laws(report)[law]
            self.assertEqual((worst["time"], worst["of"]), (frames[40]["time"], chosen["name"]))
            said = unwrapped(self.said)
            self.assertIn("its forces do not: at 0.2 s", said)
            self.assertIn(words, said)
            self.assertIn(chosen["name"], said)

    def test_a_force_where_nothing_touches_is_named(self):
        frames = self.frames(STROKES, "--step", 0.01, "--frames", 251)
        self.assertEqual(self.verdict(STROKES, frames)["verdict"], "follows")
        for at, name, words in ((150, "wall.1", "where it touches nothing"), (110, "edge.1", "across a gap")):
            spoilt = json.loads(json.dumps(frames))
            chosen = next(c for c in spoilt[at]["contacts"] if c["name"] == name)
            self.assertEqual(chosen["normal_force"], 0)
            chosen.update(normal_force=1.0, gap=None)
            report = self.verdict(STROKES, spoilt)
            self.assertEqual(report["forces"]["broken"], "gap")
            self.assertEqual(self.laws(report)["gap"]["of"], name)
            self.assertIn(words, unwrapped(self.said))

    def test_a_grip_that_is_not_met_is_named(self):
        frames = self.frames(PIVOT, "--time", 0.2, *EACH_STEP[:2], "--frames", 41)
        for frame in frames:
            for contact in frame["contacts"]:
                if contact["name"].startswith(("left", "right")):
                    contact["normal_force"] *= 1.05
            for body in frame["bodies"]:
                body["force"] = body["moment"] = None
        report = self.verdict(PIVOT, frames)
        grip = self.laws(report)["grip"]
        self.assertIn("grip", self.broken(report))
        self.assertAlmostEqual(grip["found"], 1.05 * grip["lawful"], delta=1e-6)
        self.assertEqual(grip["of"], "jaws")
        self.assertIn(f"jaws closes with {grip['found']:.3g} N instead of {grip['lawful']:.3g} N",
                      unwrapped(self.said))

    def test_a_broken_balance_is_named(self):
        scene = SOURCE / "docs/guide/held_box.toml"
        frames = self.frames(scene, "--time", 0.1, "--step", 0.01, "--frames", 11)
        self.assertEqual(self.verdict(scene, frames)["verdict"], "follows")
        for frame in frames[1:]:  # it hangs on nothing: within every cone, at rest
            for contact in frame["contacts"]:
                contact["friction_force"] = [0, 0, 0]
            del frame["bodies"]
        report = self.verdict(scene, frames, "--tolerance", 0.005)
        self.assertEqual((report["verdict"], self.broken(report)), ("wrong_forces", ["newton"]))
        self.assertAlmostEqual(self.laws(report)["newton"]["found"], 0.045 * 9.81, delta=1e-9)
        self.assertIn("0.441 N are missing", unwrapped(self.said))
        # Of longer intervals than the step the forces between are not known.
        for frame in frames[1:]:
            frame["step"] = 0.005
        report = self.verdict(scene, frames, "--tolerance", 0.005)
        self.assertEqual((report["verdict"], report["forces"]["balanced"]), ("follows", 0))
        self.assertNotIn("newton", self.laws(report))

    def test_a_body_that_is_not_its_contacts_is_named(self):
        frames = self.frames(PIVOT, "--time", 0.2, *EACH_STEP[:2], "--frames", 41)
        for key, unit in (("force", "N"), ("moment", "N m")):
            spoilt = json.loads(json.dumps(frames))
            spoilt[20]["bodies"][1][key][0] += 0.7
            report = self.verdict(PIVOT, spoilt)
            self.assertEqual((report["verdict"], self.broken(report)), ("wrong_forces", ["sum"]))
            worst = self.laws(report)["sum"]
            self.assertEqual((worst["of"], worst["time"], worst["unit"]), ("right", frames[20]["time"], unit))
            self.assertAlmostEqual(worst["found"], 0.7, delta=1e-9)
            self.assertIn(f"the {key} of right is not the sum of its contacts', by 0.7 {unit}",
                          unwrapped(self.said))

    def test_a_moment_that_is_missing_is_named(self):
        frames = self.frames(PIVOT, "--time", 0.2, *EACH_STEP[:2], "--frames", 41)
        for frame in frames:
            del frame["contacts"]
        self.assertEqual(self.verdict(PIVOT, frames)["forces"]["balanced"], 40)
        frames[20]["bodies"][0]["moment"][2] += 0.1
        report = self.verdict(PIVOT, frames)
        newton = self.laws(report)["newton"]
        self.assertEqual((report["forces"]["broken"], newton["unit"], newton["time"]),
                         ("newton", "N m", frames[20]["time"]))
        self.assertAlmostEqual(newton["found"], 0.1, delta=1e-6)
        self.assertIn("make the change of spin", unwrapped(self.said))

    def test_an_exact_fall_against_friction(self):
        for speeds in (True, False):
            report = self.verdict(FALLING, self.fall(speeds=speeds))
            self.assertEqual((report["verdict"], self.broken(report)), ("follows", []))
            self.assertEqual((report["forces"]["frames"], report["forces"]["balanced"]),
                             (20, 20 if speeds else 19))
            for law in ("gap", "normal", "cone", "dissipation", "newton"):
                self.assertLess(self.laws(report)[law]["off"], 1e-9 if speeds else 1e-2, law)
        for made, law in ((self.fall(friction=0.8), "cone"), (self.fall(friction=0.6), "dissipation"),
                          (self.fall(friction=-0.7), "dissipation"), (self.fall(normal=1.1), "grip")):
            report = self.verdict(FALLING, made)
            self.assertEqual((report["verdict"], report["forces"]["broken"]), ("wrong_forces", law))
            self.assertIn("newton", self.broken(report))

    def test_a_flat_body_that_says_its_force_alone_obeys_the_cone(self):
        frames = self.frames(FALLING, "--time", 0.1, *EACH_STEP[:2], "--frames", 21)
        for part, law in ((1, None), (1.5, "cone"), (0.5, "dissipation"), (-1, "dissipation")):
            made = json.loads(json.dumps(frames))
            for frame in made:
                frame.pop("contacts")
                for body in frame.get("bodies", []):
                    body["force"][1] *= part  # friction: the fingers press along z
            report = self.verdict(FALLING, made)
            self.assertEqual(report["forces"]["broken"], law, part)
            if law:
                of = self.laws(report)[law]["of"]
                self.assertIn(of, ("left", "right"))

    def test_a_soft_point_that_spins_says_its_force_alone(self):
        """Its torsion takes up the ellipsoid: by its moment if that is said, else its friction is not judged."""
        for scene in (SOURCE / "fixtures/canonical/soft_spin_down.toml", SCENES / "soft_fingers.toml"):
            frames = self.frames(scene, "--time", 0.05, "--step", 0.001, "--frames", 51)
            for change, law in ((lambda b: None, None), (lambda b: b.pop("moment"), None),
                                (lambda b: b.update(moment=[0.5 * m for m in b["moment"]]), "dissipation")):
                made = json.loads(json.dumps(frames))
                for frame in made:
                    frame.pop("contacts")
                    for body in frame.get("bodies", []):
                        if body["name"] in ("left", "right") and "moment" in body:
                            change(body)
                report = self.verdict(scene, made)
                broken = report["forces"]["broken"]
                self.assertTrue(broken == law or (law and broken), (scene.stem, law, broken))

    def test_what_is_left_out_is_not_judged(self):
        frames = self.frames(PIVOT, "--time", 0.2, *EACH_STEP[:2], "--frames", 41)

        def judged(change):
            changed = json.loads(json.dumps(frames))
            for frame in changed:
                change(frame)
            report = self.verdict(PIVOT, changed)
            self.assertEqual(report["verdict"], "follows")
            return report["forces"] and set(self.laws(report))
        every = {"gap", "normal", "cone", "dissipation", "sum", "grip", "newton"}
        self.assertEqual(judged(lambda f: None), every)
        self.assertIsNone(judged(lambda f: [f.pop("contacts"), f.pop("bodies")]))
        self.assertEqual(judged(lambda f: f.pop("bodies")), every - {"sum"})
        self.assertEqual(judged(lambda f: f.pop("contacts")),
                         {"gap", "normal", "cone", "dissipation", "grip", "newton"})  # of a body's sum
        self.assertEqual(judged(lambda f: [c.pop("friction_force") for c in f["contacts"]] + [f.pop("bodies")]),
                         {"gap", "normal", "grip"})
        self.assertEqual(judged(lambda f: [b.pop("closing") for b in f["bodies"]]), every)
        # In the scene's order without names; by name in any, and what presses nothing may be absent.
        self.assertEqual(judged(lambda f: [c.pop("name") for c in f["contacts"]]), every)
        self.assertEqual(judged(lambda f: f["contacts"].reverse()), every)
        self.assertEqual(judged(lambda f: f.update(contacts=[c for c in f["contacts"] if c["normal_force"]])), every)

    def test_six_digits_of_forces_alone_will_do(self):
        def in_pyramids(text):  # round friction of soft fingers turns by more than six digits leave
            return text if "\nfacets" in text else "facets = 8\n" + text
        # In tipping a finger's face turns; in the hand fingers do, and where they are is not known.
        for name, laws in (("tipping", 6), ("pivot", 6), ("soft_fingers", 6), ("dropped", 6), ("three_finger_hand", 5)):
            scene = self.file("scene.toml", in_pyramids((SCENES / f"{name}.toml").read_text()))
            exact = self.frames(scene, "--time", 0.65, "--step", 0.005, "--frames", 131)
            frames = json.loads(json.dumps(exact), parse_float=lambda text: float(f"{float(text):.6g}"))
            for frame, its in zip(frames, exact):
                frame["rotation"] = [round(x, 8) for x in its["rotation"]]
                del frame["bodies"], frame["step"]
                for contact in frame["contacts"]:
                    del contact["gap"], contact["velocity"], contact["mode"]
            report = self.verdict(scene, frames)
            self.assertEqual((report["verdict"], len(self.laws(report))), ("follows", laws), name)
            for law, worst in self.laws(report).items():
                self.assertLess(worst["off"], 1e-3, (name, law))

    def test_mistakes_are_refused_with_their_line(self):
        head, row = self.fall(head_only=True), self.fall().splitlines()[1]
        frame = '{"time": %g, "position": [0, 0, 0], "rotation": [1, 0, 0, 0, 1, 0, 0, 0, 1], %s}'

        def frames(words):
            return '{"frames": [\n' + ",\n".join(frame % (k, words) for k in range(3)) + "]}"
        for text, line, message in (
                (head.replace("right.1.normal", "rigth.1.normal"), 1,
                 'column "rigth.1.normal": the scene has no contact "rigth.1" (did you mean "right.1"?)'),
                (head.replace("left.1.fy", "left.1.up"), 1, 'the column "left.1.fy" is missing'),
                (head.replace("right.1.normal", "left.1.normal"), 1, 'two columns "left.1.normal"'),
                (head + "\n" + row.replace("0.7", "much", 1), 2, "left.1.fy: "),
                (frames('"contacts": [{"name": "lefft.1"}]'), 2, 'the scene has no "lefft.1" (did you mean'),
                (frames('"contacts": [{"normal_force": 1}]'), 2, 'say "name" in each'),
                (frames('"bodies": [{"name": "left"}, {"name": "left"}]'), 2, '"left" stands twice'),
                (frames('"contacts": [{"name": "left.1", "normal_force": "1"}]'), 2, "must be a number"),
                (frames('"step": -1'), 2, "step is the seconds"),
                (frames('"step": 1.5'), 3, "longer than since the frame before")):
            result = run("verify", FALLING, "--trajectory", self.file("m.txt", text))
            self.assertEqual((result.returncode, result.stdout), (2, ""), text)
            self.assertIn(f"m.txt:{line}: ", result.stderr)
            self.assertIn(message, unwrapped(result.stderr))


main()
