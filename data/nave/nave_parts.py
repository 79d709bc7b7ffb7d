"""The pieces of the nave that are built once and then placed many times. Metres, floor at y = 0."""
import math

from solids import (beveled_box, circle, lathe, moved, pointed_arc, pointed_samples, round_profile, sphere,
                    stack,
                    sweep, torus)

ARCH_RATIO = 1.25                          # radius of every pointed arch over its half span


def foil_ring(distance, radius, offset, y, samples=9):
    """Plan of a pier of eight round shafts `distance` from its axis, grown outwards by `offset`."""
    ring, r = [], radius + offset
    for sector in range(8):
        for k in range(samples):
            a = math.pi / 4 * (k / samples - 0.5)
            reach = distance * math.cos(a) + math.sqrt(r * r - (distance * math.sin(a)) ** 2)
            angle = a + sector * math.pi / 4
            ring.append((reach * math.sin(angle), y, reach * math.cos(angle)))
    return ring


def _bulge(d, y0, y1, out, steps=4):
    """A round moulding between two heights that stands out by `out` over the offset d."""
    return [(d + out * math.sin(math.pi * k / steps), y0 + (y1 - y0) * k / steps) for k in range(steps + 1)]


def pier_profile(bottom, top, d):
    """(offset, y) of base, shaft and bell of a pier; `d` is the size of the mouldings."""
    base = [(1.5 * d, bottom)] + _bulge(1.3 * d, bottom + 0.4 * d, bottom + 1.6 * d, 0.45 * d)
    base += [(0.55 * d, bottom + 1.75 * d), (0.45 * d, bottom + 2.1 * d)]
    base += _bulge(0.5 * d, bottom + 2.3 * d, bottom + 3.0 * d, 0.28 * d, 3) + [(0.0, bottom + 3.4 * d)]
    neck = top - 5.2 * d
    ring = [(0.0, neck - 0.5 * d)] + _bulge(0.0, neck - 0.4 * d, neck + 0.2 * d, 0.3 * d,
                                            3) + [(0.0, neck + 0.3 * d)]
    bell = [(1.5 * d * (k / 7) ** 2.2, neck + 0.3 * d + (top - neck - 0.6 * d) * k / 7) for k in range(1, 8)]
    return base + ring + bell + [(1.5 * d, top)]


def pier(bottom, top, distance=0.33, radius=0.16, d=0.11, samples=9):
    """A clustered column: shafts, moulded base, bell capital."""
    return stack([foil_ring(distance, radius, offset, y, samples) for offset,
                  y in pier_profile(bottom, top, d)])


def octagon_block(half, y0, y1, bevel):
    """Plinth or abacus: an octagon with worked edges."""
    turn, r = math.pi / 8, half / math.cos(math.pi / 8)
    return stack([circle(r - bevel, 8, y0, turn), circle(r, 8, y0 + bevel, turn),
                  circle(r, 8, y1 - bevel, turn), circle(r - bevel, 8, y1, turn)])


def rib_profile(width, depth):
    """A roll between two hollows, hanging below the path (outward is up)."""
    w, d = width / 2, depth
    return [(w, 0.06), (w, -0.35 * d), (0.62 * w, -0.5 * d), (0.6 * w, -0.72 * d), (0.42 * w, -0.92 * d),
            (0.0, -d),
            (-0.42 * w, -0.92 * d), (-0.6 * w, -0.72 * d), (-0.62 * w, -0.5 * d), (-w, -0.35 * d), (-w, 0.06)]


def arch_path(span, springing, half_height, steps, start=(0.0, 0.0)):
    """Points of a pointed arch from `start` (x, z) by `span`; as high as one of half span `half_height`."""
    unit = pointed_arc(1.0, ARCH_RATIO)
    ts = pointed_samples(1.0, steps, ARCH_RATIO)
    ts = [-t for t in ts] + ts[-2::-1]
    return [(start[0] + span[0] * (t + 1) / 2, springing + half_height * unit(t),
             start[1] + span[1] * (t + 1) / 2)
            for t in ts]


def rib(span, springing, half_height, width, depth, steps, start=(0.0, 0.0)):
    """A vault rib or archivolt: the profile carried along a pointed arch."""
    n = math.hypot(*span)
    side = (-span[1] / n, 0.0, span[0] / n)
    path = arch_path(span, springing, half_height, steps, start)
    return sweep(path, [(-a, b) for a, b in rib_profile(width, depth)], side)


def moulding(path, size):
    """A string course along a horizontal path; it projects by `size` to the left."""
    profile = [(0.1, -size), (0.0, -size), (-0.35 * size, -0.75 * size), (-0.55 * size, -0.3 * size),
               (-size, 0.0),
               (-size, 0.35 * size), (-0.75 * size, 0.6 * size), (0.0, 0.9 * size), (0.1, 0.9 * size)]
    return sweep(path, profile)


def tracery(half, sill, springing, radius):
    """Bars of a window in the plane z = 0: a mullion, two small arches and a circle above them."""
    parts = []
    bar = round_profile(radius, 6)
    small = half / 2
    low = springing - 0.25 * half
    parts.append(sweep([(0.0, sill, 0.0), (0.0, low, 0.0)], bar))
    arc = pointed_arc(small, 1.1)
    us = pointed_samples(small, 8, 1.1)
    us = [-u for u in us] + us[-2::-1]
    for centre in (-small, small):
        parts.append(sweep([(centre + u, low + arc(u), 0.0) for u in us], bar, (0.0, 0.0, 1.0)))
    eye = 0.36 * half
    ring = [(eye * math.sin(a), low + 1.02 * half + eye * math.cos(a), 0.0)
            for a in (2 * math.pi * k / 28 for k in range(28))]
    parts.append(sweep(ring, bar, (0.0, 0.0, 1.0), closed=True))
    return parts


