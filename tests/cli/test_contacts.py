"""lcpush contacts: the field's own contact problem, judged here by code of the test's own."""
import json
import math
import random

from tool import SOURCE, ToolTest, json_of, main, run, unwrapped

from motion_frames import cross, dot

INCLINE = SOURCE / "docs/check/incline.json"


def frame(n):
    t = cross(n, [1, 0, 0] if abs(n[0]) < 0.9 else [0, 1, 0])
    t = [x / math.hypot(*t) for x in t]
    return [n, t, cross(n, t)]


def of_bodies(links, masses, pull):
    """W, b, mu of balls: a link is two bodies (-1: the ground), a unit normal and a friction; b is what
    the accelerations `pull` do."""
    columns = []
    for i, j, n, _ in links:
        for d in frame(n):
            columns.append({body: [sign * x for x in d] + [x * 0.5 for x in cross([-y for y in n], d)]
                            for body, sign in ((i, 1), (j, -1)) if body >= 0})
    inertia = [1, 1, 1, 10, 10, 10]
    W = [[sum(dot([x * k for x, k in zip(p[body], inertia)], q[body]) / masses[body]
              for body in p.keys() & q.keys()) for q in columns] for p in columns]
    b = [sum(dot(p[body], pull[body]) for body in p) for p in columns]
    return {"W": W, "b": b, "mu": [link[3] for link in links]}


def pile(base, ratio, rng):
    """Balls on each other in a plane, pushed about."""
    places = [(i + level / 2, 0, level * math.sqrt(0.75)) for level in range(base)
              for i in range(base - level)]
    links = [(k, -1, [0, 0, 1], rng.uniform(0.05, 1)) for k, p in enumerate(places) if p[2] == 0]
    links += [(i, j, [x - y for x, y in zip(p, q)], rng.uniform(0.05, 1))
              for i, p in enumerate(places) for j, q in enumerate(places[:i]) if abs(math.dist(p, q) - 1) < 1e-9]
    masses = [10 ** rng.uniform(0, math.log10(ratio)) for _ in places]
    push = rng.choice([0, 1, 5])
    return of_bodies(links, masses, [[rng.gauss(0, push), rng.gauss(0, push), -9.81, 0, 0, 0] for _ in places])


def left(problem, r):
    """The worst of Signorini's law and of the cone, beside the terms of a contact's own rows; the largest angle off
    a slip beyond rounding."""
    worst, angle = 0, 0
    for c, mu in enumerate(problem["mu"]):
        rows = range(3 * c, 3 * c + 3)
        u = [dot(problem["W"][i], r) + problem["b"][i] for i in rows]
        size = max(sum(abs(x * y) for x, y in zip(problem["W"][i], r)) + abs(problem["b"][i]) for i in rows) or 1
        unit = size / max(problem["W"][i][i] for i in rows)
        n, *t = r[3 * c:3 * c + 3]
        worst = max(worst, -n / unit, -u[0] / size, min(n / unit, u[0] / size), (math.hypot(*t) - mu * n) / unit)
        if math.hypot(*u[1:]) > 1e-8 * size and mu * n > 1e-8 * unit:
            angle = max(angle, abs(math.atan2(t[0] * u[2] - t[1] * u[1], -dot(t, u[1:]))))
    return worst, angle


