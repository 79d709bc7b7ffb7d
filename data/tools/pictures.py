"""Pictures: PNG and Radiance HDR writers, and noise that is the same on every run."""
import math
import os
import random
import struct
import zlib


def save(path, parts):
    """Writes a file whole or not at all."""
    with open(path + ".part", "wb") as file:
        for part in parts:
            file.write(part)
    os.replace(path + ".part", path)


def srgb(linear):
    """Linear 0..1 to an sRGB byte."""
    x = min(1.0, max(0.0, linear))
    v = 12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055
    return int(255 * v + 0.5)


SRGB_TABLE = bytes(srgb(i / 4095) for i in range(4096))


def srgb_bytes(colour):
    return bytes(SRGB_TABLE[int(4095 * min(1.0, max(0.0, c)) + 0.5)] for c in colour)


def png_bytes(width, height, rows, channels=3):
    """A PNG of 8-bit RGB or RGBA; `rows` are bytes of width * channels, top first."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    packed = zlib.compress(b"".join(_filtered(rows, channels)), 6)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def _filtered(rows, channels):
    """Filter 1 (difference to the pixel at the left) on every row: smooth pictures pack well."""
    for row in rows:
        shifted = bytes(channels) + row[:-channels]
        yield b"\x01" + bytes((a - b) & 255 for a, b in zip(row, shifted))


def write_png(path, width, height, rows, channels=3):
    save(path, [png_bytes(width, height, rows, channels)])


def rgbe(colour):
    largest = max(colour)
    if largest < 1e-32:
        return (0, 0, 0, 0)
    mantissa, exponent = math.frexp(largest)
    factor = mantissa * 256.0 / largest
    return (int(colour[0] * factor), int(colour[1] * factor), int(colour[2] * factor), exponent + 128)


def write_hdr(path, width, height, rows):
    """Radiance picture, run-length coded; `rows` of linear RGB tuples, top first; 8 <= width < 32768."""
    parts = [b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width)]
    for row in rows:
        pixels = [rgbe(c) for c in row]
        parts.append(struct.pack(">BBH", 2, 2, width))
        parts += [_runs(bytes(p[channel] for p in pixels)) for channel in range(4)]
    save(path, parts)


def _runs(data):
    """Radiance's coding of one channel of a row: runs as 128 + length, other bytes after their count."""
    out, start, n = bytearray(), 0, len(data)
    while start < n:
        begin = start                      # find the next run of at least 4
        run = 1
        while begin < n:
            run = 1
            while run < 127 and begin + run < n and data[begin + run] == data[begin]:
                run += 1
            if run >= 4:
                break
            begin += run
        while start < begin:
            count = min(128, begin - start)
            out.append(count)
            out += data[start:start + count]
            start += count
        if begin < n:
            out += bytes((128 + run, data[begin]))
            start = begin + run
    return bytes(out)


class Noise:
    """Value noise on a lattice, smooth, in -1..1; repeats after 256 (or `period`, a power of two) cells."""

    def __init__(self, seed, period=256):
        dice = random.Random(seed)
        keys = [(dice.random(), i) for i in range(256)]
        self.order = [i for _, i in sorted(keys)]
        self.order += self.order
        self.value = [2 * dice.random() - 1 for _ in range(256)] * 2
        self.mask = period - 1

    def at3(self, x, y, z):
        order, value = self.order, self.value
        fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
        u, v, w = x - fx, y - fy, z - fz
        u, v, w = u * u * (3 - 2 * u), v * v * (3 - 2 * v), w * w * (3 - 2 * w)
        m = self.mask
        x0, y0, z0 = fx & m, fy & m, fz & m
        x1, y1, z1 = (x0 + 1) & m, (y0 + 1) & m, (z0 + 1) & m
        a, b = order[x0], order[x1]
        aa, ab, ba, bb = order[a + y0], order[a + y1], order[b + y0], order[b + y1]
        c00 = value[aa + z0] + u * (value[ba + z0] - value[aa + z0])
        c10 = value[ab + z0] + u * (value[bb + z0] - value[ab + z0])
        c01 = value[aa + z1] + u * (value[ba + z1] - value[aa + z1])
        c11 = value[ab + z1] + u * (value[bb + z1] - value[ab + z1])
        c0 = c00 + v * (c10 - c00)
        return c0 + w * (c01 + v * (c11 - c01) - c0)

    def at2(self, x, y):
        order, value = self.order, self.value
        fx, fy = math.floor(x), math.floor(y)
        u, v = x - fx, y - fy
        u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
        m = self.mask
        x0, y0 = fx & m, fy & m
        x1, y1 = (x0 + 1) & m, (y0 + 1) & m
        a, b = order[x0], order[x1]
        c0 = value[a + y0] + u * (value[b + y0] - value[a + y0])
        c1 = value[a + y1] + u * (value[b + y1] - value[a + y1])
        return c0 + v * (c1 - c0)

    def fractal2(self, x, y, octaves, gain=0.5):
        """Sum of octaves, each twice as fine; periodic with `period` (each octave keeps it)."""
        total, weight = 0.0, 1.0
        for _ in range(octaves):
            total += weight * self.at2(x, y)
            x, y, weight = 2 * x, 2 * y, weight * gain
        return total

    def fractal3(self, x, y, z, octaves, gain=0.5):
        total, weight = 0.0, 1.0
        for _ in range(octaves):
            total += weight * self.at3(x, y, z)
            x, y, z, weight = 2.02 * x + 7.1, 2.03 * y + 3.7, 2.01 * z + 11.3, weight * gain
        return total
