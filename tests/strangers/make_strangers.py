#!/usr/bin/env python3
"""Makes models that nobody prepared: houses, rooms, halls, parts, cars, trees, terrains, in every unit and up axis.

usage: make_strangers.py FOLDER

Writes them and `strangers.txt`: name, "in" or "out" for where its first view stands ("any": either), metres per
unit, up axis, and notes. The same bytes each time.
"""
import math
import pathlib
import random
import sys

sys.dont_write_bytecode = True
from shapes import Shape, write_glb, write_obj, write_stl  # noqa: E402


# --- houses ---

def wall(s, start, end, bottom, top, holes=(), thickness=0.25):
    """Along x or y from `start` to `end` in the plan; holes: (from, to, sill, head) along it."""
    (x0, y0), (x1, y1) = start, end
    along_x = y0 == y1
    length = x1 - x0 if along_x else y1 - y0

    def piece(a, b, low, high):
        if b - a < 1e-6 or high - low < 1e-6:
            return
        if along_x:
            s.box((x0 + a, y0 - thickness / 2, low), (x0 + b, y0 + thickness / 2, high))
        else:
            s.box((x0 - thickness / 2, y0 + a, low), (x0 + thickness / 2, y0 + b, high))
    at = 0.0
    for a, b, sill, head in sorted(holes):
        piece(at, a, bottom, top)
        piece(a, b, bottom, bottom + sill)
        piece(a, b, bottom + head, top)
        at = b
    piece(at, length, bottom, top)


def furnish(s, x0, y0, x1, y1, floor, seed):
    rng = random.Random(seed)
    cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
    s.part(f"table{seed}", "wood").box((cx - 0.8, cy - 0.45, floor + 0.71), (cx + 0.8, cy + 0.45, floor + 0.75))
    for dx in (-0.7, 0.7):
        for dy in (-0.38, 0.38):
            s.box((cx + dx - 0.03, cy + dy - 0.03, floor), (cx + dx + 0.03, cy + dy + 0.03, floor + 0.71))
    s.part(f"sofa{seed}", "cloth").box((x0 + 0.3, y0 + 0.3, floor), (x0 + 1.1, y0 + 2.2, floor + 0.42))
    s.box((x0 + 0.3, y0 + 0.3, floor + 0.42), (x0 + 0.5, y0 + 2.2, floor + 0.85))
    s.part(f"cupboard{seed}", "wood").box((x1 - 1.0, y1 - 1.5, floor), (x1 - 0.45, y1 - 0.4, floor + 1.9))
    for k in range(rng.randint(0, 3)):
        a = rng.uniform(0, 6.28)
        px, py = cx + 1.1 * math.cos(a), cy + 0.8 * math.sin(a)
        s.part(f"chair{seed}.{k}", "wood").box((px - 0.2, py - 0.2, floor + 0.42), (px + 0.2, py + 0.2, floor + 0.46))
        for dx in (-0.17, 0.17):
            for dy in (-0.17, 0.17):
                s.box((px + dx - 0.02, py + dy - 0.02, floor), (px + dx + 0.02, py + dy + 0.02, floor + 0.42))


