"""Walls with arched or round openings, as closed solids without T-junctions.

A wall lives in (u, y, d): along, up, and through it. `place(u, y, d)` puts it into the world: straight and
round walls are one thing. Openings narrow from the inner face (d0) to the outer one (d1) by `splay`.
"""
import math

from mesh import Surface
from solids import pointed_arc, pointed_samples


class Opening:
    """Samples (u, low, high) across the hole from left to right; scaling is about `anchor` = (u, y)."""

    def __init__(self, samples, anchor, splay=1.0):
        self.samples = samples
        self.anchor = anchor
        self.splay = splay

    def scaled(self, factor, floor=None):
        """The samples `factor` times as wide about the anchor; a sill at `floor` stays there."""
        u0, y0 = self.anchor
        return [(u0 + (u - u0) * factor, low if low == floor else y0 + (low - y0) * factor,
                 y0 + (high - y0) * factor)
                for u, low, high in self.samples]


def lancet(centre, half, sill, springing, splay=1.0, steps=10, ratio=1.25):
    """A pointed window or arch: straight from sill to springing, then two arcs."""
    height = pointed_arc(half, ratio)
    us = pointed_samples(half, steps, ratio)
    us = [-u for u in us] + us[-2::-1]
    return Opening([(centre + u, sill, springing + height(u)) for u in us], (centre, springing), splay)


def round_window(centre, y, radius, splay=1.0, steps=24):
    samples = []
    for i in range(steps + 1):
        a = math.pi * i / steps
        h = radius * math.sin(a) if 0 < i < steps else 0.0
        samples.append((centre - radius * math.cos(a), y - h, y + h))
    return Opening(samples, (centre, y), splay)


def wall(place, u_range, y_range, d_range, openings, step=1e9):
    """The solid; openings are sorted along u, apart; plain stretches are cut into pieces of about `step`."""
    surface = Surface()
    d0, d1 = d_range
    ends = [u_range[0], *(o.samples[k][0] for o in openings for k in (0, -1)), u_range[1]]
    pieces = [max(1, round((b - a) / step)) for a, b in zip(ends[::2], ends[1::2])]
    inner = _stations(u_range, y_range, [o.samples for o in openings], pieces)
    outer = _stations(u_range, y_range, [o.scaled(o.splay, y_range[0]) for o in openings], pieces)

    def strip(a, a_heights, a_depth, b, b_heights, b_depth, flip):
        part = Surface()
        part.between([place(a.u, y, a_depth) for y in a_heights], [place(b.u, y, b_depth) for y in b_heights])
        surface.append(part.flip() if flip else part)

    def ribbon(i0, o0, i1, o1, height, flip):
        part = Surface()
        part.grid([[place(s.u, height(s), d0) for s in (i0, i1)],
                   [place(s.u, height(s), d1) for s in (o0, o1)]])
        surface.append(part.flip() if flip else part)

    for stations, depth in ((inner, d0), (outer, d1)):
        for a, b in zip(stations, stations[1:]):
            if a.opens:
                strip(a, [a.bottom, a.low], depth, b, [b.bottom, b.low], depth, depth == d0)
                strip(a, [a.high, a.top], depth, b, [b.high, b.top], depth, depth == d0)
            else:
                strip(a, a.chain(), depth, b, b.chain(), depth, depth == d0)
    for i0, o0, i1, o1 in zip(inner, outer, inner[1:], outer[1:]):
        ribbon(i0, o0, i1, o1, lambda s: s.top, True)
        to_bottom = i0.opens and i0.low == i0.bottom and i1.low == i1.bottom
        if not to_bottom:
            ribbon(i0, o0, i1, o1, lambda s: s.bottom, False)
        if i0.opens:
            ribbon(i0, o0, i1, o1, lambda s: s.high, False)
            if not to_bottom:
                ribbon(i0, o0, i1, o1, lambda s: s.low, True)
    for i, o in zip(inner, outer):
        if i.jamb:
            strip(i, [i.low, i.high], d0, o, [o.low, o.high], d1, i.opens)
    strip(inner[0], inner[0].chain(), d0, outer[0], outer[0].chain(), d1, False)
    strip(inner[-1], inner[-1].chain(), d0, outer[-1], outer[-1].chain(), d1, True)
    return surface.closed()


class _Station:
    """A vertical line across the wall: where it stands and the hole (low, high) it touches, if any."""

    def __init__(self, u, y_range, hole=None, opens=False, jamb=False):
        self.u = u
        self.bottom, self.top = y_range
        self.low, self.high = hole or y_range
        self.opens = opens                 # the strip to the right of the line lies in the opening
        self.jamb = jamb                   # the hole ends here in an upright edge

    def chain(self):
        return sorted({self.bottom, self.low, self.high, self.top})


def _stations(u_range, y_range, openings, pieces):
    """All lines of one face; `pieces` says into how many parts each plain stretch is cut."""
    stations = [_Station(u_range[0], y_range)]

    def plain_up_to(end, count):
        start = stations[-1].u
        stations.extend(_Station(start + (end - start) * k / count, y_range) for k in range(1, count))

    for samples, count in zip(openings, pieces):
        plain_up_to(samples[0][0], count)
        last = len(samples) - 1
        for k, (u, low, high) in enumerate(samples):
            stations.append(_Station(u, y_range, (low, high), k < last, k in (0, last) and high > low))
    plain_up_to(u_range[1], pieces[-1])
    stations.append(_Station(u_range[1], y_range))
    return stations
