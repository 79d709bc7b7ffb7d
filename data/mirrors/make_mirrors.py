#!/usr/bin/env python3
"""Builds the hall of mirrors: two facing mirrors, curved ones, a knot of all colours, glass. Metres."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "tools")]

from glb import Model
from mesh import Surface, box_mapping
from parquet import parquet
from solids import beveled_box, box, lathe, round_profile, smooth_step, sphere, sweep

WIDE, DEEP, HIGH = 4.0, 5.0, 4.2           # half width (x), half depth (z), height of the room


def add_room(model):
    """One closed shell: an inner box inside an outer one, so that no ray gets out."""
    w, d, h = WIDE, DEEP, HIGH
    for low, high, name in (((-w - 0.2, -0.2, -d - 0.2), (w + 0.2, 0.0, d + 0.2), "floor"),
                            ((-w - 0.2, h, -d - 0.2), (w + 0.2, h + 0.2, d + 0.2), "plaster"),
                            ((-w - 0.2, -0.1, -d - 0.1), (-w, h + 0.1, d + 0.1), "plaster"),
                            ((w, -0.1, -d - 0.1), (w + 0.2, h + 0.1, d + 0.1), "plaster"),
                            ((-w - 0.1, -0.1, -d - 0.2), (w + 0.1, h + 0.1, -d), "wall"),
                            ((-w - 0.1, -0.1, d), (w + 0.1, h + 0.1, d + 0.2), "wall")):
        uv = box_mapping(2.4) if name == "floor" else None
        model.add(box(low, high).shaded(20, uv), name)
    add_trim(model)


def add_trim(model):
    """Skirting and a cornice, mitred at the corners of the room."""
    def run(points, profile):
        rows = []
        for k, (x, z) in enumerate(points):
            sx, sz = math.copysign(1, x), math.copysign(1, z)
            rows.append([(x - sx * a, y, z - sz * a) for a, y in profile])
        surface = Surface()
        surface.grid([row + row[:1] for row in rows + rows[:1]])
        return surface.closed()

    corners = [(-WIDE, -DEEP), (-WIDE, DEEP), (WIDE, DEEP), (WIDE, -DEEP)]
    skirting = [(-0.05, -0.05), (0.03, -0.05), (0.03, 0.16), (0.02, 0.2), (-0.05, 0.2)]
    h = HIGH
    cornice = [(-0.05, h - 0.26), (0.03, h - 0.26), (0.05, h - 0.2), (0.07, h - 0.13), (0.12, h - 0.08),
               (0.2, h - 0.05),
               (0.21, h + 0.05), (-0.05, h + 0.05)]
    model.add(run(corners, skirting).shaded(20), "trim")
    model.add(run(corners, cornice).shaded(20), "trim")


def add_wall_mirrors(model):
    """Two mirrors that face each other at x = -4 and x = 4, in gilded frames."""
    for side in (-1, 1):
        x = side * (WIDE - 0.03)
        sheet = Surface()
        corners = [(x, 0.45, -3.4), (x, 3.45, -3.4), (x, 3.45, 3.4), (x, 0.45, 3.4)]
        sheet.fan(corners if side < 0 else corners[::-1])
        model.add(sheet.shaded(), "mirror")
        profile = [(0.0, 0.0), (0.04, 0.075), (0.09, 0.06), (0.13, 0.11), (0.18, 0.1), (0.22, 0.0)]
        frame = Surface()
        rows = []
        for z, y in ((-3.38, 0.47), (3.38, 0.47), (3.38, 3.43), (-3.38, 3.43)):
            oz, oy = math.copysign(1, z), (1 if y > 2 else -1)
            rows.append([(side * (WIDE + 0.02 - out), y + oy * a, z + oz * a)
                         for a, out in profile] + [(side * (WIDE + 0.1), y + oy * 0.22, z + oz * 0.22),
                                                   (side * (WIDE + 0.1), y, z)])
        frame.grid([row + row[:1] for row in rows + rows[:1]])
        model.add(frame.closed().shaded(30), "gilt")


def add_bent_mirror(model):
    """A free-standing sheet of steel, 2.2 m high, that bulges and hollows like one of a fun fair."""
    columns, rows, thick = 72, 56, 0.03

    def point(s, t, back):
        bend = 0.22 * math.sin(2.0 * math.pi * t + 0.5) + 0.3 * math.cos(math.pi * s)
        return (2.4 * (s - 0.5), 0.12 + 2.3 * t, bend - (thick if back else 0.0))

    sheet = Surface()
    grids = [[[point(i / columns, j / rows, back) for i in range(columns + 1)] for j in range(rows + 1)]
             for back in (False, True)]
    sheet.grid(grids[0])
    back = Surface()
    back.grid(grids[1])
    sheet.append(back.flip())
    for pick, flip in ((lambda g: g[0], True), (lambda g: g[-1], False),
                       (lambda g: [row[0] for row in g], False), (lambda g: [row[-1] for row in g], True)):
        edge = Surface()
        edge.grid([pick(grids[0]), pick(grids[1])])
        sheet.append(edge.flip() if flip else edge)
    mesh = sheet.closed().shaded(50).turned(-14)
    model.add(mesh.moved(1.7, 0.0, -3.75), "steel")


def add_curved_mirrors(model):
    ball = sphere(0.85, 128, 64)
    model.add(ball.shaded(60).moved(-0.75, 1.17, -2.6), "chrome")
    ring = lathe([(0.25, -0.02), (0.5, -0.02), (0.52, 0.06), (0.46, 0.14), (0.5, 0.3), (0.44, 0.33),
                  (0.4, 0.28),
                  (0.25, 0.2), (0.2, 0.1)], 64)
    model.add(ring.shaded(30).moved(-0.75, 0.0, -2.6), "ebony")
    cone = [(0, 0.0), (0.42, 0.0), (0.43, 0.03), (0.42, 0.06)] + \
           [(0.4 * (1 - k / 20) ** 0.85 + 0.012, 0.06 + 1.35 * k / 20) for k in range(20)] + [(0, 1.44)]
    model.add(lathe(cone, 96).shaded(40).moved(-0.55, 0.0, -0.6), "chrome")
    vase = []
    for k in range(49):
        t = k / 48
        r = 0.16 + 0.26 * math.sin(math.pi * min(1.0, t * 1.18)) ** 1.3 + 0.2 * smooth_step(0.82, 1.0, t) ** 2
        vase.append((r, 1.25 * t))
    inside = [(max(0.05, r - 0.03), y) for r, y in vase[::-1] if y > 0.06]
    profile = [(0, 0.0)] + vase + inside + [(0, 0.06)]
    model.add(lathe(profile, 96).shaded(40).moved(3.15, 0.0, -1.0), "gold")


def knot_point(t):
    """A trefoil knot of about unit size."""
    r = 2 + math.cos(3 * t)
    return (r * math.cos(2 * t) / 3, math.sin(3 * t) / 2.6, r * math.sin(2 * t) / 3)


def add_knot(model):
    """Colours at the vertices: the position in the knot's box is red, green and blue."""
    steps, size = 360, 0.5
    path = [tuple(size * c for c in knot_point(2 * math.pi * k / steps)) for k in range(steps)]
    knot = closed_tube(path, 0.115, 24).shaded(60)

    def colour(p, _):
        r, g, b = (min(1.0, max(0.0, c / (2.1 * size) + 0.5)) for c in (p[0], p[1] * 2.2, p[2]))
        return (0.02 + 0.9 * r * r, 0.02 + 0.9 * g * g, 0.02 + 0.9 * b * b)

    model.add(knot.paint(colour).moved(1.25, 1.32, -0.6), "coloured")
    cube = beveled_box((-0.2, -0.2, -0.2), (0.2, 0.2, 0.2), 0.012).shaded(15)
    cube.paint(lambda p, n: tuple(0.03 + 0.92 * (c > 0) for c in p))
    model.add(cube.turned(24).moved(-1.2, 0.2, 0.45), "coloured")
    stand = [(0, 0.0), (0.34, 0.0), (0.35, 0.03), (0.3, 0.07), (0.12, 0.12), (0.075, 0.25), (0.06, 0.55),
             (0.075, 0.72),
             (0.16, 0.8), (0.36, 0.84), (0.37, 0.87), (0, 0.88)]
    model.add(lathe(stand, 64).shaded(32).moved(1.25, 0.0, -0.6), "ebony")


