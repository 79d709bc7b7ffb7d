#!/usr/bin/env python3
"""Builds the nave: a gothic basilica of six bays with aisles, chancel arch and apse. Metres; east is -z."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "tools")]

import nave_parts as parts
from glb import Model
from mesh import Surface
from nave_furnishing import CHOIR, STONE, add_altar, add_candles, add_furniture
from nave_glass import add_glass
from nave_textures import ashlar, marble_floor
from solids import beveled_box, lathe, moved, pointed_arc, stack, sweep, vault_shell
from walls import lancet, round_window, wall

BAYS = [-12.5, -7.5, -2.5, 2.5, 7.5, 12.5]  # z of their centres
EDGES = [-15, -10, -5, 0, 5, 10, 15]        # z of the pier lines
PIER_X = 4.5                                # arcade line
SPRING_NAVE, SPRING_AISLE, SPRING_APSE = 8.9, 5.0, 8.0
NAVE_HALF, AISLE_HALF, AISLE_X = 4.12, 2.325, 7.175
APSE_Z, APSE_RADIUS = -15.5, 3.7


def vault_mapping(springing, half, ratio=parts.ARCH_RATIO):
    """Courses run along the ridge: texture coordinates are the ruled line and the arc's length."""
    radius = ratio * half

    def uv(p, n):
        arc = radius * math.asin(max(-1.0, min(1.0, (p[1] - springing) / radius)))
        return (p[0] / 2, arc / 2) if abs(n[0]) < abs(n[2]) else (p[2] / 2, arc / 2)
    return uv


def add_vaults(model):
    def shell(half_x, x, springing):
        whole = Surface()
        for z in BAYS:
            bay = vault_shell(half_x, 2.5, springing, 12, 0.25, ends=(z == BAYS[0], z == BAYS[-1]))
            whole.append(moved(bay, (x, 0.0, z)))
        return whole.closed().shaded(25, vault_mapping(springing, half_x))

    model.add(shell(NAVE_HALF, 0.0, SPRING_NAVE), "vault")
    aisle = shell(AISLE_HALF, AISLE_X, SPRING_AISLE)
    model.add(aisle, "vault")
    model.add(aisle.mirrored_x(), "vault")


def rib_set(half_x, springing, inset, width, depth, steps):
    """Ribs of one bay about the origin: two diagonals, a transverse arch at its +z end, two wall ribs."""
    h = half_x
    diagonal = [parts.rib((2 * h, 5.0), springing, h, width, depth, steps, (-h, -2.5)),
                parts.rib((-2 * h, 5.0), springing, h, width, depth, steps, (h, -2.5))]
    transverse = parts.rib((2 * h, 0.0), springing, h, 1.35 * width, 1.15 * depth, steps, (-h, 2.5))
    walls = [parts.rib((0.0, 5.0), springing, h, 0.8 * width, 0.6 * depth, steps, (s * (h - inset), -2.5))
             for s in (-1, 1)]
    boss = lathe([(0, -0.2), (0.06, -0.19), (0.12, -0.13), (0.17, -0.12), (0.2, -0.05), (0.2, 0.1),
                  (0, 0.1)], 24)
    top = springing + h * pointed_arc(1.0, parts.ARCH_RATIO)(0.0)
    return diagonal + walls + [moved(boss, (0.0, top - depth + 0.06, 0.0))], transverse


def add_ribs(model):
    for half, springing, inset, width, depth, steps, x in (
            (NAVE_HALF, SPRING_NAVE, 0.1, 0.3, 0.3, 16, 0.0), (AISLE_HALF, SPRING_AISLE, 0.12, 0.22, 0.2, 12,
                                                               AISLE_X)):
        bay, transverse = rib_set(half, springing, inset, width, depth, steps)
        bay = [s.shaded(38) for s in bay]
        transverse = transverse.shaded(38)
        for z in BAYS:
            for mesh in bay + ([transverse] if z < BAYS[-1] else []):
                placed = mesh.moved(x, 0.0, z)
                model.add(placed, "rib")
                if x:
                    model.add(placed.mirrored_x(), "rib")


