"""The sky of space: the Milky Way and stars all around. And the part of the Earth that is seen from orbit."""
import math
import random

from mesh import Mesh, normalize, snapped
from pictures import Noise, png_bytes, srgb_bytes
from pose import mixed
from skies import Night, mix, step
from solids import smooth_step

RADIUS, HEIGHT = 60.0, 11.0                # of the Earth, and of the orbit above it
HORIZON = math.acos(RADIUS / (RADIUS + HEIGHT))
CENTRE = (0.0, -RADIUS - HEIGHT, 0.0)
AXIS = normalize((0.22, 1.0, -0.42))       # from the centre to the middle of what is painted
HALF = 0.72                                # radians from there to the edge of the painted square
SIZE = 720


class Space(Night):
    """Without horizon, and without stars: those are small triangles, sharper than a map."""

    def __call__(self, d):
        sky = (0.0016, 0.0021, 0.0038)
        band = self.band(d)
        if band > 0.002:
            bulge = 0.5 + 0.5 * sum(a * b for a, b in zip(d, self.CENTRE))
            clump = self.noise.fractal3(5 * d[0], 5 * d[1], 5 * d[2], 4, 0.6)
            dust = step(0.05, 0.75, self.noise.fractal3(6 * d[0] + 30, 6 * d[1], 6 * d[2], 3, 0.6) + 0.9 * band
                        - 0.45)
            light = 0.03 * band * (0.35 + 1.5 * bulge ** 3) * max(0.0, 1 + 0.9 * clump) * (1 - 0.8 * dust)
            tint = mix((0.75, 0.85, 1.1), (1.15, 0.95, 0.8), bulge ** 2)
            sky = tuple(s + light * t for s, t in zip(sky, tint))
        return sky


STAR_TINTS = {"warm": (1.0, 0.74, 0.5), "white": (1.0, 0.95, 0.9), "blue": (0.65, 0.8, 1.15)}
MAGNITUDES = 4                             # each 2.6 times as bright as the next


def add_stars(model, count=5200, seed=8, distance=320.0):
    """Triangles that face the origin, of materials "star <tint> <magnitude>"; the scene says how they shine."""
    dice, sky = random.Random(seed), Space()
    for tint in STAR_TINTS:
        for magnitude in range(MAGNITUDES):
            model.material(f"star {tint} {magnitude}", (0, 0, 0), roughness=1.0, emissive=(1, 1, 1),
                           double_sided=True)
    meshes = {}
    while count:
        y, a = 2 * dice.random() - 1, 2 * math.pi * dice.random()
        d = (math.sqrt(1 - y * y) * math.sin(a), y, -math.sqrt(1 - y * y) * math.cos(a))
        chance, rank, heat, turn = (dice.random() for _ in range(4))
        if chance > 0.25 + 0.75 * sky.band(d):
            continue
        count -= 1
        magnitude = sum(rank > share for share in (0.02, 0.09, 0.32))
        tint = ("warm", "white", "blue")[min(2, int(3 * heat))]
        _star(meshes.setdefault(f"star {tint} {magnitude}", Mesh()), d, distance,
              (0.3, 0.25, 0.2, 0.18)[magnitude], turn)
    for name, mesh in meshes.items():
        model.add(mesh, name)


def _star(mesh, d, distance, size, turn):
    side = normalize((d[1], -d[0], 0.0) if abs(d[2]) < 0.9 else (0.0, d[2], -d[1]))
    up = (d[1] * side[2] - d[2] * side[1], d[2] * side[0] - d[0] * side[2], d[0] * side[1] - d[1] * side[0])
    first = len(mesh.positions)
    for k in range(3):
        a = 2 * math.pi * (turn + k / 3)
        mesh.positions.append(snapped(tuple(distance * c + size * (math.cos(a) * s + math.sin(a) * u)
                                            for c, s, u in zip(d, side, up))))
        mesh.normals.append(tuple(-c for c in d))
    mesh.faces.append((first, first + 1, first + 2))


def _axes():
    """Two directions across AXIS."""
    u = normalize((AXIS[1], -AXIS[0], 0.0))
    v = (AXIS[1] * u[2] - AXIS[2] * u[1], AXIS[2] * u[0] - AXIS[0] * u[2], AXIS[0] * u[1] - AXIS[1] * u[0])
    return u, v


def _direction(s, t):
    """From the Earth's centre; s and t in -1..1 are angles across AXIS over HALF."""
    u, v = _axes()
    angle = HALF * math.hypot(s, t)
    k = math.sin(angle) / (math.hypot(s, t) or 1.0)
    c = math.cos(angle)
    return tuple(c * a + k * (s * p + t * q) for a, p, q in zip(AXIS, u, v))


