"""An elephant as a blend of round shapes, 3.1 m at the shoulder, facing +x, feet at y = 0."""
from implicit import Body, chain, ellipsoid, plate, polygonise, round_cone
from mesh import Mesh
from pictures import Noise
from solids import moved, round_profile, sphere, sweep

EAR = 48.0                                 # degrees by which the ears stand off


def shapes():
    """Groups of shapes; each group flows into the others."""
    single = [round_cone((-0.85, 1.95, 0), (0.7, 2.05, 0), 0.8, 0.82),
              ellipsoid((-0.1, 1.72, 0), (1.2, 0.86, 0.84)),
              round_cone((-1.15, 1.95, 0), (-0.9, 1.6, 0), 0.55, 0.6),
              round_cone((0.7, 2.35, 0), (1.75, 2.62, 0), 0.62, 0.5),
              ellipsoid((1.85, 2.62, 0), (0.52, 0.58, 0.47)), ellipsoid((1.95, 2.9, 0), (0.34, 0.3, 0.36)),
              round_cone((2.0, 2.3, 0.0), (2.2, 2.15, 0.0), 0.36, 0.3)]
    for z in (-1, 1):
        single += [ellipsoid((0.86 + 0.27 * z, 0.1, 0.43 * z), (0.31, 0.13, 0.29)),
                   ellipsoid((-0.91 - 0.3 * z, 0.1, 0.42 * z), (0.3, 0.13, 0.28)),
                   ellipsoid((2.13, 2.72, 0.33 * z), (0.14, 0.1, 0.1)),
                   round_cone((2.1, 2.28, 0.2 * z), (2.3, 2.08, 0.27 * z), 0.16, 0.12)]
    out = [[shape] for shape in single]
    for z in (-1, 1):
        out += [chain([(0.8 + 0.05 * z, 1.6, 0.45 * z), (0.82 + 0.16 * z, 0.85, 0.44 * z),
                       (0.82 + 0.27 * z, 0.22, 0.43 * z)], [0.4, 0.27, 0.25]),
                chain([(-0.95 - 0.05 * z, 1.5, 0.42 * z), (-0.75 - 0.16 * z, 0.85, 0.42 * z),
                       (-0.95 - 0.3 * z, 0.22, 0.42 * z)], [0.48, 0.3, 0.25]),
                [plate((1.2, 2.5, 0.8 * z), 0.45, 0.56, 0.062, EAR * z, 10 * z)],
                [plate((1.22, 2.1, 0.81 * z), 0.26, 0.4, 0.06, EAR * z, 10 * z)]]
    trunk = [(2.2, 2.2, 0), (2.55, 1.82, 0), (2.9, 1.66, 0.02), (3.25, 1.74, 0.05), (3.48, 2.02, 0.08),
             (3.52, 2.38, 0.1),
             (3.62, 2.68, 0.11), (3.84, 2.8, 0.12)]
    radii = [(r, 0.0, 0.0) for r in (0.33, 0.28, 0.24, 0.205, 0.175, 0.15, 0.13, 0.115)]
    out.append(chain(curve(trunk, 3), [r for r, _, _ in curve(radii, 3)]))
    tail = [(-1.6, 2.25, 0), (-1.86, 1.85, 0.04), (-1.93, 1.4, 0.1), (-1.9, 1.05, 0.13), (-1.92, 0.8, 0.14)]
    return out + [chain(tail, [0.11, 0.075, 0.06, 0.055, 0.085])]


def build(cell):
    """Parts as (mesh, material): skin with colours at its vertices, tusks, eyes."""
    noise = Noise(41)

    def relief(x, y, z):
        """Folds of the skin: rings about trunk and legs, fine wrinkles everywhere."""
        fold = noise.at3(3 * x, 14 * y, 3 * z) if x < 2.3 else noise.at3(13 * x, 13 * y, 3 * z)
        return 0.007 * fold + 0.004 * noise.at3(21 * x, 21 * y, 21 * z)

    surface, normals = polygonise(Body(shapes(), 0.16, relief), (0.0, 1.9, 0.0), cell)
    skin = Mesh()
    skin.positions, skin.normals, skin.faces = surface.closed().positions, normals, surface.faces

    def colour(p, n):
        tone = 0.8 + 0.16 * noise.fractal3(1.7 * p[0], 1.7 * p[1], 1.7 * p[2], 3)
        dust = 0.35 * max(0.0, n[1]) + 0.4 * max(0.0, 0.7 - p[1])
        grey, earth = (0.2, 0.175, 0.16), (0.34, 0.22, 0.14)
        return tuple(tone * (g + (e - g) * min(1.0, dust)) for g, e in zip(grey, earth))

    parts = [(skin.paint(colour), "skin")]
    for z in (-1, 1):
        path = [(2.2, 2.14, 0.25 * z), (2.45, 1.9, 0.31 * z), (2.72, 1.8, 0.35 * z), (2.98, 1.83, 0.36 * z),
                (3.18, 1.95, 0.34 * z), (3.26, 2.03, 0.33 * z)]
        path = curve(path, 5)
        count = len(path)
        widths = [0.085 * (1 - (k / (count - 1)) ** 1.8) + 0.006 for k in range(count)]
        tusk = sweep(path, round_profile(1.0, 16), widths=widths)
        parts.append((tusk.shaded(60), "ivory"))
        parts.append((moved(sphere(0.042, 20, 10), (2.19, 2.74, 0.405 * z)).shaded(60), "eye"))
    return parts


def curve(points, pieces):
    """Catmull-Rom through the points."""
    out = []
    ends = [points[0]] + list(points) + [points[-1]]
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        for k in range(pieces):
            t = k / pieces
            out.append(tuple(0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t +
                                    (3 * q - p - 3 * r + s) * t ** 3) for p, q, r, s in zip(a, b, c, d)))
    return out + [points[-1]]
