#!/usr/bin/env python3
"""Draws the environment maps: night.hdr, sunset.hdr, day.hdr, and the day as six faces and as a cross.

Equirectangular pictures have -z in the middle and +x to the right of it; faces are as they look
from inside, with -z ("pz", ahead) in the middle of the cross.
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "tools")]

from pictures import srgb_bytes, write_hdr, write_png
from skies import Day, Night, Sunset

WIDTH, HEIGHT = 1024, 512
FACE = 256
# The direction through (s, t) of each face, s and t in -1..1, t down.
FACES = {
    "px": lambda s, t: (1.0, -t, s), "nx": lambda s, t: (-1.0, -t, -s),
    "py": lambda s, t: (s, 1.0, -t), "ny": lambda s, t: (s, -1.0, t),
    "pz": lambda s, t: (s, -t, -1.0), "nz": lambda s, t: (-s, -t, 1.0),
}
CROSS = {"py": (1, 0), "nx": (0, 1), "pz": (1, 1), "px": (2, 1), "nz": (3, 1), "ny": (1, 2)}


def equirectangular(sky):
    columns = [2 * math.pi * ((x + 0.5) / WIDTH - 0.5) for x in range(WIDTH)]
    around = [(math.sin(a), -math.cos(a)) for a in columns]
    rows = []
    for y in range(HEIGHT):
        polar = math.pi * (y + 0.5) / HEIGHT
        high, wide = math.cos(polar), math.sin(polar)
        rows.append([sky((wide * s, high, wide * c)) for s, c in around])
    return rows


def doubled(rows):
    """The picture at twice the size, bilinear, without a seam."""
    def between(a, b):
        return tuple(0.75 * p + 0.25 * q for p, q in zip(a, b))

    wide = []
    for row in rows:
        line = []
        for k, c in enumerate(row):
            line += (between(c, row[k - 1]), between(c, row[(k + 1) % len(row)]))
        wide.append(line)
    out = []
    for k, line in enumerate(wide):
        for other in (wide[max(0, k - 1)], wide[min(len(wide) - 1, k + 1)]):
            out.append([between(a, b) for a, b in zip(line, other)])
    return out


def add_star(rows, d, colour):
    """Adds a star of one pixel, shared among the four nearest."""
    height, width = len(rows), len(rows[0])
    x = (0.5 + math.atan2(d[0], -d[2]) / (2 * math.pi)) * width - 0.5
    y = min(height - 1.001, max(0.0, math.acos(d[1]) / math.pi * height - 0.5))
    x0, y0 = math.floor(x), math.floor(y)
    for j in (0, 1):
        for i in (0, 1):
            share = (1 - abs(x - x0 - i)) * (1 - abs(y - y0 - j))
            row, column = rows[y0 + j], (x0 + i) % width
            row[column] = tuple(a + share * b for a, b in zip(row[column], colour))


def display(colour):
    """Radiance to the 0..1 of a display for the PNG files."""
    return tuple(c / (c + 0.45) * 1.2 for c in colour)


def faces(sky):
    out = {}
    for name, towards in FACES.items():
        rows = []
        for j in range(FACE):
            row = bytearray()
            for i in range(FACE):
                x, y, z = towards(2 * (i + 0.5) / FACE - 1, 2 * (j + 0.5) / FACE - 1)
                n = math.sqrt(x * x + y * y + z * z)
                row += srgb_bytes(display(sky((x / n, y / n, z / n))))
            rows.append(bytes(row))
        out[name] = rows
    return out


def write_cross(path, pictures):
    rows = [bytearray(4 * FACE * 3) for _ in range(3 * FACE)]
    for name, (column, line) in CROSS.items():
        for j, row in enumerate(pictures[name]):
            start = column * FACE * 3
            rows[line * FACE + j][start:start + FACE * 3] = row
    write_png(path, 4 * FACE, 3 * FACE, [bytes(r) for r in rows])


def main():
    folder = os.path.join(HERE, "generated")
    os.makedirs(folder, exist_ok=True)
    write_hdr(os.path.join(folder, "sunset.hdr"), WIDTH, HEIGHT, equirectangular(Sunset()))
    day = Day()
    write_hdr(os.path.join(folder, "day.hdr"), WIDTH, HEIGHT, equirectangular(day))
    pictures = faces(day)
    for name, rows in pictures.items():
        write_png(os.path.join(folder, f"day_{name}.png"), FACE, FACE, rows)
    write_cross(os.path.join(folder, "day_cross.png"), pictures)
    night = Night()
    rows = doubled(equirectangular(night))
    for d, colour in night.stars(13000, 8):
        add_star(rows, d, colour)
    write_hdr(os.path.join(folder, "night.hdr"), 2 * WIDTH, 2 * HEIGHT, rows)
    print("environments: night, sunset, day")


if __name__ == "__main__":
    main()
