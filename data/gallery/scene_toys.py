"""Rabbit, ladybird, cow, chairs and bricks on a polished floor, for light from everywhere (8.12 and 8.13)."""
import math

import cow
import furniture
import ladybird
import palette
import rabbit
from furniture import placed
from mesh import Surface
from solids import beveled_box, lathe, sphere

BRICKS = (("red", (0.6, 0.06, 0.045)), ("yellow", (0.78, 0.5, 0.05)), ("blue", (0.06, 0.2, 0.5)),
          ("green", (0.12, 0.4, 0.14)))


def stage(model):
    """A floor that bends up into the wall behind."""
    profile = [(6.0, 0.0), (-2.6, 0.0)]
    profile += [(-2.6 - 1.2 * math.sin(a), 1.2 - 1.2 * math.cos(a))
                for a in (math.pi / 2 * k / 24 for k in range(1, 25))]
    profile += [(-3.8, 6.0)]
    surface = Surface()
    surface.grid([[(x, y, z) for x in (-9.0, 9.0)] for z, y in profile])
    model.add(surface.shaded(30), "floor")


def bricks(model):
    size = 0.32
    for colour, x, y, z, turn in (("blue", -1.55, 0, 0.55, 12), ("red", -1.2, 0, 0.75, 48),
                                  ("yellow", -1.38, 1, 0.62, 30),
                                  ("green", 1.95, 0, 0.85, 20)):
        brick = beveled_box((-size / 2, 0.0, -size / 2), (size / 2, size, size / 2), 0.02).shaded(25)
        model.add(brick.turned(turn).moved(x, y * size, z), colour)
    arch = [(0, 0.0), (0.16, 0.0), (0.165, 0.01), (0.165, 0.5), (0.0, 0.78)]
    model.add(lathe(arch, 48).shaded(40).moved(1.95, 0.0, 0.3), "blue")
    model.add(sphere(0.2, 64, 32).shaded(60).moved(-0.55, 0.2, 1.3), "yellow")


def build(model):
    palette.use(model, "hide", "horn", "eye", "fur", "shell", "cheek", "wood")
    model.material("floor", (0.5, 0.66, 0.64), roughness=0.06, double_sided=True)
    model.material("wings", (1, 1, 1), roughness=0.1, texture=model.texture(ladybird.spots()))
    for name, colour in BRICKS:
        model.material(name, colour, roughness=0.25)
    stage(model)
    bricks(model)
    for parts in (placed(rabbit.build(), -0.6, -0.1, -38),
                  placed(ladybird.build(), 0.62, 0.95, -150, 0.0, 0.75),
                  placed(cow.build(0.032), 1.05, -0.55, -158, 0.0, 0.68),
                  placed(furniture.wood_chair(), -1.75, -0.85, -40, 0.0, 1.15),
                  placed(furniture.wood_chair(), 2.15, -1.3, -140, 0.0, 1.15)):
        palette.add(model, parts)
