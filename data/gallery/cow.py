"""A cow of black and white patches, 1.45 m at the shoulder, facing +x, feet at y = 0."""
from implicit import Body, chain, ellipsoid, plate, round_cone
from pictures import Noise
from pose import implicit_mesh, mixed
from solids import moved, smooth_step, sphere

MUZZLE = (1.55, 1.16, 0.0)


def shapes():
    single = [round_cone((-0.78, 1.06, 0), (0.55, 1.05, 0), 0.4, 0.39),
              ellipsoid((-0.15, 0.93, 0), (0.88, 0.42, 0.44)),
              ellipsoid((0.5, 1.33, 0), (0.36, 0.13, 0.15)),
              round_cone((-0.85, 1.18, 0), (-1.02, 0.95, 0), 0.26, 0.25),
              round_cone((0.55, 1.12, 0), (1.08, 1.36, 0), 0.3, 0.185),
              ellipsoid((0.82, 0.97, 0), (0.3, 0.25, 0.07)),
              ellipsoid((1.2, 1.44, 0), (0.17, 0.15, 0.145)),
              round_cone((1.25, 1.39, 0), (1.5, 1.2, 0), 0.13, 0.09),
              ellipsoid(MUZZLE, (0.1, 0.1, 0.118)),
              ellipsoid((-0.5, 0.58, 0), (0.2, 0.15, 0.17))]
    for z in (-1, 1):
        single += [ellipsoid((-0.86, 1.32, 0.16 * z), (0.17, 0.11, 0.1)),
                   ellipsoid((1.27, 1.47, 0.115 * z), (0.06, 0.045, 0.035)),
                   plate((1.1, 1.46, 0.26 * z), 0.13, 0.06, 0.018, 90 + 22 * z, 12),
                   round_cone((-0.42, 0.48, 0.07 * z), (-0.42, 0.4, 0.07 * z), 0.03, 0.02),
                   round_cone((-0.58, 0.48, 0.07 * z), (-0.58, 0.4, 0.07 * z), 0.03, 0.02)]
    out = [[shape] for shape in single]
    for z in (-1, 1):
        step = 0.1 * z
        out += [chain([(0.52, 0.98, 0.2 * z), (0.54 + step, 0.5, 0.2 * z), (0.5 + 1.5 * step, 0.16, 0.2 * z),
                       (0.53 + 1.5 * step, 0.05, 0.2 * z)], [0.2, 0.085, 0.06, 0.075]),
                chain([(-0.86, 1.0, 0.19 * z), (-0.76 - step, 0.68, 0.21 * z),
                       (-1.0 - step, 0.5, 0.2 * z), (-0.95 - 1.6 * step, 0.16, 0.2 * z),
                       (-0.92 - 1.6 * step, 0.05, 0.2 * z)], [0.29, 0.17, 0.085, 0.062, 0.075])]
    out.append(chain([(-1.18, 1.25, 0), (-1.3, 1.0, 0.02), (-1.31, 0.7, 0.05), (-1.27, 0.48, 0.08),
                      (-1.28, 0.36, 0.09)], [0.05, 0.032, 0.026, 0.06, 0.025]))
    return out


def build(cell=0.03):
    """Parts as (mesh, material): hide with colours at its vertices, horns, eyes."""
    noise = Noise(141)
    hide = implicit_mesh(Body(shapes(), 0.11, lambda x, y, z: 0.003 * noise.at3(25 * x, 25 * y, 25 * z)),
                         (0.0, 1.0, 0.0), cell)

    def colour(p, n):
        x, y, z = p
        patch = noise.fractal3(1.5 * x + 3.3, 1.35 * y + 8.1, 1.1 * z + 0.4, 2)
        black = smooth_step(0.02, 0.07, patch)
        if x > 1.0:
            blaze = smooth_step(0.045, 0.065, abs(z) + 0.03 * noise.at2(9 * x, 9 * y))
            black = blaze if y > 1.2 else blaze * smooth_step(1.1, 1.2, y)
        if y < 0.62 and abs(x + 0.5) > 0.22:
            black *= smooth_step(0.4, 0.62, y)
        c = mixed((0.86, 0.82, 0.75), (0.025, 0.021, 0.02), black)
        nose = sum((a - b) ** 2 for a, b in zip(p, MUZZLE)) ** 0.5
        c = mixed(c, (0.62, 0.34, 0.3), 1 - smooth_step(0.1, 0.16, nose))
        if abs(x + 0.5) < 0.24 and y < 0.66:
            c = mixed((0.75, 0.42, 0.37), c, smooth_step(0.52, 0.64, y))
        return mixed((0.03, 0.025, 0.02), c, smooth_step(0.075, 0.095, y))

    parts = [(hide.paint(colour), "hide")]
    for z in (-1, 1):
        horn = chain([(1.14, 1.55, 0.09 * z), (1.14, 1.61, 0.2 * z), (1.2, 1.71, 0.26 * z),
                      (1.26, 1.8, 0.25 * z)], [0.04, 0.036, 0.024, 0.009])
        parts.append((implicit_mesh(Body([horn], 0.02), (1.14, 1.6, 0.185 * z), 0.014), "horn"))
        parts.append((moved(sphere(0.028, 20, 10), (1.305, 1.455, 0.128 * z)).shaded(60), "eye"))
    return parts
