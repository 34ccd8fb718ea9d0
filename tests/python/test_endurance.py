"""The Python package under strain: eight threads, a thousand solves, and Ctrl-C."""
import os
import pathlib
import resource
import signal
import sys
import threading
import time
import unittest

from built import lcpush
from lcpush import _library

SLIDE = "fixtures/scenes/straight_slide.toml"
LONG = ("left.friction", 0.1, 1.0)  # 200,000 values of it take a minute


def resident():
    """Bytes of memory in use now."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


class Threads(unittest.TestCase):
    def test_eight_ask_at_once_and_get_what_one_gets(self):
        scenes = [lcpush.read(str(path))
                  for path in sorted(pathlib.Path("fixtures/scenes").glob("*.toml"))[:8]]
        alone = [scene.solve(check=False).json for scene in scenes]
        wrong = []

        def work(first):
            for k in range(first, first + 24):
                i = k % len(scenes)
                if scenes[i].solve(check=False).json != alone[i]:
                    wrong.append(scenes[i].title)
                try:
                    lcpush.Scene("[object]\n", f"{first}.toml")
                    wrong.append("no error")
                except lcpush.InputError as error:
                    if error.file != f"{first}.toml":
                        wrong.append(str(error))

        threads = [threading.Thread(target=work, args=(k,)) for k in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


class Memory(unittest.TestCase):
    def test_is_flat_over_a_thousand_solves(self):
        scene = lcpush.read(SLIDE)

        def some(count):
            for _ in range(count):
                scene.solve()
                try:
                    lcpush.Scene("[object]\nmass = -1\n")
                except lcpush.InputError:
                    pass

        some(200)
        before = resident()
        some(1000)
        self.assertLess(resident() - before, 500_000)


class Interrupts(unittest.TestCase):
    def setUp(self):
        # A shell's background jobs are told to ignore Ctrl-C, and the tests with them.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)

    def ended_after(self, work, begun):
        """s, from Ctrl-C to its KeyboardInterrupt; `begun`: how long it may work before, s."""
        sent = []

        def press():
            time.sleep(begun)
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        presser = threading.Thread(target=press)
        presser.start()
        before = signal.getsignal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            work()
        ended = time.monotonic()
        presser.join()
        while _library._running:  # what could not end so soon would disturb the next
            time.sleep(0.01)
        self.assertIs(signal.getsignal(signal.SIGINT), before)
        return ended - sent[0]

    def test_end_long_work_soon(self):
        scene = lcpush.read(SLIDE)
        tables = scene.to_dict()
        for finger, z in zip(tables["finger"], (0.005, -0.005)):
            finger.update(shape="disc", center=[0, 0, z], radius=0.005, points=100)
        wide = lcpush.Scene({**tables, "facets": 32})  # each value takes half a second
        pivot = lcpush.read("fixtures/scenes/pivot.toml").to_dict()
        for finger, z in zip(pivot["finger"], (0.005, -0.005)):
            del finger["points"]
            finger.update(shape="disc", center=[0, 0, z], radius=0.005, points=90)
        searched = lcpush.Scene(pivot)  # a tenth of a second, most of it on other paths of pivots
        for finger in pivot["finger"]:
            finger["points"] = 20
        exact = lcpush.Scene(pivot)  # its pivots in fractions take many seconds
        tables["pusher"][0]["friction"] = 0.3
        for finger in tables["finger"]:
            finger["points"] = 400
        huge = lcpush.Scene({**tables, "facets": 64})  # nothing of these asks whether to go on
        works = (huge.certify, lambda: huge.move(time=1), lambda: scene.sweep(*LONG, steps=200_000),
                 lambda: wide.sweep(*LONG, steps=1000),
                 lambda: lcpush.read("docs/guide/held_box.toml").move(time=90, step=1e-4),
                 lambda: scene.spread(enumerate_all=True, seconds=60), lambda: exact.pivots(exact=True))
        for work, begun in (*((work, 0.5) for work in works), (searched.break_, 0.04)):
            # Another process may hold the processor just then: once of three has to be soon.
            self.assertTrue(any(self.ended_after(work, begun) < 0.2 for _ in range(3)))

    def test_are_what_a_handler_makes_of_them(self):
        """A signal's handler that raises ends the work, another does not."""
        scene, seen = lcpush.read(SLIDE), []

        def raises(*_):
            raise TimeoutError("enough")

        for handler in (seen.append, raises):
            before = signal.signal(signal.SIGALRM, lambda *_, f=handler: f(1))
            self.addCleanup(signal.signal, signal.SIGALRM, before)
            signal.setitimer(signal.ITIMER_REAL, 0.2)
            if handler is raises:
                with self.assertRaisesRegex(TimeoutError, "enough"):
                    scene.sweep(*LONG, steps=200_000)
            else:
                while not seen:
                    self.assertTrue(scene.sweep(*LONG, steps=100).complete)

    def test_come_from_progress_as_well(self):
        seen = []

        def stop(done):
            seen.append(done)
            if done > 0.001:
                raise ZeroDivisionError("enough")

        with self.assertRaisesRegex(ZeroDivisionError, "enough"):
            lcpush.read(SLIDE).sweep(*LONG, steps=200_000, progress=stop)
        self.assertTrue(seen and seen == sorted(seen) and seen[-1] < 0.5)

    def test_leave_progress_at_its_end(self):
        for work in (lcpush.read(SLIDE).solve, lcpush.read("docs/guide/square.toml").move):
            seen = []
            work(progress=seen.append)
            self.assertTrue(seen == sorted(seen) and seen[-1] == 1, seen)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
