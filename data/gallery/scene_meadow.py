"""A cow on a hill looks at the setting sun; fence, puddle, poppies in the grass (figure 8.10)."""
import math
import random

import cow
import landscape
import palette
from mesh import Surface, normalize
from pictures import Noise
from pose import mixed
from solids import round_profile, smooth_step, sphere, sweep

_noise = Noise(201)
PUDDLE = (-2.1, 1.2, 2.3, 1.25)            # middle x and z, half axes
COW = (1.15, -0.6, 140.0)                  # x, z, degrees


def puddle_distance(x, z):
    waver = 1 + 0.2 * _noise.at2(0.8 * x + 5, 0.8 * z)
    return math.hypot((x - PUDDLE[0]) / PUDDLE[2], (z - PUDDLE[1]) / PUDDLE[3]) * waver


def height(x, z):
    """A crest that falls off to the west (-z), hills in the distance."""
    near = 0.12 * _noise.fractal2(0.3 * x, 0.3 * z, 3) + 0.035 * (x + 1.5)
    slope = -0.16 * max(0.0, -z - 2.5) + 2.2 * smooth_step(-30.0, -70.0, z)
    r = math.hypot(x, z)
    hills = smooth_step(35.0, 170.0, r) * (4.0 + 9.0 * (0.4 + _noise.fractal2(0.013 * x + 3, 0.013 * z + 8, 3)))
    ground = near + max(-5.5, slope) + hills
    shore = puddle_distance(x, z)
    return ground + (-0.35 - ground) * (1 - smooth_step(0.55, 1.5, shore))


def terrain():
    sectors, rings = 220, 112
    rows = []
    for r in [0.0] + [0.3 * 1.066 ** k for k in range(rings)]:
        row = []
        for k in range(sectors if r else 1):
            a = 2 * math.pi * k / sectors
            x, z = r * math.sin(a), r * math.cos(a)
            row.append((x, height(x, z), z))
        rows.append(row if r else row * sectors)
    surface = Surface()
    surface.grid([row + row[:1] for row in rows])
    mesh = surface.shaded(60)

    def colour(p, n):
        x, y, z = p
        field = smooth_step(-0.1, 0.35, _noise.fractal2(0.045 * x + 31, 0.045 * z, 2))
        c = mixed((0.075, 0.12, 0.03), (0.24, 0.21, 0.06), field if math.hypot(x, z) > 14 else 0.25 * field)
        c = mixed((0.07, 0.045, 0.03), c, smooth_step(-0.16, -0.02, y) if puddle_distance(x, z) < 1.7 else 1.0)
        return tuple(v * (1 + 0.25 * _noise.at2(2.7 * x, 2.7 * z)) for v in c)

    return mesh.paint(colour)


def puddle():
    cx, cz, a, b = PUDDLE
    surface = Surface()
    rows = [[(cx + t * 1.7 * a * math.sin(w), -0.12, cz + t * 1.7 * b * math.cos(w))
             for w in (2 * math.pi * k / 96 for k in range(96))]
            for t in [k / 40 for k in range(41)]]
    surface.grid([row + row[:1] for row in rows])
    mesh = surface.flip().shaded(60)
    mesh.normals = [normalize((0.006 * _noise.at2(5 * p[0], 13 * p[2]), 1.0,
                               0.012 * _noise.at2(5 * p[0] + 40, 13 * p[2]))) for p in mesh.positions]
    return mesh


def fence():
    """Posts and two rails along the crest."""
    posts, parts = [], []
    for k in range(13):
        x = -15.0 + 2.3 * k
        posts.append((x, -4.4 + 0.012 * x * x))
    dice = random.Random(202)
    for x, z in posts:
        y, lean = height(x, z), 0.06 * (dice.random() - 0.5)
        parts.append(sweep([(x, y - 0.2, z), (x + lean, y + 1.12, z)], round_profile(0.065, 10),
                           widths=[1.0, 0.85]).shaded(50))
    for level in (0.52, 0.95):
        path = [(x, height(x, z) + level + 0.05 * (dice.random() - 0.5), z + 0.08) for x, z in posts]
        parts.append(sweep(path, round_profile(0.04, 8)).shaded(60))
    return parts


def poppy(dice):
    """A flower on its stem: (stem, petals)."""
    tall = 0.3 + 0.25 * dice.random()
    lean = 0.12 * (dice.random() - 0.5)
    stem = sweep([(0, -0.05, 0), (0.4 * lean, 0.6 * tall, 0), (lean, tall, 0)],
                 round_profile(0.004, 5)).shaded(60)
    surface = Surface()
    rows = []
    for j in range(5):
        t = j / 4
        rows.append([(lean + r * math.sin(a), tall + 0.034 * t ** 1.5, r * math.cos(a))
                     for a, r in ((2 * math.pi * k / 16,
                                   0.004 + 0.042 * t * (1 + 0.14 * math.cos(8 * math.pi * k / 16)))
                                   for k in range(16))])
    surface.grid([row + row[:1] for row in rows])
    return stem, surface.shaded(60)


def add_plants(model):
    dice = random.Random(203)
    tufts = [landscape.grass_tuft(dice) for _ in range(14)]
    for tuft in tufts:
        tuft.colours = [(0.5 * r, 0.72 * g, 0.5 * b) for r, g, b in tuft.colours]
    flowers = [poppy(dice) for _ in range(6)]
    placed = 0
    while placed < 5200:
        r, a = 1.2 + 21.0 * dice.random() ** 1.25, 2 * math.pi * dice.random()
        x, z = r * math.sin(a), 2.0 - r * math.cos(a)
        size, turn = 0.45 + 0.5 * dice.random(), 360 * dice.random()
        pick, chance = int(14 * dice.random()), dice.random()
        dense = 0.35 + 0.65 * smooth_step(-0.3, 0.4, _noise.at2(0.5 * x + 60, 0.5 * z))
        if z > 5.6 or puddle_distance(x, z) < 1.25 or chance > dense:
            continue
        model.add(tufts[pick].scaled(size).turned(turn).moved(x, height(x, z), z), "grass")
        placed += 1
        if chance < 0.07 and z > -7:
            stem, petals = flowers[pick % 6]
            model.add(stem.turned(turn).moved(x, height(x, z), z), "stem")
            model.add(petals.turned(turn).moved(x, height(x, z), z), "petal")


def build(model):
    palette.use(model, "hide", "horn", "eye", "gold")
    model.material("terrain", (1, 1, 1), roughness=0.95)
    model.material("water", (0.75, 0.85, 0.85), roughness=0.0, alpha=0.1, double_sided=True)
    model.material("grass", (1, 1, 1), roughness=0.8, double_sided=True)
    model.material("stem", (0.08, 0.11, 0.03), roughness=0.8)
    model.material("petal", (0.75, 0.04, 0.02), roughness=0.7, double_sided=True)
    model.material("timber", (0.2, 0.14, 0.1), roughness=0.9)
    model.add(terrain(), "terrain")
    model.add(puddle(), "water")
    for part in fence():
        model.add(part, "timber")
    x, z, turn = COW
    feet = [(x + 1.0 * math.sin(a), z + 1.0 * math.cos(a)) for a in (0.5, 2.1, 3.6, 5.2)]
    ground = min(height(*f) for f in feet)
    for mesh, material in cow.build():
        model.add(mesh.turned(turn).moved(x, ground - 0.01, z), material)
    a = math.radians(turn)
    bell = (x + 0.98 * math.cos(a), ground + 0.86, z - 0.98 * math.sin(a))
    model.add(sphere(0.075, 24, 12).shaded(60).moved(*bell), "gold")
    add_plants(model)
