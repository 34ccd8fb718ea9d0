"""lcpush report: one self-contained page and its pictures; numbers as in solve and break.

    test_report.py TOOL ROOT [--all]      with --all every scene instead of each third"""
import math
import re
import sys
import xml.etree.ElementTree as ElementTree

from tool import SCENES, SOURCE, ToolTest, main, run, unwrapped
from tool import json_of as answer

RAYS = SOURCE / "fixtures/rays"
ALL = "--all" in sys.argv
SVG = "{http://www.w3.org/2000/svg}"
NAMESPACE = "http://www.w3.org/2000/svg"


def element(page, name):
    """The part of the page with this id."""
    return next(e for e in page.iter() if e.get("id") == name)


def classed(element, kind):
    return [e for e in element.iter() if kind in e.get("class", "").split()]


def words(element):
    return unwrapped("".join(element.itertext()))


def points(polygon):
    return [tuple(map(float, pair.split(","))) for pair in polygon.get("points").split()]


def tip_and_tail(arrow):
    """Of an arrow's group: where its head ends, and where its shaft begins."""
    shaft, head = arrow.find(f"{SVG}line"), arrow.find(f"{SVG}polygon")
    return points(head)[0], (float(shaft.get("x1")), float(shaft.get("y1")))


class Report(ToolTest):
    def page(self, scene, *words, code=0):
        result = run("report", scene, *words)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertTrue(result.stdout.startswith("<!DOCTYPE html>\n"))
        return ElementTree.fromstring(result.stdout)

    def picture(self, scene, name, *words, code=0):
        result = run("report", scene, "--format", "svg", "--picture", name, *words)
        self.assertEqual(result.returncode, code, result.stderr)
        return ElementTree.fromstring(result.stdout)

    def refused(self, pattern, *words):
        self.is_refused(run("report", *words), pattern)

    def near(self, shown, exact, zero):
        """Six digits of the exact number, or 0 for what rounding left of a zero."""
        self.assertAlmostEqual(float(shown), exact, delta=max(6e-6 * abs(exact), zero))

    def test_every_scene_gives_a_page_of_its_own(self):
        for scene in (sorted(SCENES.glob("*.toml")) + sorted(RAYS.glob("*.toml")))[::1 if ALL else 3]:
            with self.subTest(scene=scene.name):
                more = ["--pusher", "upper"] if scene.stem == "two_pushers" else []
                result = run("report", scene, *more)
                solved = run("solve", scene).returncode == 0
                breaks = run("break", scene, *more)
                if "no [[pusher]]" not in breaks.stderr and "moves" not in breaks.stderr:
                    solved = solved and breaks.returncode == 0
                self.assertEqual(result.returncode, 0 if solved else 1, result.stderr)
                text = result.stdout
                page = ElementTree.fromstring(text)
                self.assertEqual(re.findall(r"[a-z]+://[^\"'\s<]*", text.replace(NAMESPACE, "")), [])
                self.assertNotRegex(text, r"<script|@import|url\(|<iframe|<object |<link (?!rel="
                                          r"\"icon\" href=\"data:,\")")
                for image in page.iter("img"):
                    self.assertTrue(image.get("src").startswith("data:image/svg+xml,"))
                ids = [e.get("id") for e in page.iter() if e.get("id")]
                self.assertEqual(len(ids), len(set(ids)))
                for link in page.iter("a"):
                    self.assertIn(link.get("href")[1:], ids)
                for labelled in page.iter():
                    if labelled.get("aria-labelledby"):
                        self.assertIn(labelled.get("aria-labelledby"), ids)
                self.assertNotRegex(text, r"\bnan\b|\binf\b")

    def test_landmarks_headings_captions_and_named_pictures(self):
        page = self.page(SCENES / "pivot.toml", "--vary", "edge.friction=0:1", "--steps", 5)
        self.assertEqual(page.get("lang"), "en")
        for landmark in ("header", "nav", "main", "footer"):
            self.assertEqual(len(list(page.iter(landmark))), 1, landmark)
        self.assertEqual(len(list(page.iter("h1"))), 1)
        levels = [int(e.tag[1]) for e in page.iter() if re.fullmatch("h[1-6]", e.tag)]
        self.assertTrue(all(b <= a + 1 for a, b in zip(levels, levels[1:])), levels)
        tables = list(page.iter("table"))
        self.assertGreaterEqual(len(tables), 2)
        for table in tables:
            self.assertTrue(words(table.find("caption")))
            self.assertEqual({th.get("scope") for th in table.find("thead").iter("th")}, {"col"})
            for row in table.find("tbody").iter("tr"):
                self.assertEqual(row.find("th").get("scope"), "row")
        for svg in page.iter(f"{SVG}svg"):
            self.assertEqual(svg.get("role"), "img")
            self.assertTrue(svg[0].tag == f"{SVG}title" and svg[0].text)
            self.assertTrue(svg[1].tag == f"{SVG}desc" and svg[1].text)
        self.assertTrue([image.get("alt") for image in page.iter("img")] and
                        all(image.get("alt") for image in page.iter("img")))
        for sample in page.iter("svg"): # legend and table marks: words stand beside them
            self.assertEqual(sample.get("aria-hidden"), "true")

    def test_contact_table_has_the_numbers_and_modes_of_solve(self):
        does = {"stick": "sticks", "slide": "slips", "separate": "opens"} # as solve's text says it
        for name in ("straight_slide", "pivot", "tipping", "three_finger_hand", "soft_fingers"):
            scene = SCENES / f"{name}.toml"
            expected = answer("solve", scene)["contacts"]
            zero = 1e-8 * max(contact["normal_force"] for contact in expected)
            rows = element(self.page(scene), "contacts").findall(".//tbody")[-1].findall("tr")
            self.assertEqual(len(rows), len(expected))
            for row, contact in zip(rows, expected):
                cells = [words(cell) for cell in row]
                self.assertEqual(cells[:2], [contact["name"], does[contact["mode"]]])
                self.near(cells[2], contact["normal_force"], zero)
                self.near(cells[3], math.hypot(*contact["friction_force"]), zero)

    def test_what_was_asked_stands_in_it_and_theory_in_a_fold(self):
        scene = SCENES / "straight_slide.toml"
        page = self.page(scene, "--pressure", "rigid")
        asked = words(element(page, "inputs"))
        for part in (f"lcpush report {scene} --pressure rigid", "0.2 kg, a box of 0.1 x 0.03 x 0.01 m",
                     "9.81 m/s^2 along -y", "pressure rigid; round friction", "grip_force = 20"):
            self.assertIn(part, asked)
        folds = " ".join(words(fold) for fold in page.iter("details"))
        for part in ("paths of pivots", "(H1)"):
            self.assertEqual(words(page).count(part), folds.count(part))
            self.assertIn(part, folds)

    def test_words_have_the_numbers_of_solve_and_break(self):
        scene = SCENES / "pivot.toml"
        page = self.page(scene)
        pushed, broken = answer("solve", scene), answer("break", scene)
        force = next(b["force"] for b in pushed["bodies"] if b["name"] == "edge")
        self.assertIn(f"{math.hypot(*force):.6g} N along", words(element(page, "facts")))
        self.assertIn(f"{math.hypot(*pushed['object']['acceleration'][3:]):.6g} rad/s^2",
                      words(element(page, "facts")))
        self.assertIn(f"{broken['break_force']:.6g} N, normal force of edge",
                      words(element(page, "breaking")))

    def test_arrows_are_as_long_as_their_forces(self):
        scene = SCENES / "straight_slide.toml"
        svg = self.picture(scene, "front")
        bar = [e for e in classed(svg, "scale")][1]
        newtons = [e.text for e in svg.iter(f"{SVG}text") if (e.text or "").endswith(" N")]
        unit = float(re.search(r"h([\d.]+)v", bar.get("d"))[1]) / float(newtons[0].split()[0])
        lengths = sorted(math.dist(*tip_and_tail(arrow)) / unit
                         for arrow in classed(svg, "normal") if arrow.find(f"{SVG}line") is not None)
        exact = sorted(contact["normal_force"] for contact in answer("solve", scene)["contacts"]
                       if contact["body"] == "wall")
        self.assertEqual(len(lengths), len(exact))
        for length, force in zip(lengths, exact):
            self.assertAlmostEqual(length, force, delta=0.01)

    def test_instantaneous_centre_is_drawn_where_the_motion_has_it(self):
        scene = SCENES / "pivot.toml" # a bar of 0.1 m about the origin
        ax, ay, _, _, _, turn = answer("solve", scene)["object"]["acceleration"]
        svg = self.picture(scene, "front")
        corners = points(classed(svg, "object")[0])
        xs, ys = [p[0] for p in corners], [p[1] for p in corners]
        meters = 0.1 / (max(xs) - min(xs))
        mark = next(e for e in classed(svg, "turning") if e.tag == f"{SVG}circle")
        x = (float(mark.get("cx")) - (min(xs) + max(xs)) / 2) * meters
        y = -(float(mark.get("cy")) - (min(ys) + max(ys)) / 2) * meters
        self.assertAlmostEqual(x, -ay / turn, delta=2e-5) # hundredths of a pixel
        self.assertAlmostEqual(y, ax / turn, delta=2e-5)
        self.assertGreater(abs(ay / turn), 1e-3)

    def test_friction_points_as_it_does_in_its_contact_plane(self):
        # t and o = n x t of each body, as docs/theory/theory.md defines them.
        frames = {"left": ((1, 0, 0), (0, -1, 0)), "right": ((1, 0, 0), (0, 1, 0)),
                  "wall": ((0, 1, 0), (0, 0, 1)), "edge": ((1, 0, 0), (0, 0, -1))}
        for name in ("straight_slide", "pivot"):
            scene = SCENES / f"{name}.toml"
            contacts = [c for c in answer("solve", scene)["contacts"]
                        if math.hypot(*c["friction_force"]) > 1e-6]
            arrows = [tip_and_tail(e) for e in classed(self.picture(scene, "friction"), "friction")]
            self.assertEqual(len(arrows), len(contacts))
            for contact, (tip, tail) in zip(contacts, arrows):
                bound = self.mu(scene, contact) * contact["normal_force"]
                along, across = (sum(a * b for a, b in zip(contact["friction_force"], axis)) / bound
                                 for axis in frames[contact["body"]])
                self.assertAlmostEqual((tip[0] - tail[0]) / 40, along, delta=1e-3)
                self.assertAlmostEqual((tip[1] - tail[1]) / 40, -across, delta=1e-3)

    def mu(self, scene, contact):
        part = scene.read_text().split(f'name = "{contact["body"]}"')[1]
        return float(re.search(r"friction = ([\d.]+)", part)[1])

    def test_ray_says_who_squeezes_and_exits_1(self):
        scene = SCENES / "jam.toml"
        page = self.page(scene, code=1)
        jam = answer("solve", scene)["jam"]
        box = words(element(page, "answer"))
        self.assertIn("NOT SOLVED (ray)", box)
        for sentence in jam["words"]:
            self.assertIn(unwrapped(sentence.removeprefix("- ")), box)
        ray = {entry["name"]: entry["value"] for entry in answer("solve", scene)["ray"]}
        rows = element(page, "answer").find(".//tbody").findall("tr")
        self.assertEqual({words(row[0]) for row in rows}, set(ray))
        for row in rows:
            self.near(words(row[1]), ray[words(row[0])], 0)
        self.assertFalse(any(e.get("id") == "contacts" for e in page.iter()))
        self.picture(scene, "front", code=1)

    def test_grasp_that_does_not_hold_says_so_and_exits_1(self):
        scene = self.path / "weak.toml"
        text = (SCENES / "straight_slide.toml").read_text()
        scene.write_text(text.replace("grip_force = 20", "grip_force = 0.5"))
        broken = run("break", scene)
        self.assertEqual((broken.returncode, "The grasp does not hold" in broken.stdout), (1, True))
        page = self.page(scene, code=1)
        self.assertIn("The grasp does not hold", words(element(page, "answer")))
        self.assertIn("does NOT hold the object", words(element(page, "facts")))
        self.assertIn("The grasp does not hold", words(element(page, "breaking")))

    def test_a_grasp_without_a_pusher_has_no_breaking_force(self):
        scene = self.path / "held.toml"
        text = (SCENES / "straight_slide.toml").read_text()
        scene.write_text(text[:text.index("[[pusher]]")])
        page = self.page(scene)
        self.assertFalse(any(e.get("id") == "breaking" for e in page.iter()))
        self.assertIn("this is the grasp alone", words(element(page, "facts")))
        self.refused("nothing can break the grasp", scene, "--vary", "object.mass=1:2")

    def test_names_cannot_break_out(self):
        scene = self.path / "names.toml"
        text = (SCENES / "straight_slide.toml").read_text()
        text = text.replace('"wall"', r'''"</desc><script>&\"'"''').replace(
            'title = "', r'title = "</title>\uFFFE<b>&')
        scene.write_text(text)
        page = self.page(scene)
        self.assertFalse(list(page.iter("script")) + list(page.iter("b")))
        self.assertIn("</desc><script>&\"'", words(page))
        for name in ("isometric", "front", "top", "friction", "residuals"):
            svg = self.picture(scene, name)
            self.assertFalse([e for e in svg.iter() if e.tag.endswith("script")])

    def test_bad_words_are_refused_before_anything_is_written(self):
        scene = SCENES / "pivot.toml"
        self.refused("--format is html or svg, not \"json\"", scene, "--json")
        self.refused("--picture goes with --format svg", scene, "--picture", "front")
        self.refused(r"--picture is isometric, front, top, friction or residuals for this scene, not \"side\"",
                     scene, "--format", "svg", "--picture", "side")
        self.refused("--picture is isometric, front or top", SCENES / "jam.toml", "--format", "svg",
                     "--picture", "friction")
        self.refused("--vary needs PATH=FROM:TO", scene, "--vary", "edge.friction")
        self.refused("--steps goes with --vary", scene, "--steps", "5")
        self.refused("--pressure is pad, even or rigid", scene, "--pressure", "soft")
        self.refused("several pushers", SCENES / "two_pushers.toml")
        self.refused("no pusher is named", scene, "--pusher", "egde")
        self.refused("a scene file is needed")
        self.refused("cannot be", self.path / "none.toml")
        target = self.path / "page.html"
        result = run("report", scene, "--vary", "edge.frction=0:1", "-o", target)
        self.assertEqual((result.returncode, target.exists()), (2, False))

    def test_pictures_in_the_docs_are_what_their_commands_draw(self):
        scenes = [path.stem for path in sorted(SCENES.glob("*.toml"))]
        self.assertEqual(scenes, [path.stem for path in sorted((SOURCE / "docs/scenes").iterdir())])
        for path, scene, name in [("docs/teach/pivot_front.svg", "pivot", "front"),
                                  *((f"docs/scenes/{scene}.svg", scene, "isometric") for scene in scenes)]:
            with self.subTest(path=path):
                more = ["--pusher", "upper"] if scene == "two_pushers" else []
                self.same_drawing(ElementTree.parse(SOURCE / path).getroot(),
                                  self.picture(SCENES / f"{scene}.toml", name, *more,
                                               code=int(scene in ("dropped", "jam"))))

    def same_drawing(self, kept, now):
        # Labels may stand elsewhere where rounding decides between two places.
        def drawn(svg):
            return [e for e in svg.iter() if e.tag != f"{SVG}style"
                    and not {"label", "leader", "leader-end"} & set(e.get("class", "").split())]

        def numbers(text):
            return [float(x) for x in re.findall(r"-?\d+\.?\d*", text)]

        self.assertEqual(len(drawn(kept)), len(drawn(now)))
        for a, b in zip(drawn(kept), drawn(now)):
            self.assertEqual((a.tag, a.get("class"), a.text), (b.tag, b.get("class"), b.text))
            for key in ("points", "d", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r"):
                for p, q in zip(numbers(a.get(key, "")), numbers(b.get(key, ""))):
                    self.assertAlmostEqual(p, q, delta=0.05)
        self.assertEqual(sorted(e.text for e in classed(kept, "label")),
                         sorted(e.text for e in classed(now, "label")))

    def test_a_sweep_draws_the_force_and_the_turn_in_the_unit_that_was_typed(self):
        words_ = ("report", SCENES / "straight_slide_point.toml", "--facets", "8", "--vary", "wall.shift[1]=-8:4 mm", "--steps", 13)
        plot = ElementTree.fromstring(run(*words_, "--format", "svg", "--picture", "sweep1").stdout)
        texts = [e.text for e in plot.iter(f"{SVG}text")]
        for label in ("force, N", "acceleration about z, rad/s^2", "shift of wall along y, mm"):
            self.assertIn(label, texts)
        self.assertIn("At -4.9 mm: acceleration about z is zero.", plot.find(f"{SVG}desc").text)
        page = self.page(SCENES / "straight_slide.toml", "--pressure", "rigid", "--vary", "*.grip_force=2000:30000 mN")
        self.assertIn("At 6538.29 mN: at breaking: wall sticks", words(element(page, "sweeps")))

    def test_stopped_early_the_page_has_what_there_is(self):
        words_ = ["--vary", "*.friction=0.3:0.9", "--vary", "object.mass=0.1:0.3", "--steps", 9999]
        result = run("report", SCENES / "soft_fingers.toml", *words_, "--seconds", 0.5)
        self.assertEqual(result.returncode, 1)
        self.assertIn("stopped after 0.5 s of processor time; what there was", unwrapped(result.stderr))
        page = ElementTree.fromstring(result.stdout)
        self.assertIn("Push with", words(element(page, "answer")))
        self.assertIn("It was stopped before its range was done", words(element(page, "sweeps")))

    def test_help_has_an_example(self):
        text = run("report", "--help").stdout
        self.assertRegex(text, r"lcpush report fixtures/scenes/\w+\.toml -o \w+\.html")
        for command in re.findall(r"^  lcpush (report .*)$", text, flags=re.M):
            words_ = command.replace("fixtures/", str(SOURCE / "fixtures") + "/").split()
            words_[words_.index("-o") + 1] = str(self.path / "out")
            if "--vary" in words_:
                words_ += ["--steps", "3"]
            self.assertEqual(run(*words_).returncode, 0, command)


main()
