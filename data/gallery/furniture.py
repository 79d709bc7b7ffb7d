"""Table, chairs and what stands on the table: lathes and sweeps. Metres, floor at y = 0."""
import math

from elephant import curve
from solids import beveled_box, lathe, moved, round_profile, sphere, sweep, torus


def rounded(points, radius, pieces=6):
    """A path whose inner corners are arcs that begin `radius` before them."""
    out = [points[0]]
    for a, b, c in zip(points, points[1:], points[2:]):
        def towards(q, reach):
            d = [y - x for x, y in zip(b, q)]
            n = math.sqrt(sum(v * v for v in d))
            k = min(reach, 0.49 * n) / n
            return tuple(x + k * v for x, v in zip(b, d))
        p, q = towards(a, radius), towards(c, radius)
        for k in range(pieces + 1):
            t = k / pieces
            out.append(tuple((1 - t) ** 2 * x + 2 * t * (1 - t) * y + t * t * z for x, y, z in zip(p, b, q)))
    return out + [points[-1]]


def tube_chair():
    """A cantilever chair of bent steel tube, facing +x: (mesh, material) parts."""
    half = 0.23
    side = [(-0.2, 0.86), (-0.2, 0.46), (0.24, 0.46), (0.24, 0.017), (-0.26, 0.017)]
    path = [(x, y, half) for x, y in side] + [(x, y, -half) for x, y in side[::-1]]
    tube = sweep(rounded(path, 0.085, 8), round_profile(0.0125, 16))
    parts = [(tube.shaded(60), "chrome")]
    seat = beveled_box((-0.19, 0.474, -0.235), (0.23, 0.5, 0.235), 0.012).shaded(25)
    back = beveled_box((-0.225, 0.66, -0.235), (-0.2, 0.86, 0.235), 0.012).shaded(25)
    return parts + [(seat, "leather"), (back, "leather")]


def wood_chair():
    """A chair with turned legs and a back of five staves, facing +x."""
    leg = [(0, 0.0), (0.014, 0.0), (0.02, 0.05), (0.017, 0.09), (0.026, 0.2), (0.019, 0.32), (0.025, 0.36),
           (0.018, 0.4), (0.02, 0.44), (0, 0.45)]
    parts = []
    for x in (-0.18, 0.18):
        for z in (-0.18, 0.18):
            parts.append((lathe(leg, 24).shaded(40).moved(x, 0.0, z), "wood"))
    for z in (-0.18, 0.18):
        parts.append((sweep([(-0.18, 0.18, z), (0.18, 0.18, z)], round_profile(0.011, 12)).shaded(60), "wood"))
    parts.append((sweep([(0.0, 0.18, -0.18), (0.0, 0.18, 0.18)], round_profile(0.011, 12)).shaded(60), "wood"))
    seat = [(0, 0.44), (0.24, 0.44), (0.255, 0.45), (0.255, 0.47), (0.245, 0.48), (0.2, 0.478), (0, 0.47)]
    parts.append((lathe(seat, 64).shaded(38), "wood"))
    bow = []
    for k in range(25):
        a = math.pi * k / 24
        bow.append((-0.19 - 0.09 * math.sin(a), 0.47 + 0.46 * math.sin(a) ** 0.6, -0.2 * math.cos(a)))
    parts.append((sweep(bow, round_profile(0.014, 14)).shaded(60), "wood"))
    for z in (-0.11, -0.055, 0.0, 0.055, 0.11):
        a = math.acos(-z / 0.2)
        top = (-0.19 - 0.09 * math.sin(a), 0.47 + 0.46 * math.sin(a) ** 0.6, z)
        parts.append((sweep([(-0.2, 0.47, 0.8 * z), top], round_profile(0.007, 10)).shaded(60), "wood"))
    return parts


