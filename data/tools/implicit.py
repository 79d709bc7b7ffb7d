"""Surfaces of implicit bodies: rounded shapes blended into one, polygonised by marching tetrahedra.

Distances are in metres, negative inside. Cubes of a lattice are cut into six tetrahedra about one diagonal,
alike in every cube, so that the surface is closed without special cases.
"""
import math

from mesh import Surface, add, cross, dot, normalize, scale, sub

TETRAHEDRA = ((0, 1, 3, 7), (0, 1, 5, 7), (0, 2, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 4, 6, 7))
CORNERS = tuple((i & 1, i >> 1 & 1, i >> 2) for i in range(8))


def round_cone(a, b, ra, rb):
    """Distance to a capsule from a to b whose radius runs from ra to rb."""
    ax, ay, az = a
    dx, dy, dz = b[0] - ax, b[1] - ay, b[2] - az
    inverse = 1 / (dx * dx + dy * dy + dz * dz)

    def distance(x, y, z):
        x, y, z = x - ax, y - ay, z - az
        t = (x * dx + y * dy + z * dz) * inverse
        t = 0.0 if t < 0 else 1.0 if t > 1 else t
        x, y, z = x - t * dx, y - t * dy, z - t * dz
        return math.sqrt(x * x + y * y + z * z) - (ra + (rb - ra) * t)
    return distance


def ellipsoid(centre, radii, turn=0.0, lean=0.0):
    """About the distance to an ellipsoid, turned about y and then leaned about x (degrees)."""
    cx, cy, cz = centre
    ct, st = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    cl, sl = math.cos(math.radians(lean)), math.sin(math.radians(lean))
    rx, ry, rz = radii

    def distance(x, y, z):
        x, y, z = x - cx, y - cy, z - cz
        x, z = ct * x - st * z, st * x + ct * z
        y, z = cl * y - sl * z, sl * y + cl * z
        ux, uy, uz = x / rx, y / ry, z / rz
        k0 = math.sqrt(ux * ux + uy * uy + uz * uz)
        k1 = math.sqrt((ux / rx) ** 2 + (uy / ry) ** 2 + (uz / rz) ** 2)
        return k0 * (k0 - 1) / k1 if k1 > 1e-9 else -min(radii)
    return distance


def chain(points, radii):
    """Round cones along a path; as one group of a Body they do not swell where they meet."""
    return [round_cone(a, b, ra, rb) for a, b, ra, rb in zip(points, points[1:], radii, radii[1:])]


def plate(centre, half_u, half_v, thickness, turn=0.0, lean=0.0):
    """An oval plate with a round edge; half_u is horizontal, half_v upright before it leans."""
    cx, cy, cz = centre
    ct, st = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    cl, sl = math.cos(math.radians(lean)), math.sin(math.radians(lean))
    small = min(half_u, half_v)

    def distance(x, y, z):
        x, y, z = x - cx, y - cy, z - cz
        x, z = ct * x - st * z, st * x + ct * z
        y, z = cl * y - sl * z, sl * y + cl * z
        beyond = (math.hypot(x / half_u, y / half_v) - 1) * small
        return (math.hypot(beyond, z) if beyond > 0 else abs(z)) - thickness
    return distance


class Body:
    """A smooth union of groups of shapes; `blend` is the width over which groups flow into each other.

    Shapes of one group are joined without blending.
    """

    def __init__(self, groups, blend, relief=None):
        self.shapes = [(number, shape) for number, group in enumerate(groups) for shape in group]
        self.blend = blend
        self.relief = relief or (lambda x, y, z: 0.0)

    def distance(self, p, shapes):
        x, y, z = p
        k = self.blend
        total = best = 1e9
        group = -1
        for number, shape in shapes:
            d = shape(x, y, z)
            if number == group:
                best = d if d < best else best
                continue
            gap = abs(best - total)
            total = (best if best < total else total) - ((k - gap) * (k - gap) / (4 * k) if gap < k else 0.0)
            group, best = number, d
        gap = abs(best - total)
        return (best if best < total else total) - ((k - gap) * (k - gap) / (4 * k) if gap < k else 0.0)

    def near(self, p, reach):
        """The shapes that can matter within `reach` of p."""
        values = [shape(*p) for _, shape in self.shapes]
        limit = min(values) + 2 * reach + 1.5 * self.blend
        return [s for s, v in zip(self.shapes, values) if v <= limit]

    def detailed(self, p, shapes):
        return self.distance(p, shapes) - self.relief(*p)

    def gradient(self, p, shapes, distance, e=0.004):
        """Gradient of `distance(p, shapes)` by differences at the corners of a tetrahedron."""
        total = (0.0, 0.0, 0.0)
        for s in ((1, -1, -1), (-1, -1, 1), (-1, 1, -1), (1, 1, 1)):
            total = add(total, scale(s, distance(add(p, scale(s, e)), shapes)))
        return scale(total, 0.25 / e)


def polygonise(body, inside, cell, relaxations=1):
    """The closed surface about the point `inside`, which lies in the body, and the normals of its vertices.

    Follows the surface from cube to cube, so that only cubes that it cuts are looked at.
    """
    march = _March(body, inside, cell)
    march.follow()
    return march.finish(relaxations)


