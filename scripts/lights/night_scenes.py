"""A street, a hall and a tree at night, lit by any number of lights, as a model and a scene that the Renderer reads."""
import math
import os
import random

POWER = {"street": 9000.0, "hall": 30000.0, "tree": 2500.0}  # W/sr of all lights together
VIEWS = {"street": ((-27, 1.8, 3), (1, -0.05, -0.18), 70), "hall": ((-18, 1.7, 7), (1, -0.02, -0.35), 75),
         "tree": ((0.5, 1.8, 7.5), (-0.05, 0.02, -1), 60)}
SCENES, KINDS = tuple(VIEWS), ("points", "spots", "balls", "boxes")
CORNERS = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))


class Boxes:
    """Text of an .obj file of boxes."""

    def __init__(self, library):
        self.lines, self.count = ["mtllib " + library], 0

    def material(self, name):
        self.lines.append("usemtl " + name)

    def add(self, low, high):
        for x in (low[0], high[0]):
            for y in (low[1], high[1]):
                self.lines += ["v %.9g %.9g %.9g" % (x, y, z) for z in (low[2], high[2])]
        self.lines += ["f " + " ".join(str(self.count + corner) for corner in face) for face in CORNERS]
        self.count += 8


def street(boxes, chance):
    boxes.material("wall")
    boxes.add((-30, -.2, -12), (30, 0, 12))
    boxes.material("brick")
    for i in range(14):
        for near, far in ((6, 10), (-10, -6)):
            boxes.add((4.3 * i - 28, 0, near), (4.3 * i - 24.8, chance.uniform(3, 8), far))
    return lambda: (chance.uniform(-29, 29), chance.uniform(2, 5), chance.uniform(-5.5, 5.5))


def hall(boxes, chance):
    boxes.material("wall")
    for low, high in (((-20, -.2, -10), (20, 0, 10)), ((-20, 6, -10), (20, 6.2, 10)), ((-20, 0, -10.2), (20, 6, -10)),
                      ((-20, 0, 10), (20, 6, 10.2)), ((-20.2, 0, -10), (-20, 6, 10)), ((20, 0, -10), (20.2, 6, 10))):
        boxes.add(low, high)
    boxes.material("brick")
    for x in range(-15, 20, 6):
        for z in (-5, 0, 5):
            boxes.add((x - .4, 0, z - .4), (x + .4, 6, z + .4))
    return lambda: (chance.uniform(-19, 19), 5.8, chance.uniform(-9, 9))


def tree(boxes, chance):
    boxes.material("wall")
    boxes.add((-8, -.2, -8), (8, 0, 8))
    boxes.add((-8, 0, -8.2), (8, 6, -8))
    boxes.material("brick")
    boxes.add((-.15, 0, -.15), (.15, 1, .15))
    cone = lambda up: 2 * (1 - (up - .8) / 3.2)  # noqa: E731 (its radius at that height)
    for _ in range(1500):
        up, turn = chance.uniform(.8, 4), chance.uniform(0, 2 * math.pi)
        far = cone(up) * chance.uniform(.2, .95)
        x, z, size = far * math.cos(turn), far * math.sin(turn), chance.uniform(.05, .15)
        boxes.add((x - size, up, z - size), (x + size, up + .02, z + size))

    def at_rim():
        up, turn = chance.uniform(.8, 3.9), chance.uniform(0, 2 * math.pi)
        return (cone(up) + .08) * math.cos(turn), up, (cone(up) + .08) * math.sin(turn)
    return at_rim


def light_of(kind, at, power):
    text = "[[light]]\nkind = \"%s\"\nposition = [%.6g, %.6g, %.6g]\nintensity = [%.6g, %.6g, %.6g]\n" % (
        {"points": "point", "spots": "spot", "balls": "sphere"}[kind], *at, power, .85 * power, .7 * power)
    if kind == "spots":
        text += "direction = [0, -1, 0.1]\ninnerAngle = 20.0\nouterAngle = 40.0\n"
    return text + ("radius = 0.03\n" if kind == "balls" else "")


def write(folder, scene, kind, count):
    """Gives the scene's path without its extension. Every number of lights has the same power."""
    name = os.path.join(folder, "%s-%s-%d" % (scene, kind, count))
    chance = random.Random(7)
    boxes = Boxes(os.path.basename(name) + ".mtl")
    place = {"street": street, "hall": hall, "tree": tree}[scene](boxes, chance)
    power, lights = POWER[scene] / count, []
    side = .03
    boxes.material("light")
    for _ in range(count):
        at = place()
        if kind == "boxes":
            boxes.add([c - side for c in at], [c + side for c in at])
        else:
            lights.append(light_of(kind, at, power))
    # A box sends as much as a point of this power: its surface lies open to all sides.
    radiance = 4 * math.pi * power / (math.pi * 24 * side * side)
    with open(name + ".mtl", "w", encoding="ascii") as file:
        file.write("newmtl wall\nKd .7 .7 .7\nnewmtl brick\nKd .6 .25 .2\nnewmtl light\nKd 0 0 0\n"
                   "Ke %.6g %.6g %.6g\n" % (radiance, .85 * radiance, .7 * radiance))
    with open(name + ".obj", "w", encoding="ascii") as file:
        file.write("\n".join(boxes.lines) + "\n")
    eye, forward, fov = VIEWS[scene]
    with open(name + ".scn", "w", encoding="ascii") as file:
        file.write("version = 2\nmodel = \"%s.obj\"\nambient = [0, 0, 0]\nbackground = [0, 0, 0]\n"
                   "[camera]\neye = %s\nforward = %s\nfov = %.1f\n%s" % (
                       os.path.basename(name), list(eye), list(forward), fov, "".join(lights)))
    return name