def add_piers(model):
    pier = parts.pier(0.2, 4.78, samples=8).shaded(32)
    plinth = parts.octagon_block(0.72, -0.05, 0.24, 0.03).shaded(20)
    abacus = parts.octagon_block(0.76, 4.74, 5.0, 0.04).shaded(20)
    shaft = parts.pier(4.98, 8.62, 0.14, 0.07, 0.045, samples=3).shaded(32)
    impost = parts.octagon_block(0.32, 8.6, 8.92, 0.03).shaded(20)
    respond = parts.pier(0.12, 4.85, 0.2, 0.1, 0.07, samples=4).shaded(32)
    respond_plinth = parts.octagon_block(0.42, -0.05, 0.16, 0.02).shaded(20)
    respond_abacus = parts.octagon_block(0.46, 4.82, 5.02, 0.03).shaded(20)
    for z in EDGES:
        at = [(pier, PIER_X), (plinth, PIER_X), (abacus, PIER_X), (shaft, 4.03), (impost, 4.03),
              (respond, 9.4), (respond_plinth, 9.4), (respond_abacus, 9.4)]
        for mesh, x in at:
            if z == -15 and mesh is plinth:
                mesh = parts.octagon_block(0.72, -0.05, CHOIR + 0.2, 0.03).shaded(20)
            placed = mesh.moved(x, 0.0, z)
            for side in (placed, placed.mirrored_x()):
                model.add(side, "pier")


def along_z(side):
    """Walls parallel to the nave, `side` +1 at x > 0; their inner face is at the smaller d."""
    return lambda u, y, d: (side * d, y, u)


def add_walls(model):
    def stone(surface):
        model.add(surface.shaded(30, STONE), "stone")

    arches = [lancet(z, 2.0, 4.95, 5.0, steps=14) for z in BAYS]
    clerestory = [lancet(z, 1.2, 9.3, 11.0, 0.9, 12) for z in BAYS]
    aisle = [lancet(z, 0.8, 1.9, 4.5, 0.72, 10) for z in BAYS]
    for side in (1, -1):
        stone(wall(along_z(side), (-15.1, 15.1), (4.95, 8.3), (4.04, 4.96), arches))
        stone(wall(along_z(side), (-15.12, 15.12), (8.2, 14.7), (4.1, 4.9), clerestory))
        stone(wall(along_z(side), (-15.9, 15.2), (-0.25, 8.7), (9.4, 10.2), aisle))
    add_end_walls(stone)
    for side in (1, -1):
        for z in BAYS:
            arch = parts.rib((0.0, 4.0), 4.99, 2.0, 0.5, 0.14, 14, (side * PIER_X, z - 2.0)).shaded(38)
            model.add(arch, "rib")
    add_courses(model)


def add_end_walls(stone):
    west, east = (lambda u, y, d: (u, y, d)), (lambda u, y, d: (u, y, -d))
    stone(wall(west, (-10.4, 10.4), (-0.25, 6.5), (14.95, 16.0), [lancet(0.0, 1.5, -0.25, 3.1, 0.8, 14)]))
    stone(wall(west, (-10.3, 10.3), (6.4, 15.0), (14.98, 15.9), [round_window(0.0, 9.9, 2.4, 0.86, 32)]))
    stone(wall(east, (-4.7, 4.7), (-0.25, 14.8), (14.93, 15.85), [lancet(0.0, 3.3, -0.25, 8.2, 1.0, 20)]))
    for side in (1, -1):
        stone(wall(lambda u, y, d, s=side: (s * u, y, -d), (4.6, 10.3), (-0.24, 8.6), (14.96, 15.87),
                   [lancet(AISLE_X, 0.8, 1.9, 4.5, 0.72, 10)]))

    def bent(u, y, d):
        a = u / APSE_RADIUS
        return (d * math.sin(a), y, APSE_Z - d * math.cos(a))

    reach = math.radians(93) * APSE_RADIUS
    windows = [lancet(math.radians(a) * APSE_RADIUS, 0.52, 2.7, 6.0, 0.8, 8) for a in (-72, -36, 0, 36, 72)]
    stone(wall(bent, (-reach, reach), (0.2, 8.05), (APSE_RADIUS, APSE_RADIUS + 0.8), windows, 0.3))
    stone(apse_dome())