class _March:
    BLOCK = 3                              # cubes a side that share one list of shapes

    def __init__(self, body, origin, cell):
        self.body, self.origin, self.cell = body, origin, cell
        self.values = {}                   # lattice point -> distance
        self.lists = {}                    # block -> shapes near it
        self.edges = {}                    # pair of lattice points -> vertex
        self.points, self.shapes, self.triangles = [], [], []

    def position(self, lattice):
        return tuple(o + self.cell * c for o, c in zip(self.origin, lattice))

    def shapes_at(self, lattice):
        key = tuple(c // self.BLOCK for c in lattice)
        shapes = self.lists.get(key)
        if shapes is None:
            middle = self.position(tuple((c + 0.5) * self.BLOCK for c in key))
            reach = 0.9 * self.BLOCK * self.cell
            shapes = self.lists[key] = self.body.near(middle, reach)
        return shapes

    def value(self, lattice):
        d = self.values.get(lattice)
        if d is None:
            d = self.values[lattice] = self.body.distance(self.position(lattice), self.shapes_at(lattice))
        return d

    def follow(self):
        top = 0
        while self.value((0, top, 0)) < 0:
            top += 1
        first = (0, top - 1, 0)
        waiting, seen = [first], {first}
        while waiting:
            at = waiting.pop()
            lattice = [(at[0] + x, at[1] + y, at[2] + z) for x, y, z in CORNERS]
            values = [self.value(p) for p in lattice]
            inside = [v < 0 for v in values]
            for tetrahedron in TETRAHEDRA:
                self.cut(tetrahedron, lattice, values, inside, self.shapes_at(at))
            for axis in range(3):
                for side in (0, 1):
                    face = [inside[c] for c in range(8) if (c >> axis & 1) == side]
                    to = tuple(v + (2 * side - 1 if k == axis else 0) for k, v in enumerate(at))
                    if any(face) and not all(face) and to not in seen:
                        seen.add(to)
                        waiting.append(to)

    def cut(self, tetrahedron, lattice, values, inside, shapes):
        deep = [c for c in tetrahedron if inside[c]]
        out = [c for c in tetrahedron if not inside[c]]
        if not deep or not out:
            return

        def vertex(a, b):
            return self.vertex(lattice[a], lattice[b], values[a], values[b], shapes)

        if len(deep) == 2:
            (a, b), (c, d) = deep, out
            ring = [vertex(a, c), vertex(a, d), vertex(b, d), vertex(b, c)]
            faces = [(ring[0], ring[1], ring[2]), (ring[0], ring[2], ring[3])]
        else:
            lone, others = (deep[0], out) if len(deep) == 1 else (out[0], deep)
            faces = [tuple(vertex(lone, o) for o in others)]
        outwards = sub(self._mean(out, lattice), self._mean(deep, lattice))
        for a, b, c in faces:
            n = cross(sub(self.points[b], self.points[a]), sub(self.points[c], self.points[a]))
            self.triangles.append((a, b, c) if dot(n, outwards) >= 0 else (a, c, b))

    @staticmethod
    def _mean(corners, lattice):
        return tuple(sum(lattice[c][k] for c in corners) / len(corners) for k in range(3))

    def vertex(self, a, b, va, vb, shapes):
        key = (a, b) if a < b else (b, a)
        index = self.edges.get(key)
        if index is None:
            t = min(0.97, max(0.03, va / (va - vb)))   # never at a corner: no face collapses
            pa, pb = self.position(a), self.position(b)
            index = self.edges[key] = len(self.points)
            self.points.append(tuple(x + (y - x) * t for x, y in zip(pa, pb)))
            self.shapes.append(shapes)
        return index

    def finish(self, relaxations):
        for _ in range(relaxations):
            self._relax()
        surface = Surface()
        points = [self._on_surface(p, s) for p, s in zip(self.points, self.shapes)]
        surface.positions = [tuple(round(c * 32768) / 32768 for c in p) for p in points]
        surface.faces = self.triangles
        return surface, self._normals(surface)

    def _normals(self, surface):
        """Gradients; where the body is thinner than a cell and they mislead, the mean of the faces about."""
        points = surface.positions
        sums = [(0.0, 0.0, 0.0)] * len(points)
        for a, b, c in surface.faces:
            n = cross(sub(points[b], points[a]), sub(points[c], points[a]))
            for v in (a, b, c):
                sums[v] = add(sums[v], n)
        normals = []
        for p, shapes, total in zip(points, self.shapes, sums):
            n, faces = normalize(self.body.gradient(p, shapes, self.body.detailed)), normalize(total)
            normals.append(n if dot(n, faces) > 0.5 else faces)
        return normals

    def _relax(self):
        """Moves every vertex towards the mean of its neighbours, which evens the triangles out."""
        sums = [[0.0, 0.0, 0.0, 0] for _ in self.points]
        for triangle in self.triangles:
            for k in range(3):
                s, p = sums[triangle[k]], self.points[triangle[(k + 1) % 3]]
                s[0] += p[0]
                s[1] += p[1]
                s[2] += p[2]
                s[3] += 1
        self.points = [tuple(0.5 * c + 0.5 * t / s[3] for c, t in zip(p, s)) for p,
                       s in zip(self.points, sums)]

    def _on_surface(self, p, shapes):
        """One step of Newton's method, no longer than half a cell."""
        g = self.body.gradient(p, shapes, self.body.distance)
        steep = math.sqrt(dot(g, g))
        if steep < 0.2:
            return p
        d = self.body.detailed(p, shapes) / steep
        return sub(p, scale(g, max(-0.5 * self.cell, min(0.5 * self.cell, d)) / steep))