class Contacts(ToolTest):
    def written(self, problem, name="problem.json"):
        return self.file(name, json.dumps(problem))

    def test_problems_with_mass_ratios_up_to_a_million_are_solved_to_rounding(self):
        rng = random.Random(1)
        problems = [pile(base, ratio, rng) for base in (2, 3, 4, 5) for ratio in (1, 1e3, 1e6) for _ in range(3)]
        for _ in range(20):  # a heap in disorder, whose normals all have a way out
            bodies = rng.randint(1, 8)
            links = []
            for _ in range(rng.randint(1, 14)):
                n = [rng.gauss(0, 1), rng.gauss(0, 1), abs(rng.gauss(0, 1))]
                i = rng.randrange(bodies)
                links.append((i, rng.randrange(-1, i), [x / math.hypot(*n) for x in n], rng.choice([0, 0.3, 1])))
            problems.append(of_bodies(links, [10 ** rng.uniform(0, 6) for _ in range(bodies)],
                                      [[rng.gauss(0, 5) for _ in range(6)] for _ in range(bodies)]))
        for k, problem in enumerate(problems):
            answer = json_of("contacts", self.written(problem))
            self.assertEqual(answer["status"], "solved", k)
            worst, angle = left(problem, answer["r"])
            self.assertLessEqual(worst, 1e-12, k)
            self.assertLessEqual(angle, 1e-6, k)

    def test_forces_in_thousandths_are_told(self):
        """Of a block that slides: impulses of a millisecond, which no order of axes mends."""
        for factor, said in ((1e-3, "times 1000"), (1e3, "divided by 1000")):
            slid = {"W": [[0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.5]], "g": [-8.49546, 4.905, 0], "mu": [0.3],
                    "r": [16.99092 * factor, -5.097276 * factor, 0]}
            hint = json_of("contacts", self.written(slid), "--tolerance", "1e-4")["hint"]
            self.assertIn(f"With every force {said} the laws hold", hint)
        for factor in (1e4, 1e6):  # a thousandth of which is as wrong
            slid["r"] = [16.99092 * factor, -5.097276 * factor, 0]
            self.assertNotIn("the laws hold", json_of("contacts", self.written(slid))["hint"] or "")

    def test_refused_forces_are_told_what_is_wrong(self):
        slides = {"W": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "b": [0.5, 0, -1], "mu": 0.5, "normal": "last"}
        self.assertEqual([round(x, 9) for x in json_of("contacts", self.written(slides))["r"]], [-0.5, 0, 1])
        for r, words in (([0, 0, 1], "friction is 0, where 0.5 against the slip is due"),
                         ([-0.2, 0, 1], "friction is 0.2, where 0.5 against the slip is due"),
                         ([0.5, 0, 1], "friction of 0.5 goes along with the slip, where 0.5 against the slip is due; "
                          "its sign looks turned. With every friction turned round the laws hold."),
                         ([-0.3, 0.4, 1], "friction is 2.03 rad off"), ([-0.6, 0, 1], "friction is 0.6, and mu r_n is 0.5"),
                         ([-0.5, 0, -1], "it pulls with 1"), ([0, 0, 0.5], "it goes into the other body at 0.5"),
                         ([0, 0, 2], "it presses with 2 and parts at 1"),
                         ([0.5, 0, -1], "With every force turned round the laws hold"),
                         ([1, -0.5, 0], "The laws hold where the forces alone have the normal first.")):
            result = run("contacts", self.written({**slides, "r": r}))
            self.assertEqual(result.returncode, 1)
            self.assertIn(words, unwrapped(result.stdout))
        first = {**slides, "r": [-0.5, 0, 1]}
        del first["normal"]
        self.assertIn("With --normal last the laws hold.", json_of("contacts", self.written(first))["hint"])
        masses = {"M": [[2, 0], [0, 2]], "H": [[1, 0, 0, 1, 0, 0], [0, 1, 0, 0, 1, 0]], "f": [-4, 0]}
        one, two = (json_of("contacts", self.written({**masses, "mu": mu})) for mu in (0.5, [0.5, 0.5]))
        self.assertEqual(one, two)

    def test_closed_forms(self):
        weight = 2 * 9.81
        answer = json_of("contacts", INCLINE)
        self.assertEqual(answer["modes"], ["stick", "slip"])
        normal = weight * math.cos(math.pi / 6)
        for found, right in zip(answer["r"], [normal, -weight / 2, 0, normal, -0.4 * normal, 0]):
            self.assertAlmostEqual(found, right, 9)
        half = math.sqrt(0.5)  # a ball of 2 kg in a frictionless groove of 90 degrees
        wedge = of_bodies([(0, -1, [half, 0, half], 0), (0, -1, [-half, 0, half], 0)], [2],
                          [[0, 0, -9.81, 0, 0, 0]])
        found = json_of("contacts", self.written(wedge))["r"]
        for force in (found[0], found[3]):
            self.assertAlmostEqual(force, weight * half, 9)
        pyramids = json_of("contacts", INCLINE, "--facets", 4)
        self.assertEqual((pyramids["status"], pyramids["friction"]), ("solved", {"law": "pyramids", "facets": 4}))
        self.assertAlmostEqual(pyramids["r"][4], -0.4 * normal, 9)

    def test_masses_and_tangents_first_say_the_same(self):
        problem = {"M": [[2, 0, 0], [0, 2, 0], [0, 0, 2]], "H": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
                   "f": [-17, 9.81, 0], "w": [0, 0, 0.5], "mu": [0.4]}
        first = json_of("contacts", self.written(problem))["r"]
        self.assertAlmostEqual(math.hypot(*first[1:]), 0.4 * 17, 9)
        last = {"W": [[0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.5]], "b": [4.905, 0.5, -8.5], "mu": [0.4], "normal": "last"}
        for found, right in zip(json_of("contacts", self.written(last))["r"], first[1:] + first[:1]):
            self.assertAlmostEqual(found, right, 9)

    def test_exported_pushes_have_the_same_forces(self):
        for name in ("coin", "squeeze", "dropped", "tipping", "lever"):
            scene = SOURCE / f"fixtures/scenes/{name}.toml"
            run("export", scene, "-o", self.path / name)
            answer = json_of("contacts", self.path / name / "fclib")
            self.assertEqual(answer["status"], "solved", name)
            for k, contact in enumerate(json_of("solve", scene, "--pressure", "even")["contacts"]):
                self.assertAlmostEqual(answer["r"][3 * k], contact["normal_force"], 6, (name, k))
            self.file("r.json", json.dumps({"r": answer["r"]}))
            judged = run("contacts", self.path / name / "fclib", "--forces", self.path / "r.json")
            self.assertEqual(judged.returncode, 0, judged)

    def test_own_answers_are_right_and_changed_ones_refused_on_all_scenes(self):
        rng = random.Random(3)
        for scene in sorted((SOURCE / "fixtures/scenes").glob("*.toml")):
            name = scene.stem
            run("export", scene, "-o", self.path / name)
            if not (self.path / name / "fclib").is_dir():
                continue
            answer = json_of("solve", scene)
            if answer["status"] != "solved":
                continue
            G = json_of("matrices", scene)["G"]["values"]
            r = []
            for k, contact in enumerate(answer["contacts"]):
                n, *tangents = ([G[i][3 * k + m] for i in range(3)] for m in range(3))
                r += [contact["normal_force"], *(dot(t, contact["friction_force"]) for t in tangents)]

            def judged(forces):
                return run("contacts", self.path / name / "fclib", "--forces", self.file("r.json", json.dumps(forces)))
            self.assertEqual(judged(r).returncode, 0, (name, judged(r)))
            largest = max(map(abs, r))
            for _ in range(10 if largest > 1e-9 else 0):
                changed = list(r)
                changed[rng.randrange(len(r))] += rng.choice([-1, 1]) * 10 ** rng.uniform(-4, 0) * largest
                self.assertEqual(judged(changed).returncode, 1, (name, changed))

    def test_a_scene_is_told_where_its_contacts_are(self):
        scene = SOURCE / "fixtures/scenes/straight_slide.toml"
        self.assertIn("a scene; `lcpush export", unwrapped(run("contacts", scene).stderr))

    def test_bad_input_is_refused_by_name(self):
        good = {"W": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "b": [-1, 0, 0], "mu": [0.5]}
        for change, message in [({"mu": [-1]}, '"mu" of contact 1 is -1; friction is >= 0'),
                                ({"b": [1, 2]}, '"b" is 2 x 1'), ({"mu": None}, '"mu" is missing'),
                                ({"W": [[1, 2, 0], [2, 1, 0], [0, 0, 1]]}, "not positive semidefinite"),
                                ({"W": [[1, 0.5, 0], [0, 1, 0], [0, 0, 1]]}, "not symmetric"),
                                ({"b": [1, "x", 2]}, '"b" must hold numbers, got a string'),
                                ({"g": [0, 0, 1]}, '"b" and "g" are both there and differ'),
                                ({"M": [[1]], "H": [[1, 0, 0]], "f": [1]}, '"W" beside "M"'),
                                ({"mu": 0.5, "W": [[1, 0], [0, 1]], "b": [-1, 0]}, "2 are no multiple of that"),
                                ({"mu": [0.5] * 1001}, "at most 3000"), ({"normal": "up"}, '"first" or "last"')]:
            result = run("contacts", self.written({**good, **change}))
            self.assertEqual((result.returncode, result.stdout), (2, ""), message)
            self.assertIn(message, unwrapped(result.stderr))
            self.assertIn("problem.json", unwrapped(result.stderr))
        self.assertEqual(run("contacts", self.written({**good, "g": good["b"]})).returncode, 0)
        self.assertIsNone(json_of("contacts", self.written({**good, "r": [0, 0, 0]}))["hint"])  # 0 has no order
        unread = run("contacts", self.written({**good, "forces": [1, 0, 0]})).stdout
        self.assertIn('Not read of the file: forces. Forces to be judged are called "r".', unread)
        nearly = run("contacts", self.written({**good, "r": [1, 0.50002, 0]})).stdout
        self.assertIn("friction is 0.50002, and mu r_n is 0.5", unwrapped(nearly))

    def test_where_nothing_holds_that_is_shown(self):
        jam = {"W": [[0] * 3] * 3, "b": [-1, 0, 0], "mu": [0.5]}  # nothing moves: no force opens it
        rows = [[s * (m == n) for s in (1, -1) for n in range(3)] for m in range(3)]
        squeezed = {"W": rows + [[-x for x in row] for row in rows], "b": [-1, 0, 0, -3, 0, 0], "mu": [0.5] * 2}
        for problem, words in ((jam, "There are no such forces: contact 1 closes at 1, whatever presses."),
                               (squeezed, "of contacts 1 and 2 the normal velocities sum up to -4")):
            for options in ((), ("--facets", 8)):
                answer = json_of("contacts", self.written(problem), *options)
                self.assertEqual((answer["status"], len(answer["none"])), ("no_solution", len(problem["mu"])))
                for weight in answer["none"]:
                    self.assertAlmostEqual(weight, 1, 6)
                self.assertIsNone(answer["residuals"]["lcp"])
                self.assertIn(words, unwrapped(run("contacts", self.written(problem), *options).stdout))
        # A ball that three walls close in on, with friction; and integers, W = v v'.
        J = [row for a in (0, 2 * math.pi / 3, 4 * math.pi / 3) for row in
             ((math.cos(a), math.sin(a), 0), (-math.sin(a), math.cos(a), 0), (0, 0, 1))]
        v = [1, 2, 0, -2, 1, 1]
        walls = {"W": [[dot(a, b) for b in J] for a in J], "b": [-1, 0, 0] * 3, "mu": [0.5] * 3}
        whole = {"W": [[a * b for b in v] for a in v], "b": [-1, 0, 0, -1, 0, 0], "mu": [0.5] * 2}
        for problem, words in ((walls, "of contacts 1, 2 and 3 the normal velocities sum up to -3"), (whole, "no such forces")):
            for options in ((), ("--facets", 8)):
                self.assertIn(words, unwrapped(run("contacts", self.written(problem), *options).stdout))
        eased = {**squeezed, "b": [-1, 0, 0, 3, 0, 0]}  # as fast as the one closes the other may open
        self.assertEqual(json_of("contacts", self.written(eased))["status"], "solved")


main()