def house(storeys=1, width=10.0, depth=8.0, ground=0.0, void=0.0, roof="gable", furniture=True, glass=True):
    """`ground`: width of the plot; `void`: height between a hung ceiling and the slab above it."""
    s = Shape()
    if ground:
        s.part("ground", "grass").grid(ground, 4, lambda x, y: -0.02)
    height, slab = 2.9, 0.3
    hx, hy = width / 2, depth / 2
    for k in range(storeys):
        z = k * height
        floor = z + 0.3
        top = z + height + 0.3 - slab
        s.part(f"slab{k}", "stone")
        if k == 0:
            s.box((-hx, -hy, floor - slab), (hx, hy, floor))
        else:  # with a hole for the stairs
            s.box((-hx, -hy, floor - slab), (hx - 1.4, hy, floor))
            s.box((hx - 1.4, -hy, floor - slab), (hx, hy - 4.6, floor))
        if void:
            s.part(f"ceiling{k}", "plaster").box((-hx + 0.13, -hy + 0.13, top - void - 0.02),
                                                 (hx - 1.6, hy - 0.13, top - void))
        s.part(f"walls{k}", "plaster")
        door = [(width * 0.45, width * 0.45 + 1.0, 0.0, 2.1)] if k == 0 else []
        wall(s, (-hx, -hy), (hx, -hy), floor, top, door + [(1.0, 2.8, 0.9, 2.2), (width - 2.8, width - 1.2, 0.9, 2.2)])
        wall(s, (-hx, hy), (hx, hy), floor, top, [(1.5, 3.5, 0.9, 2.2)])
        wall(s, (-hx, -hy), (-hx, hy), floor, top, [(2.0, 4.0, 0.9, 2.2)])
        wall(s, (hx, -hy), (hx, hy), floor, top, [(1.0, 2.2, 0.9, 2.2)])
        wall(s, (0, -hy + 0.125), (0, hy - 0.125), floor, top, [(2.5, 3.5, 0.0, 2.05)], 0.12)
        if glass:
            s.part(f"panes{k}", "glass")
            s.box((-hx + 1.0, -hy - 0.01, floor + 0.9), (-hx + 2.8, -hy + 0.01, floor + 2.2))
            s.box((hx - 2.8, -hy - 0.01, floor + 0.9), (hx - 1.2, -hy + 0.01, floor + 2.2))
            s.box((-hx + 1.5, hy - 0.01, floor + 0.9), (-hx + 3.5, hy + 0.01, floor + 2.2))
        if furniture:
            furnish(s, -hx + 0.2, -hy + 0.2, -0.2, hy - 0.2, floor, 10 * k + 1)
            furnish(s, 0.2, -hy + 0.2, hx - 1.6, hy - 0.2, floor, 10 * k + 2)
        if k + 1 < storeys:
            s.part(f"stairs{k}", "wood")
            for i in range(16):
                y = hy - 0.4 - i * 0.26
                s.box((hx - 1.3, y - 0.28, floor + i * height / 16), (hx - 0.2, y, floor + (i + 1) * height / 16))
    top = storeys * height + 0.3
    s.part("attic", "stone").box((-hx, -hy, top - slab), (hx, hy, top))
    if roof == "gable":
        ridge = top + depth * 0.35
        e = 0.5
        s.part("roof", "tiles")
        s.face((-hx - e, -hy - e, top - 0.1), (hx + e, -hy - e, top - 0.1), (hx + e, 0, ridge), (-hx - e, 0, ridge))
        s.face((hx + e, hy + e, top - 0.1), (-hx - e, hy + e, top - 0.1), (-hx - e, 0, ridge), (hx + e, 0, ridge))
        s.part("gables", "plaster")
        s.face((-hx, hy, top), (-hx, -hy, top), (-hx, 0, ridge - 0.2))
        s.face((hx, -hy, top), (hx, hy, top), (hx, 0, ridge - 0.2))
    return s


# --- rooms and halls ---

def room(width=4.5, depth=6.0, height=2.7, window=True, lamp=False, furniture=True, walls="plaster"):
    s = Shape().part("floor", "wood").box((-width / 2, -depth / 2, -0.2), (width / 2, depth / 2, 0))
    s.part("ceiling", walls).box((-width / 2, -depth / 2, height), (width / 2, depth / 2, height + 0.2))
    s.part("walls", walls)
    wall(s, (-width / 2, -depth / 2), (width / 2, -depth / 2), 0, height, [(width / 2 - 1, width / 2 + 1, 0.9, 2.2)] if window else [])
    wall(s, (-width / 2, depth / 2), (width / 2, depth / 2), 0, height, [(0.5, 1.4, 0, 2.0)] if window else [])
    wall(s, (-width / 2, -depth / 2), (-width / 2, depth / 2), 0, height)
    wall(s, (width / 2, -depth / 2), (width / 2, depth / 2), 0, height)
    if furniture:
        furnish(s, -width / 2, -depth / 2, width / 2, depth / 2, 0.0, 7)
    if lamp:
        s.lamp = (0, 0, height - 0.4)
    return s


