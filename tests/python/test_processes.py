"""The Python package where processes and threads begin and end.

    python3 test_processes.py TOOL LIBRARY SOURCE
"""
import os
import pathlib
import subprocess
import sys
import unittest

LIBRARY, SOURCE = sys.argv[2], pathlib.Path(sys.argv[3])
BEGIN = """
import atexit, multiprocessing, os, signal, sys, threading, time
import lcpush
scene = lcpush.read("fixtures/scenes/straight_slide.toml")
"""
LONG = 'scene.sweep("left.friction", 0.1, 1.0, steps=200_000'


class Processes(unittest.TestCase):
    def said(self, program):
        """What it prints; it has to end well, and soon."""
        result = subprocess.run([sys.executable, "-B", "-W", "ignore::DeprecationWarning",  # of forks
                                 "-c", BEGIN + program], cwd=SOURCE,
                                capture_output=True, text=True, timeout=60,
                                env={**os.environ, "LCPUSH_LIBRARY": LIBRARY,
                                     "PYTHONPATH": str(SOURCE / "src/python")})
        self.assertEqual((result.returncode, result.stderr), (0, ""), program)
        return result.stdout

    def test_end_while_a_thread_asks(self):
        for more in ("", ", progress=lambda done: None"):
            self.assertEqual(self.said("threading.Thread(target=lambda: " + LONG + more + "), daemon=True)"
                                       ".start(); time.sleep(0.3); print('over')"), "over\n")

    def test_end_while_work_goes_on_that_was_left(self):
        self.assertEqual(self.said("""
def end(done):
    raise SystemExit
atexit.register(print, "over")
""" + LONG + ", progress=end)"), "over\n")

    def test_are_interrupted_at_any_moment(self):
        said = self.said("""
right = scene.solve().json
begin = time.monotonic()
for _ in range(20):
    scene.solve()
takes = (time.monotonic() - begin) / 20
asks, interrupted = False, 0

def interrupt(*_):
    global asks
    if asks:
        asks = False
        raise KeyboardInterrupt

signal.signal(signal.SIGALRM, interrupt)
signal.setitimer(signal.ITIMER_REAL, takes, 1.1 * takes)
end = time.monotonic() + 3
while time.monotonic() < end:
    try:
        asks = True
        found = scene.solve().json
        asks = False
        assert found == right
    except KeyboardInterrupt:
        interrupted += 1
signal.setitimer(signal.ITIMER_REAL, 0)
assert scene.solve().json == right
print(interrupted > 10)
""")
        self.assertEqual(said, "True\n")

    def test_ask_in_their_last_moments(self):
        said = self.said("""
class Last:
    def __del__(self):
        print(scene.solve())
last = Last()
atexit.register(lambda: print(scene.solve()))
""")
        self.assertEqual(said.count("Push with 20.1 N"), 2, said)

    def test_ask_after_a_fork(self):
        if not hasattr(os, "fork"):
            self.skipTest("nothing forks here")
        said = self.said("""
scene.solve()
threading.Thread(target=lambda: """ + LONG + """), daemon=True).start()
time.sleep(0.1)
child = os.fork()
print(scene.solve(), flush=True)
if child:
    assert os.waitpid(child, 0)[1] == 0
""")
        self.assertEqual(said.count("Push with 20.1 N"), 2, said)

    def test_send_each_other_answers_and_errors(self):
        said = self.said("""
if __name__ == "__main__":
    jam = lcpush.read("fixtures/scenes/jam.toml")
    with multiprocessing.Pool(2) as pool:
        print(*pool.map(lcpush.Scene.break_, [scene] * 3))
        for call, words in ((lcpush.Scene.solve, (jam,)), (lcpush.Scene, ("[object]\\\\n", "a.toml"))):
            try:
                pool.apply(call, words)
            except lcpush.NotSolved as error:
                print(error.status, error.ray[0]["name"])
            except lcpush.InputError as error:
                print(error.file, error.line)
""")
        self.assertEqual(said.count("The grasp breaks at 20 N"), 3)
        self.assertRegex(said, r"\nray \w.*\na\.toml \d\n")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
