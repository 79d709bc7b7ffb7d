"""Surfaces with all that a vertex can have, as indexed lists in the modes of glTF; placements by 4 x 4 matrices."""
import math

TRIANGLES, STRIP, FAN = 4, 5, 6


class Surface:
    def __init__(self, mode=TRIANGLES):
        self.mode, self.indices = mode, []
        self.positions, self.normals, self.sets = [], [], ([], [])

    def vertex(self, position, normal, u, v):
        self.positions.append(position)
        self.normals.append(normal)
        self.sets[0].append((u, v))
        self.sets[1].append((1 - v * 0.7, 0.2 + u * 0.6))
        return len(self.positions) - 1


def triangles_of(mode, indices):
    """As section 3.7.2.1 of the format says."""
    if mode == TRIANGLES:
        return [tuple(indices[k:k + 3]) for k in range(0, len(indices) // 3 * 3, 3)]
    if mode == STRIP:
        return [(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]) for i in range(len(indices) - 2)]
    return [(indices[i + 1], indices[i + 2], indices[0]) for i in range(len(indices) - 2)]


def _sheet(rows, columns, at):
    """`at(i, j)`: position and normal."""
    s = Surface()
    for i in range(rows + 1):
        for j in range(columns + 1):
            s.vertex(*at(i / rows, j / columns), j / columns, i / rows)
    for i in range(rows):
        for j in range(columns):
            a = i * (columns + 1) + j
            b, c, d = a + 1, a + columns + 1, a + columns + 2
            s.indices += [a, c, b, b, c, d]
    return s


def ball(rows, columns):
    def at(i, j):
        polar, around = math.pi * i, 2 * math.pi * j
        wide = math.sin(polar) if 0 < i < 1 else 0.0  # no slivers of rounding at the poles
        n = (wide * math.sin(around), math.cos(polar), wide * math.cos(around))
        return tuple(0.9 * c for c in n), n
    return _sheet(rows, columns, at)


def hill(steps, height):
    def at(i, j):
        x, z = 2 * j - 1, 2 * i - 1
        size = math.sqrt(1 + 4 * height * height * (x * x + z * z))
        return ((x * 0.9, height * (1 - x * x - z * z) * 0.9, z * 0.9),
                (2 * height * x / size, 1 / size, 2 * height * z / size))
    return _sheet(steps, steps, at)


def box(x, y, z):
    s = Surface()
    for axis in range(3):
        for side in (-1, 1):
            n = tuple(side if k == axis else 0 for k in range(3))
            first = len(s.positions)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                p = [0.0, 0.0, 0.0]
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, a * side, b
                s.vertex((p[0] * x, p[1] * y, p[2] * z), n, (a + 1) / 2, (b + 1) / 2)
            s.indices += [first + k for k in (0, 1, 2, 0, 2, 3)]
    return s


def ribbon(steps):
    s = Surface(STRIP)
    for k in range(steps + 1):
        a = math.pi * (k / steps - 0.5) * 1.5
        n = (math.sin(a), 0.0, math.cos(a))
        for y in (0.7, -0.7):
            s.vertex((0.9 * n[0], y, 0.9 * n[2]), n, k / steps, (1 - y) / 2)
    s.indices = list(range(len(s.positions)))
    return s


def disc(sides):
    s = Surface(FAN)
    s.vertex((0.0, 0.3, 0.0), (0.0, 1.0, 0.0), 0.5, 0.5)
    for k in range(sides + 1):
        a = 2 * math.pi * k / sides
        s.vertex((0.9 * math.sin(a), 0.0, 0.9 * math.cos(a)), (0.0, 1.0, 0.0), 0.5 + math.sin(a) / 2, 0.5 + math.cos(a) / 2)
    s.indices = list(range(len(s.positions)))
    return s


IDENTITY = tuple(tuple(float(r == c) for c in range(4)) for r in range(4))


def times(a, b):
    return tuple(tuple(sum(a[r][k] * b[k][c] for k in range(4)) for c in range(4)) for r in range(4))


def placement(translation=(0, 0, 0), rotation=(0, 0, 0, 1), scale=(1, 1, 1)):
    size = math.sqrt(sum(c * c for c in rotation))
    x, y, z, w = (c / size for c in rotation)
    turn = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    rows = [tuple(turn[r][c] * scale[c] for c in range(3)) + (translation[r],) for r in range(3)]
    return (*rows, (0.0, 0.0, 0.0, 1.0))


def point(m, p):
    return tuple(sum(m[r][c] * p[c] for c in range(3)) + m[r][3] for r in range(3))


def inverse(m):
    """Of a matrix that has one."""
    size = determinant(m)
    turn = [[v / size for v in column] for column in zip(*cofactors(m))]
    back = [-sum(turn[r][c] * m[c][3] for c in range(3)) for r in range(3)]
    return (*(tuple(turn[r]) + (back[r],) for r in range(3)), (0.0, 0.0, 0.0, 1.0))


def mixed(matrices, weights):
    return tuple(tuple(sum(w * m[r][c] for m, w in zip(matrices, weights)) for c in range(4)) for r in range(4))


def cofactors(m):
    """By which normals turn, but for their length; with the determinant's sign."""
    def minor(r, c):
        (a, b), (d, e) = [[m[i][j] for j in range(3) if j != c] for i in range(3) if i != r]
        return a * e - b * d
    return [[(-1) ** (r + c) * minor(r, c) for c in range(3)] for r in range(3)]


def determinant(m):
    return sum(m[0][c] * v for c, v in enumerate(cofactors(m)[0]))