def single_sided_room():
    """Walls without thickness, whose fronts are inside, as games and catalogues have them."""
    x, y, z = 2.0, 2.6, 2.5
    s = Shape().part("room", "plaster")
    s.face((-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)).face((-x, y, z), (x, y, z), (x, -y, z), (-x, -y, z))
    s.face((-x, -y, 0), (-x, y, 0), (-x, y, z), (-x, -y, z)).face((x, y, 0), (x, -y, 0), (x, -y, z), (x, y, z))
    s.face((x, -y, 0), (-x, -y, 0), (-x, -y, z), (x, -y, z)).face((-x, y, 0), (x, y, 0), (x, y, z), (-x, y, z))
    furnish(s, -x, -y, x, y, 0.0, 3)
    return s


def hall(length=40.0, width=16.0, height=9.0, columns=6):
    s = Shape().part("floor", "stone").box((-length / 2, -width / 2, -0.4), (length / 2, width / 2, 0))
    s.part("roof", "wood").box((-length / 2, -width / 2, height), (length / 2, width / 2, height + 0.4))
    s.part("walls", "plaster")
    holes = [(2 + 6 * k, 4 + 6 * k, 2.0, 6.5) for k in range(int(length / 6) - 1)]
    wall(s, (-length / 2, -width / 2), (length / 2, -width / 2), 0, height, holes, 0.6)
    wall(s, (-length / 2, width / 2), (length / 2, width / 2), 0, height, holes, 0.6)
    wall(s, (-length / 2, -width / 2), (-length / 2, width / 2), 0, height, [(width / 2 - 1.5, width / 2 + 1.5, 0, 3)], 0.6)
    wall(s, (length / 2, -width / 2), (length / 2, width / 2), 0, height, (), 0.6)
    s.part("columns", "stone")
    for k in range(columns):
        for y in (-width / 4, width / 4):
            x = (k + 0.5) / columns * length - length / 2
            s.lathe([(0.0, 0.0), (0.5, 0.0), (0.4, 0.4), (0.35, height - 0.5), (0.55, height), (0.0, height)], 16, (x, y))
    return s


def corridor():
    s = Shape().part("floor", "stone").box((-15, -1, -0.2), (15, 1, 0)).box((13, -1, -0.2), (15, 12, 0))
    s.part("ceiling", "plaster").box((-15, -1, 2.4), (15, 1, 2.6)).box((13, 1, 2.4), (15, 12, 2.6))
    s.part("walls", "plaster")
    wall(s, (-15, -1), (15, -1), 0, 2.4, [(3, 4, 0, 2)], 0.1)
    wall(s, (-15, 1), (13, 1), 0, 2.4, [(6, 7, 0, 2), (20, 21, 0, 2)], 0.1)
    wall(s, (-15, -1), (-15, 1), 0, 2.4, (), 0.1)
    wall(s, (15, -1), (15, 12), 0, 2.4, (), 0.1)
    wall(s, (13, 1), (13, 12), 0, 2.4, (), 0.1)
    wall(s, (13, 12), (15, 12), 0, 2.4, [(0.5, 1.5, 0.9, 2)], 0.1)
    return s


def attic():
    """Under a gable roof; one can stand along the middle only."""
    s = Shape().part("floor", "wood").box((-5, -4, -0.2), (5, 4, 0))
    s.part("roof", "wood").face((-5, -4, 0), (-5, 0, 3.6), (5, 0, 3.6), (5, -4, 0)).face((5, 4, 0), (5, 0, 3.6), (-5, 0, 3.6), (-5, 4, 0))
    s.face((-5, 0, 3.9), (-5, -4.3, 0), (5, -4.3, 0), (5, 0, 3.9)).face((5, 0, 3.9), (5, 4.3, 0), (-5, 4.3, 0), (-5, 0, 3.9))
    s.part("gables", "plaster").face((-5, 4, 0), (-5, -4, 0), (-5, 0, 3.6)).face((-4.9, -4, 0), (-4.9, 4, 0), (-4.9, 0, 3.6))
    s.face((5, -4, 0), (5, 4, 0), (5, 0, 3.6)).face((4.9, 4, 0), (4.9, -4, 0), (4.9, 0, 3.6))
    s.part("chest", "wood").box((-1, -0.5, 0), (0.2, 0.3, 0.6))
    return s


# --- parts ---

