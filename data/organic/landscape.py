"""The ground about the pond: rolling terrain, rocks, grass, acacias, birds. y up, water at y = 0."""
import math
import random

from mesh import Mesh, Surface, add, cross, normalize, scale, sub
from pictures import Noise
from solids import displaced, icosphere, round_profile, smooth_step, sweep

POND = (-1.2, 6.0, 8.2, 3.6)               # centre x and z, half axes
_noise = Noise(51)


def pond_distance(x, z):
    """1 on the shore, less over the water; the shore wavers."""
    u, v = (x - POND[0]) / POND[2], (z - POND[1]) / POND[3]
    return math.hypot(u, v) * (1 + 0.16 * _noise.at2(0.35 * x + 9, 0.35 * z))


def height(x, z):
    r = math.hypot(x, z)
    rolling = 0.3 + 0.22 * _noise.at2(0.09 * x, 0.09 * z) + 0.05 * _noise.fractal2(0.5 * x, 0.5 * z, 3)
    hills = smooth_step(18.0, 160.0, r) * 11.0 * (0.35 + _noise.fractal2(0.016 * x + 3, 0.016 * z + 8, 3))
    shore = pond_distance(x, z)
    ground = rolling + hills
    return ground + (-0.75 - ground) * (1 - smooth_step(0.62, 1.32, shore))


def terrain():
    """Rings that widen from the pond to the horizon."""
    sectors, rings = 224, 118
    radii = [0.0] + [0.35 * 1.0645 ** k for k in range(rings)]
    rows = []
    for r in radii:
        row = []
        for k in range(sectors if r else 1):
            a = 2 * math.pi * k / sectors
            x, z = r * math.sin(a) + POND[0], r * math.cos(a) + POND[1]
            row.append((x, height(x, z), z))
        rows.append(row if r else row * sectors)
    surface = Surface()
    surface.grid([row + row[:1] for row in rows])
    mesh = surface.shaded(60)
    grass, straw, earth, mud = (0.15, 0.13, 0.045), (0.33, 0.235, 0.09), (0.25, 0.145, 0.075), (0.1, 0.062,
                                                                                                0.04)

    def colour(p, n):
        x, y, z = p
        patch = smooth_step(-0.3, 0.45, _noise.fractal2(0.21 * x + 40, 0.21 * z, 4))
        fine = 1 + 0.22 * _noise.at2(2.3 * x, 2.3 * z)
        c = _mix(grass, straw, patch)
        c = _mix(c, earth, smooth_step(0.2, 0.7, _noise.fractal2(0.13 * x, 0.13 * z + 70, 3)))
        c = _mix(mud, c, smooth_step(0.02, 0.26, y))
        return tuple(fine * v for v in c)

    return mesh.paint(colour)


def _mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def water():
    """A sheet that ends under the shore, a little rippled by its normals."""
    surface = Surface()
    cx, cz, a, b = POND
    rows = [[(cx + t * 1.5 * a * math.sin(w), 0.0, cz + t * 1.6 * b * math.cos(w))
             for w in (2 * math.pi * k / 96 for k in range(97))] for t in [k / 60 for k in range(61)]]
    surface.grid([row[:-1] + row[:1] for row in rows])
    mesh = surface.flip().shaded(60)

    def ripple(p):
        x, _, z = p
        e, n = 0.05, _noise
        here = n.at2(0.8 * x, 2.1 * z) + 0.4 * n.at2(2.3 * x, 6.1 * z)
        dx = n.at2(0.8 * (x + e), 2.1 * z) + 0.4 * n.at2(2.3 * (x + e), 6.1 * z) - here
        dz = n.at2(0.8 * x, 2.1 * (z + e)) + 0.4 * n.at2(2.3 * x, 6.1 * (z + e)) - here
        return normalize((-0.0022 * dx / e, 1.0, -0.0022 * dz / e))

    mesh.normals = [ripple(p) for p in mesh.positions]
    return mesh


def rock(seed):
    """A weathered boulder of about unit size."""
    noise = Noise(seed)

    def place(p):
        r = 1 + 0.34 * noise.at3(1.1 * p[0], 1.1 * p[1], 1.1 * p[2]) + 0.1 * noise.fractal3(*scale(p, 3.1), 3)
        return (r * p[0], 0.62 * r * p[1], 0.85 * r * p[2])

    mesh = displaced(icosphere(4), place).shaded(50)

    def colour(p, n):
        tone = 1 + 0.35 * noise.fractal3(*scale(p, 4.0), 3)
        lichen = smooth_step(0.15, 0.6, noise.fractal3(*add(scale(p, 2.0), (9.0, 0.0, 0.0)), 3)) * max(0.0,
                                                                                                       n[1])
        return tuple(tone * c for c in _mix((0.24, 0.17, 0.125), (0.3, 0.27, 0.13), lichen))

    return mesh.paint(colour)


