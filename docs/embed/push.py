"""lcpush from Python by ctypes: how hard to push a bar through a grip of 20 N.

    python3 push.py LIBRARY        (a shared library of src/c/c_interface.cpp)
"""
import ctypes
import sys
from ctypes import POINTER, Structure, byref, c_char, c_char_p, c_double, c_int, c_size_t, c_void_p

Vec3, Vec6 = c_double * 3, c_double * 6


class Object(Structure):
    _fields_ = [("mass", c_double), ("inertia", c_double * 9), ("wrench", Vec6)]


class Body(Structure):
    _fields_ = [("role", c_int), ("normal", Vec3), ("tangent", Vec3), ("friction", c_double),
                ("torsion_radius", c_double), ("bilateral", c_int), ("first_point", c_int),
                ("point_count", c_int), ("acceleration", Vec6), ("preload", c_double)]


class Actuator(Structure):
    _fields_ = [("force", c_double), ("inertia", c_double)]


class Drive(Structure):
    _fields_ = [("body", c_int), ("actuator", c_int), ("twist", Vec6)]


class Point(Structure):
    _fields_ = [(axis, c_double) for axis in "xyz"]


class Scene(Structure):
    _fields_ = [("object", Object), ("gravity", Vec3), ("facets", c_int), ("pressure", c_int),
                ("planar", c_int), ("bodies", POINTER(Body)), ("body_count", c_int),
                ("points", POINTER(Point)), ("point_count", c_int),
                ("actuators", POINTER(Actuator)), ("actuator_count", c_int),
                ("drives", POINTER(Drive)), ("drive_count", c_int), ("weights", POINTER(c_double))]


class Size(Structure):
    _fields_ = [(name, c_int)
                for name in ("bodies", "points", "facets", "actuators", "drives", "pulls")]


FINGER, PUSHER, PAD, RUNNING, SOLVED = 0, 1, 0, 0, 1

lib = ctypes.CDLL(sys.argv[1])
lib.lcpush_make.restype = c_void_p
lib.lcpush_make.argtypes = [c_void_p, c_size_t, POINTER(Size)]
lib.lcpush_describe.argtypes = [c_void_p, POINTER(Scene)]
lib.lcpush_solve.argtypes = [c_void_p]
lib.lcpush_wrench_of.argtypes = [c_void_p, c_int, Vec6]
lib.lcpush_why.argtypes = [c_void_p]
lib.lcpush_mistake_text.restype = lib.lcpush_status_text.restype = c_char_p

# Two point fingers hold a bar of 0.2 kg; a smooth point pushes it with 0.1 m/s^2.
points = (Point * 3)((0, 0, 0.005), (0, 0, -0.005), (-0.05, 0, 0))
bodies = (Body * 3)(
    Body(FINGER, (0, 0, -1), (1, 0, 0), 0.5, 0, 0, 0, 1),
    Body(FINGER, (0, 0, 1), (1, 0, 0), 0.5, 0, 0, 1, 1),
    Body(PUSHER, (1, 0, 0), (0, 1, 0), 0, 0, 0, 2, 1, (0.1, 0, 0, 0, 0, 0)))
actuators = (Actuator * 2)((20, 0), (20, 0))
drives = (Drive * 2)((0, 0, (0, 0, -1, 0, 0, 0)), (1, 1, (0, 0, 1, 0, 0, 0)))
scene = Scene(Object(0.2, (1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4)), (0, 0, 0), 4, PAD, 0,
              bodies, 3, points, 3, actuators, 2, drives, 2)

memory = (c_char * 100_000)()
size = Size(bodies=3, points=3, facets=4, actuators=2, drives=2)
push = lib.lcpush_make(memory, len(memory), byref(size))
if not push or lib.lcpush_describe(push, byref(scene)) != RUNNING:
    sys.exit(lib.lcpush_mistake_text(lib.lcpush_why(push)).decode() if push else "too little memory")
status = lib.lcpush_solve(push)
if status != SOLVED:
    sys.exit(lib.lcpush_status_text(status).decode())
wrench = Vec6()
lib.lcpush_wrench_of(push, 2, wrench)
print(f"{wrench[0]:.2f} N")
