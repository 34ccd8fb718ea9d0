"""Numbers as the Python package takes and gives them: lists, NumPy's arrays, SciPy's sparse matrices, and
what only looks like one of these."""
import array
import decimal
import fractions
import math
import sys
import unittest

from built import lcpush

SLIDE = "fixtures/scenes/straight_slide.toml"
M, Q, Z = [[2, 1], [1, 2]], [-5, -6], [4 / 3, 7 / 3]


class Frame:
    """As pandas' DataFrame: what it goes through are its columns' names."""

    def __init__(self, numbers):
        self.numbers = numbers

    def __iter__(self):
        return iter(["a", "b"])

    def mask(self):
        """pandas has a method of that name."""

    def __array__(self, dtype=None, copy=None):
        return self.numbers


class Lists(unittest.TestCase):
    def test_of_every_kind_are_read(self):
        numbers = ([decimal.Decimal(2), fractions.Fraction(1)], (1, 2.0))
        for matrix, q in ((M, tuple(Q)), (numbers, range(-5, -7, -1)), ((iter(row) for row in M), Q),
                          (M, array.array("d", Q))):
            answer = lcpush.lcp(matrix, q)
            self.assertTrue(lcpush.check(M, Q, answer.z))
        self.assertLess(lcpush.lcp(M, [5, -6], free={0}).z[0], 0)
        for none in (None, -math.inf):
            self.assertLess(lcpush.lcp(M, [5, -6], lo=[none, 0], hi=None).z[0], 0)

    def test_boxes_follow_rows_and_sweeps_are_asked_for(self):
        box = ([[2, 0], [0, 2]], [-5, -3])
        for findex in ([-1, 0], (None, 0)):
            for options in ({}, {"solver": "gauss-seidel", "sweeps": 100, "relaxation": 1.2}):
                answer = lcpush.lcp(*box, hi=[math.inf, 0.5], findex=findex, **options)
                self.assertEqual([round(float(z), 9) for z in answer.z], [2.5, 1.25])
                self.assertTrue(lcpush.check(*box, answer.z, hi=["Inf", 0.5], findex=findex))
        self.assertRaisesRegex(lcpush.NotSolved, "limit of sweeps", lcpush.lcp, [[2, 1], [1, 2]], Q,
                               solver="gauss-seidel", sweeps=1)
        for end in (1e15, 1e20, 1e30, math.inf, "inf", "Inf", None):
            lo = [-end if isinstance(end, float) else None if end is None else f"-{end}"] * 2
            self.assertEqual(lcpush.lcp(M, Q, lo=lo, hi=[end, end])["at"], ["between", "between"])
        self.assertEqual(list(lcpush.lcp("[2 1; 1 2]", "[-5; -6]").z), list(lcpush.lcp(M, Q).z))

    def test_that_are_empty_are_no_gravity(self):
        tables = {**lcpush.read(SLIDE).to_dict(), "gravity": []}
        self.assertRaisesRegex(lcpush.InputError, "gravity", lcpush.Scene, tables)

    def test_without_an_order_are_refused(self):
        for matrix, q in ((M, {-5, -6}), ([{1, 2}, {3, 4}], Q), ({0: 1}, [1]), (M, b"ab")):
            self.assertRaises(lcpush.InputError, lcpush.lcp, matrix, q)
        tables = lcpush.read(SLIDE).to_dict()
        tables["object"]["mass"] = b"0.2"
        self.assertRaisesRegex(lcpush.InputError, "not b'0.2'", lcpush.Scene, tables)


