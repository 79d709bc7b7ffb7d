"""A ladybird 1 m long (to be scaled), facing +x, feet at y = 0."""
import math

from mesh import Surface
from pictures import png_bytes, srgb_bytes
from solids import moved, round_profile, smooth_step, sphere, sweep

DOTS = ((0.24, 0.0, 0.1), (0.1, 0.24, 0.09), (-0.14, 0.16, 0.085), (-0.3, 0.27, 0.07), (-0.1, 0.36, 0.06))
SIZE = 512


def spots():
    """The wing cases from above; u runs along x, v along -z, both over -0.5..0.5."""
    rows = []
    for j in range(SIZE):
        row = bytearray()
        for i in range(SIZE):
            x, z = (i + 0.5) / SIZE - 0.5, abs((j + 0.5) / SIZE - 0.5)
            black = smooth_step(0.012, 0.008, z)
            for cx, cz, r in DOTS:
                black = max(black, smooth_step(r + 0.004, r - 0.004, math.hypot(x - cx, z - cz)))
            c = [a + (b - a) * black for a, b in zip((0.62, 0.02, 0.012), (0.012, 0.01, 0.01))]
            row += srgb_bytes(c)
        rows.append(bytes(row))
    return png_bytes(SIZE, SIZE, rows)


def dome(radii, centre, low, steps=(96, 40)):
    """The part of an ellipsoid above `low` (-1..1 of its height), closed by a flat floor."""
    around, up = steps
    surface, rows = Surface(), []
    start = math.asin(low)
    for j in range(up + 1):
        a = start + (math.pi / 2 - start) * j / up
        ring = [(centre[0] + radii[0] * math.cos(a) * math.sin(b), centre[1] + radii[1] * math.sin(a),
                 centre[2] + radii[2] * math.cos(a) * math.cos(b))
                for b in (2 * math.pi * k / around for k in range(around))]
        rows.append(ring if j < up else [(centre[0], centre[1] + radii[1], centre[2])] * around)
    surface.grid([row + row[:1] for row in rows])
    surface.fan(rows[0][::-1])
    return surface.closed()


def build():
    """Parts as (mesh, material): the wing cases have texture coordinates for `spots`."""
    uv = lambda p, n: (p[0] + 0.5, 0.5 - p[2])
    parts = [(dome((0.5, 0.42, 0.42), (-0.02, 0.12, 0.0), -0.05).shaded(50, uv), "wings"),
             (dome((0.19, 0.2, 0.27), (0.42, 0.13, 0.0), -0.3).shaded(50), "shell"),
             (moved(sphere(0.12, 32, 16), (0.56, 0.17, 0.0)).shaded(60), "shell")]
    for z in (-1, 1):
        for x, reach in ((0.28, 0.2), (0.02, 0.02), (-0.24, -0.18)):
            path = [(x, 0.14, 0.25 * z), (x + 0.5 * reach, 0.19, 0.45 * z), (x + reach, 0.02, 0.55 * z),
                    (x + 1.3 * reach + 0.03, 0.012, 0.6 * z)]
            parts.append((sweep(path, round_profile(0.022, 10), widths=[1.2, 1, 0.8, 0.5]).shaded(60), "shell"))
        feeler = [(0.63, 0.22, 0.05 * z), (0.7, 0.3, 0.09 * z), (0.77, 0.33, 0.14 * z), (0.83, 0.32, 0.18 * z)]
        parts.append((sweep(feeler, round_profile(0.011, 8)).shaded(60), "shell"))
        parts.append((moved(sphere(0.022, 16, 8), feeler[-1]).shaded(60), "shell"))
        parts.append((moved(sphere(0.055, 20, 10), (0.52, 0.23, 0.15 * z)).shaded(60), "cheek"))
        parts.append((moved(sphere(0.028, 20, 10), (0.655, 0.2, 0.065 * z)).shaded(60), "cheek"))
    return parts
