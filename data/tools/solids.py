"""Closed solids, all as `Surface`s that are welded and turned outwards."""
import math

from mesh import Surface, add, cross, dot, normalize, scale, sub


def circle(radius, segments, y=0.0, turn=0.0):
    """Points of a horizontal circle, counter-clockwise seen from above; the first is not repeated."""
    return [(radius * math.sin(2 * math.pi * i / segments + turn), y,
             radius * math.cos(2 * math.pi * i / segments + turn)) for i in range(segments)]


def stack(rings):
    """Rings of equally many points, lowest first, closed by fans; a ring of one point is a tip."""
    surface = Surface()
    count = max(len(r) for r in rings)
    rows = [list(r) * count if len(r) == 1 else list(r) for r in rings]
    surface.grid([row + row[:1] for row in rows])
    if len(rings[0]) > 1:
        surface.fan(rows[0][::-1])
    if len(rings[-1]) > 1:
        surface.fan(rows[-1])
    return surface.closed()


def lathe(profile, segments=48):
    """Revolves (radius, y) points, lowest first, about the y axis; radius 0 is allowed at the ends only."""
    return stack([circle(r, segments, y) if r > 0 else [(0.0, y, 0.0)] for r, y in profile])


def box(low, high):
    (x0, y0, z0), (x1, y1, z1) = low, high
    return stack([[(x0, y, z0), (x0, y, z1), (x1, y, z1), (x1, y, z0)] for y in (y0, y1)])


def beveled_box(low, high, bevel):
    """A box whose twelve edges are cut at 45 degrees."""
    (x0, y0, z0), (x1, y1, z1) = low, high

    def ring(y, inset):
        b, i = bevel, inset
        return [(x0 + i, y, z0 + b), (x0 + i, y, z1 - b), (x0 + b, y, z1 - i), (x1 - b, y, z1 - i),
                (x1 - i, y, z1 - b), (x1 - i, y, z0 + b), (x1 - b, y, z0 + i), (x0 + b, y, z0 + i)]

    return stack([ring(y0, bevel), ring(y0 + bevel, 0), ring(y1 - bevel, 0), ring(y1, bevel)])


def sphere(radius, segments=64, rings=32, centre=(0.0, 0.0, 0.0)):
    profile = [(0.0 if i in (0, rings) else radius * math.sin(math.pi * i / rings),
                -radius * math.cos(math.pi * i / rings)) for i in range(rings + 1)]
    return moved(lathe(profile, segments), centre)


