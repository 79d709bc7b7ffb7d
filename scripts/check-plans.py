#!/usr/bin/env python3
"""Opens drawings that Renderer makes with other programs, and measures what is in them.

  scripts/check-plans.py [PROGRAMS]     the folder of the programs [build/release/bin]

A house of 40 x 12 m with a slanted wall is drawn as DXF, SVG, PDF and PNG. Lengths and areas of the DXF are read by
ezdxf; the SVG is drawn by librsvg (rsvg-convert) and the PDF by poppler (pdftoppm), and in their images the wall is
measured in pixels. Exits with 1 where something is wrong, with 77 where these programs are not installed.
"""
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

DPI = 300
LONG, WIDE, WALL, SCALE = 40.0, 12.0, 0.3, 100


def box(lines, count, corners, low, high):
    """A prism over anticlockwise corners (x, z seen from above)."""
    n = len(corners)
    for y in (low, high):
        lines += ["v %.9g %.9g %.9g" % (x, y, z) for x, z in corners]
    ring = [count + 1 + i for i in range(n)]
    lines.append("f " + " ".join(map(str, ring)))
    lines.append("f " + " ".join(str(i + n) for i in reversed(ring)))
    lines += ["f %d %d %d %d" % (ring[(i + 1) % n], ring[i], ring[i] + n, ring[(i + 1) % n] + n) for i in range(n)]
    return count + 2 * n


def write_house(folder):
    def rectangle(x, z, x2, z2):
        return [(x, z), (x2, z), (x2, z2), (x, z2)]
    lines, count = [], 0
    prisms = [(rectangle(0, 0, LONG, WALL), 0, 3), (rectangle(0, WIDE - WALL, LONG, WIDE), 0, 3),
              (rectangle(0, WALL, WALL, WIDE - WALL), 0, 3), (rectangle(LONG - WALL, WALL, LONG, WIDE - WALL), 0, 3),
              ([(20, WALL), (20.2, WALL), (23.2, WIDE - WALL), (23, WIDE - WALL)], 0, 3),
              (rectangle(0, 0, LONG, WIDE), -.2, 0)]
    for k, (corners, low, high) in enumerate(prisms):
        lines.append("o part%d" % k)
        count = box(lines, count, corners, low, high)
    (folder / "house.obj").write_text("\n".join(lines) + "\n")


def draw(programs, folder, name, *options):
    command = [str(programs / "Renderer"), str(folder / "house.obj"), "--units=m", "--plan", str(folder / name),
               "--plan-scale", str(SCALE), *options]
    subprocess.run(command, check=True)
    return folder / name


def check(what, found, wanted, within):
    good = abs(found - wanted) <= within
    print("%-44s %14.6f  wanted %12.6f  %s" % (what, found, wanted, "good" if good else "WRONG"))
    return good


def lengths(path):
    import ezdxf
    outer, rooms, total = 0.0, [], 0.0
    for entity in ezdxf.readfile(str(path)).modelspace():
        if entity.dxftype() == "POLYLINE" and entity.dxf.layer == "CUT":
            points = [v.dxf.location for v in entity.vertices]
            area = sum(a.x * b.y - b.x * a.y for a, b in zip(points, points[1:] + points[:1])) / 2
            total += area
            outer = max(outer, max(p.x for p in points) - min(p.x for p in points))
        elif entity.dxftype() == "TEXT":
            rooms.append(float(entity.dxf.text.split()[1]))
    return outer, total, rooms


def width_of_ink(path):
    """From the first to the last dark pixel of the rows that the long wall crosses: those with the most ink."""
    import numpy
    from PIL import Image
    dark = numpy.asarray(Image.open(path).convert("L")) < 220
    row = dark[dark.sum(axis=1).argmax()]
    columns = numpy.flatnonzero(row)
    return columns[-1] - columns[0] + 1


def main():
    if len(sys.argv) > 2 or sys.argv[1:2] and sys.argv[1].startswith("-"):
        print(__doc__)
        sys.exit(0 if sys.argv[1:2] in (["-h"], ["--help"]) else 2)
    root = pathlib.Path(__file__).resolve().parents[1]
    programs = pathlib.Path(sys.argv[1]) if sys.argv[1:] else root / "build/release/bin"
    missing = [name for name in ("rsvg-convert", "pdftoppm") if shutil.which(name) is None]
    for module in ("ezdxf", "numpy", "PIL"):
        try:
            __import__(module)
        except ImportError:
            missing.append("python3-" + module.lower())
    if missing:
        print("check-plans.py: not installed: " + ", ".join(missing), file=sys.stderr)
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_house(folder)
        outer, total, rooms = lengths(draw(programs, folder, "house.dxf"))
        inside = (LONG - 2 * WALL) * (WIDE - 2 * WALL) - .2 * (WIDE - 2 * WALL)
        slant = math.hypot(3, WIDE - 2 * WALL)
        good = check("DXF: the long wall, m", outer, LONG, LONG * 1e-6)
        good &= check("DXF: what is cut, m2", total, LONG * WIDE - inside, 1e-4)
        good &= check("DXF: rooms together, m2", sum(rooms), inside, .011)
        good &= check("DXF: number of rooms (slant %.3f m)" % slant, len(rooms), 2, 0)
        wanted = LONG * 1000 / SCALE / 25.4 * DPI
        line = .5 / 25.4 * DPI  # half a millimetre, half of it on either side
        svg = folder / "svg.png"
        subprocess.run(["rsvg-convert", "-d", str(DPI), "-p", str(DPI), "-o", str(svg),
                        str(draw(programs, folder, "house.svg"))], check=True)
        good &= check("SVG: the long wall, pixels", width_of_ink(svg) - line, wanted, 2)
        subprocess.run(["pdftoppm", "-r", str(DPI), "-png", "-singlefile", str(draw(programs, folder, "house.pdf")),
                        str(folder / "pdf")], check=True)
        good &= check("PDF: the long wall, pixels", width_of_ink(folder / "pdf.png") - line, wanted, 2)
        for picture in ("lines", "both"):
            path = draw(programs, folder, picture + ".png", "--plan-image", picture, "--plan-dpi", str(DPI),
                        "--antialiasing", "1", "--setting=background=1,1,1")
            if picture == "lines":
                good &= check("PNG: the long wall, pixels", width_of_ink(path) - line, wanted, 1)
            from PIL import Image
            good &= check("PNG, %s: pixels to an inch" % picture, Image.open(path).info["dpi"][0], DPI, .01)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
