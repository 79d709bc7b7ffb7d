"""A girl in a dress, 1.7 m from crown to toes, afloat: upright, facing +x, the waist at y = 1."""
import math

from elephant import curve
from implicit import Body, chain, ellipsoid, round_cone
from mesh import Surface
from pictures import Noise
from pose import implicit_mesh, mixed
from solids import moved, smooth_step, sphere

FOLDS = 11


def limbs():
    """Skin: head, neck, shoulders, arms with hands, legs with feet that point down."""
    out = [[ellipsoid((0.015, 1.575, 0), (0.098, 0.118, 0.079))],
           [ellipsoid((0.045, 1.515, 0), (0.062, 0.072, 0.056))],
           [round_cone((0.106, 1.555, 0), (0.118, 1.53, 0), 0.008, 0.012)],
           [ellipsoid((0.094, 1.497, 0), (0.017, 0.008, 0.022))],
           [round_cone((-0.025, 1.32, 0), (-0.018, 1.5, 0), 0.045, 0.04)],
           [ellipsoid((0.078, 1.474, 0), (0.026, 0.024, 0.028))],
           [round_cone((-0.01, 1.325, -0.13), (-0.01, 1.325, 0.13), 0.05, 0.05)],
           [ellipsoid((0.0, 1.24, 0), (0.075, 0.13, 0.1))],
           [round_cone((0.0, 1.2, 0), (0.0, 0.8, 0), 0.045, 0.05)],
           [round_cone((0.0, 0.8, -0.08), (0.0, 0.8, 0.08), 0.05, 0.05)]]
    for z in (-1, 1):
        arm = curve([(-0.01, 1.325, 0.155 * z), (-0.05, 1.26, 0.29 * z), (-0.06, 1.22, 0.42 * z),
                     (0.0, 1.27, 0.54 * z), (0.06, 1.34, 0.65 * z)], 3)
        radii = [0.05 - 0.026 * k / (len(arm) - 1) + 0.004 * math.sin(2.6 * math.pi * k / (len(arm) - 1))
                 for k in range(len(arm))]
        out += [chain(arm, radii), [ellipsoid((0.085, 1.37, 0.685 * z), (0.03, 0.034, 0.032))]]
        for k in range(4):
            x, y = 0.105 - 0.016 * k, 1.405 - 0.012 * k
            out.append(chain([(0.09, 1.38, 0.69 * z), (x, y, (0.735 + 0.004 * k) * z),
                              (x - 0.01, y + 0.012 - 0.005 * k, (0.775 - 0.004 * k) * z)],
                              [0.013, 0.0105, 0.008]))
        out.append(chain([(0.08, 1.36, 0.68 * z), (0.115, 1.35, 0.7 * z), (0.135, 1.36, 0.715 * z)],
                         [0.013, 0.011, 0.009]))
    bent = ((1, (0.055, 0.6), (-0.13, 0.24), (-0.13, 0.1)), (-1, (0.04, 0.55), (-0.03, 0.13), (0.0, -0.02)))
    for z, knee, ankle, toe in bent:
        out += [chain(curve([(0.0, 0.82, 0.08 * z), (knee[0], knee[1], 0.07 * z),
                             (0.5 * (knee[0] + ankle[0]) - 0.03, 0.5 * (knee[1] + ankle[1]) + 0.03, 0.062 * z),
                             (ankle[0], ankle[1], 0.055 * z)], 3),
                      [0.06, 0.06, 0.06, 0.058, 0.058, 0.056, 0.054, 0.046, 0.038, 0.033]),
                chain([(ankle[0], ankle[1], 0.055 * z), (ankle[0] + 0.04, 0.5 * (ankle[1] + toe[1]), 0.055 * z),
                       (toe[0] + 0.04, toe[1] - 0.02, 0.055 * z)], [0.034, 0.036, 0.022])]
    return out


def locks():
    """Hair: a cap on the head, a long braid of flowing locks that lift backwards and up."""
    out = [[ellipsoid((-0.018, 1.598, 0), (0.104, 0.112, 0.094))]]
    for k in range(21):
        t = k / 20 - 0.5
        a, lift = math.pi * t, 0.5 + 0.5 * math.cos(5 * t) + 0.35 * math.sin(7.3 * k)
        z, w = 0.085 * math.sin(a), 0.12 * math.sin(3.1 * k)
        points = [(-0.04, 1.66 - 0.1 * abs(t), 0.8 * z), (-0.14, 1.6 - 0.16 * abs(t), 1.5 * z),
                  (-0.27, 1.54 + 0.05 * lift - 0.1 * abs(t), 2.4 * z + 0.2 * w),
                  (-0.42, 1.57 + 0.09 * lift, 3.2 * z + 0.5 * w),
                  (-0.56 - 0.06 * lift, 1.66 + 0.1 * lift + 0.4 * w, 3.8 * z + w)]
        path = curve(points, 3)
        out.append(chain(path, [0.027 * (1 - (j / (len(path) - 1)) ** 1.6) + 0.01 for j in range(len(path))]))
    return out