def apse_dome():
    """A half dome of the arch's profile with a thickness of 0.3 m."""
    radius, surface = APSE_RADIUS + 0.06, Surface()
    height = pointed_arc(radius, parts.ARCH_RATIO)
    steps, rows = 16, []
    heights = [radius * math.cos(math.pi / 2 * k / steps) for k in range(steps)] + [0.0]
    for thick in (0.0, 0.3):
        rows.append([])
        for k in range(45):
            a = math.radians(-93 + 186 * k / 44)
            rows[-1].append([((r + (thick if r else 0)) * math.sin(a),
                              SPRING_APSE + height(r) + (0 if r == radius else thick),
                              APSE_Z - (r + (thick if r else 0)) * math.cos(a)) for r in heights])
    inner, outer = rows
    surface.grid(inner)
    surface.append(_grid(outer).flip())
    surface.append(_grid([[c[0] for c in inner], [c[0] for c in outer]]))
    for side, flip in ((0, True), (-1, False)):
        part = _grid([inner[side], outer[side]])
        surface.append(part.flip() if flip else part)
    return surface.closed()


def _grid(rows):
    part = Surface()
    part.grid(rows)
    return part


def add_courses(model):
    """Mouldings that hide the seams between wall bands, and the ribs of the apse."""
    for side in (1, -1):
        for x, y, size in ((4.06, 8.26, 0.12), (9.42, 1.55, 0.08)):
            path = [(side * x, y, 15.0 * side), (side * x, y, -15.0 * side)]
            model.add(parts.moulding(path, size).shaded(38), "rib")
    model.add(parts.moulding([(-4.2, 6.46, 15.02), (4.2, 6.46, 15.02)], 0.14).shaded(38), "rib")
    angles = [math.radians(-92 + 184 * k / 48) for k in range(49)]
    for y, size in ((SPRING_APSE, 0.13), (2.2, 0.09)):
        path = [((APSE_RADIUS + 0.03) * math.sin(a), y, APSE_Z - (APSE_RADIUS + 0.03) * math.cos(a))
                for a in angles]
        model.add(parts.moulding(path, size).shaded(38), "rib")
    model.add(parts.rib((6.6, 0.0), 8.19, 3.3, 0.55, 0.18, 20, (-3.3, -15.45)).shaded(38), "rib")
    height = pointed_arc(APSE_RADIUS, parts.ARCH_RATIO)
    shaft = parts.pier(CHOIR - 0.02, SPRING_APSE + 0.02, 0.11, 0.06, 0.04, samples=3).shaded(32)
    for degrees in (-90, -54, -18, 18, 54, 90):
        a = math.radians(degrees)
        s, c = math.sin(a), math.cos(a)
        rs = [APSE_RADIUS * math.cos(math.pi / 2 * k / 16) for k in range(17)]
        path = [(r * s, SPRING_APSE + height(r), APSE_Z - r * c) for r in rs]
        profile = [(x, y + 0.02) for x, y in parts.rib_profile(0.2, 0.2)]
        model.add(sweep(path, [(-x, y) for x, y in profile], (c, 0.0, s)).shaded(38), "rib")
        model.add(shaft.moved((APSE_RADIUS - 0.02) * s, 0.0, APSE_Z - (APSE_RADIUS - 0.02) * c), "pier")