def round_table(top):
    """A table 1.2 m across on a turned foot; `top` is the material of its plate."""
    foot = [(0, 0.0), (0.33, 0.0), (0.335, 0.012), (0.32, 0.025), (0.16, 0.05), (0.06, 0.1), (0.042, 0.18),
            (0.038, 0.5), (0.045, 0.64), (0.1, 0.7), (0.2, 0.718), (0, 0.72)]
    plate = [(0, 0.72), (0.585, 0.72), (0.597, 0.725), (0.6, 0.735), (0.597, 0.745), (0.585, 0.75), (0, 0.75)]
    return [(lathe(foot, 72).shaded(40), "chrome"), (lathe(plate, 128).shaded(30), top)]


def teapot(material):
    """A round pot with spout along +x; 0.26 m from end to end."""
    body = [(0, 0.0), (0.05, 0.0), (0.054, 0.006)]
    body += [(0.03 + 0.062 * math.sin(math.pi * (0.12 + 0.76 * k / 20)) ** 0.8, 0.008 + 0.115 * k / 20)
             for k in range(21)]
    body += [(0.04, 0.124), (0, 0.126)]
    lid = [(0, 0.122), (0.047, 0.122), (0.05, 0.126), (0.044, 0.132), (0.025, 0.14), (0.008, 0.145),
           (0.006, 0.15),
           (0.012, 0.156), (0.013, 0.163), (0.008, 0.17), (0, 0.171)]
    spout = curve([(0.07, 0.045, 0), (0.105, 0.06, 0), (0.125, 0.09, 0), (0.155, 0.118, 0)], 5)
    widths = [1.4 - 0.75 * k / (len(spout) - 1) for k in range(len(spout))]
    handle = []
    for k in range(17):
        a = math.pi * (0.5 + k / 16)
        handle.append((-0.075 + 0.055 * math.cos(a), 0.068 + 0.042 * math.sin(a), 0.0))
    return [(lathe(body, 72).shaded(40), material), (lathe(lid, 72).shaded(40), material),
            (sweep(spout, round_profile(0.016, 20), widths=widths).shaded(60), material),
            (sweep(handle, round_profile(0.0075, 14)).shaded(60), material)]


def cup(material):
    wall = [(0, 0.0), (0.022, 0.0), (0.025, 0.006), (0.024, 0.01), (0.034, 0.03), (0.04, 0.058), (0.037, 0.058),
            (0.031, 0.03), (0.02, 0.012), (0, 0.011)]
    saucer = [(0, -0.012), (0.03, -0.012), (0.04, -0.008), (0.068, 0.0), (0.067, 0.003), (0.035, -0.004),
              (0, -0.004)]
    ear = [(0.036 + 0.016 * math.sin(math.pi * k / 12), 0.03 - 0.018 * math.cos(math.pi * k / 12), 0.0)
           for k in range(13)]
    return [(moved(lathe(wall, 48), (0, 0.008, 0)).shaded(40), material),
            (moved(lathe(saucer, 48), (0, 0.012, 0)).shaded(40), material),
            (moved(sweep(ear, round_profile(0.004, 10)), (0, 0.008, 0)).shaded(60), material)]


def bowl_of_fruit(material):
    wall = [(0, 0.0), (0.06, 0.0), (0.065, 0.01), (0.05, 0.018), (0.1, 0.045), (0.14, 0.085), (0.155, 0.11),
            (0.149, 0.112), (0.132, 0.088), (0.095, 0.054), (0.03, 0.03), (0, 0.028)]
    parts = [(lathe(wall, 72).shaded(40), material)]
    for x, y, z, r, fruit in ((0.05, 0.09, 0.03, 0.04, "orange"), (-0.045, 0.088, 0.04, 0.038, "apple"),
                              (0.0, 0.088, -0.055, 0.04, "lime"), (0.005, 0.145, 0.005, 0.039, "orange")):
        parts.append((moved(sphere(r, 40, 20), (x, y, z)).shaded(60), fruit))
    return parts


def placed(parts, x, z, degrees=0.0, y=0.0, size=1.0):
    return [(mesh.scaled(size).turned(degrees).moved(x, y, z), material) for mesh, material in parts]
