"""Textures of the nave: ashlar courses of limestone, a floor of marble squares."""
import random

from pictures import Noise, png_bytes, srgb_bytes

SIZE = 512


def ashlar(seed, contrast):
    """2 m x 2 m of dressed stone in courses of 0.25 m with narrow joints; repeats."""
    dice = random.Random(seed)
    courses = 8
    noise = Noise(seed, 64)
    stones = []
    for _ in range(courses):
        shift, cuts = dice.random() * 0.5, [0.0]
        while cuts[-1] < 0.8:
            cuts.append(cuts[-1] + 0.16 + 0.14 * dice.random())
        stones.append((shift, [c / cuts[-1] for c in cuts],
                       [(dice.random() - 0.5, dice.random() - 0.5) for _ in cuts]))
    grain = [[noise.fractal2(x / 16, y / 16, 3) for x in range(0, SIZE, 2)] for y in range(0, SIZE, 2)]
    rows = []
    for y in range(SIZE):
        shift, cuts, tones = stones[y * courses // SIZE]
        v = y * courses / SIZE % 1.0
        near_joint = min(v, 1 - v) * SIZE / courses < 1.0
        row = bytearray()
        for x in range(SIZE):
            u = (x / SIZE + shift) % 1.0
            k = next(i for i in range(len(cuts) - 1) if u < cuts[i + 1])
            joint = near_joint or min(u - cuts[k], cuts[k + 1] - u) * SIZE < 1.0
            light, warm = tones[k]
            tone = 1 + contrast * (0.16 * light + 0.1 * grain[y // 2][x // 2] - (0.22 if joint else 0.0))
            row += srgb_bytes((0.7 * tone * (1 + 0.06 * warm), 0.61 * tone, 0.475 * tone * (1 - 0.12 * warm)))
        rows.append(bytes(row))
    return png_bytes(SIZE, SIZE, rows)


def marble_floor(seed):
    """4 m x 4 m: pale squares set diagonally, dark ones at their corners, with veins; repeats."""
    noise = Noise(seed, 16)
    dice = random.Random(seed)
    tones = [[dice.random() for _ in range(8)] for _ in range(8)]
    rows = []
    for y in range(SIZE):
        row = bytearray()
        for x in range(SIZE):
            u, v = 8 * x / SIZE, 8 * y / SIZE
            i, j = int(u), int(v)
            edge = min(u - i, i + 1 - u, v - j, j + 1 - v) * SIZE / 8
            warp = noise.fractal2(2 * u + 3 * (i * 7 % 5), 2 * v + 3 * (j * 11 % 7), 4)
            vein = max(0.0, 1 - 7 * abs(warp - 0.1)) ** 2
            tone = 0.9 + 0.2 * tones[i][j] + 0.08 * warp
            if edge < 0.9:
                colour = (0.2, 0.17, 0.14)
            elif (i + j) % 2:
                colour = (0.62 * tone - 0.2 * vein, 0.55 * tone - 0.2 * vein, 0.46 * tone - 0.18 * vein)
            else:
                colour = (0.11 * tone + 0.14 * vein, 0.06 * tone + 0.11 * vein, 0.05 * tone + 0.08 * vein)
            row += srgb_bytes(colour)
        rows.append(bytes(row))
    return png_bytes(SIZE, SIZE, rows)
