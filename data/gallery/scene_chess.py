"""An elephant, a chess knight and a polished cone on a board before two tall mirrors (figures 8.1 and 8.8)."""
import math

import elephant
import knight
import palette
from mesh import Surface
from solids import beveled_box, box, lathe

SQUARE = 0.8


def board(model):
    """Eight squares by eight with a frame; y = 0 on top."""
    half = 4 * SQUARE
    for i in range(8):
        for j in range(8):
            x, z = SQUARE * (i - 4), SQUARE * (j - 4)
            tile = beveled_box((x, -0.1, z), (x + SQUARE, 0.0, z + SQUARE), 0.006)
            model.add(tile.shaded(20), "light square" if (i + j) % 2 else "dark square")
    for low, high in (((-half - 0.3, -0.14, -half - 0.3), (half + 0.3, 0.012, -half)),
                      ((-half - 0.3, -0.14, half), (half + 0.3, 0.012, half + 0.3)),
                      ((-half - 0.3, -0.14, -half), (-half, 0.012, half)),
                      ((half, -0.14, -half), (half + 0.3, 0.012, half))):
        model.add(beveled_box(low, high, 0.02).shaded(20), "wood")
    model.add(box((-9, -0.3, -9), (9, -0.13, 9)).shaded(), "ground")


def curtain(model, radius=7.4, high=6.5):
    """Velvet all around, in deep folds."""
    surface, around = Surface(), 720
    rows = []
    for j in range(13):
        y, t = -0.15 + high * j / 12, j / 12
        row = []
        for k in range(around):
            a = 2 * math.pi * k / around
            folds = (0.2 - 0.08 * t) * math.sin(60 * a + 1.3 * math.sin(7 * a)) + 0.1 * math.sin(23 * a + t)
            row.append(((radius + folds) * math.sin(a), y, (radius + folds) * math.cos(a)))
        rows.append(row)
    surface.grid([row + row[:1] for row in rows])
    model.add(surface.shaded(70), "velvet")
    model.add(lathe([(0, high - 0.2), (radius + 0.5, high - 0.2), (radius + 0.5, high), (0, high)],
                    96).shaded(30), "ceiling")


def mirror(model, x, z, degrees, wide=1.55, high=4.3):
    """A tall glass in a gilded frame; it looks along +z before it is turned."""
    def stand(mesh, material):
        model.add(mesh.turned(degrees).moved(x, 0.0, z), material)

    sheet = Surface()
    sheet.fan([(-wide, 0.2, 0.0), (wide, 0.2, 0.0), (wide, high, 0.0), (-wide, high, 0.0)])
    stand(sheet.shaded(), "mirror")
    profile = [(-0.01, 0.02), (0.02, 0.06), (0.06, 0.045), (0.1, 0.1), (0.16, 0.085), (0.19, 0.0),
               (0.19, -0.08), (-0.01, -0.08)]
    rows = []
    for cx, cy in ((-wide, 0.2), (wide, 0.2), (wide, high), (-wide, high)):
        sx, sy = math.copysign(1, cx), 1 if cy > 1 else -1
        rows.append([(cx + sx * a, cy + sy * a, out) for a, out in profile])
    frame = Surface()
    frame.grid([row + row[:1] for row in rows + rows[:1]])
    stand(frame.closed().shaded(30), "gilt")
    stand(box((-wide, 0.2, -0.07), (wide, high, -0.03)).shaded(), "wood")
    for k in (-1, 1):
        foot = beveled_box((k * wide - 0.1, -0.14, -0.3), (k * wide + 0.1, 0.03, 0.3), 0.03).shaded(20)
        stand(foot, "wood")


def build(model):
    palette.use(model, "skin", "ivory", "eye", "lacquer", "gold", "chrome", "mirror", "gilt", "wood")
    model.material("light square", (0.78, 0.72, 0.6), roughness=0.12)
    model.material("dark square", (0.055, 0.03, 0.022), roughness=0.08)
    model.material("ground", (0.05, 0.03, 0.028), roughness=0.9)
    model.material("velvet", (0.03, 0.12, 0.13), roughness=0.95, double_sided=True)
    model.material("ceiling", (0.25, 0.2, 0.17), roughness=0.9)
    board(model)
    curtain(model)
    mirror(model, -1.75, -3.55, 14)
    mirror(model, 1.95, -3.45, -20)
    for mesh, material in elephant.build(0.055):
        model.add(mesh.scaled(0.58).turned(-26).moved(-0.95, 0.0, -0.2), material)
    for mesh, material in knight.build():
        model.add(mesh.scaled(1.18).turned(-160).moved(2.0, 0.0, 0.25), material)
    cone = [(0, 0.0), (0.6, 0.0), (0.62, 0.02), (0.615, 0.06), (0.59, 0.07)]
    cone += [(0.57 * (1 - k / 24) + 0.01, 0.07 + 2.3 * k / 24) for k in range(24)] + [(0, 2.38)]
    model.add(lathe(cone, 128).shaded(40).moved(0.75, 0.0, -1.75), "chrome")