def grass_tuft(dice):
    """Blades that lean outwards, each three triangles of two sides' worth of light."""
    mesh = Mesh()
    mesh.colours = []
    for _ in range(8):
        a, lean = 2 * math.pi * dice.random(), 0.15 + 0.5 * dice.random()
        tall, wide = 0.22 + 0.3 * dice.random(), 0.012 + 0.008 * dice.random()
        x, z = 0.1 * (dice.random() - 0.5), 0.1 * (dice.random() - 0.5)
        out, across = (math.sin(a), 0.0, math.cos(a)), (math.cos(a), 0.0, -math.sin(a))
        root, first = (x, -0.04, z), len(mesh.positions)
        middle = add(root, (0.35 * lean * tall * out[0], 0.6 * tall, 0.35 * lean * tall * out[2]))
        tip = add(root, (lean * tall * out[0], tall, lean * tall * out[2]))
        n = normalize(cross(across, sub(tip, root)))
        n = n if n[1] > 0 else scale(n, -1)
        tone = 0.7 + 0.6 * dice.random()
        for p, shade in ((add(root, scale(across, -wide)), 0.5), (add(root, scale(across, wide)), 0.5),
                         (add(middle, scale(across, 0.8 * wide)),
                          0.9), (add(middle, scale(across, -0.8 * wide)), 0.9),
                         (tip, 1.25)):
            mesh.positions.append(p)
            mesh.normals.append(n)
            mesh.colours.append(tuple(tone * shade * c for c in (0.42, 0.3, 0.1)))
        faces = ((0, 1, 2), (0, 2, 3), (3, 2, 4))
        p = [mesh.positions[first + k] for k in range(3)]
        turned = sum(u * v for u, v in zip(cross(sub(p[1], p[0]), sub(p[2], p[0])), n)) < 0
        mesh.faces += [tuple(first + k for k in (f[::-1] if turned else f)) for f in faces]
    return mesh


def acacia(seed):
    """An umbrella thorn, 5 m high: (bark, leaves)."""
    dice = random.Random(seed)
    bark, tips = Surface(), []

    def limb(start, direction, reach, radius, order):
        path, p, d = [start], start, direction
        pieces = 5
        for _ in range(pieces):
            jitter = tuple(0.22 * (dice.random() - 0.5) for _ in range(3))
            flatten = (0.0, (0.0, 0.02, -0.05, -0.06)[order], 0.0) if order else (0.0, 0.05, 0.0)
            d = normalize(add(add(d, jitter), flatten))
            p = add(p, scale(d, reach / pieces))
            path.append(p)
        widths = [radius * (1 - 0.55 * k / pieces) for k in range(pieces + 1)]
        bark.append(sweep(path, round_profile(1.0, 8 if order < 2 else 5), widths=widths))
        if order == 3:
            tips.append(p)
            return
        forks = (4, 3, 3)[order]
        for k in range(forks):
            a = 2 * math.pi * (k + 0.7 * dice.random()) / forks
            spread = (0.62, 0.7, 0.72)[order]
            side = normalize(add(scale(d, 1 - spread), (spread * math.sin(a), 0.25, spread * math.cos(a))))
            limb(path[-1 if k else -2], side, reach * (0.62, 0.7, 0.7)[order], radius * 0.5, order + 1)

    limb((0.0, -0.3, 0.0), (0.08, 1.0, 0.04), 2.7, 0.2, 0)
    return bark.shaded(60), _leaves(tips, dice)


def _leaves(tips, dice):
    """Flat clouds of small leaves about the ends of the branches."""
    mesh = Mesh()
    mesh.colours = []
    for x, y, z in tips:
        for _ in range(85):
            a, r = 2 * math.pi * dice.random(), 0.95 * math.sqrt(dice.random())
            c = (x + r * math.sin(a), y + 0.1 + 0.26 * (dice.random() - 0.35) * (1.25 - r),
                 z + r * math.cos(a))
            n = normalize((dice.random() - 0.5, 0.35 + dice.random(), dice.random() - 0.5))
            u = normalize(cross(n, (dice.random() - 0.5, 0.2, dice.random() - 0.5)))
            v = cross(n, u)
            size, first, tone = 0.05 + 0.05 * dice.random(), len(mesh.positions), 0.65 + 0.7 * dice.random()
            for i, j in ((-1.4, 0), (0, -0.6), (1.4, 0), (0, 0.6)):
                mesh.positions.append(add(c, add(scale(u, i * size), scale(v, j * size))))
                mesh.normals.append(n)
                mesh.colours.append(tuple(tone * k for k in (0.1, 0.12, 0.03)))
            mesh.faces += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return mesh


def bird(dice):
    """A gliding bird seen from afar: two wings and a body, 1.6 m across."""
    surface = Surface()
    lift = 0.2 + 0.25 * dice.random()
    nose, tail, left, right = (0, 0, -0.3), (0, 0.02, 0.35), (-0.8, lift, 0.15), (0.8, lift, 0.15)
    for wing in (left, right):
        elbow = (wing[0] * 0.5, lift * 0.85, -0.1)
        for tri in ((nose, elbow, tail), (elbow, wing, tail)):
            surface.fan(tri if wing is right else tri[::-1])
    return surface.flip().shaded(10)