class Arrays(unittest.TestCase):
    def test_of_numpy_and_scipy_come_and_go(self):
        try:
            import numpy
            from scipy import sparse
        except ImportError:
            self.skipTest("SciPy is not installed")
        M, q = numpy.array([[2.0, 1], [1, 2]]), numpy.array([[-5.0], [-6]])
        twice = sparse.coo_matrix(([1, 1, 1, 1, 2], ([0, 0, 0, 1, 1], [0, 0, 1, 0, 1])))
        for matrix in (M, M.astype(int), sparse.csr_matrix(M), sparse.csc_matrix(M), twice):
            answer = lcpush.lcp(matrix, q)
            self.assertEqual((answer.z.shape, answer.z.dtype), ((2,), numpy.dtype(float)))
            self.assertTrue(numpy.allclose(answer.w, M @ answer.z + q.ravel()))
            self.assertTrue(lcpush.check(matrix, q, answer.z))
        scene = lcpush.read(SLIDE)
        solution, motion = scene.solve(), scene.move(time=0.1, frames=4)
        n = len(solution.names)
        for array, shape in ((solution.M, (n, n)), (solution.q, (n,)),
                             (solution.acceleration, (6,)), (solution.bodies[0].force, (3,)),
                             (motion.times, (4,)), (motion.positions, (4, 3)),
                             (motion.rotations, (4, 3, 3)), (motion.twists, (4, 6)),
                             (scene.sweep("*.grip_force", 5, 30, pressure="rigid").force, (8, 3))):
            self.assertEqual(array.shape, shape)
        own = scene.to_dict()
        own["pusher"][0]["acceleration"] = numpy.array([0.2, 0, 0])
        own["finger"][0]["friction"] = numpy.float64(0.5)
        self.assertAlmostEqual(lcpush.Scene(own).solve().acceleration[0], 0.2, places=9)
        given = {"object": {"acceleration": solution.acceleration},
                 "contacts": [contact.to_dict() for contact in solution.contacts]}
        self.assertTrue(scene.verify(given))

    def test_of_every_layout_are_the_same(self):
        try:
            import numpy
            from scipy import sparse
        except ImportError:
            self.skipTest("SciPy is not installed")
        A, q = numpy.array(M, float), numpy.array(Q, float)
        wide = numpy.zeros((4, 4))
        wide[::2, ::2] = A
        given = [wide[::2, ::2], numpy.asfortranarray(A), A.astype("f2"), A.astype(">f8"), A.astype("u1"),
                 A.astype(object), A.astype(numpy.longdouble), numpy.ma.array(A), Frame(A),
                 sparse.csr_matrix(A).todense(), sparse.csr_array(A)]
        given += [sparse.csr_matrix(A).asformat(name)
                  for name in ("bsr", "coo", "csc", "csr", "dia", "dok", "lil")]
        for matrix in given:
            self.assertEqual(lcpush.lcp(matrix, q).json, lcpush.lcp(M, Q).json, type(matrix))
            self.assertTrue(lcpush.check(matrix, numpy.asmatrix(q), numpy.asmatrix(Z).T))
        self.assertEqual(lcpush.pivots(Frame(A), q).json, lcpush.pivots(A.tolist(), q.tolist()).json)
        before = sparse.coo_matrix(([1.0, 1, 2, 1, 1], ([0, 0, 1, 0, 1], [0, 0, 1, 1, 0])))
        lcpush.lcp(before, q)
        self.assertEqual(before.nnz, 5)  # it is left as it was

    def test_that_are_not_plain_matrices_are_refused(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("NumPy is not installed")
        A = numpy.array(M, float)
        for matrix, words in ((numpy.ma.array(A, mask=[[0, 1], [0, 0]]), "M has masked entries"),
                              (A[None], "M must be a matrix"), (A[0], "M must be a matrix"),
                              (numpy.array(2.0), "M must be a matrix")):
            self.assertRaisesRegex(lcpush.InputError, words, lcpush.lcp, matrix, Q)
            self.assertRaisesRegex(lcpush.InputError, words, lcpush.pivots, matrix, Q)
        masked = numpy.ma.array(Z, mask=[0, 1])
        self.assertRaisesRegex(lcpush.InputError, "z has masked entries", lcpush.check, M, Q, masked)

    def test_of_a_map_are_columns(self):
        sweep = lcpush.read(SLIDE).sweep("wall.friction", 0.1, 0.3, steps=3,
                                         over=("left.friction", 0.2, 0.4))
        for k, point in enumerate(sweep.points):
            self.assertEqual((sweep.values[k], sweep.second_values[k], sweep.break_force[k]),
                             (point.value, point.second_value, point.break_force))
        self.assertAlmostEqual(sweep.values[1], 0.2, places=12)
        self.assertAlmostEqual(sweep.second_values[3], 0.3, places=12)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
