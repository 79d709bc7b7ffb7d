"""A breakfast table on a terrace; sky and sea shine in steel, porcelain and polished stone (figure 8.2)."""
import random

import furniture
import palette
from furniture import placed
from mesh import Surface, box_mapping, normalize
from pictures import Noise, png_bytes, srgb_bytes
from pose import mixed
from solids import beveled_box, displaced, icosphere, lathe
from walls import lancet, wall


def tiles(size=512, count=4):
    """Squares of honed stone."""
    noise, dice = Noise(191), random.Random(191)
    tones = [[0.85 + 0.3 * dice.random() for _ in range(count)] for _ in range(count)]
    rows = []
    for j in range(size):
        row = bytearray()
        for i in range(size):
            u, v = count * i / size, count * j / size
            joint = min(u % 1, 1 - u % 1, v % 1, 1 - v % 1) < 0.012
            vein = 0.1 * noise.fractal2(3 * u + 17 * int(v), 3 * v + 11 * int(u), 4)
            light = tones[int(v)][int(u)] * (1 + vein) * (0.55 if joint else 1)
            row += srgb_bytes(tuple(light * c for c in (0.44, 0.36, 0.29)))
        rows.append(bytes(row))
    return png_bytes(size, size, rows)


def topiary(model, x, z):
    pot = [(0, 0.0), (0.17, 0.0), (0.18, 0.02), (0.24, 0.36), (0.27, 0.37), (0.275, 0.44), (0.25, 0.445),
           (0.225, 0.4), (0, 0.39)]
    model.add(lathe(pot, 64).shaded(35).moved(x, 0.0, z), "terracotta")
    model.add(lathe([(0, 0.38), (0.028, 0.38), (0.022, 0.9), (0, 0.92)], 20).shaded(40).moved(x, 0.0, z),
              "bark")
    noise = Noise(192)

    def leafy(p):
        r = 0.36 * (1 + 0.09 * noise.at3(9 * p[0], 9 * p[1], 9 * p[2])
                    + 0.07 * noise.at3(23 * p[0], 23 * p[1], 23 * p[2]))
        return tuple(r * c for c in p)

    ball = displaced(icosphere(5), leafy).shaded(60)
    ball.paint(lambda p, n: mixed((0.03, 0.07, 0.015), (0.12, 0.2, 0.04),
                                  0.5 + 3.2 * (sum(c * c for c in p) ** 0.5 - 0.36) / 0.36 + 0.2 * n[1]))
    model.add(ball.moved(x, 1.2, z), "leaf")


def sea():
    """Far below, rippled by its normals."""
    noise, n, half = Noise(193), 150, 240.0
    surface = Surface()
    ts = [half * t * abs(t) for t in (2 * k / n - 1 for k in range(n + 1))]
    surface.grid([[(x, -9.0, z) for x in ts] for z in ts])
    mesh = surface.flip().shaded(60)
    if mesh.normals[0][1] < 0:
        mesh = surface.flip().shaded(60)
    mesh.normals = [normalize((0.05 * noise.at2(0.3 * x, 0.9 * z), 1.0,
                               0.09 * noise.at2(0.3 * x + 50, 0.9 * z)))
                    for x, _, z in mesh.positions]
    return mesh


def build(model):
    palette.use(model, "chrome", "porcelain", "orange", "apple", "lime")
    model.material("stone", (1, 1, 1), roughness=0.06, texture=model.texture(tiles()))
    model.material("green wall", (0.16, 0.4, 0.17), roughness=0.9)
    model.material("white wall", (0.75, 0.73, 0.69), roughness=0.9)
    model.material("table top", (0.03, 0.032, 0.036), roughness=0.02)
    model.material("terracotta", (0.42, 0.15, 0.075), roughness=0.8)
    model.material("bark", (0.12, 0.085, 0.06), roughness=0.95)
    model.material("cushion", (0.55, 0.085, 0.035), roughness=0.4)
    model.material("sea", (0.01, 0.07, 0.1), roughness=0.02)
    model.material("leaf", (1, 1, 1), roughness=0.8)
    floor = beveled_box((-3.0, -0.3, -2.2), (3.6, 0.0, 3.4), 0.01)
    model.add(floor.shaded(20, box_mapping(2.4)), "stone")
    along = wall(lambda u, y, d: (u, y, -d), (-3.0, 3.6), (0.0, 3.1), (1.9, 2.2),
                 [lancet(-0.55, 0.5, 0.95, 1.75, 1.0, 12, 1.0), lancet(1.9, 0.5, 0.95, 1.75, 1.0, 12, 1.0)])
    model.add(along.shaded(25), "green wall")
    side = wall(lambda u, y, d: (-d, y, u), (-1.9, 3.4), (0.0, 3.1), (2.7, 3.0),
                [lancet(0.9, 0.6, 0.0, 1.7, 1.0, 12, 1.0)])
    model.add(side.shaded(25), "white wall")
    parapet = beveled_box((3.35, 0.0, -1.9), (3.6, 0.55, 3.4), 0.02)
    model.add(parapet.shaded(20), "white wall")
    for parts in (placed(furniture.round_table("table top"), 0.25, 0.1),
                  placed(furniture.tube_chair(), 1.2, 0.5, 196),
                  placed(furniture.tube_chair(), -0.75, 0.55, 24),
                  placed(furniture.tube_chair(), 0.35, -0.9, -84),
                  placed(furniture.teapot("chrome"), 0.3, 0.1, 35, 0.75, 1.35),
                  placed(furniture.bowl_of_fruit("porcelain"), -0.07, -0.08, 10, 0.75),
                  placed(furniture.cup("porcelain"), 0.58, 0.28, 60, 0.75),
                  placed(furniture.cup("porcelain"), 0.02, 0.42, 200, 0.75)):
        palette.add(model, [(mesh, "cushion" if material == "leather" else material) for mesh,
                            material in parts])
    topiary(model, -2.2, -1.35)
    topiary(model, 2.85, -1.4)
    model.add(sea(), "sea")
