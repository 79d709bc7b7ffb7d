"""A sitting rabbit about 1.2 m long and high (to be scaled), facing +x, feet at y = 0."""
import math

from implicit import Body, ellipsoid, plate, round_cone
from pictures import Noise
from pose import implicit_mesh, mixed
from solids import moved, smooth_step, sphere


def shapes():
    single = [ellipsoid((-0.1, 0.34, 0), (0.38, 0.3, 0.26)), ellipsoid((-0.27, 0.31, 0), (0.29, 0.3, 0.29)),
              ellipsoid((0.2, 0.36, 0), (0.17, 0.26, 0.18)),
              round_cone((0.12, 0.48, 0), (0.3, 0.66, 0), 0.18, 0.13),
              ellipsoid((0.36, 0.73, 0), (0.185, 0.16, 0.145)), ellipsoid((0.49, 0.68, 0), (0.09, 0.08, 0.085)),
              ellipsoid((-0.57, 0.27, 0), (0.09, 0.1, 0.09))]
    for z in (-1, 1):
        single += [ellipsoid((-0.2, 0.22, 0.2 * z), (0.25, 0.2, 0.11)),
                   round_cone((-0.25, 0.055, 0.23 * z), (0.1, 0.05, 0.22 * z), 0.055, 0.055),
                   round_cone((0.22, 0.32, 0.1 * z), (0.29, 0.07, 0.1 * z), 0.085, 0.055),
                   ellipsoid((0.33, 0.05, 0.1 * z), (0.085, 0.055, 0.06)),
                   ellipsoid((0.41, 0.66, 0.085 * z), (0.09, 0.075, 0.06)),
                   plate((0.2, 1.05, 0.105 * z), 0.06, 0.22, 0.034, 62 * z, -14)]
        single.append(round_cone((0.3, 0.82, 0.06 * z), (0.25, 0.9, 0.08 * z), 0.05, 0.04))
    return [[shape] for shape in single]


def build(cell=0.02):
    """Parts as (mesh, material): fur with colours at its vertices, eyes."""
    noise = Noise(151)

    def relief(x, y, z):
        calm = 1 - smooth_step(0.8, 0.95, y)
        return calm * (0.005 * noise.at3(16 * x, 40 * y, 30 * z) + 0.003 * noise.at3(50 * x, 60 * y, 60 * z))

    fur = implicit_mesh(Body(shapes(), 0.09, relief), (0.0, 0.35, 0.0), cell)

    def colour(p, n):
        x, y, z = p
        tone = 1 + 0.18 * noise.fractal3(4 * x, 4 * y, 4 * z, 3)
        c = mixed((0.42, 0.26, 0.15), (0.3, 0.17, 0.1), smooth_step(0.2, 0.6, y))
        pale = max(smooth_step(-0.5, -0.56, x) if y < 0.4 else 0.0,
                   smooth_step(0.16, 0.1, y), smooth_step(0.46, 0.54, x) if y > 0.5 else 0.0,
                   smooth_step(0.3, 0.36, x) * smooth_step(0.6, 0.5, y) if y < 0.6 else 0.0)
        c = mixed(c, (0.82, 0.76, 0.68), pale)
        if y > 0.88:
            inner = smooth_step(0.35, 0.75, n[0])
            c = mixed(c, (0.72, 0.42, 0.38), inner)
        nose = math.hypot(x - 0.58, 1.3 * (y - 0.72), z)
        c = mixed((0.5, 0.2, 0.19), c, smooth_step(0.022, 0.04, nose))
        return tuple(tone * v for v in c)

    parts = [(fur.paint(colour), "fur")]
    for z in (-1, 1):
        parts.append((moved(sphere(0.034, 24, 12), (0.435, 0.762, 0.122 * z)).shaded(60), "eye"))
    return parts
