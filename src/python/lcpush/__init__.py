"""The mechanics of prehensile pushing, solved as the complementarity problem that it is.

>>> import lcpush
>>> answer = lcpush.lcp([[2, 1], [1, 2]], [-5, -6])
>>> answer.status
'solved'

`read` a scene file, or build a `Scene` from a dictionary, and ask it: `solve()`, `break_()`,
`sweep()`, `spread()`, `verify()`, `move()`, `report()`. SI units, the scene's axes, the gripper's
frame. Arrays are NumPy's where NumPy is installed, else lists. docs/guide/python.md explains.
"""
from ._answers import (Answer, Body, Breaking, Certificate, Contact, ContactForces, LcpAnswer, LcpSolutions,
                       LcpVerdict, MotionVerdict, Pivots, Record, Solution, Spread, Verdict)
from ._courses import Cone, Curve, Design, Funnel, Hold, Motion, Plan, Sweep
from ._errors import InputError, NotSolved
from ._library import version as __version__
from ._raw import check, contacts, equilibria, lcp, lcp_all, pivots
from ._scene import Scene, read, verify_scene

__all__ = ["Answer", "Body", "Breaking", "Certificate", "Cone", "Contact", "ContactForces", "Curve", "Design", "Funnel", "Hold",
           "InputError",
           "LcpAnswer", "LcpSolutions", "LcpVerdict", "Motion", "MotionVerdict", "NotSolved", "Pivots", "Plan",
           "Record", "Scene", "Solution", "Spread", "Sweep", "Verdict", "__version__", "check", "contacts",
           "equilibria", "lcp", "lcp_all", "pivots", "read", "verify_scene"]