def tray(x=0.1, y=0.06, z=0.04, wall_=0.003):
    s = Shape().part("tray").box((0, 0, 0), (x, y, wall_))
    s.box((0, 0, wall_), (x, wall_, z)).box((0, y - wall_, wall_), (x, y, z))
    s.box((0, wall_, wall_), (wall_, y - wall_, z)).box((x - wall_, wall_, wall_), (x, y - wall_, z))
    return s


def housing():
    s = tray(0.2, 0.14, 0.08, 0.004)
    s.part("lid").box((0, 0, 0.08), (0.2, 0.14, 0.084))
    for x in (0.02, 0.18):
        for y in (0.02, 0.12):
            s.part("boss").lathe([(0.0, 0.004), (0.006, 0.004), (0.006, 0.076), (0.0, 0.076)], 16, (x, y))
    return s


def gear(teeth=18):
    s = Shape().part("gear")
    outline = []
    for i in range(teeth):
        for k, r in ((0, 0.04), (0.3, 0.04), (0.4, 0.048), (0.6, 0.048), (0.7, 0.04)):
            a = 2 * math.pi * (i + k) / teeth
            outline.append((r * math.cos(a), r * math.sin(a)))
    hole = [(0.012 * math.cos(2 * math.pi * i / len(outline)), 0.012 * math.sin(2 * math.pi * i / len(outline)))
            for i in range(len(outline))]
    for i in range(len(outline)):
        (ax, ay), (bx, by) = outline[i], outline[(i + 1) % len(outline)]
        (cx, cy), (dx, dy) = hole[i], hole[(i + 1) % len(hole)]
        s.face((ax, ay, 0), (bx, by, 0), (bx, by, 0.015), (ax, ay, 0.015))
        s.face((dx, dy, 0), (cx, cy, 0), (cx, cy, 0.015), (dx, dy, 0.015))
        s.face((ax, ay, 0.015), (bx, by, 0.015), (dx, dy, 0.015), (cx, cy, 0.015))
        s.face((bx, by, 0), (ax, ay, 0), (cx, cy, 0), (dx, dy, 0))
    return s


def bowl():
    outer = [(0.03, 0.0), (0.05, 0.005), (0.075, 0.03), (0.09, 0.07)]
    inner = [(0.087, 0.07), (0.072, 0.032), (0.048, 0.009), (0.0, 0.006)]
    return Shape().part("bowl").lathe([(0.0, 0.0)] + outer + inner, 48)


def pipe():
    return Shape().part("pipe").lathe([(0.05, 0.0), (0.05, 1.2), (0.045, 1.2), (0.045, 0.0), (0.05, 0.0)], 32, axis="x")


def bottle():
    s = Shape().part("bottle", "glass").lathe([(0.0, 0.0), (0.035, 0.0), (0.038, 0.15), (0.012, 0.2), (0.012, 0.26)], 32)
    return s.part("cork", "wood").lathe([(0.0, 0.24), (0.011, 0.24), (0.011, 0.275), (0.0, 0.275)], 16)


def bracket():
    s = Shape().part("bracket").box((0, 0, 0), (0.08, 0.05, 0.006)).box((0, 0, 0.006), (0.006, 0.05, 0.07))
    return s.face((0.006, 0.022, 0.006), (0.05, 0.022, 0.006), (0.006, 0.022, 0.05)).face(
        (0.006, 0.028, 0.006), (0.006, 0.028, 0.05), (0.05, 0.028, 0.006)).face(
        (0.05, 0.022, 0.006), (0.05, 0.028, 0.006), (0.006, 0.028, 0.05), (0.006, 0.022, 0.05))


def chair():
    s = Shape().part("seat", "cloth").box((-0.22, -0.22, 0.43), (0.22, 0.22, 0.48)).part("frame", "wood")
    for x in (-0.2, 0.2):
        s.box((x - 0.02, -0.22, 0), (x + 0.02, -0.18, 0.43)).box((x - 0.02, 0.18, 0), (x + 0.02, 0.22, 0.95))
    return s.box((-0.2, 0.19, 0.75), (0.2, 0.21, 0.93))


def shelf():
    """Open in front, a person would fit into it if it were larger."""
    s = Shape().part("shelf", "wood")
    for z in (0, 0.4, 0.8, 1.2, 1.6, 1.98):
        s.box((-0.45, -0.2, z), (0.45, 0.2, z + 0.02))
    return s.box((-0.47, -0.2, 0), (-0.45, 0.2, 2)).box((0.45, -0.2, 0), (0.47, 0.2, 2)).box((-0.45, 0.18, 0), (0.45, 0.2, 2))


