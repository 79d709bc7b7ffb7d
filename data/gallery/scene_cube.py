"""The cube of all colours above a dark mirror, among white pearls that take its light (figure 8.6)."""
import math

import palette
import space
from mesh import Surface
from pose import tilted
from solids import lathe, sphere

HALF, STEPS = 0.5, 24


def colour_cube():
    """Faces as grids, so that the colours of the eight corners run evenly over them."""
    surface = Surface()
    ts = [HALF * (2 * k / STEPS - 1) for k in range(STEPS + 1)]
    for axis in range(3):
        for side in (-HALF, HALF):
            def point(u, v):
                p = [u, v]
                p.insert(axis, side)
                return tuple(p)
            face = Surface()
            face.grid([[point(u, v) for u in ts] for v in ts])
            surface.append(face.flip() if (side < 0) == (axis != 1) else face)
    mesh = surface.closed().shaded(20)
    return mesh.paint(lambda p, n: tuple(0.015 + 0.93 * min(1.0, max(0.0, c + HALF)) ** 1.6 for c in p))


def build(model):
    palette.use(model, "coloured", "gilt")
    model.material("dais", (0.012, 0.013, 0.017), roughness=0.02)
    model.material("pearl", (0.85, 0.84, 0.82), roughness=0.2)
    cube = tilted(tilted(colour_cube(), "x", 45), "z", 35.264)
    model.add(cube.turned(18).moved(0.0, 1.12, 0.0), "coloured")
    disc = [(0, -0.2), (2.0, -0.2), (2.0, 0.0), (0, 0.0)]
    model.add(lathe(disc, 192).shaded(30), "dais")
    model.add(lathe([(1.9, -0.14), (2.045, -0.14), (2.06, -0.09), (2.045, -0.04), (1.9, -0.04)],
                    192).shaded(30), "gilt")
    pearl = sphere(0.16, 64, 32).shaded(60)
    for k in range(9):
        a = 2 * math.pi * (k + 0.35) / 9
        model.add(pearl.moved(1.45 * math.sin(a), 0.16, 1.45 * math.cos(a)), "pearl")
    space.add_stars(model)