def closed_tube(path, radius, sides):
    """A tube along a closed path; the twist that carried frames leave over is spread along it."""
    surface, count = Surface(), len(path)
    rings = []
    for k in range(count):
        a, b = path[k - 1], path[(k + 1) % count]
        t = [q - p for p, q in zip(a, b)]
        n = math.sqrt(sum(c * c for c in t))
        t = [c / n for c in t]
        up = (-path[k][0], 1.4, -path[k][2])           # never along the knot
        u = [up[1] * t[2] - up[2] * t[1], up[2] * t[0] - up[0] * t[2], up[0] * t[1] - up[1] * t[0]]
        n = math.sqrt(sum(c * c for c in u))
        u = [c / n for c in u]
        v = [t[1] * u[2] - t[2] * u[1], t[2] * u[0] - t[0] * u[2], t[0] * u[1] - t[1] * u[0]]
        rings.append([tuple(p + radius * (x * math.cos(w) + y * math.sin(w)) for p, x,
                            y in zip(path[k], u, v))
                      for w in (2 * math.pi * j / sides for j in range(sides))])
    surface.grid([ring + ring[:1] for ring in rings + rings[:1]])
    return surface.closed()


def add_glass(model):
    model.add(sphere(0.42, 96, 48).shaded(60).moved(0.72, 0.42, 0.85), "glass_solid")
    panel = beveled_box((-0.75, 0.06, -0.02), (0.75, 1.75, 0.02), 0.006)
    model.add(panel.shaded(15).turned(62).moved(2.25, 0.0, 2.15), "glass_panel_solid")
    foot = beveled_box((-0.8, -0.02, -0.09), (0.8, 0.075, 0.09), 0.015)
    model.add(foot.shaded(20).turned(62).moved(2.25, 0.0, 2.15), "ebony")
    for k, (x, z, r) in enumerate(((1.55, 1.25, 0.14), (0.1, 1.55, 0.11), (1.75, 0.55, 0.1))):
        model.add(sphere(r, 48, 24).shaded(60).moved(x, r, z), ("gold", "chrome", "ruby_solid")[k])


