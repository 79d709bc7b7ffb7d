#!/usr/bin/env python3
"""Builds the watering place: elephants at a pond under the setting sun. Metres, y up, water at y = 0."""
import math
import os
import random
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "tools"), os.path.join(HERE, "..", "environments")]

import elephant
import landscape
from glb import Model
from suns import SUNSET


def stand(mesh, size, degrees, x, z, ground):
    return mesh.scaled(size).turned(degrees).moved(x, ground, z)


def add_elephants(model):
    parts = elephant.build(0.06)
    for size, degrees, x, z in ((1.0, 172.0, 2.6, 0.2), (0.5, 150.0, -1.55, 1.35)):
        feet = [(x + 1.1 * size * math.sin(a), z + 1.1 * size * math.cos(a)) for a in (0.5, 2.1, 3.6, 5.2)]
        ground = min(landscape.height(*f) for f in feet)
        for mesh, material in parts:
            if not (size < 1 and material == "ivory"):
                model.add(stand(mesh, size, degrees, x, z, ground - 0.02), material)


def add_rocks(model):
    stones = [landscape.rock(seed) for seed in (61, 62, 63)]
    for k, (x, z, size) in enumerate(((-6.6, 2.3, 0.75), (-7.6, 3.0, 0.42), (6.9, 6.6, 0.62),
                                      (7.7, 6.0, 0.36),
                                      (-3.4, 9.9, 0.3), (6.2, -3.2, 0.8), (-11.0, -4.0, 1.3), (14.0, -14.0,
                                                                                               2.0))):
        y = landscape.height(x, z) + 0.12 * size
        model.add(stand(stones[k % 3], size, 67.0 * k, x, z, y), "rock")


def add_grass(model):
    dice = random.Random(71)
    tufts = [landscape.grass_tuft(dice) for _ in range(12)]
    placed = 0
    while placed < 2600:
        r, a = 3.0 + 27.0 * dice.random() ** 1.4, 2 * math.pi * dice.random()
        x, z = landscape.POND[0] + r * math.sin(a), landscape.POND[1] + r * math.cos(a)
        size, turn = 0.6 + 0.9 * dice.random(), 360 * dice.random()
        pick, chance = int(12 * dice.random()), dice.random()
        shore = landscape.pond_distance(x, z)
        if z > 12.5 or shore < 1.02 or chance > 0.25 + 0.75 * landscape.smooth_step(0.0, 0.5, _patch(x, z)):
            continue
        if math.hypot(x - 2.2, z - 0.2) < 2.4 or math.hypot(x + 1.6, z - 1.3) < 1.2:
            continue
        model.add(stand(tufts[pick], size, turn, x, z, landscape.height(x, z)), "grass")
        placed += 1


def _patch(x, z):
    return math.sin(0.9 * x + 1.3 * math.sin(0.7 * z)) * math.cos(0.8 * z + math.sin(0.6 * x))


def add_trees(model):
    trees = [landscape.acacia(seed) for seed in (81, 82)]
    for k, (x, z, size) in enumerate(((9.4, -6.5, 1.15), (-15.5, -30.0, 1.3), (-32.0, -46.0, 1.25),
                                      (20.0, -44.0, 1.3))):
        bark, leaves = trees[k % 2]
        y = landscape.height(x, z)
        model.add(stand(bark, size, 100.0 * k + 20, x, z, y), "bark")
        model.add(stand(leaves, size, 100.0 * k + 20, x, z, y), "leaf")


def add_birds(model):
    dice = random.Random(91)
    for k in range(7):
        at = (-6.0 + 3.1 * k + 2 * dice.random(), 15.0 + 2.2 * abs(k - 2.4) + dice.random(),
              -46.0 - 2 * dice.random())
        bird = landscape.bird(dice)
        model.add(bird.turned(35 + 20 * dice.random()).moved(*at), "bird")


def check_sun():
    """The scene's sun must shine from where the sky's sun stands."""
    with open(os.path.join(HERE, "organic.scn"), encoding="utf-8") as file:
        text = file.read()
    found = re.search(r'name = "sun".*?direction = \[([^]]*)\]', text, re.S)
    direction = [float(v) for v in found.group(1).split(",")]
    n = math.sqrt(sum(v * v for v in direction))
    if sum(-a * b for a, b in zip(direction, SUNSET)) / n < 0.9999:
        raise SystemExit(f"organic.scn: the sun's direction must be {[round(-c, 4) for c in SUNSET]}")


def main():
    folder = os.path.join(HERE, "generated")
    os.makedirs(folder, exist_ok=True)
    check_sun()
    model = Model()
    model.material("terrain", (1, 1, 1), roughness=0.95)
    model.material("water", (0.75, 0.85, 0.85), roughness=0.0, alpha=0.1, double_sided=True)
    model.material("skin", (1, 1, 1), roughness=0.7)
    model.material("ivory", (0.72, 0.62, 0.45), roughness=0.25)
    model.material("eye", (0.02, 0.012, 0.01), roughness=0.05)
    model.material("rock", (1, 1, 1), roughness=0.9)
    model.material("grass", (1, 1, 1), roughness=0.8, double_sided=True)
    model.material("bark", (0.12, 0.085, 0.06), roughness=0.95)
    model.material("leaf", (1, 1, 1), roughness=0.8, double_sided=True)
    model.material("bird", (0.05, 0.045, 0.045), roughness=0.9, double_sided=True)
    model.add(landscape.terrain(), "terrain")
    model.add(landscape.water(), "water")
    for build in (add_elephants, add_rocks, add_grass, add_trees, add_birds):
        build(model)
    model.write(os.path.join(folder, "organic.glb"))
    print(f"organic: {model.triangles} triangles")


if __name__ == "__main__":
    main()
