"""Triangle meshes: `Surface` collects welded polygons, `Mesh` is what is shaded and written.

Every position is snapped to a grid of 2^-15 m. Snapped numbers are exact in 32-bit floats below 512 m, and
moving them by snapped numbers stays exact: parts that touch have bit-equal vertices, no ray passes between.
"""
import math

GRID = 32768.0


def snap(value):
    return round(value * GRID) / GRID


def snapped(p):
    return (round(p[0] * GRID) / GRID, round(p[1] * GRID) / GRID, round(p[2] * GRID) / GRID)


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def normalize(a):
    n = length(a)
    return (a[0] / n, a[1] / n, a[2] / n) if n > 0 else (0.0, 1.0, 0.0)


def lerp(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


class Mesh:
    """Vertices with normals and perhaps texture coordinates and linear colours; counter-clockwise faces."""

    def __init__(self):
        self.positions = []
        self.normals = []
        self.uvs = None
        self.colours = None
        self.faces = []

    def _copy(self, positions, normals, flip=False):
        out = Mesh()
        out.positions, out.normals = positions, normals
        out.uvs, out.colours = self.uvs, self.colours
        out.faces = [(a, c, b) for a, b, c in self.faces] if flip else self.faces
        return out

    def moved(self, x=0.0, y=0.0, z=0.0):
        return self._copy([snapped((p[0] + x, p[1] + y, p[2] + z)) for p in self.positions], self.normals)

    def mirrored_x(self):
        return self._copy([(-p[0], p[1], p[2]) for p in self.positions],
                          [(-n[0], n[1], n[2]) for n in self.normals], flip=True)

    def mirrored_z(self):
        return self._copy([(p[0], p[1], -p[2]) for p in self.positions],
                          [(n[0], n[1], -n[2]) for n in self.normals], flip=True)

    def turned(self, degrees):
        """Turned about the y axis, from +z towards +x."""
        angle = math.radians(degrees)
        c, s = math.cos(angle), math.sin(angle)
        return self._copy([snapped((c * p[0] + s * p[2], p[1], c * p[2] - s * p[0])) for p in self.positions],
                          [(c * n[0] + s * n[2], n[1], c * n[2] - s * n[0]) for n in self.normals])

    def scaled(self, s):
        return self._copy([snapped(scale(p, s)) for p in self.positions], self.normals)

    def paint(self, colour):
        """Gives each vertex the linear colour `colour(position, normal)`."""
        self.colours = [colour(p, n) for p, n in zip(self.positions, self.normals)]
        return self


class Surface:
    """Polygons over welded, snapped vertices."""

    def __init__(self):
        self.positions = []
        self.faces = []
        self._index = {}

    def vertex(self, p):
        key = snapped(p)
        index = self._index.get(key)
        if index is None:
            index = self._index[key] = len(self.positions)
            self.positions.append(key)
        return index

    def triangle(self, a, b, c):
        if a != b and b != c and c != a:
            self.faces.append((a, b, c))

    def quad(self, a, b, c, d):
        """Split along the shorter diagonal; corners may coincide."""
        p = self.positions
        ac, bd = sub(p[a], p[c]), sub(p[b], p[d])
        if len({a, b, c, d}) < 4 or dot(ac, ac) <= dot(bd, bd):
            self.triangle(a, b, c)
            self.triangle(a, c, d)
        else:
            self.triangle(a, b, d)
            self.triangle(b, c, d)

    def grid(self, rows):
        """Quads between rows of equally many points."""
        rows = [[self.vertex(p) for p in row] for row in rows]
        for r0, r1 in zip(rows, rows[1:]):
            for i in range(len(r0) - 1):
                self.quad(r0[i], r0[i + 1], r1[i + 1], r1[i])

    def fan(self, points):
        """A convex polygon."""
        ids = [self.vertex(p) for p in points]
        for i in range(1, len(ids) - 1):
            self.triangle(ids[0], ids[i], ids[i + 1])

    def between(self, left, right):
        """Triangles between two chains of points that run the same way (a polygon monotone along them)."""
        l, r = [self.vertex(p) for p in left], [self.vertex(p) for p in right]
        i = j = 0
        while i < len(l) - 1 or j < len(r) - 1:
            go_left = j == len(r) - 1 or (i < len(l) - 1 and
                                          self._distance(l[i + 1], r[j]) <= self._distance(l[i], r[j + 1]))
            if go_left:
                self.triangle(l[i], r[j], l[i + 1])
                i += 1
            else:
                self.triangle(l[i], r[j], r[j + 1])
                j += 1

    def _distance(self, a, b):
        d = sub(self.positions[a], self.positions[b])
        return dot(d, d)

    def append(self, other):
        """Welds another surface into this one; faces that lie back to back vanish."""
        ids = [self.vertex(p) for p in other.positions]
        self.faces.extend((ids[a], ids[b], ids[c]) for a, b, c in other.faces)
        return self

    def flip(self):
        self.faces = [(a, c, b) for a, b, c in self.faces]
        return self

    def open_edges(self):
        """Directed edges that have not exactly one opposite: none when the surface is closed and oriented."""
        count = {}
        for a, b, c in self.faces:
            for edge in ((a, b), (b, c), (c, a)):
                count[edge] = count.get(edge, 0) + 1
        return [e for e, n in count.items() if n != 1 or count.get((e[1], e[0]), 0) != 1]

    def volume(self):
        p = self.positions
        return sum(dot(p[a], cross(p[b], p[c])) for a, b, c in self.faces) / 6

    def closed(self):
        """Checks that the surface is closed and turns it outwards."""
        bad = self.open_edges()
        if bad:
            a, b = bad[0]
            raise ValueError(f"{len(bad)} open edges, the first {self.positions[a]} - {self.positions[b]}")
        return self.flip() if self.volume() < 0 else self

    def shaded(self, crease=35.0, uv=None):
        """A mesh whose normals are smooth where faces meet at less than `crease` degrees.

        `uv(position, faceNormal)` gives texture coordinates.
        """
        points = self.positions
        raw = [cross(sub(points[b], points[a]), sub(points[c], points[a])) for a, b, c in self.faces]
        unit = [normalize(n) for n in raw]
        around = [[] for _ in points]
        for f, face in enumerate(self.faces):
            for v in face:
                around[v].append(f)
        limit = math.cos(math.radians(crease))
        mesh, known = Mesh(), {}
        mesh.uvs = [] if uv else None
        for f, face in enumerate(self.faces):
            n = unit[f]
            corners = []
            for v in face:
                group = tuple(g for g in around[v] if dot(unit[g], n) >= limit)
                at = uv(points[v], n) if uv else None
                key = (v, group, at)
                index = known.get(key)
                if index is None:
                    index = known[key] = len(mesh.positions)
                    mesh.positions.append(points[v])
                    mesh.normals.append(self._normal(v, group, unit))
                    if uv:
                        mesh.uvs.append(at)
                corners.append(index)
            mesh.faces.append(tuple(corners))
        return mesh

    def _normal(self, v, group, unit):
        """Face normals weighted by the angle that each face takes at the vertex."""
        if len(group) == 1:
            return unit[group[0]]
        total = (0.0, 0.0, 0.0)
        p = self.positions
        for g in group:
            face = self.faces[g]
            k = face.index(v)
            e0 = normalize(sub(p[face[(k + 1) % 3]], p[v]))
            e1 = normalize(sub(p[face[(k + 2) % 3]], p[v]))
            total = add(total, scale(unit[g], math.acos(max(-1.0, min(1.0, dot(e0, e1))))))
        return normalize(total)


def box_mapping(metres):
    """Texture coordinates by the dominant axis; the texture covers `metres` x `metres`."""
    def uv(p, n):
        ax, ay, az = abs(n[0]), abs(n[1]), abs(n[2])
        if ay >= ax and ay >= az:
            return (p[0] / metres, p[2] / metres)
        return (p[2] / metres, p[1] / metres) if ax >= az else (p[0] / metres, p[1] / metres)
    return uv