def icosphere(levels):
    """Unit sphere of 20 * 4^levels nearly equal triangles."""
    g = (1 + math.sqrt(5)) / 2
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
               (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
             (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
             (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    triangles = [tuple(normalize(corners[i]) for i in f) for f in faces]
    for _ in range(levels):
        finer = []
        for a, b, c in triangles:
            ab, bc, ca = normalize(add(a, b)), normalize(add(b, c)), normalize(add(c, a))
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return triangles


def displaced(triangles, place):
    """A closed surface from triangles whose corners are moved by `place(point)`."""
    surface = Surface()
    for t in triangles:
        surface.triangle(*(surface.vertex(place(p)) for p in t))
    return surface.closed()


def torus(major, minor, segments=48, sides=16, y=0.0):
    rings = []
    for i in range(segments + 1):
        a = 2 * math.pi * (i % segments) / segments
        rings.append([((major + minor * math.cos(b)) * math.sin(a), y + minor * math.sin(b),
                       (major + minor * math.cos(b)) * math.cos(a))
                      for b in (2 * math.pi * (j % sides) / sides for j in range(sides + 1))])
    surface = Surface()
    surface.grid(rings)
    return surface.closed()


def sweep(path, profile, side=None, closed=False, widths=None):
    """Carries a convex or star-shaped `profile` of (across, outward) points along `path`.

    `side` fixes the across direction (for paths in a plane); else frames are carried along without twist.
    `outward` is cross(tangent, across). `widths` scales the profile at each point. Open paths get caps.
    """
    surface = Surface()
    rings = [[add(p, add(scale(s, a * w), scale(o, b * w))) for a, b in profile]
             for p, (s, o), w in zip(path, _frames(path, side, closed), widths or [1.0] * len(path))]
    if closed:
        rings.append(rings[0])
    surface.grid([ring + ring[:1] for ring in rings])
    if not closed:
        _cap(surface, path[0], rings[0][::-1])
        _cap(surface, path[-1], rings[-1])
    return surface.closed()


def _cap(surface, centre, ring):
    """A fan about the path's point keeps star-shaped profiles right; one point (a tip) needs none."""
    ids = [surface.vertex(p) for p in ring]
    if len(set(ids)) < 3:
        return
    middle = surface.vertex(centre)
    for a, b in zip(ids, ids[1:] + ids[:1]):
        surface.triangle(middle, a, b)


def _frames(path, side, closed):
    count = len(path)
    frames, across = [], side
    for i in range(count):
        before = path[i - 1] if i > 0 or closed else path[i]
        after = path[(i + 1) % count] if i + 1 < count or closed else path[i]
        tangent = normalize(sub(after, before))
        if across is None:
            helper = (0.0, 1.0, 0.0) if abs(tangent[1]) < 0.9 else (1.0, 0.0, 0.0)
            across = normalize(cross(helper, tangent))
        elif side is None:
            across = normalize(sub(across, scale(tangent, dot(across, tangent))))
        frames.append((across, normalize(cross(tangent, across))))
    return frames


def round_profile(radius, sides=8):
    return [(radius * math.cos(2 * math.pi * i / sides), radius * math.sin(2 * math.pi * i / sides))
            for i in range(sides)]


def pointed_arc(half, ratio=1.25):
    """Height of a pointed arch over |u| <= half; both arcs have the radius ratio * half."""
    radius = ratio * half

    def height(u):
        x = min(abs(u), half) + radius - half
        return math.sqrt(max(0.0, radius * radius - x * x))
    return height


def pointed_samples(half, steps, ratio=1.25):
    """Abscissas 0..half of the arch above at equal steps of arc; `steps` intervals, half first."""
    radius = ratio * half
    top = math.acos((radius - half) / radius)
    return [radius * math.cos(top * i / steps) - (radius - half) if i < steps else 0.0
            for i in range(steps + 1)]


def vault_shell(half_x, half_z, springing, steps, thickness, ratio=1.25, ends=(True, True)):
    """One bay of a pointed cross vault about the origin: closed but for ends where the next bay joins.

    Height is H(min(|x| / half_x, |z| / half_z)), so both tunnels meet on straight diagonals at one height.
    """
    surface = Surface()
    unit = pointed_arc(1.0, ratio)
    ts = pointed_samples(1.0, steps, ratio)          # 1 .. 0
    ts = ts + [-t for t in ts[-2::-1]]               # 1 .. 0 .. -1

    def web(point, flip):
        """One of four webs: ruled lines at parameter b, from the groin |b| out to 1."""
        for lift, turn in ((0.0, flip), (thickness, not flip)):
            rows = []
            for b in ts:
                n = max(1, steps // 3)
                rows.append([point(abs(b) + (1 - abs(b)) * k / n, b, springing + half_x * unit(b) + lift)
                             for k in range(n + 1)])
            part = Surface()
            part.grid(rows)
            surface.append(part.flip() if turn else part)

    for s in (1, -1):
        web(lambda a, b, y, s=s: (s * a * half_x, y, b * half_z), s > 0)
        web(lambda a, b, y, s=s: (b * half_x, y, s * a * half_z), s < 0)

    def rim(point, flip):
        part = Surface()
        part.grid([[point(b, springing + half_x * unit(b) + lift) for b in ts] for lift in (0.0, thickness)])
        surface.append(part.flip() if flip else part)

    for s in (1, -1):
        rim(lambda b, y, s=s: (s * half_x, y, b * half_z), s < 0)
        if ends[0 if s < 0 else 1]:
            rim(lambda b, y, s=s: (b * half_x, y, s * half_z), s > 0)
    return surface


def moved(surface, offset):
    out = Surface()
    ids = [out.vertex(add(p, offset)) for p in surface.positions]
    out.faces = [(ids[a], ids[b], ids[c]) for a, b, c in surface.faces]
    return out


def smooth_step(a, b, x):
    t = max(0.0, min(1.0, (x - a) / (b - a)))
    return t * t * (3 - 2 * t)
