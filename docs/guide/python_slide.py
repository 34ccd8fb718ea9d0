"""A bar in the grip: a scene built in Python, how hard to push it, and where it goes."""
import lcpush

pad = {"shape": "disc", "radius": 0.005, "friction": 0.5, "grip_force": 20}
scene = lcpush.Scene({
    "title": "A bar pushed through the grip",
    "object": {"mass": 0.2, "box": [0.1, 0.03, 0.01]},
    "finger": [{"name": "left", "center": [0, 0, 0.005], "normal": [0, 0, -1], **pad},
               {"name": "right", "center": [0, 0, -0.005], "normal": [0, 0, 1], **pad}],
    "pusher": [{"name": "wall", "shape": "line", "ends": [[-0.05, -0.015, 0], [-0.05, 0.015, 0]],
                "normal": [1, 0, 0], "friction": 0.3, "acceleration": [0.1, 0, 0]}],
})
for warning in scene.warnings:
    print(f"line {warning.line}: {warning.text}")

print(scene.break_())

push = scene.solve()
print(push)
print(f"the wall pushes with {push.body('wall').force[0]:.2f} N")
for contact in push.contacts[:2]:
    print(f"  {contact.name} {contact.mode}s, {contact.normal_force:.2f} N")

motion = scene.move(time=0.5)
print(motion)
print(f"after {motion.times[-1]:.1f} s it is at x = {1000 * motion.positions[-1][0]:.2f} mm")

try:
    lcpush.Scene(scene.text.replace("0.3", "-0.3"), "mine.toml")
except lcpush.InputError as error:
    print(f"line {error.line} of {error.file}: {error.message}")
