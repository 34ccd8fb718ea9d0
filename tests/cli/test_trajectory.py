"""lcpush verify --trajectory: other people's motions, step by step."""
import csv
import json
import math

from tool import SOURCE, ToolTest, main, run, unwrapped
from scene_tables import finger, table

PIVOT = SOURCE / "fixtures/scenes/pivot.toml"
POSE = ["time", "x", "y", "z", *(f"r{i}{j}" for i in "123" for j in "123")]
SPEEDS = ["vx", "vy", "vz", "wx", "wy", "wz"]
HELD = (
    table("", gravity=[0, -9.81, 0]) +
    table("[object]", mass=0.045, box=[0.04, 0.04, 0.04]) +
    finger("left", "disc", center=[0, 0, 0.02], radius=0.005, normal=[0, 0, -1], friction=0.7, grip_force=12) +
    finger("right", "disc", center=[0, 0, -0.02], radius=0.005, normal=[0, 0, 1], friction=0.7, grip_force=12)
)


class Trajectory(ToolTest):
    def verdict(self, scene, motion, *words):
        result = run("verify", scene, "--trajectory", motion, "--json", "--seconds", 600, *words)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return json.loads(result.stdout), result.returncode

    def own(self, *words):
        return run("move", PIVOT, "--time", 0.4, "--step", 0.005, "--frames", 81, *words).stdout

    def test_its_own_motions_follow_the_laws_in_either_format(self):
        for name, words in (("m.json", ["--json"]), ("m.csv", ["--format", "csv"])):
            report, code = self.verdict(PIVOT, self.file(name, self.own(*words)))
            self.assertEqual((report["verdict"], code), ("follows", 0))
            self.assertEqual(report["steps"], 80)
            self.assertLessEqual(report["worst"], 1e-9)

    def test_its_own_motions_follow_whatever_steps_lie_between_their_frames(self):
        told = run("verify", PIVOT, "--trajectory", self.file("m.csv", run("move", PIVOT, "--format", "csv").stdout)).stdout
        self.assertIn("every law but Newton's is kept", unwrapped(told))
        self.assertIn("Newton's law, that forces make the motion, is not judged: several steps", unwrapped(told))
        for name in ("soft_fingers", "dropped", "tipping"):
            scene = SOURCE / f"fixtures/scenes/{name}.toml"
            motion = run("move", scene, "--time", 0.3, "--frames", 61, "--json").stdout
            report, code = self.verdict(scene, self.file("m.json", motion))
            self.assertEqual((report["verdict"], code), ("follows", 0), name)

    def test_bodies_do_not_go_into_each_other(self):
        scene = SOURCE / "docs/check/block.toml"  # a wall pushes a box at 10 mm/s

        def moves(speed, names="time,x,y,z"):
            rows = [f"{k / 100},{speed * k / 100}" + ",0" * (names.count(",") - 1) for k in range(11)]
            return self.verdict(scene, self.file("m.csv", "\n".join([names, *rows])))
        for speed, depth in ((0, 1e-3), (0.005, 5e-4), (0.0098, 2e-5)):
            report, code = moves(speed)
            self.assertEqual((report["verdict"], code), ("differs", 1), speed)
            self.assertAlmostEqual(report["overlap"], depth, 9)
        self.assertIn("at 0.1 s wall.1 is 1 mm inside its face",
                      unwrapped(run("verify", scene, "--trajectory", self.file("m.csv", "time,x,y,z\n0,0,0,0\n0.05,0,0,0\n0.1,0,0,0")).stdout))
        report, code = moves(0.01)
        self.assertEqual((report["verdict"], code, report["overlap"], report["hint"]), ("follows", 0, 0, None))
        self.assertEqual(moves(0.01, "time,x,y,z,mass,pitched")[0]["unread"], ["mass", "pitched"])

    def test_wrong_accelerations_are_refused_in_few_frames_and_in_many(self):
        thrown, ball = (SOURCE / f"fixtures/canonical/{name}.toml" for name in ("thrown_up", "bowling_ball"))

        def flies(g, frames, with_speeds=False, spin=5.0, speed=2.0):
            rows = ["time,x,y,z,qw,qx,qy,qz" + ",vx,vy,vz,wx,wy,wz" * with_speeds]
            for t in (0.3 * k / frames for k in range(frames + 1)):
                row = [t, t, speed * t - g * t * t / 2, 0, math.cos(spin * t / 2), 0, 0, math.sin(spin * t / 2)]
                rows.append(",".join(map(str, row + [1, speed - g * t, 0, 0, 0, spin] * with_speeds)))
            return self.verdict(thrown, self.file("m.csv", "\n".join(rows)))[0]["verdict"]
        for frames in (10, 40, 100):
            self.assertEqual(flies(9.81, frames), "follows", frames)
            for g in (5, 8, 12):
                for with_speeds in (False, True):
                    self.assertEqual(flies(g, frames, with_speeds), "differs", (g, frames, with_speeds))
            self.assertEqual(flies(9.81, frames, spin=0), "differs", frames)  # the scene's turns
            self.assertEqual(flies(9.81, frames, speed=1.5), "differs", frames)
        glides = ["time,x,y,z,qw,qx,qy,qz"] + [f"{0.6 * k / 200},{1.2 * k / 200},0,0,1,0,0,0" for k in range(201)]
        self.assertEqual(self.verdict(ball, self.file("m.csv", "\n".join(glides)))[0]["verdict"], "differs")

    def test_frames_too_far_apart_to_tell_a_speed_are_not_judged(self):
        cube = SOURCE / "fixtures/canonical/thrown_cube.toml"  # 6 m/s, 0.1 m large
        rows = ["time,x,y,z"] + [f"{t},{6 * t - 0.25 * 9.81 * t * t},0,0" for t in (k / 16 for k in range(11))]
        report, code = self.verdict(cube, self.file("m.csv", "\n".join(rows)))
        self.assertEqual((report["verdict"], report["coarse"], code), ("stopped", True, 1))

    def test_rounding_of_an_object_that_stays_is_no_motion(self):
        scene = self.file("held.toml", HELD)
        for noise, verdict in ((1e-10, "follows"), (1e-5, "creeps")):
            rows = ["time,x,y,z"] + [f"{k / 100},{noise * (k % 3)},{-noise * (k % 2)},0" for k in range(20)]
            self.assertEqual(self.verdict(scene, self.file("m.csv", "\n".join(rows)))[0]["verdict"], verdict, noise)

    def test_other_units_and_orders_are_told(self):
        frames = json.loads(self.own("--json"))["frames"]
        large = {"frames": [{"time": f["time"], "position": [1e3 * x for x in f["position"]],
                             "rotation": f["rotation"]} for f in frames]}
        self.assertIn("these look like millimetres", self.verdict(PIVOT, self.file("m.json", json.dumps(large)))[0]["hint"])
        columns = {"frames": [{"time": f["time"], "position": f["position"],
                               "rotation": [f["rotation"][3 * (k % 3) + k // 3] for k in range(9)]} for f in frames]}
        self.assertIn("column by column", self.verdict(PIVOT, self.file("m.json", json.dumps(columns)))[0]["hint"])
        rows = ["time,x,y,z,qw,qx,qy,qz"]
        for frame in frames:
            r = frame["rotation"]
            w = math.sqrt(1 + r[0] + r[4] + r[8]) / 2
            q = [(r[7] - r[5]) / 4 / w, (r[2] - r[6]) / 4 / w, (r[3] - r[1]) / 4 / w, w]
            rows.append(",".join(map(str, [frame["time"], *frame["position"], *q])))
        self.assertIn("quaternions have w first", self.verdict(PIVOT, self.file("m.csv", "\n".join(rows)))[0]["hint"])
        refused = run("verify", PIVOT, "--trajectory", self.file("m.csv", "t,px,py,pz\n0,0,0,0"))
        self.assertIn('here it is "time", "px", "py" and "pz"', unwrapped(refused.stderr))

    def test_an_exact_fall_follows(self):
        scene = self.file("weak.toml", HELD.replace("grip_force = 12", "grip_force = 0.1"))
        down = 9.81 - 2 * 0.7 * 0.1 / 0.045
        rows = [f"{t},0,{-down * t * t / 2},0,1,0,0,0,0,{-down * t},0,0,0,0" for t in (k / 200 for k in range(11))]
        head = "time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz"
        report, code = self.verdict(scene, self.file("m.csv", "\n".join([head, *rows])))
        self.assertEqual((report["verdict"], code), ("follows", 0))
        # The same with `t` and no rotation, as it does not turn; and as JSON with quaternions.
        plain = "\n".join(["t,x,y,z,vx,vy,vz,wx,wy,wz"] + [",".join(row.split(",")[:4] + row.split(",")[8:]) for row in rows])
        frames = [{"t": t, "position": [0, y, 0], "quaternion": [2, 0, 0, 0], "twist": [0, v, 0, 0, 0, 0]}
                  for t, y, v in ((x[0], x[2], x[9]) for x in (list(map(float, row.split(","))) for row in rows))]
        for text, is_turn in ((plain, False), (json.dumps({"frames": frames}), True)):
            other, code = self.verdict(scene, self.file("m.csv", text))
            self.assertEqual(other, {**report, "has_rotation": is_turn})
        told = unwrapped(run("verify", scene, "--trajectory", self.file("m.csv", plain)).stdout)
        self.assertIn("the file says none: the object is taken not to turn", told)
        # A turn of 90 degrees about z, either way to say it.
        ways = {"quaternion": [0.5 ** 0.5, 0, 0, 0.5 ** 0.5], "rotation": [0, -1, 0, 1, 0, 0, 0, 0, 1]}
        turned = [self.verdict(scene, self.file("m.json", json.dumps({"frames": [
            {"time": k, "position": [0, 0, 0], name: way} for k in range(3)]})))[0] for name, way in ways.items()]
        self.assertEqual(*[{key: round(value, 9) if isinstance(value, float) else value for key, value in one.items()}
                           for one in turned])
        # Half as fast is no fall.
        slow = [row.split(",") for row in rows]
        for row in slow:
            row[2], row[9] = str(float(row[2]) / 2), str(float(row[9]) / 2)
        text = "\n".join([head, *(",".join(row) for row in slow)])
        self.assertEqual(self.verdict(scene, self.file("m.csv", text))[0]["verdict"], "differs")

    def fall(self, down, seconds, frames, start=(0, 0, 0), speeds=True):
        """The verdict on a log of a box that slips out of 2 x 2 N and falls at `down` m/s^2."""
        scene = self.file("slips.toml", HELD.replace("grip_force = 12", "grip_force = 2").replace("0.045", "0.2")
                          .replace("friction = 0.7", "friction = 0.3"))
        rows = ["time,x,y,z,qw,qx,qy,qz" + ",vx,vy,vz,wx,wy,wz" * speeds]
        for t in (seconds * k / (frames - 1) for k in range(frames)):
            x, y, z = start[0], start[1] - down * t * t / 2, start[2]
            rows.append(f"{t},{x},{y},{z},1,0,0,0" + f",0,{-down * t},0,0,0,0" * speeds)
        motion = self.file("m.csv", "\n".join(rows))
        return self.verdict(scene, motion)[0], run("verify", scene, "--trajectory", motion).stdout

    def test_frames_at_uneven_times_need_no_velocities(self):
        """The mean velocity since a frame is that of half an interval ago: of a longer one, of longer ago."""
        thrown = SOURCE / "fixtures/canonical/thrown_up.toml"
        rows = run("move", thrown, "--time", 0.35, "--frames", 36, "--format", "csv").stdout.splitlines()
        rows = [row.split(",")[:13] for row in rows]
        for left_out in ([7], [3, 4, 9], range(2, 30, 3)):
            kept = [row for k, row in enumerate(rows) if k - 1 not in left_out]
            for rise, verdict in ((0, "follows"), (3, "differs")):  # m/s^2, beside 9.81
                made = [kept[0]] + [[t, x, str(float(y) + rise * float(t) ** 2 / 2), *more] for t, x, y, *more in kept[1:]]
                report, code = self.verdict(thrown, self.file("m.csv", "\n".join(map(",".join, made))))
                self.assertEqual((report["verdict"], code), (verdict, int(rise > 0)), (left_out, rise))

    def test_a_turn_in_place_says_nothing_of_digits(self):
        scene = SOURCE / "fixtures/canonical/spinning_disc.toml"
        rows = run("move", scene, "--time", 0.3, "--step", 0.003, "--frames", 61, "--format", "csv").stdout.splitlines()
        report, _ = self.verdict(scene, self.file("m.csv", "\n".join(",".join(row.split(",")[:13]) for row in rows)))
        self.assertNotIn("digits", report["hint"] or "")

    def test_a_hair_beside_a_face_is_no_fall(self):
        """A line that ends where its face does, on an object that drifts by 0.1 um."""
        scene = SOURCE / "fixtures/scenes/straight_slide.toml"
        rows = ["time,x,y,z"] + [f"{t},{0.05 * t * t},{1e-7 * (1 - math.exp(-10 * t))},0" for t in (k / 100 for k in range(51))]
        self.assertEqual(self.verdict(scene, self.file("m.csv", "\n".join(rows)))[0]["verdict"], "follows")

    def test_what_goes_on_all_the_time_adds_up(self):
        """A cube in flight that loses a third of its spin in 0.3 s."""
        scene, rows = SOURCE / "fixtures/canonical/thrown_up.toml", ["time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz"]
        for spin, verdict in ((0, "follows"), (1, "differs")):
            motion = rows[:]
            for t in (0.3 * k / 200 for k in range(201)):
                angle, rate = 5 * (t - spin * t * t / 2), 5 * (1 - spin * t)
                motion.append(f"{t},{t},{2 * t - 9.81 * t * t / 2},0,{math.cos(angle / 2)},0,0,{math.sin(angle / 2)},1,{2 - 9.81 * t},0,0,0,{rate}")
            self.assertEqual(self.verdict(scene, self.file("m.csv", "\n".join(motion)))[0]["verdict"], verdict)

    def test_rotations_that_are_none_have_no_digits(self):
        """A block that stands still where it has to slide; its times are no milliseconds, whatever obeys over so short a time."""
        scene = SOURCE / "fixtures/canonical/ramp_20_03.toml"
        for rotation in ("1,0,0,0,1,0,0,0,1", "1,-1e-13,0,1e-13,1,0,0,0,1"):
            rows = [",".join(POSE)] + [f"{t},0,0,0,{rotation}" for t in (k / 300 for k in range(101))]
            report, code = self.verdict(scene, self.file("m.csv", "\n".join(rows)))
            self.assertEqual((report["verdict"], code, report["hint"]), ("differs", 1, None))

    def test_what_sinks_is_said_to_sink(self):
        scene, a = SOURCE / "fixtures/canonical/ramp_20_03.toml", 9.81 * (math.sin(math.radians(20)) - 0.3 * math.cos(math.radians(20)))
        rows = ["time,x,y,z"] + [f"{t},{a * t * t / 2},{-1e-3 * t},0" for t in (k / 200 for k in range(101))]
        self.assertIn("inside its face; bodies do not go into each other",
                      unwrapped(run("verify", scene, "--trajectory", self.file("m.csv", "\n".join(rows))).stdout))

    def test_wrong_accelerations_add_up(self):
        right = 9.81 - 2 * 0.3 * 2 / 0.2
        for seconds, frames in ((0.06, 61), (0.06, 601), (0.05, 21)):
            for speeds in (True, False):
                self.assertEqual(self.fall(right, seconds, frames, speeds=speeds)[0]["verdict"], "follows")
                # Twice as fast, half as fast, friction of half and of a twentieth less.
                for wrong in (2 * right, right / 2, 9.81 - 3, 1.3 * right):
                    report, text = self.fall(wrong, seconds, frames, speeds=speeds)
                    self.assertNotEqual(report["verdict"], "follows", (seconds, frames, speeds, wrong))
        self.assertRegex(unwrapped(self.fall(2 * right, 0.05, 501)[1]),
                         r"its velocity changes by \(0, -.*\) m/s, and by the laws by \(0, -.*\) m/s")

    def slide(self, accelerations, frames, seconds=0.5, speeds=False, end="\n", head="", **more):
        """The verdict on a block that starts from rest down a ramp, with these accelerations one after the other."""
        place = speed = 0.0
        rows, h = [head + "time,x,y,z" + ",vx,vy,vz,wx,wy,wz" * speeds], seconds / frames
        for k in range(frames + 1):
            rows.append(f"{k * h},{place:{more.get('digits', '')}},0,0" + f",{speed},0,0,0,0,0" * speeds)
            a = accelerations[min(len(accelerations) - 1, k * len(accelerations) // frames)]
            place += speed * h + a * h * h / 2
            speed += a * h
        return self.verdict(SOURCE / "fixtures/canonical/ramp_20_03.toml", self.file("m.csv", end.join(rows)),
                            "--tolerance", more.get("tolerance", 0.01))[0]

    def test_a_wrong_acceleration_is_seen_in_dense_frames_and_small_ones_at_small_tolerances(self):
        a = 9.81 * (math.sin(math.radians(20)) - 0.3 * math.cos(math.radians(20)))
        for frames in (20, 200, 2000, 10000):
            self.assertEqual(self.slide([a], frames)["verdict"], "follows", frames)
            for part in (0, 0.7, 1.5, 2, 10):
                for speeds in (False, True):
                    self.assertEqual(self.slide([part * a], frames, speeds=speeds)["verdict"], "differs", (frames, part))
        for tolerance in (1e-6, 1e-4, 0.01):
            self.assertEqual(self.slide([a], 200, tolerance=tolerance)["verdict"], "follows", tolerance)
            for part in (0.88, 1.12):
                for speeds in (False, True):
                    report = self.slide([part * a], 200, speeds=speeds, tolerance=tolerance)
                    self.assertEqual(report["verdict"], "differs", (part, speeds, tolerance))
        # It starts late, forgets friction at first, or gravity at last.
        for parts in ((0, 1, 1, 1, 1), (5, 1, 1, 1, 1), (1, 1, 1, 1, 0)):
            self.assertEqual(self.slide([part * a for part in parts], 400)["verdict"], "differs", parts)

    def test_friction_that_drives_back_what_it_has_stopped_is_seen(self):
        cube, a = SOURCE / "fixtures/canonical/thrown_cube.toml", 0.5 * 9.81  # 6 m/s: it rests after 1.22 s
        for end, verdict in ((1.2, "follows"), (1.5, "differs"), (1.8, "differs")):
            rows = ["time,x,y,z"] + [f"{t},{6 * t - a * t * t / 2},0,0" for t in (k / 200 for k in range(int(200 * end)))]
            self.assertEqual(self.verdict(cube, self.file("m.csv", "\n".join(rows)))[0]["verdict"], verdict, end)

    def test_files_as_spreadsheets_and_csv_writers_have_them(self):
        a = 9.81 * (math.sin(math.radians(20)) - 0.3 * math.cos(math.radians(20)))
        for head, end in (("", "\r\n"), ("\ufeff", "\n"), ("# a log\n\n", "\n")):
            self.assertEqual(self.slide([a], 100, head=head, end=end)["verdict"], "follows", (head, end))
        rows = [f"{t},{a * t * t / 2},0,0" for t in (k / 100 for k in range(40))]
        for text in ('"time","x","y","z"\n' + "\n".join(rows), "\n".join(["time,x,y,z", *rows]).replace(",", "\t")):
            scene = SOURCE / "fixtures/canonical/ramp_20_03.toml"
            self.assertEqual(self.verdict(scene, self.file("m.csv", text))[0]["verdict"], "follows", text[:20])

    def test_too_few_digits_are_told(self):
        a = 9.81 * (math.sin(math.radians(20)) - 0.3 * math.cos(math.radians(20)))
        report = self.slide([a], 1000, digits=".6f")
        self.assertEqual((report["verdict"], report["coarse"]), ("stopped", True))
        self.assertIn("Places end at 0.001 mm", report["hint"])

    def columns(self, scene, names, digits=None, by=(), *words):
        """lcpush's own motion: these columns in so many digits, some times a thousand."""
        rows = list(csv.DictReader(run("move", scene, "--time", 0.5, "--format", "csv", *words).stdout.splitlines()))
        cell = (lambda name, value: f"{value * (1000 if name in by else 1):.{digits or 17}{'f' if digits else 'g'}}")
        return self.file("m.csv", "\n".join([",".join(names)] + [",".join(cell(n, float(row[n])) for n in names) for row in rows]))

    def test_rotations_in_the_digits_that_engines_print(self):
        for digits, verdict, said in ((6, "follows", None), (5, "stopped", "Places end at 0.01 mm"), (4, "stopped", "Places end at 0.1 mm")):
            for names in (POSE, POSE + SPEEDS):
                report, _ = self.verdict(PIVOT, self.columns(PIVOT, names, digits, (), "--frames", 201))
                self.assertEqual(report["verdict"], verdict, (digits, len(names)))
                self.assertIn(said or "", report["hint"] or "")
        coin = SOURCE / "fixtures/canonical/spinning_disc.toml"  # which turns in place
        self.assertIn("Rotations end at 0.0001 and", self.verdict(coin, self.columns(coin, POSE, 4, (), "--frames", 1001))[0]["hint"])

    def test_millimetres_beside_metres_and_milliseconds_are_told(self):
        for by, words in ((("x", "y", "z"), "look like millimetres"), (("x", "y", "z", "vx", "vy", "vz"), "look like millimetres"),
                          (("time",), "look like milliseconds")):
            for name in ("pivot", "tipping"):
                scene = SOURCE / f"fixtures/scenes/{name}.toml"
                self.assertIn(words, self.verdict(scene, self.columns(scene, POSE + SPEEDS, None, by, "--frames", 101))[0]["hint"], (by, name))

    def test_changes_of_what_goes_far_in_millimetres_are_not_followed(self):
        scene = SOURCE / "fixtures/canonical/thrown_cube.toml"  # 6000 m/s, as it reads
        motion = self.columns(scene, POSE + SPEEDS, None, ("x", "y", "z", "vx", "vy", "vz"), "--frames", 201)
        report = self.verdict(scene, motion)[0]
        self.assertIn("look like millimetres", report["hint"])
        self.assertIsNone(report["missed_change"])
        self.assertNotIn("Changes ", run("verify", scene, "--trajectory", motion, "--seconds", 600).stdout)

    def test_a_landing_just_before_a_frame_follows(self):
        tray, beyond = (SOURCE / f"fixtures/canonical/{name}.toml" for name in ("tray_tips", "beyond_the_grip"))
        for frames in (201, 401):  # 18 us before the frame at 0.4475 s
            self.assertEqual(self.verdict(tray, self.columns(tray, POSE + SPEEDS, None, (), "--frames", frames))[0]["verdict"], "follows")
        for names in (POSE, POSE + SPEEDS):  # where nobody says how far what presses has closed
            self.assertEqual(self.verdict(beyond, self.columns(beyond, names, None, (), "--frames", 31))[0]["verdict"], "follows")
        for name, frames in (("pendulum", 61), ("ramp_tips", 61), ("thrown_up", 401)):
            scene = SOURCE / f"fixtures/canonical/{name}.toml"
            self.assertEqual(self.verdict(scene, self.columns(scene, POSE, None, (), "--frames", frames))[0]["verdict"], "follows", name)

    def test_a_pusher_does_not_go_through_an_object_whenever_the_log_begins(self):
        fence = SOURCE / "fixtures/canonical/fence.toml"
        for since in (0, 1, 100):
            rows = ["time,x,y,z"] + [f"{t},0,0,0" for t in range(since, since + 60)]
            self.assertEqual(self.verdict(fence, self.file("m.csv", "\n".join(rows)))[0]["verdict"], "differs", since)

    def test_positions_of_another_origin_are_judged_from_their_first_on(self):
        right = 9.81 - 2 * 0.3 * 2 / 0.2
        for start in ((0.5, 0.3, 0.01), (0, 0, 0.01), (-3, 0, 0)):
            report, text = self.fall(right, 0.06, 61, start)
            self.assertEqual((report["verdict"], report["offset"]), ("follows", list(start)))
            self.assertIn("Begins", text)
        self.assertIsNone(self.fall(right, 0.06, 61)[0]["offset"])
        moved = json.loads(self.own("--json"))
        for frame in moved["frames"]:
            frame["position"][2] += 0.01
        report, _ = self.verdict(PIVOT, self.file("m.json", json.dumps(moved)))
        self.assertEqual((report["verdict"], report["forces"]["broken"]), ("follows", None))
        late = json.loads(self.own("--json"))
        late["frames"] = late["frames"][30:]  # which is no start
        report, _ = self.verdict(PIVOT, self.file("m.json", json.dumps(late)))
        self.assertEqual((report["verdict"], report["offset"]), ("follows", None))

    def test_short_first_steps_follow(self):
        rod = self.file("rod.toml", """facets = 8
planar = true
[object]
mass = 0.23
box = [0.107, 0.0316, 0.012]
""" + "".join(f"""[[finger]]
name = "{name}"
normal = [0, 0, {-side}]
friction = 0.52
grip_force = 26.3
shape = "line"
ends = [[0.0053, -0.0028, {0.006 * side}], [0.0153, -0.0028, {0.006 * side}]]
""" for name, side in (("left", 1), ("right", -1))) + """[[pusher]]
name = "rod"
friction = 0.127
normal = [0, 1, 0]
velocity = [0.0025, 0.0147, 0]
shape = "point"
center = [-0.0109, -0.0158, 0]
""")
        for time, frames in ((0.3, 41), (0.3, 101), (1, 101)):
            motion = run("move", rod, "--time", time, "--frames", frames, "--json").stdout
            self.assertEqual(self.verdict(rod, self.file("m.json", motion))[0]["verdict"], "follows", (time, frames))

    def test_without_velocities_too(self):
        motion = json.loads(self.own("--json"))
        for frame in motion["frames"]:
            del frame["twist"]
        report, _ = self.verdict(PIVOT, self.file("m.json", json.dumps(motion)))
        self.assertEqual((report["verdict"], report["steps"]), ("follows", 79))

    def test_what_is_planted_is_found_where_it_is(self):
        motion = json.loads(self.own("--json"))
        motion["frames"][40]["position"][0] += 1e-4
        report, code = self.verdict(PIVOT, self.file("m.json", json.dumps(motion)))
        self.assertEqual((report["verdict"], code), ("differs", 1))
        self.assertAlmostEqual(report["worst"], 1e-4 / 0.005, delta=1e-3)
        self.assertIn(round(report["worst_time"], 6), (0.2, 0.205))

    def test_creep_is_told_from_friction(self):
        scene = self.file("held.toml", HELD)
        rows = [f"{k / 10},0,{-155e-6 * k / 10},0,1,0,0,0" for k in range(11)]
        motion = self.file("m.csv", "\n".join(["time,x,y,z,qw,qx,qy,qz", *rows]))
        report, code = self.verdict(scene, motion)
        self.assertEqual((report["verdict"], code), ("creeps", 1))
        self.assertAlmostEqual(report["creep"], 155e-6, delta=1e-9)
        # 2 mu F over the weight.
        self.assertAlmostEqual(report["held"], 2 * 0.7 * 12 / (0.045 * 9.81), delta=0.01)
        self.assertIn("creeps", run("verify", scene, "--trajectory", motion).stdout)
        still = self.file("s.csv", "\n".join(["time,x,y,z,qw,qx,qy,qz", "0,0,0,0,1,0,0,0",
                                              "0.1,0,0,0,1,0,0,0", "0.2,0,0,0,1,0,0,0"]))
        self.assertEqual(self.verdict(scene, still)[0]["verdict"], "follows")

    def test_turns_about_the_line_of_all_contact_points_are_seen(self):
        head = "time,x,y,z,qw,qx,qy,qz"
        for name, time, spin in (("pendulum", 0.2, 0), ("soft_spin_down", 0.05, 20), ("bowling_ball", 0.2, 0)):
            scene = SOURCE / f"fixtures/canonical/{name}.toml"
            own = run("move", scene, "--time", time, "--frames", 101, "--json").stdout
            self.assertEqual(self.verdict(scene, self.file("own.json", own))[0]["verdict"], "follows", name)
            # It hangs still, or does not stop; and a ball that turns about the vertical with nothing that turns it.
            about = "0,0,{s}" if name == "soft_spin_down" else "0,{s},0"
            rows = []
            for frame in json.loads(own)["frames"]:
                half = (50 if name == "bowling_ball" else spin) * frame["time"] / 2
                place = frame["position"] if name == "bowling_ball" else (0, 0, 0)
                turn = f"{math.cos(half)},{about.format(s=math.sin(half))}"
                rows.append(f"{frame['time']},{place[0]},{place[1]},{place[2]},{turn}")
            report, code = self.verdict(scene, self.file("wrong.csv", "\n".join([head, *rows])))
            self.assertEqual((report["verdict"], code), ("differs", 1), name)

    def test_files_that_are_none_are_refused_with_their_line(self):
        head = "time,x,y,z,qw,qx,qy,qz\n"
        for text, line, message in (
                ("", 1, "no motion"), ("time,x,y,z,qw\n", 1, "half a rotation"),
                (head + "0,0,0,0,1,0,0\n", 2, "names 8 columns, this one has 7"),
                (head + "0,0,0,x,1,0,0,0\n", 2, "z: "),
                ("time,x,y,z,vx,vy,vz\n", 1, "half a velocity"), ("time,x,y,z,roll\n", 1, '"roll": a turn is told by r11'), ("time,x,y,z,edge_fx\n", 1, 'write "edge.fx"'),
                (head + 2 * "0,0,0,0,1,0,0,0\n" + "1,0,0,0,1,0,0,0\n", 3, "time must grow"),
                (head + "0,0,0,0,1,0,0,0\n", 1, "two frames or more"),
                (head + "0,0,0,0,1,0,0,0\n1,1,0,0,1,0,0,0\n", 1, "without velocities a motion needs three"),
                (head + "0,0,0,0,0,0,0,0\n1,0,0,0,1,0,0,0\n2,0,0,0,1,0,0,0\n", 2, "not orthonormal"),
                ("{}", 1, 'give "frames"'),
                ('{"frames": [{"time": 0}]}', 1, 'a frame needs "time"')):
            result = run("verify", PIVOT, "--trajectory", self.file("m.txt", text))
            self.assertEqual((result.returncode, result.stdout), (2, ""), text)
            self.assertIn(f"m.txt:{line}: ", result.stderr)
            self.assertIn(message, unwrapped(result.stderr))
        result = run("verify", PIVOT, PIVOT, "--trajectory", "m.txt")
        self.assertIn("one file beside it", result.stderr)


main()