# --- what moves and what grows ---

def wheels_at(s, places, radius=0.32, width=0.2):
    for k, (x, y) in enumerate(places):
        wheel = Shape().part(f"wheel{k}", "rubber").lathe(
            [(0.0, 0.0), (radius, 0.0), (radius, width), (0.0, width)], 24, (0, 0), "y")
        s.add(wheel.moved(x, y, radius))
    return s


def vehicle(kind="saloon"):
    s = Shape().part("body", "paint")
    if kind == "van":
        s.box((-2.4, -0.95, 0.35), (2.4, 0.95, 2.3)).part("windscreen", "glass").box((2.39, -0.85, 1.3), (2.42, 0.85, 2.0))
    else:
        s.box((-2.2, -0.88, 0.35), (2.2, 0.88, 0.85)).box((-1.1, -0.78, 0.85), (1.2, 0.78, 1.42))
        s.part("windows", "glass").box((-1.0, -0.8, 0.92), (1.1, 0.8, 1.35))
    return wheels_at(s, [(-1.4, -0.92), (1.4, -0.92), (-1.4, 0.72), (1.4, 0.72)])


def tree(seed, height=7.0):
    rng = random.Random(seed)
    s = Shape().part("trunk", "wood").lathe([(0.25, 0.0), (0.16, height * 0.5), (0.0, height * 0.8)], 10)
    s.part("leaves", "leaf")
    for _ in range(300):
        a, e, r = rng.uniform(0, 6.28), rng.uniform(-0.6, 1.3), height * 0.3 * rng.uniform(0.3, 1)
        x, y, z = r * math.cos(a) * math.cos(e), r * math.sin(a) * math.cos(e), height * 0.68 + r * math.sin(e)
        u = [rng.uniform(-0.2, 0.2) for _ in range(6)]
        s.face((x, y, z), (x + u[0], y + u[1], z + u[2]), (x + u[3], y + u[4], z + u[5]))
    return s


def forest(seed, size=60.0, count=14):
    rng = random.Random(seed)
    s = Shape().part("ground", "grass").grid(size, 12, lambda x, y: 0.6 * math.sin(x / 9) * math.cos(y / 7))
    for k in range(count):
        s.add(tree(seed + k, rng.uniform(5, 10)).moved(rng.uniform(-0.45, 0.45) * size, rng.uniform(-0.45, 0.45) * size, -0.3))
    return s


def hills(size=400.0, steps=48, high=25.0):
    def height(x, y):
        return high * (0.6 * math.sin(x / 53 + 1) * math.cos(y / 47) + 0.3 * math.sin(x / 23) * math.sin(y / 19 + 2))
    return Shape().part("terrain", "grass").grid(size, steps, height), height


def terrain_with_house():
    s, height = hills(600.0, 60, 8.0)
    return s.add(house(2).moved(z=height(0, 0)))


def ship_on_sea():
    s = Shape().part("sea", "water").grid(2000.0, 40, lambda x, y: 0.3 * math.sin(x / 11) * math.sin(y / 13))
    s.part("hull", "paint").face((-20, -4, -2), (15, -4, -2), (15, -4.5, 4), (-20, -4.5, 4)).face(
        (15, 4, -2), (-20, 4, -2), (-20, 4.5, 4), (15, 4.5, 4)).face((15, -4, -2), (24, 0, 4), (15, -4.5, 4)).face(
        (15, 4, -2), (15, 4.5, 4), (24, 0, 4)).face((-20, 4, -2), (-20, -4, -2), (-20, -4.5, 4), (-20, 4.5, 4)).face(
        (-20, -4.5, 4), (15, -4.5, 4), (24, 0, 4), (15, 4.5, 4), (-20, 4.5, 4))
    s.part("bridge", "plaster").box((-16, -3, 4), (-6, 3, 9)).part("funnel", "tiles").lathe([(1, 9), (0.9, 13)], 20, (-11, 0))
    return s


