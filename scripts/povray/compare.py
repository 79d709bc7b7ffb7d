"""Compares two pictures in linear light for scripts/compare-povray.sh.

    compare.py FOLDER NAME SAMPLES LIMIT

takes NAME.pfm (ours), NAME.ppm (theirs, SAMPLES times as wide and high, averaged here) and NAME-parts.ppm (number of
the part that each pixel shows, in the order of NAME.parts). With glass there are also NAME-own.ppm, with POV-Ray's own
law for the shadow of glass, and NAME-dark.ppm, with black ones: where the two differ such a shadow counts. Prints the
mean of each and the mean absolute difference in percent of the mean of theirs, for each part and the whole; writes
NAME.png: ours, theirs, and their difference, of which white is a fifth of the mean. Exits with 1 where the whole, or
what no shadow of glass is in, differs by more than LIMIT percent.
"""
import array
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data", "tools"))
import pictures  # noqa: E402


def header(file, count):
    words = []
    while len(words) < count:
        words += file.readline().split(b"#")[0].split()
    return words


def read_pfm(path):
    """Width, height and numbers, top row first."""
    with open(path, "rb") as file:
        kind, width, height, scale = header(file, 4)
        width, height, values = int(width), int(height), array.array("f", file.read())
    if kind != b"PF" or len(values) != 3 * width * height:
        raise SystemExit("%s: not a whole colour .pfm" % path)
    if (float(scale) < 0) != (sys.byteorder == "little"):
        values.byteswap()
    row = 3 * width
    return width, height, [v for y in reversed(range(height)) for v in values[y * row:(y + 1) * row]]


def read_ppm(path, average=1):
    """Width, height and numbers from 0 to 1, each the mean of average x average; 16 bits a number."""
    with open(path, "rb") as file:
        kind, width, height, largest = header(file, 4)
        width, height, values = int(width), int(height), array.array("H", file.read())
    if kind != b"P6" or largest != b"65535" or len(values) != 3 * width * height:
        raise SystemExit("%s: not a whole .ppm of 16 bits" % path)
    if sys.byteorder == "little":
        values.byteswap()
    if max(values) == 65535:
        raise SystemExit("%s: the picture is clipped, the scene's lights are too strong" % path)
    row, out = 3 * width, []
    for top in range(0, height, average):
        rows = [values[y * row:(y + 1) * row] for y in range(top, top + average)]
        sums = [sum(column) for column in zip(*rows)] if average > 1 else rows[0]
        channels = []
        for c in range(3):
            one = sums[c::3]
            channels.append([sum(one[x:x + average]) for x in range(0, width, average)] if average > 1 else one)
        scale = 1 / (65535.0 * average * average)
        out += [v * scale for pixel in zip(*channels) for v in pixel]
    return width // average, height // average, out


def figures(ours, theirs, pixels):
    """Mean of each, and mean absolute difference, over `pixels`."""
    n = 3 * len(pixels)
    index = [3 * p + c for p in pixels for c in range(3)]
    a, b = sum(ours[i] for i in index) / n, sum(theirs[i] for i in index) / n
    return a, b, sum(abs(ours[i] - theirs[i]) for i in index) / n


def report(label, ours, theirs, pixels, mean):
    """Prints a line; the difference in percent of `mean`."""
    if not pixels:
        return 0.0
    share = 300.0 * len(pixels) / len(ours)
    a, b, difference = (100 * v / mean for v in figures(ours, theirs, pixels))
    print("  %-22s %6.1f %% %8.2f %8.2f %+9.3f %9.3f" % (label, share, a, b, a - b, difference))
    return difference


def write_picture(path, width, ours, theirs, mean):
    def shown(values):
        return pictures.srgb_bytes([v * 0.3 / mean for v in values])

    rows = []
    for start in range(0, len(ours), 3 * width):
        a, b = ours[start:start + 3 * width], theirs[start:start + 3 * width]
        difference = bytes(min(255, int(255 * 5 * abs(p - q) / mean)) for p, q in zip(a, b))
        rows.append(shown(a) + shown(b) + difference)
    pictures.write_png(path, 3 * width, len(rows), rows)


def main():
    folder, name, samples, limit = sys.argv[1], sys.argv[2], int(sys.argv[3]), float(sys.argv[4])
    path = os.path.join(folder, name)
    width, height, ours = read_pfm(path + ".pfm")
    everything = range(width * height)

    def theirs_of(suffix, average):
        their_width, their_height, values = read_ppm(path + suffix + ".ppm", average)
        if (their_width, their_height) != (width, height):
            raise SystemExit("%s%s.ppm: not of the size of %s.pfm" % (name, suffix, name))
        return values

    theirs = theirs_of("", samples)
    shown = [int(v * 255 + 0.5) for v in theirs_of("-parts", 1)[::3]]
    with open(path + ".parts", encoding="ascii") as file:
        names = file.read().split("\n")[:-1]
    mean = figures(ours, theirs, everything)[1]

    print("%s, %d x %d, %d samples a pixel; in %% of the mean" % (name, width, height, samples * samples))
    print("  %-22s %8s %8s %8s %9s %9s" % ("", "pixels", "ours", "POV-Ray", "bias", "absolute"))
    for number, part in enumerate(names, 1):
        report(part, ours, theirs, [p for p in everything if shown[p] == number], mean)
    worst = report("whole", ours, theirs, everything, mean)
    if os.path.exists(path + "-own.ppm"):
        own, dark = theirs_of("-own", samples), theirs_of("-dark", samples)
        shadow = [max(abs(own[3 * p + c] - dark[3 * p + c]) for c in range(3)) > 0.002 * mean for p in everything]
        print(" with POV-Ray's own shadows of glass")
        report("in them", ours, own, [p for p in everything if shadow[p]], mean)
        worst = max(worst, report("outside", ours, own, [p for p in everything if not shadow[p]], mean))
    write_picture(path + ".png", width, ours, theirs, mean)
    if not worst <= limit:
        raise SystemExit("%s: differs by %.3f %%, more than %g %%" % (name, worst, limit))


if __name__ == "__main__":
    main()