def add_lamps(model):
    """Four hanging globes; the point lights of the scene hang just under them."""
    globe = sphere(0.12, 32, 16).shaded(60)
    cup = lathe([(0, 0.09), (0.11, 0.09), (0.12, 0.12), (0.05, 0.17), (0, 0.18)], 32).shaded(30)
    for x, z, name in ((-2.4, 1.6, "lamp_blue"), (2.3, 1.4, "lamp_amber"), (0.0, -3.3, "lamp_rose")):
        model.add(globe.moved(x, 3.2, z), name)
        model.add(cup.moved(x, 3.2, z), "gilt")
        cord = sweep([(x, 3.36, z), (x, HIGH + 0.02, z)], round_profile(0.012, 8))
        model.add(cord.shaded(60), "ebony")


def main():
    folder = os.path.join(HERE, "generated")
    os.makedirs(folder, exist_ok=True)
    model = Model()
    model.material("floor", (1, 1, 1), roughness=0.1, texture=model.texture(parquet(9)))
    model.material("plaster", (0.78, 0.74, 0.68), roughness=0.9)
    model.material("wall", (0.1, 0.22, 0.24), roughness=0.7)
    model.material("trim", (0.85, 0.8, 0.7), roughness=0.5)
    model.material("mirror", (0.94, 0.96, 0.95), metallic=1.0, roughness=0.0)
    model.material("steel", (0.86, 0.88, 0.9), metallic=1.0, roughness=0.0)
    model.material("chrome", (0.9, 0.91, 0.93), metallic=1.0, roughness=0.0)
    model.material("gold", (1.0, 0.72, 0.32), metallic=1.0, roughness=0.03)
    model.material("gilt", (0.75, 0.5, 0.18), metallic=0.6, roughness=0.25)
    model.material("ebony", (0.03, 0.025, 0.022), roughness=0.12)
    model.material("coloured", (1, 1, 1), roughness=0.16)
    model.material("glass_solid", (1, 1, 1), roughness=0.0, alpha=0.05, ior=1.5)
    model.material("glass_panel_solid", (0.8, 0.95, 0.9), roughness=0.0, alpha=0.05, ior=1.5)
    model.material("ruby_solid", (0.9, 0.1, 0.1), roughness=0.0, alpha=0.05, ior=1.6)
    for name in ("lamp_blue", "lamp_amber", "lamp_rose"):
        model.material(name, (1, 1, 1), roughness=1.0, emissive=(1, 1, 1))
    for build in (add_room, add_wall_mirrors, add_bent_mirror, add_curved_mirrors, add_knot, add_glass,
                  add_lamps):
        build(model)
    model.write(os.path.join(folder, "mirrors.glb"))
    print(f"mirrors: {model.triangles} triangles")


if __name__ == "__main__":
    main()
