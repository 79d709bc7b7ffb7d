"""Radiance of three skies as functions of a direction (x, y, z), y up."""
import math
import random

from pictures import Noise
from suns import DAY, SUNSET


def mix(a, b, t):
    return (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t)


def step(a, b, x):
    t = max(0.0, min(1.0, (x - a) / (b - a)))
    return t * t * (3 - 2 * t)


def angle_to(sun, d):
    return math.acos(max(-1.0, min(1.0, sun[0] * d[0] + sun[1] * d[1] + sun[2] * d[2])))


class Sunset:
    """A low sun, a warm gradient, torn streaks of cloud lit from below."""

    def __init__(self):
        self.noise = Noise(21)

    def __call__(self, d):
        away = angle_to(SUNSET, d)
        side = 0.5 + 0.5 * math.cos(away)            # 1 at the sun, 0 opposite
        if d[1] < 0:
            haze = mix((0.16, 0.11, 0.1), (0.62, 0.3, 0.12), side ** 3)
            return mix(haze, (0.05, 0.04, 0.035), step(0.0, 0.16, -d[1]))
        colour = self.clear(d[1], side, away)
        if d[1] > 0.015:
            colour = self.clouded(colour, d, side, away)
        disc = 400.0 * math.exp(-((away / 0.0085) ** 2))
        return (colour[0] + disc, colour[1] + 0.52 * disc, colour[2] + 0.2 * disc) if disc > 1e-3 else colour

    @staticmethod
    def clear(height, side, away):
        zenith = mix((0.035, 0.07, 0.2), (0.07, 0.12, 0.27), side)
        middle = mix((0.16, 0.15, 0.28), (0.75, 0.36, 0.22), side ** 2)
        horizon = mix((0.3, 0.2, 0.24), (1.75, 0.68, 0.18), side ** 2.5)
        colour = mix(horizon, middle, step(0.0, 0.3, height))
        colour = mix(colour, zenith, step(0.12, 0.75, height))
        glow = 3.2 * math.exp(-away / 0.07) + 0.7 * math.exp(-away / 0.3)
        return (colour[0] + glow, colour[1] + 0.5 * glow, colour[2] + 0.16 * glow)

    def clouded(self, sky, d, side, away):
        flat = 1 / (d[1] + 0.12)
        x, z = d[0] * flat, d[2] * flat
        shape = self.noise.fractal3(0.75 * x + 4, 0.4, 1.7 * z, 5, 0.55)
        cover = step(0.08, 0.75, shape) * step(0.015, 0.12, d[1])
        if cover <= 0:
            return sky
        thick = step(0.25, 1.0, shape)
        lit = mix((0.34, 0.2, 0.26), (2.3, 0.85, 0.32), side ** 3)
        dark = mix((0.09, 0.08, 0.14), (0.42, 0.17, 0.15), side ** 2)
        cloud = mix(lit, dark, 0.85 * thick)
        rim = 2.0 * math.exp(-away / 0.22) * (1 - thick)
        cloud = (cloud[0] + rim, cloud[1] + 0.5 * rim, cloud[2] + 0.18 * rim)
        return mix(sky, cloud, 0.9 * cover)


class Day:
    """A high sun among cumulus clouds."""

    def __init__(self):
        self.noise = Noise(22)

    def __call__(self, d):
        away = angle_to(DAY, d)
        if d[1] < 0:
            return mix((0.62, 0.66, 0.68), (0.2, 0.22, 0.16), step(0.0, 0.12, -d[1]))
        blue = mix((0.72, 0.84, 1.0), (0.1, 0.26, 0.72), step(0.0, 0.7, d[1]) ** 0.7)
        glow = 1.1 * math.exp(-away / 0.12) + 0.35 * math.exp(-away / 0.5)
        colour = (blue[0] + glow, blue[1] + 0.95 * glow, blue[2] + 0.85 * glow)
        if d[1] > 0.02:
            flat = 1.1 / (d[1] + 0.1)
            shape = self.noise.fractal3(d[0] * flat + 9, 0.3, d[2] * flat, 5)
            cover = step(0.12, 0.6, shape) * step(0.02, 0.14, d[1])
            shade = 1.45 - 0.75 * step(0.3, 1.0, shape) + 0.4 * math.exp(-away / 0.4)
            colour = mix(colour, (shade, shade, 1.04 * shade), 0.95 * cover)
        disc = 900.0 * math.exp(-((away / 0.0085) ** 2))
        return (colour[0] + disc, colour[1] + 0.94 * disc, colour[2] + 0.8 * disc) if disc > 1e-3 else colour


class Night:
    """The band of the Milky Way over a faint glow at the horizon; `stars` are added to the picture."""

    POLE = (0.46, 0.62, 0.635)                       # of the galaxy's plane
    CENTRE = (0.66, 0.18, -0.73)                     # where the band is brightest

    def __init__(self):
        self.noise = Noise(23)

    def __call__(self, d):
        if d[1] < -0.02:
            return (0.0015, 0.0017, 0.0022)
        glow = math.exp(-max(0.0, d[1]) / 0.16)
        sky = mix((0.0035, 0.0055, 0.012), (0.016, 0.02, 0.024), glow)
        band = self.band(d)
        if band > 0.002:
            bulge = 0.5 + 0.5 * sum(a * b for a, b in zip(d, self.CENTRE))
            clump = self.noise.fractal3(5 * d[0], 5 * d[1], 5 * d[2], 5, 0.6)
            dust = step(0.05, 0.75, self.noise.fractal3(6 * d[0] + 30, 6 * d[1], 6 * d[2], 4,
                                                        0.6) + 0.9 * band - 0.45)
            light = 0.032 * band * (0.35 + 1.5 * bulge ** 3) * max(0.0, 1 + 0.9 * clump) * (1 - 0.8 * dust)
            tint = mix((0.75, 0.85, 1.1), (1.15, 0.95, 0.8), bulge ** 2)
            sky = (sky[0] + light * tint[0], sky[1] + light * tint[1], sky[2] + light * tint[2])
        return mix((0.0015, 0.0017, 0.0022), sky, step(-0.02, 0.01, d[1]))

    def band(self, d):
        across = sum(a * b for a, b in zip(d, self.POLE))
        return math.exp(-(across / 0.15) ** 2)

    def stars(self, count, seed):
        """Yields (direction, colour): few bright ones, many faint ones, crowded along the band."""
        dice = random.Random(seed)
        kept = 0
        while kept < count:
            y, a = dice.random(), 2 * math.pi * dice.random()
            r = math.sqrt(1 - y * y)
            d = (r * math.sin(a), y, -r * math.cos(a))
            chance, size, heat = dice.random(), dice.random(), dice.random()
            if chance > 0.16 + 0.84 * self.band(d):
                continue
            kept += 1
            light = min(40.0, 0.012 / max(1e-4, size) ** 1.15) * step(0.0, 0.12, y)
            tint = mix((1.0, 0.72, 0.5), (0.65, 0.8, 1.15), heat ** 0.6)
            yield d, (light * tint[0], light * tint[1], light * tint[2])