def earth(steps=150):
    """The painted part of the globe."""
    mesh = Mesh()
    mesh.uvs = []
    for j in range(steps + 1):
        for i in range(steps + 1):
            s, t = 2 * i / steps - 1, 2 * j / steps - 1
            n = _direction(s, t)
            mesh.positions.append(snapped(tuple(c + RADIUS * x for c, x in zip(CENTRE, n))))
            mesh.normals.append(n)
            mesh.uvs.append((i / steps, j / steps))
    for j in range(steps):
        for i in range(steps):
            a = j * (steps + 1) + i
            mesh.faces += [(a, a + 1, a + steps + 2), (a, a + steps + 2, a + steps + 1)]
    return mesh


def earth_map():
    """Sea, land, ice and clouds; bluer towards the horizon, where one looks through more air."""
    land, cloud = Noise(181), Noise(182)
    rows = []
    for j in range(SIZE):
        row = bytearray()
        for i in range(SIZE):
            d = _direction(2 * (i + 0.5) / SIZE - 1, 1 - 2 * (j + 0.5) / SIZE)
            row += srgb_bytes(_surface(d, land, cloud))
        rows.append(bytes(row))
    return png_bytes(SIZE, SIZE, rows)


def _surface(d, land, cloud):
    x, y, z = (5.0 * c for c in d)
    away = math.acos(min(1.0, d[1])) / HORIZON
    if away > 1.08:
        return (0.5, 0.7, 0.95)
    high = land.fractal3(x + 2.1, y + 0.7, z + 5.2, 6, 0.56)
    shore = smooth_step(0.05, 0.075, high)
    sea = mixed((0.006, 0.028, 0.09), (0.02, 0.12, 0.17), (high + 0.22) / 0.27)
    dry = smooth_step(-0.3, 0.4, land.at3(1.3 * x + 9, 1.3 * y, 1.3 * z))
    ground = mixed((0.04, 0.085, 0.025), (0.3, 0.2, 0.095), dry)
    ground = mixed(ground, (0.2, 0.15, 0.1), smooth_step(0.3, 0.75, high))
    c = mixed(sea, ground, shore)
    wx, wy = 0.55 * cloud.at3(1.4 * x, 1.4 * y, 1.4 * z), 0.55 * cloud.at3(1.4 * x + 20, 1.4 * y, 1.4 * z)
    cover = cloud.fractal3(1.6 * (x + wx), 1.6 * (y + wy), 1.6 * (z - wx), 6, 0.58)
    c = mixed(c, (0.88, 0.9, 0.93), 0.95 * smooth_step(0.08, 0.75, cover))
    return mixed(c, (0.42, 0.64, 0.95), 0.05 + 0.85 * max(0.0, away) ** 9)


def glow(eye, rim=1.075, steps=256, rings=10):
    """The shine of the air above the horizon as a ring across the view from `eye`: texture u runs outwards."""
    towards = normalize(tuple(e - c for e, c in zip(eye, CENTRE)))
    distance = math.sqrt(sum((e - c) ** 2 for e, c in zip(eye, CENTRE)))
    cap = math.acos(RADIUS / distance)
    u = normalize((towards[1], -towards[0], 0.0))
    v = tuple(a * b - c * d for a, b, c, d in zip((towards[1], towards[2], towards[0]), (u[2], u[0], u[1]),
                                                 (towards[2], towards[0], towards[1]), (u[1], u[2], u[0])))
    mesh = Mesh()
    mesh.uvs = []
    for j in range(rings + 1):
        r = RADIUS * math.sin(cap) * (0.995 + (rim - 0.995) * j / rings)
        for k in range(steps):
            a = 2 * math.pi * k / steps
            p = tuple(c + RADIUS * math.cos(cap) * t + r * (math.cos(a) * m + math.sin(a) * n)
                      for c, t, m, n in zip(CENTRE, towards, u, v))
            mesh.positions.append(snapped(p))
            mesh.normals.append(towards)
            mesh.uvs.append((0.02 + 0.96 * j / rings, 0.5))
    for j in range(rings):
        for k in range(steps):
            a, b = j * steps + k, j * steps + (k + 1) % steps
            mesh.faces += [(a, a + steps, b + steps), (a, b + steps, b)]
    return mesh


def glow_mask(size=256):
    """Coverage from the rim of the Earth (left) to space (right)."""
    row = bytearray()
    for i in range(size):
        t = i / (size - 1)
        shine = 0.8 * math.exp(-t / 0.16) * (1 - t)
        row += bytes((255, 255, 255, int(255 * shine + 0.5)))
    return png_bytes(size, 8, [bytes(row)] * 8, 4)
