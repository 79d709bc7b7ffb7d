"""The knight of a chess set, 1.5 m high, facing +x: a turned foot and a carved head."""
import math

from implicit import Body, chain, ellipsoid, round_cone
from pose import implicit_mesh
from solids import lathe, moved, sphere


def foot():
    profile = [(0, 0.0), (0.44, 0.0), (0.46, 0.02), (0.46, 0.09), (0.44, 0.115), (0.4, 0.125), (0.4, 0.15)]
    profile += [(0.42 - 0.14 * math.sin(0.5 * math.pi * k / 10), 0.16 + 0.16 * k / 10) for k in range(1, 11)]
    profile += [(0.27, 0.34), (0.31, 0.36), (0.325, 0.39), (0.31, 0.42), (0.27, 0.435), (0, 0.44)]
    return lathe(profile, 96).shaded(38)


def head_shapes():
    neck = chain([(-0.02, 0.36, 0), (-0.1, 0.6, 0), (-0.14, 0.85, 0), (-0.06, 1.08, 0), (0.06, 1.2, 0)],
                 [0.255, 0.225, 0.195, 0.165, 0.14])
    out = [neck, [ellipsoid((0.08, 0.56, 0), (0.2, 0.2, 0.17))],
           [ellipsoid((0.12, 1.18, 0), (0.17, 0.15, 0.115))],
           [ellipsoid((0.16, 1.05, 0), (0.15, 0.14, 0.1))],
           [round_cone((0.14, 1.16, 0), (0.43, 0.97, 0), 0.115, 0.082)],
           [ellipsoid((0.46, 0.95, 0), (0.09, 0.09, 0.085))],
           [round_cone((0.18, 1.05, 0), (0.4, 0.89, 0), 0.08, 0.06)]]
    for z in (-1, 1):
        out += [[round_cone((0.06, 1.3, 0.07 * z), (0.06, 1.46, 0.085 * z), 0.042, 0.012)],
                [ellipsoid((0.22, 1.2, 0.09 * z), (0.06, 0.03, 0.03))],
                [ellipsoid((0.5, 0.98, 0.055 * z), (0.035, 0.03, 0.03))]]
    return out


def mane_shapes():
    """Locks along the back of the neck, one over the other."""
    out = []
    for k in range(8):
        t = k / 7
        x, y = -0.27 - 0.08 * math.sin(math.pi * t) + 0.25 * t ** 3, 0.5 + 0.82 * t
        out.append([round_cone((x + 0.12, y + 0.06, 0), (x - 0.05, y - 0.05, 0), 0.075, 0.05)])
    out.append([round_cone((0.0, 1.34, 0), (0.17, 1.29, 0), 0.055, 0.02)])
    return out


def build(cell=0.022):
    """Parts as (mesh, material)."""
    head = implicit_mesh(Body(head_shapes(), 0.06), (-0.1, 0.6, 0.0), cell)
    mane = implicit_mesh(Body(mane_shapes(), 0.025), (-0.2, 0.52, 0.0), cell)
    parts = [(foot(), "lacquer"), (head, "lacquer"), (mane, "lacquer")]
    for z in (-1, 1):
        parts.append((moved(sphere(0.03, 20, 10), (0.215, 1.165, 0.098 * z)).shaded(60), "gold"))
    ring = lathe([(0.2, 0.43), (0.275, 0.43), (0.29, 0.445), (0.275, 0.46), (0.2, 0.46)], 96).shaded(60)
    parts.append((ring, "gold"))
    return parts
