"""The Python package and what a person types wrong: every error says what, where, and in the words of
Python's interface."""
import pathlib
import sys
import tempfile
import unittest

from built import lcpush

M, Q = [[2, 1], [1, 2]], [-5, -6]
NAN, INFINITY = float("nan"), float("inf")


def sweep(*words, **more):
    return lambda scene: scene.sweep("left.friction", *words, **more)


IN_SCENES = {  # what is asked of a scene: words that the error has
    "must be a string": lambda scene: scene.solve(solver=3),
    'did you mean "lemke"': lambda scene: scene.solve(solver="lemk"),
    'did you mean "wall"': lambda scene: scene.break_(pusher="wal"),
    'did you mean "left.friction"': lambda scene: scene.report(vary=("left.frction", 1, 2)),
    "start must be finite, not nan": sweep(NAN, 1),
    "stop must be a number, not 'a'": sweep(0.1, "a"),
    "are the same": sweep(1, 1),
    "from 2 to 1000000, not \"1\"": sweep(0.1, 1, steps=1),
    "a whole number from 2 to 1000000, not \"2.5\"": sweep(0.1, 1, steps=2.5),
    "fit into 1 GB": sweep(0.1, 1, steps=1_000_000),
    "over must be (": sweep(0.1, 1, over=("right.friction", 0.1)),
    "left.friction would change nothing: *.friction": sweep(0.1, 1, over=("*.friction", 0.1, 1)),
    "left.friction would change nothing: left": sweep(0.1, 1, each=("left.friction", [0.1, 1])),
    "each's values must be a vector, not 8": sweep(0.1, 1, each=("facets", 8)),
    "curves cannot be told apart": sweep(0.1, 1, each=("facets", range(4, 80, 2))),
    'a map is of one scene: leave out the second "vary", or "each"':
        sweep(0.1, 1, each=("facets", [4, 8]), over=("object.mass", 1, 2)),
    "from 4 to 256, got 3": sweep(0.1, 1, each=("facets", [3])),
    '"pressure" is pad, even or rigid, not "soft"': sweep(0.1, 1, pressure="soft"),
    '"time" is a number between 0 and 1e+06': lambda scene: scene.move(time=-1),
    "time must be finite, not inf": lambda scene: scene.move(time=INFINITY),
    "give one of the two": lambda scene: scene.move(time=1, step=0.1, tolerance=1e-3),
    "answer:1: an answer is a JSON object, got a number": lambda scene: scene.verify(5),
    "must be an array of 6 numbers, got 3":
        lambda scene: scene.verify({"object": {"acceleration": [1, 2, 3]}}),
    "is no number, text, list or dictionary":
        lambda scene: scene.verify({"object": {"acceleration": {1, 2}}}),
    "NaN is no JSON": lambda scene: scene.verify({"object": {"acceleration": [NAN] * 6}}),
    "of a file: pathlib.Path('a.json')": lambda scene: scene.verify("a.json"),
    "of a file: pathlib.Path('a.csv')": lambda scene: scene.verify_motion("a.csv"),
    "this is no answer: keys must be": lambda scene: scene.verify({("a", 1): 2}),
    "motion:1: a motion needs two frames": lambda scene: scene.verify_motion([]),
    "all three numbers are 0": lambda scene: scene.cone((0, 0, 0)),
    "twist must be a vector, not 5": lambda scene: scene.cone(5),
    '"to" must be an array of 3 numbers, got 2': lambda scene: scene.plan((1, 2)),
    """"set" 'object.mas="1 g"': no key "mas" """: lambda scene: scene.with_values({"object.mas": "1 g"}),
    '"picture" is isometric, front': lambda scene: scene.picture("fron"),
    '"facets" is an even number from 4': lambda scene: scene.pivots(facets=5),
    '"exact" would change that': lambda scene: scene.pivots(exact=True, as_solved=True),
    "even does not go with parallel jaws": lambda scene: scene.pivots(pressure="even"),
    '"pusher" goes with "break"': lambda scene: scene.certify(pusher="wall"),
}

OF_FINGERS = {  # another value of the first finger's friction, or another key
    "finger[0]: friction must be finite, not nan": {"friction": NAN},
    "friction must be a number, got the text": {"friction": "0.5"},
    "friction must be >= 0": {"friction": -0.5},
    "finger[0]: friction must be a number, a text": {"friction": 1j},
    "missing key \"friction\"": {"friction": None},
    "finger[0]: normal[1] must be a number, a text": {"normal": [0, {}, -1]},
    "did you mean \"friction\"": {"fricton": 0.5},
    "'fr iction' is no key of a scene": {"fr iction": 0.5},
}