def rose_tracery(radius, petals, bar):
    """Bars of a wheel window about the origin in the plane z = 0."""
    profile = round_profile(bar, 8)
    side = (0.0, 0.0, 1.0)

    def ring(r, cx=0.0, cy=0.0, n=48, thick=1.0):
        path = [(cx + r * math.sin(2 * math.pi * k / n), cy + r * math.cos(2 * math.pi * k / n), 0.0)
                for k in range(n)]
        return sweep(path, [(a * thick, b * thick) for a, b in profile], side, closed=True)

    parts = [ring(0.24 * radius, thick=1.4), ring(0.98 * radius, thick=1.6)]
    for k in range(petals):
        a = 2 * math.pi * k / petals
        s, c = math.sin(a), math.cos(a)
        parts.append(sweep([(0.24 * radius * s, 0.24 * radius * c, 0.0),
                            (0.72 * radius * s, 0.72 * radius * c, 0.0)],
                           profile))
        b = a + math.pi / petals
        reach = 0.79 * radius
        parts.append(ring(0.175 * radius, reach * math.sin(b), reach * math.cos(b), 24))
        small = 0.66 * radius
        arc = [(small * math.sin(a + t * math.pi / petals), small * math.cos(a + t * math.pi / petals), 0.0)
               for t in (0, 0.5, 1, 1.5, 2)]
        parts.append(sweep(arc, [(x * 0.7, y * 0.7) for x, y in profile], side))
    return parts


def candle(height, radius):
    """Wax and flame of a candle that stands on y = 0."""
    wax = lathe([(0, 0), (radius, 0), (radius, height - 0.3 * radius), (0.8 * radius, height),
                 (0, height - 0.004)], 12)
    r = 1.1 * radius
    flame = lathe([(r * x, r * y) for x, y in ((0, 0), (0.42, 0.35), (0.55, 0.8), (0.42, 1.5), (0.2, 2.3),
                                               (0, 3.2))], 10)
    return wax, moved(flame, (0.0, height + 0.006, 0.0))


def candlestick():
    """An altar candlestick, 0.62 m high."""
    return lathe([(0, 0), (0.13, 0), (0.13, 0.02), (0.1, 0.045), (0.045, 0.07), (0.03, 0.12), (0.055, 0.17),
                  (0.028, 0.22), (0.024, 0.36), (0.045, 0.4), (0.024, 0.44), (0.02, 0.52), (0.05, 0.56),
                  (0.085, 0.6), (0.085, 0.62), (0, 0.615)], 24)


def chandelier(radius, arms, rise):
    """A hanging ring; returns (metal parts, places of its candles). The ring lies at y = 0."""
    metal = [torus(radius, 0.045, 48, 8), torus(radius, 0.02, 48, 6, 0.12), torus(0.14, 0.025, 24, 8, rise)]
    places = []
    for k in range(arms):
        a = 2 * math.pi * k / arms
        x, z = radius * math.sin(a), radius * math.cos(a)
        cup = lathe([(0, 0.03), (0.03, 0.035), (0.035, 0.1), (0.08, 0.15), (0.085, 0.17), (0, 0.165)], 12)
        metal.append(moved(cup, (x, 0.0, z)))
        places.append((x, 0.16, z))
        if k % 3 == 0:
            metal.append(sweep([(x, 0.04, z), (0.1 * x / radius, rise, 0.1 * z / radius)],
                               round_profile(0.012, 6)))
    return metal, places


def bench(width):
    """A pew that faces -z, standing on y = 0: seat, back, two ends, kneeler."""
    w = width / 2
    parts = [beveled_box((-w, 0.42, -0.22), (w, 0.465, 0.2), 0.012),
             beveled_box((-w, 0.52, 0.2), (w, 0.92, 0.24), 0.012),
             beveled_box((-w - 0.02, 0.93, 0.16), (w + 0.02, 0.97, 0.28), 0.012),
             beveled_box((-w, 0.12, -0.55), (w, 0.17, -0.38), 0.012)]
    for s in (-1, 1):
        x0, x1 = sorted((s * (w - 0.02), s * (w + 0.05)))
        parts.append(beveled_box((x0, -0.02, -0.58), (x1, 0.3, 0.3), 0.015))
        parts.append(beveled_box((x0 + 0.005, 0.28, -0.2), (x1 - 0.005, 1.02, 0.27), 0.015))
        parts.append(moved(sphere(0.05, 16, 8), ((x0 + x1) / 2, 1.06, 0.22)))
    return parts


def door_leaf(width, height, y0):
    """Planks and rails with studs in the plane z = 0, hinged at x = 0, without the arch."""
    parts, planks = [], 6
    for k in range(planks):
        x = width * k / planks
        parts.append(beveled_box((x + 0.004, y0, -0.03), (x + width / planks - 0.004, height, 0.03), 0.008))
    for y in (0.5, 1.5, 2.5):
        parts.append(beveled_box((0.02, y, -0.055), (width - 0.02, y + 0.16, -0.02), 0.01))
    return parts
