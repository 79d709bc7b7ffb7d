"""A floor of oak laid in squares of five staves, each square turned against its neighbours."""
import random

from pictures import Noise, png_bytes, srgb_bytes

SIZE = 512


def parquet(seed):
    """Covers four squares by four; repeats."""
    noise = Noise(seed, 256)
    dice = random.Random(seed)
    tones = [[(dice.random(), dice.random()) for _ in range(5)] for _ in range(16)]
    rows = []
    for y in range(SIZE):
        row = bytearray()
        for x in range(SIZE):
            u, v = 4 * x / SIZE, 4 * y / SIZE
            i, j = int(u), int(v)
            along, across = (u - i, v - j) if (i + j) % 2 else (v - j, u - i)
            stave = int(5 * across)
            tone, warm = tones[4 * i + j][stave]
            f = 5 * across - stave
            joint = min(f, 1 - f) < 0.02 or min(along, 1 - along) < 0.006
            grain = noise.at2(3 * along + 31 * stave + 7 * i, 40 * across + 13 * j)
            grain += 0.6 * noise.at2(9 * along + 5 * stave, 110 * across + 3 * i)
            light = (0.72 + 0.45 * tone + 0.13 * grain) * (0.45 if joint else 1.0)
            row += srgb_bytes((0.36 * light, (0.19 + 0.02 * warm) * light, (0.085 + 0.02 * warm) * light))
        rows.append(bytes(row))
    return png_bytes(SIZE, SIZE, rows)
