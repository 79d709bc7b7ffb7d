"""What stands and hangs in the nave: candles, altar, pews, door, font. Metres."""
import math

import nave_parts as parts
from mesh import Surface, box_mapping
from solids import beveled_box, circle, lathe, round_profile, stack, sweep, torus
from walls import lancet

CHOIR = 0.48                                # height of the choir's floor: three steps of 0.16 m
STONE = box_mapping(2.0)


def add_candles(model):
    wax, flame = parts.candle(0.3, 0.025)
    wax, flame = wax.shaded(40), flame.shaded(60)

    def lit(x, y, z, size=1.0):
        model.add(wax.scaled(size).moved(x, y, z), "wax")
        model.add(flame.scaled(size).moved(x, y, z), "flame")

    metal, places = parts.chandelier(1.05, 12, 1.9)
    metal = [m.shaded(40) for m in metal]
    for z in (12.5, 2.5, -7.5):
        for mesh in metal:
            model.add(mesh.moved(0.0, 4.4, z), "brass")
        model.add(sweep([(0.0, 6.25, z), (0.0, 13.7, z)], round_profile(0.015, 6)).shaded(60), "brass")
        for x, y, dz in places:
            lit(x, 4.4 + y, z + dz)
    stick = parts.candlestick().shaded(40)
    for x in (-1.05, -0.75, -0.45, 0.45, 0.75, 1.05):
        model.add(stick.moved(x, 1.57, -15.75), "brass")
        lit(x, 2.18, -15.75)
    for x in (-1.9, 1.9):
        model.add(stick.scaled(2.0).moved(x, CHOIR, -14.2), "brass")
        lit(x, CHOIR + 1.23, -14.2, 2.2)


def add_altar(model):
    for low, high, bevel, material in (
            ((-1.9, 0.4, -16.6), (1.9, CHOIR + 0.15, -14.4), 0.02, "step"),
            ((-1.1, 0.5, -16.1), (1.1, 1.42, -15.2), 0.03, "pier"),
            ((-1.35, 1.41, -16.25), (1.35, 1.56, -15.05), 0.04, "pier"),
            ((-0.55, 1.36, -15.03), (0.55, 1.575, -15.02), 0.002, "cloth"),
            ((-0.55, 1.562, -16.2), (0.55, 1.574, -15.021), 0.002, "cloth"),
            ((-0.035, 1.575, -15.93), (0.035, 3.1, -15.87), 0.012, "brass"),
            ((-0.42, 2.58, -15.925), (0.42, 2.65, -15.875), 0.012, "brass")):
        model.add(beveled_box(low, high, bevel).shaded(20, STONE if material in ("step", "stone") else None),
                  material)
    ring = torus(0.26, 0.02, 40, 10)
    upright = Surface()
    ids = [upright.vertex((x, 2.615 + z, -15.9 + y)) for x, y, z in ring.positions]
    upright.faces = [(ids[a], ids[b], ids[c]) for a, b, c in ring.faces]
    model.add(upright.closed().shaded(40), "brass")


def add_furniture(model):
    pew = [p.shaded(30) for p in parts.bench(2.0)]
    for row in range(7):
        for x in (-2.25, 2.25):
            for mesh in pew:
                model.add(mesh.moved(x, 0.0, -8.6 + 1.25 * row), "wood")
    board = beveled_box((-1.38, -0.05, 15.455), (1.38, 3.1, 15.475), 0.004)
    model.add(board.shaded(25), "wood")
    leaf = [p.shaded(25) for p in parts.door_leaf(1.3, 3.05, 0.02)]
    for mesh in leaf:
        for placed in (mesh.moved(-1.302, 0.0, 15.45), mesh.moved(0.002, 0.0, 15.45)):
            model.add(placed, "wood")
    head = lancet(0.0, 1.36, 3.06, 3.1, steps=14)
    outline = [(u, h) for u, _, h in head.samples]
    lunette = stack([[(x, y, z) for x, y in [(-1.36, 3.06)] + outline + [(1.36, 3.06)]]
                     for z in (15.41, 15.47)])
    model.add(lunette.shaded(25), "wood")
    for x in (-0.12, 0.12):
        ring = [(x + 0.07 * math.sin(a), 1.15 + 0.07 * math.cos(a), 15.38)
                for a in (math.pi * k / 10 for k in range(20))]
        model.add(sweep(ring, round_profile(0.01, 6), (0.0, 0.0, 1.0), closed=True).shaded(60), "iron")
    font = lathe([(0, -0.02), (0.5, -0.02), (0.5, 0.16), (0.34, 0.2), (0.22, 0.3), (0.17, 0.45), (0.17, 0.7),
                  (0.26, 0.76), (0.48, 0.86), (0.55, 1.0), (0.56, 1.08), (0.5, 1.1), (0.46, 1.06),
                  (0.4, 0.98), (0.2, 0.92), (0, 0.9)], 64)
    model.add(font.shaded(35).moved(-2.3, 0.0, 11.6), "marble")
    water = Surface()
    water.fan(circle(0.475, 48, 1.05))
    model.add(water.shaded().moved(-2.3, 0.0, 11.6), "water")