def dress():
    """From the bust to the hem: close above the waist, wide folds below that the wind carries backwards."""
    steps, around = 60, 264
    surface, rows = Surface(), []
    for j in range(steps + 1):
        t = j / steps
        y = 1.29 - 0.85 * t
        bodice = 0.118 - 0.032 * smooth_step(0.02, 0.32, t)
        chest = 0.02 * smooth_step(0.02, 0.07, t) * smooth_step(0.28, 0.12, t)
        s = max(0.0, (t - 0.32) / 0.68)
        row = []
        for k in range(around):
            a = 2 * math.pi * k / around
            swing = 0.08 * math.sin(2 * a + 0.6) + 0.05 * math.sin(3 * a + 2.0)
            depth = 0.013 * smooth_step(0.0, 0.1, s) + 0.055 * s ** 1.3
            fold = math.cos(FOLDS * a + 1.5 * math.sin(2 * a) + 0.8 * s) * depth
            r = bodice + 0.36 * s ** 0.85 + s * swing + fold
            bust = chest * math.exp(-((abs(a - math.pi / 2) - 0.5) / 0.4) ** 2)
            x, z = (r * 0.8 + bust) * math.sin(a), r * math.cos(a) * (1.1 - 0.1 * s)
            lift = 0.12 * s * s * math.cos(a + math.pi / 2 - 0.3) + 0.05 * s * s * math.sin(3 * a)
            row.append((x - 0.16 * s ** 2, y + lift, z))
        rows.append(row)
    hem = rows[-1]
    inner = [[(0.985 * x, y + 0.012, 0.985 * z) for x, y, z in hem]]
    surface.grid([row + row[:1] for row in rows + inner])
    return surface


def build():
    """Parts as (mesh, material): limbs and hair with colours at their vertices, the dress, eyes."""
    noise = Noise(171)
    limb = implicit_mesh(Body(limbs(), 0.025), (0.0, 1.25, 0.0), 0.0135)

    def tone(p, n):
        x, y, z = p
        c = mixed((0.72, 0.43, 0.31), (0.66, 0.36, 0.25), 0.5 + 0.5 * noise.at3(9 * x, 9 * y, 9 * z))
        if y > 1.43 and x > 0.02:
            lips = smooth_step(0.02, 0.012, math.hypot((y - 1.497) * 1.9, z)) if x > 0.085 else 0.0
            c = mixed(c, (0.45, 0.07, 0.06), lips)
            cheek = smooth_step(0.045, 0.01, math.hypot(y - 1.525, abs(z) - 0.05))
            c = mixed(c, (0.72, 0.3, 0.22), 0.5 * cheek)
            brow = smooth_step(0.006, 0.002, abs(y - 1.617 + 0.3 * (abs(z) - 0.03)))
            c = mixed(c, (0.2, 0.1, 0.06), 0.8 * brow * smooth_step(0.026, 0.018, abs(abs(z) - 0.034)))
        return c

    hair = implicit_mesh(Body(locks(), 0.02, lambda x, y, z: 0.004 * noise.at3(4 * x, 60 * y, 60 * z)),
                         (-0.018, 1.6, 0.0), 0.0125)
    hair.paint(lambda p, n: mixed((0.05, 0.022, 0.012), (0.14, 0.06, 0.025),
                                  0.5 + 0.5 * noise.at3(6 * p[0], 45 * p[1], 45 * p[2])))
    parts = [(limb.paint(tone), "body"), (hair, "hair"), (dress().shaded(60), "dress")]
    for z in (-1, 1):
        strap = [(-0.085, 1.27, 0.075 * z), (-0.06, 1.345, 0.085 * z), (-0.005, 1.378, 0.09 * z),
                 (0.05, 1.345, 0.085 * z), (0.085, 1.27, 0.075 * z)]
        parts.append((implicit_mesh(Body([chain(curve(strap, 3), [0.011] * 13)], 0.01), strap[0], 0.009),
                      "dress"))
        parts.append((moved(sphere(0.0145, 24, 12), (0.0895, 1.578, 0.034 * z)).shaded(60), "cheek"))
        parts.append((moved(sphere(0.0098, 20, 10), (0.0968, 1.576, 0.0345 * z)).shaded(60), "eye"))
    return parts