OF_PROBLEMS = {
    "M must be a matrix: a list of rows": lambda: lcpush.lcp(5, [1]),
    "M[0, 0] must be a number, not 'abc'": lambda: lcpush.lcp("abc", [1]),
    "M must be a list of rows, but 1 is no row": lambda: lcpush.lcp([1, 2], Q),
    "row 0 has 2 numbers, row 1 has 1": lambda: lcpush.lcp([[1, 2], [3]], Q),
    "M[0, 1] must be a number, not 'a'": lambda: lcpush.lcp([[1, "a"], [1, 2]], Q),
    "M[1, 0] must be finite, not nan": lambda: lcpush.lcp([[1, 0], [NAN, 2]], Q),
    "M must be square, but it is 1 x 2": lambda: lcpush.lcp([[1, 2]], [1]),
    "M must be square, but it is 0 x 0": lambda: lcpush.lcp([], []),
    "q must be a vector, not None": lambda: lcpush.lcp(M, None),
    "q must have 2 numbers, one a row of M, not 3": lambda: lcpush.lcp(M, [1, 2, 3]),
    "q[1] must be finite, not inf": lambda: lcpush.lcp(M, [1, INFINITY]),
    "z must have 2 numbers": lambda: lcpush.check(M, Q, [1]),
    "tolerance must be finite, not nan": lambda: lcpush.check(M, Q, Q, tolerance=NAN),
    "z[1] must be finite": lambda: lcpush.check(M, Q, [1, NAN]),
    "free must hold rows from 0 to 1, not 2": lambda: lcpush.lcp(M, Q, free=[2]),
    "free must hold rows from 0 to 1, not -1": lambda: lcpush.lcp(M, Q, free=[-1]),
    "whole numbers from 0, not True": lambda: lcpush.lcp(M, Q, free=[True, False]),
    "free must be a list of rows, not 1": lambda: lcpush.lcp(M, Q, free=1),
    "lo[0] is inf": lambda: lcpush.lcp(M, Q, lo=INFINITY),
    "lo must have 2 numbers": lambda: lcpush.lcp(M, Q, lo=[0, 0, 0]),
    "row 1 (counted from 1): the lower end 2 is above": lambda: lcpush.lcp(M, Q, lo=2, hi=1),
    "row 1 (counted from 1) has 0": lambda: lcpush.lcp([[0, 1], [1, 2]], Q, solver="gauss-seidel"),
    '"solver" is lemke': lambda: lcpush.lcp(M, Q, solver="newton"),
    '"q" must have a number a row': lambda: lcpush.pivots([[1]], [1, 2]),
    '"x" is not a number': lambda: lcpush.pivots([["x"]], [1]),
}


class Mistakes(unittest.TestCase):
    def refused(self, call, *words):
        with self.assertRaises(lcpush.InputError) as caught:
            call()
        for word in words:
            self.assertIn(word, str(caught.exception))
        # Whoever calls Python has written no request, and has not counted its lines.
        self.assertNotIn("request", str(caught.exception))
        self.assertNotEqual(caught.exception.file, "request")
        return caught.exception

    def test_in_questions_are_named(self):
        scene = lcpush.read("fixtures/scenes/straight_slide.toml")
        for words, ask in IN_SCENES.items():
            with self.subTest(words):
                self.refused(lambda ask=ask: ask(scene), words)

    def test_in_dictionaries_are_named(self):
        tables = lcpush.read("fixtures/scenes/straight_slide.toml").to_dict()
        first, other = tables["finger"]
        for words, change in OF_FINGERS.items():
            with self.subTest(words):
                self.refused(lambda c=change: lcpush.Scene({**tables, "finger": [{**first, **c}, other]}),
                             words)
        for words, source in {"not NoneType": None, "missing the table [object]": {"object": 5},
                              "did you mean \"finger\"": {**tables, "fingr": [{}]},
                              "finger[0] must be": {**tables, "finger": [first, 5]},
                              "lcpush.read('a.toml')": "a.toml"}.items():
            with self.subTest(words):
                self.refused(lambda s=source: lcpush.Scene(s), words)

    def test_in_raw_problems_are_named(self):
        for words, call in OF_PROBLEMS.items():
            with self.subTest(words):
                self.refused(call, words)

    def test_in_arrays_are_named(self):
        try:
            import numpy
            from scipy import sparse
        except ImportError:
            self.skipTest("SciPy is not installed")
        holed = numpy.array([[1, NAN], [0, 1]])
        for matrix in (holed, sparse.csr_matrix(holed), holed.tolist()):
            self.refused(lambda m=matrix: lcpush.lcp(m, Q), "M[0, 1] must be finite, not nan")
        self.refused(lambda: lcpush.lcp(numpy.array(M) * 1j, Q), "M[0, 0] must be a number, not 2j")
        self.refused(lambda: lcpush.lcp(M, Q, free=numpy.array([True, False])), "not True")
        scene = lcpush.read("fixtures/scenes/straight_slide.toml")
        self.assertEqual(len(scene.sweep("left.friction", numpy.float32(0.25), numpy.float64(1),
                                         steps=numpy.int64(3)).values), 3)

    def test_in_files_have_their_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "mine.toml")
            path.write_bytes(b'title = "a"\n\xff\xfe\n')
            error = self.refused(lambda: lcpush.read(path), "is no UTF-8 text")
            self.assertEqual((error.file, error.line), (str(path), 2))
            self.assertRaises(FileNotFoundError, lcpush.read, pathlib.Path(folder, "none.toml"))

    def test_in_names_list_what_there_is(self):
        scene = lcpush.read("fixtures/scenes/straight_slide.toml")
        self.assertRaisesRegex(AttributeError, "has bodies, contacts", getattr, scene.solve(), "forces")
        self.assertRaisesRegex(KeyError, "left, right, wall", scene.solve().body, "wal")
        curves = scene.sweep("left.friction", 0.1, 1, steps=3, each=("facets", [4, 8]))
        self.refused(lambda: curves.values, "ask one of its `curves`")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