def add_floor(model):
    floor = beveled_box((-10.35, -0.3, -16.1), (10.35, 0.0, 16.4), 0.02)
    model.add(floor.shaded(20, lambda p, n: (p[0] / 4 + 0.25, p[2] / 4)), "floor")
    for k, (x, z0, z1) in enumerate(((4.06, -11.6, -12.1), (4.03, -11.95, -12.45))):
        model.add(beveled_box((-x, -0.1, z1), (x, 0.16 * (k + 1), z0), 0.02).shaded(20, STONE), "step")
    arc = [(4.1 * math.sin(a), APSE_Z - 4.1 * math.cos(a))
           for a in (math.pi / 2 * (1 - k / 16) for k in range(33))]
    plan = [(4.0, -12.3)] + arc + [(-4.0, -12.3)]
    choir = stack([[(x, y, z) for x, z in plan] for y in (-0.1, CHOIR)])
    model.add(choir.shaded(20, lambda p, n: (p[0] / 4 + 0.25, p[2] / 4)), "floor")


def add_windows(model):
    def place(part, to):
        """Moves a bar from the plane z = 0 by `to(x, y, z)`."""
        out = Surface()
        ids = [out.vertex(to(*p)) for p in part.positions]
        out.faces = [(ids[a], ids[b], ids[c]) for a, b, c in part.faces]
        model.add(out.closed().shaded(38), "tracery")

    clerestory = parts.tracery(1.14, 9.25, 11.0, 0.055)
    aisle = parts.tracery(0.66, 1.9, 4.5, 0.04)
    for z in BAYS:
        for side in (1, -1):
            for part in clerestory:
                place(part, lambda x, y, d, s=side, z=z: (s * (4.5 + d), y, z + x))
            for part in aisle:
                place(part, lambda x, y, d, s=side, z=z: (s * (9.86 + d), y, z + x))
    for part in parts.rose_tracery(2.2, 12, 0.07):
        place(part, lambda x, y, d: (x, 9.9 + y, 15.5 + d))


def main():
    folder = os.path.join(HERE, "generated")
    os.makedirs(folder, exist_ok=True)
    model = Model()
    wall_picture, vault_picture = model.texture(ashlar(11, 1.0)), model.texture(ashlar(12, 0.55))
    floor_picture = model.texture(marble_floor(5))
    model.material("stone", (0.9, 0.9, 0.9), roughness=0.95, texture=wall_picture)
    model.material("vault", (0.98, 0.96, 0.93), roughness=0.95, texture=vault_picture)
    model.material("rib", (0.74, 0.62, 0.465), roughness=0.9)
    model.material("pier", (0.72, 0.605, 0.455), roughness=0.9)
    model.material("tracery", (0.6, 0.54, 0.45), roughness=0.9)
    model.material("step", (0.85, 0.84, 0.82), roughness=0.5, texture=wall_picture)
    model.material("floor", (1.0, 1.0, 1.0), roughness=0.08, texture=floor_picture)
    model.material("marble", (0.78, 0.74, 0.7), roughness=0.12)
    model.material("wood", (0.2, 0.1, 0.045), roughness=0.3)
    model.material("iron", (0.06, 0.06, 0.065), roughness=0.4, metallic=0.5)
    model.material("brass", (0.9, 0.66, 0.3), roughness=0.2, metallic=1.0)
    model.material("cloth", (0.75, 0.72, 0.66), roughness=0.95)
    model.material("wax", (0.85, 0.78, 0.62), roughness=0.6)
    model.material("flame", (1.0, 0.7, 0.3), roughness=1.0, emissive=(1.0, 0.55, 0.18))
    model.material("water", (0.9, 0.95, 0.97), roughness=0.0, alpha=0.05)
    for build in (add_vaults, add_ribs, add_piers, add_walls, add_floor, add_windows, add_candles, add_altar,
                  add_furniture, add_glass):
        build(model)
    model.write(os.path.join(folder, "nave.glb"))
    print(f"nave: {model.triangles} triangles")


if __name__ == "__main__":
    main()
