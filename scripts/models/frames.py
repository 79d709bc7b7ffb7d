"""Axes, scales and the frame of the view that two programs share. Plain Python: Blender runs it, too.

A turn is a list of three (axis, sign): coordinate i of ours is sign times that axis of theirs. A box is (low, high).
"""
import itertools
import math

AS_IS = ((0, 1), (1, 1), (2, 1))
Z_TO_Y = ((0, 1), (2, 1), (1, -1))  # theirs has z up, ours y
FORWARD = (-0.48, -0.62, -0.62)     # of ours; no axis and no diagonal of a cube
UP = (0.0, 1.0, 0.0)
MARGIN = 1.05
FITS = 0.01                         # of the diagonal: so far apart may sides of boxes that are the same be
FAR = 4.0                           # a box so many times the other one is not framed with it


def turns():
    """The 24 that mirror nothing."""
    for axes in itertools.permutations(range(3)):
        even = sum(axes[i] > axes[j] for i in range(3) for j in range(i + 1, 3)) % 2 == 0
        for signs in itertools.product((1, -1), repeat=3):
            if (math.prod(signs) > 0) == even:
                yield tuple(zip(axes, signs))


def turned(turn, point):
    return tuple(sign * point[axis] for axis, sign in turn)


def turned_back(turn, point):
    result = [0.0, 0.0, 0.0]
    for value, (axis, sign) in zip(point, turn):
        result[axis] = sign * value
    return tuple(result)


def turned_box(turn, scale, box, zero=(0.0, 0.0, 0.0)):
    corners = [[scale * v - z for v, z in zip(turned(turn, corner), zero)] for corner in box]
    return tuple(map(min, *corners)), tuple(map(max, *corners))


def diagonal(box):
    return math.dist(*box)


def apart(one, other):
    """The farthest that a side of one box is from that of the other, as a fraction of the larger diagonal."""
    size = max(diagonal(one), diagonal(other)) or 1.0
    return max(abs(a - b) for p, q in zip(one, other) for a, b in zip(p, q)) / size


def align(ours, theirs, usual, scales=(1.0,), zero=(0.0, 0.0, 0.0)):
    """(turn, scale, how far the boxes are apart then): the usual one where it fits, else the best one of all."""
    ratio = diagonal(ours) / diagonal(theirs) if diagonal(theirs) else 1.0
    tries = [(usual, scale) for scale in scales] + [(usual, ratio)]
    tries += [(turn, scale) for scale in (*scales, ratio) for turn in turns()]
    found = [(apart(ours, turned_box(turn, scale, theirs, zero)), turn, scale) for turn, scale in tries]
    for distance, turn, scale in found:
        if distance < FITS:
            return turn, scale, distance
    distance, turn, scale = min(found[:len(scales)])
    return turn, scale, distance


def around(middle, radius):
    """The cube in a sphere."""
    half = radius / math.sqrt(3)
    return tuple(m - half for m in middle), tuple(m + half for m in middle)


def union(ours, theirs):
    """Both boxes, so that what one lacks is seen; ours alone where the other is far larger."""
    both = tuple(map(min, ours[0], theirs[0])), tuple(map(max, ours[1], theirs[1]))
    return both if diagonal(both) < FAR * diagonal(ours) else ours


def view(box):
    """An orthographic camera that sees all of a box in a square: eye, forward, up, width."""
    middle = [(a + b) / 2 for a, b in zip(*box)]
    size = diagonal(box) or 1.0
    length = math.sqrt(sum(v * v for v in FORWARD))
    forward = [v / length for v in FORWARD]
    right = unit(cross(forward, UP))
    up = cross(right, forward)
    half = 0.0
    for corner in itertools.product(*zip(*box)):
        offset = [a - b for a, b in zip(corner, middle)]
        half = max(half, abs(dot(offset, right)), abs(dot(offset, up)))
    eye = [m - size * f for m, f in zip(middle, forward)]
    return {"eye": eye, "forward": forward, "up": up, "width": 2 * MARGIN * half, "depth": 2 * size}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [v / length for v in a]