def figure():
    s = Shape().part("figure", "stone")
    s.lathe([(0.0, 0), (0.16, 0.02), (0.12, 0.5), (0.2, 0.9), (0.14, 1.15), (0.23, 1.45), (0.07, 1.52), (0.11, 1.62),
             (0.1, 1.75), (0.0, 1.82)], 24)
    return s.box((-0.35, -0.06, 1.0), (-0.24, 0.06, 1.45)).box((0.24, -0.06, 1.0), (0.35, 0.06, 1.45))


def street(houses=5):
    s = Shape().part("ground", "stone").grid(160.0, 8, lambda x, y: -0.02)
    for k in range(houses):
        s.add(house(1 + k % 3, 8, 8, furniture=False).moved((k - houses // 2) * 13.0, 8.0))
        s.add(house(1 + (k + 1) % 2, 8, 8, furniture=False).moved((k - houses // 2) * 13.0, -14.0))
    return s


def with_ground(s, size, material="grass", steps=2):
    return Shape().part("ground", material).grid(size, steps, lambda x, y: -0.01).add(s)


def under_dome(s, radius, ground=True, lowest=0.0, rings=8):
    out = Shape().part("sky", "heaven").dome(radius, 32, rings, lowest)
    if ground:
        out.part("ground", "grass").grid(1.9 * radius, 8, lambda x, y: -0.02)
    return out.add(s)


def sky_box(s, size):
    out = Shape().part("skybox", "heaven").box((-size, -size, -size), (size, size, size))
    name, material, vertices, faces = out.parts[-1]
    out.parts[-1] = (name, material, vertices, [face[::-1] for face in faces])
    out.part("ground", "grass").grid(1.9 * size, 4, lambda x, y: -0.02)
    return out.add(s)


def sky_faces(s, size):
    """A sky box whose faces are parts of their own: blue above, light around, brown below."""
    _, _, vertices, faces = Shape().part("box").box((-size, -size, -size), (size, size, size)).parts[0]
    out = Shape()
    for i, face in enumerate(faces):
        corners = [vertices[v] for v in reversed(face)]
        height = sum(z for _, _, z in corners)
        material = "heaven" if height > 3.9 * size else "earth" if height < -3.9 * size else "horizon"
        out.parts.append((f"sky {i + 1}", material, corners, [tuple(range(len(corners)))]))
    return out.add(s)


def stray(s, eye, target, lamp=None):
    s.camera, s.lamp = (eye, target), lamp
    return s


UNITS = {"m": 1.0, "cm": 100.0, "mm": 1000.0, "in": 1 / 0.0254, "ft": 1 / 0.3048}


def catalogue():
    """(name, where, shape, format, unit, up, unlit)"""
    obj, stl, glb = "obj", "stl", "glb"
    yield "house1", "any", house(1), obj, "m", "y", ()
    yield "house2_cm", "any", house(2, void=0.5), obj, "cm", "z", ()
    yield "house3_mm", "any", house(3, 12, 9, void=0.7), obj, "mm", "z", ()
    yield "house4_ft", "any", house(4, 9, 9, roof="flat"), obj, "ft", "y", ()
    yield "house1_plot", "out", house(1, ground=30), glb, "m", "y", ()
    yield "house2_plot", "out", house(2, ground=60, void=0.4), obj, "m", "z", ()
    yield "house3_plot", "out", house(3, ground=200), glb, "m", "y", ()
    yield "house_empty", "any", house(2, furniture=False, glass=False), stl, "mm", "z", ()
    yield "house_in", "any", house(2, 14, 10), obj, "in", "y", ()
    yield "street", "out", street(), glb, "m", "y", ()
    yield "room", "in", room(), glb, "m", "y", ()
    yield "room_cm", "in", room(3.2, 4.0, 2.5), obj, "cm", "y", ()
    yield "room_mm", "in", room(6, 8, 3.0), obj, "mm", "z", ()
    yield "room_closed", "in", room(window=False), glb, "m", "y", ()
    yield "room_lamp", "in", room(5, 5, 2.6, window=False, lamp=True), glb, "m", "y", ()
    yield "room_single", "in", single_sided_room(), glb, "m", "y", ()
    yield "room_single_obj", "in", single_sided_room(), obj, "m", "z", ()
    yield "hall", "in", hall(), glb, "m", "y", ()
    yield "hall_long", "in", hall(90, 24, 14, 12), obj, "m", "z", ()
    yield "corridor", "in", corridor(), glb, "m", "y", ()
    yield "attic", "in", attic(), glb, "m", "y", ()
    yield "tray", "out", tray(), stl, "mm", "z", ()
    yield "tray_large", "out", tray(0.6, 0.4, 0.2, 0.01), stl, "mm", "z", ()
    yield "tray_glb", "out", tray(0.3, 0.2, 0.1, 0.004), glb, "m", "y", ()
    yield "housing", "out", housing(), stl, "mm", "z", ()
    yield "housing_obj", "out", housing(), obj, "mm", "z", ()
    yield "gear", "out", gear(), stl, "mm", "z", ()
    yield "bowl", "out", bowl(), stl, "mm", "z", ()
    yield "bowl_glb", "out", bowl(), glb, "m", "y", ()
    yield "pipe", "out", pipe(), stl, "mm", "z", ()
    yield "bottle", "out", bottle(), glb, "m", "y", ()
    yield "bracket", "out", bracket(), stl, "mm", "z", ()
    yield "chair", "out", chair(), obj, "m", "y", ()
    yield "shelf", "out", shelf(), glb, "m", "y", ()
    yield "car", "out", vehicle(), glb, "m", "y", ()
    yield "van_ground", "out", with_ground(vehicle("van"), 40.0, "stone"), glb, "m", "y", ()
    yield "car_cm", "out", vehicle(), obj, "cm", "y", ()
    yield "tree", "out", tree(3), glb, "m", "y", ()
    yield "forest", "out", forest(5), glb, "m", "y", ()
    yield "hills", "out", hills()[0], obj, "m", "z", ()
    yield "terrain_house", "out", terrain_with_house(), glb, "m", "y", ()
    yield "ship_sea", "out", ship_on_sea(), glb, "m", "y", ()
    yield "figure_wide", "out", with_ground(figure(), 100.0, "stone", 30), glb, "m", "y", ()
    yield "figure", "out", figure(), obj, "m", "z", ()
    yield "dome_house", "out", under_dome(house(2), 300.0), glb, "m", "y", ("heaven",)
    yield "dome_lit_house", "out", under_dome(house(1), 400.0), glb, "m", "y", ()
    yield "sphere_car", "out", under_dome(vehicle(), 100.0, True, -1.0, 16), glb, "m", "y", ("heaven",)
    yield "skybox_figure", "out", sky_box(figure(), 200.0), glb, "m", "y", ("heaven",)
    yield "sky_faces", "out", sky_faces(house(1), 200.0), glb, "m", "y", ("heaven", "horizon", "earth")
    yield "stray_far", "out", stray(figure(), (40, -60, 30), (0, 0, 1)), glb, "m", "y", ()
    yield "stray_past", "out", stray(bowl(), (0.4, -0.5, 0.2), (3, -4, 3)), glb, "m", "y", ()
    yield "stray_near", "out", stray(vehicle(), (2.6, -1.4, 0.5), (2.2, -0.9, 0.4)), glb, "m", "y", ()
    yield "stray_lamp", "own", stray(chair(), (1.5, -2.2, 1.2), (0, 0, 0.5), (0, 0, -300)), glb, "m", "y", ()
    yield "crawl_space", "own", stray(room(6, 6, 1.0, window=False, furniture=False), (1, -1, 0.5), (-2, 2, 0.5)), glb, "m", "y", ()
    yield "own_camera", "own", stray(vehicle(), (6, -6, 2.5), (0, 0, 0.7)), glb, "m", "y", ()


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    lines = ["# name, first view, metres per unit, up axis: made by make_strangers.py"]
    for name, where, shape, form, unit, up, unlit in catalogue():
        path = folder / f"{name}.{form}"
        scale = UNITS[unit]
        if form == "obj":
            write_obj(shape, path, scale, up)
        elif form == "stl":
            write_stl(shape, path, scale, up)
        else:
            write_glb(shape, path, scale, unlit)
        lines.append(f"{path.name} {where} {1 / scale:.6g} {up if form != 'glb' else 'y'}")
    (folder / "strangers.txt").write_text("\n".join(lines) + "\n")
    print(len(lines) - 1, "models")


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]))
