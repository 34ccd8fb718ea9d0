"""Scenes as people write them: a box or a cylinder, two fingertips, an edge that pushes or drags it."""
import random


def listed(numbers):
    return "[" + ", ".join(f"{x:.6g}" for x in numbers) + "]"


def random_scene(seed):
    """All is where it should be: nothing is odd about any of them."""
    pick = random.Random(seed)
    grip, push, across = pick.sample(range(3), 3)  # axes
    if seed % 2:  # a cylinder about one of the three, gripped at its ends or across
        radius, length, axis = pick.uniform(0.005, 0.1), pick.uniform(0.005, 0.3), pick.randrange(3)
        size = [length if k == axis else 2 * radius for k in range(3)]
        text = (f"[object]\nmass = {pick.uniform(300, 9000) * length * radius ** 2:.6g}\n"
                f"cylinder_radius = {radius:.6g}\ncylinder_length = {length:.6g}\naxis = \"{'xyz'[axis]}\"\n")
    else:
        axis, size = None, [pick.uniform(0.01, 0.3), pick.uniform(0.01, 0.3), pick.uniform(0.002, 0.1)]
        text = f"[object]\nmass = {pick.uniform(100, 9000) * size[0] * size[1] * size[2]:.6g}\nbox = {listed(size)}\n"
    text = f"gravity = [0, {-9.81 * pick.randrange(2)}, 0]\n" + text
    text += f"[gripper]\njaws = \"{pick.choice(['parallel', 'independent'])}\"\n"
    flat, force, small = axis in (None, grip), pick.uniform(1, 50), min(size[push], size[across])
    place = [pick.uniform(-0.2, 0.2) * size[k] if flat or k == axis else 0 for k in range(3)]
    shapes = {"point": "", "disc": f"radius = {small / 5:.6g}\n",
              "rectangle": f"size = {listed([small / 4, small / 5])}\npoints = [2, 2]\n"}
    for side in (1, -1):
        place[grip] = side * size[grip] / 2
        shape = pick.choice(list(shapes)) if flat else "point"
        text += (f"[[finger]]\nname = \"{'left' if side > 0 else 'right'}\"\nshape = \"{shape}\"\n"
                 f"center = {listed(place)}\n{shapes[shape]}"
                 f"normal = {listed([-side if k == grip else 0 for k in range(3)])}\n"
                 f"friction = {pick.uniform(0, 1.5):.6g}\ngrip_force = {force:.6g}\n")
    along = axis if axis not in (None, push) else across  # of a cylinder, the line that it touches
    ends = [[-size[push] / 2 if k == push else side * size[along] * pick.uniform(0.1, 0.5) if k == along
             else 0 for k in range(3)] for side in (-1, 1)]
    way = across if pick.random() < 0.2 else push  # dragged, or pushed
    return text + (f"[[pusher]]\nname = \"wall\"\nshape = \"line\"\nends = [{listed(ends[0])}, {listed(ends[1])}]\n"
                   f"normal = {listed([int(k == push) for k in range(3)])}\nfriction = {pick.uniform(0, 1):.6g}\n"
                   f"acceleration = {listed([pick.uniform(0.01, 2) if k == way else 0 for k in range(3)])}\n")
