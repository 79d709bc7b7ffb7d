"""Runs the independent programs on a model: Blender (mask and base colours), f3d (mask alone), and osgconv of
OpenSceneGraph, which makes an OBJ of what Blender does not read."""
import json
import math
import os
import struct
import zlib

import numpy

import frames
import programs
from ours import exr

HERE = os.path.dirname(os.path.abspath(__file__))
NO_COLOUR = 32  # above: plain_materials.NONE
BLENDER = {".gltf", ".glb", ".vrm", ".fbx", ".dae", ".obj", ".ply", ".stl", ".wrl", ".x3d", ".dxf", ".blend"}
OVER = ((0, 1), (1, -1), (2, -1))  # osgconv turns models of y up to z up, and Blender turns OBJ files again
F3D = {".3ds": frames.Z_TO_Y}  # what else it reads is read by Blender, or by Assimp
OSG = {".x": OVER, ".ac": frames.Z_TO_Y, ".lwo": OVER, ".lws": OVER}
ANGLE = 0.05    # degrees of f3d's view, which has no orthographic one: rays are parallel but for this


class Blender:
    name, endings = "Blender", BLENDER

    def __init__(self, program):
        self.program = program

    def render(self, model, stem, ours, side, usual=None):
        """(answer, mask, colours, where there are colours)."""
        job = {"model": model, "usual": usual, "image": stem + ".theirs.exr", "answer": stem + ".json", "side": side,
               "low": ours["low"], "high": ours["high"], "zero": ours["zero"]}
        with open(stem + ".job", "w", encoding="utf-8") as file:
            json.dump(job, file)
        for path in (job["image"], job["answer"]):
            if os.path.exists(path):
                os.remove(path)
        programs.run([self.program, "--background", "--factory-startup", "-noaudio", "--threads", "1",
                      "--python-exit-code", "1", "--python", os.path.join(HERE, "render_blender.py"), "--",
                      stem + ".job"], stem + ".theirs.log")
        if not os.path.exists(job["answer"]):
            raise programs.Failed(programs.last_line(stem + ".theirs.log"))
        with open(job["answer"], encoding="utf-8") as file:
            answer = json.load(file)
        image = exr.Exr(job["image"])
        colours = image.colours()
        mask = image.channels["A"] > 0.5
        return answer, mask, colours, mask & (colours.max(axis=2) < NO_COLOUR)


class OpenSceneGraph:
    name, endings = "OpenSceneGraph", set(OSG)

    def __init__(self, program, blender):
        self.program, self.blender = program, blender

    def render(self, model, stem, ours, side):
        made = stem + ".made.obj"
        if os.path.exists(made):
            os.remove(made)
        programs.run([self.program, model, made], stem + ".theirs.log")
        if not os.path.exists(made):
            raise programs.Failed(programs.last_line(stem + ".theirs.log"))
        return self.blender.render(made, stem, ours, side, OSG[os.path.splitext(model)[1].lower()])


class F3d:
    name, endings = "f3d", set(F3D)

    def __init__(self, program):
        self.program = program

    def render(self, model, stem, ours, side):
        usual = F3D[os.path.splitext(model)[1].lower()]
        turn, scale, distance = self.align(model, stem, ours, usual)
        view = frames.view((tuple(ours["low"]), tuple(ours["high"])))
        # Far off by a narrow angle, about the middle of what is seen.
        half = numpy.tan(numpy.radians(ANGLE / 2))
        eye = [e + f * (view["depth"] / 2 - view["width"] / 2 / half) for e, f in zip(view["eye"], view["forward"])]
        point = [e + f * view["depth"] / 2 for e, f in zip(view["eye"], view["forward"])]
        camera = {name: frames.turned_back(turn, [(v + z) / scale for v, z in zip(value, ours["zero"])])
                 for name, value in (("position", eye), ("focal-point", point))}
        camera["view-up"] = frames.turned_back(turn, view["up"])
        image = stem + ".theirs.png"
        looking = ["--camera-%s=%s" % (name, ",".join("%.9g" % v for v in value)) for name, value in camera.items()]
        self.start(["--no-background", "--output", image, "--resolution", "%d,%d" % (side, side),
                    "--camera-view-angle", str(ANGLE), model] + looking, stem)
        mask = read_alpha(image) > 127
        return ({"turn": turn, "usual": turn == usual, "scale": scale, "apart": distance, "view": view,
                 "triangles": 0, "parts": 0}, mask, numpy.zeros((*mask.shape, 3)), numpy.zeros_like(mask))

    def start(self, options, stem):
        programs.run(["xvfb-run", "-a", self.program, "--dry-run"] + options, stem + ".theirs.log")

    def align(self, model, stem, ours, usual):
        """As frames.align, by the sphere around the model that f3d's own view tells; it says no bounds."""
        self.start(["--verbose", "--no-render", model], stem)
        with open(stem + ".theirs.log", encoding="utf-8", errors="replace") as file:
            lines = dict(line.strip().split(": ", 1) for line in file if line.startswith("Camera ") and ": " in line)
        try:
            eye, middle = ([float(word) for word in lines["Camera " + name].split(",")]
                           for name in ("position", "focal point"))
        except (KeyError, ValueError):
            raise programs.Failed(programs.last_line(stem + ".theirs.log")) from None
        theirs = frames.around(middle, math.dist(eye, middle) * math.sin(math.radians(15)))
        box = tuple(ours["low"]), tuple(ours["high"])
        sphere = frames.around([(a + b) / 2 for a, b in zip(*box)], frames.diagonal(box) / 2)
        return frames.align(sphere, theirs, usual, (1.0,), ours["zero"])


def read_alpha(path):
    """The last channel of an 8-bit PNG with alpha, top row first."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed, size = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack_from(">IIBB", data, at + 8)
            size = width, height
            if (depth, colours) != (8, 6):
                raise programs.Failed("%s: no PNG of 8 bits with alpha" % path)
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    return unfiltered(zlib.decompress(packed), *size)[..., 3]


def unfiltered(data, width, height):
    rows = numpy.zeros((height + 1, width + 1, 4), int)
    for y in range(height):
        line = data[y * (4 * width + 1):(y + 1) * (4 * width + 1)]
        values, above = numpy.frombuffer(line[1:], numpy.uint8).reshape(width, 4).astype(int), rows[y, 1:]
        if line[0] in (0, 2):
            rows[y + 1, 1:] = (values + (above if line[0] == 2 else 0)) & 255
            continue
        for x in range(width):
            a, b, c = rows[y + 1, x], rows[y, x + 1], rows[y, x]
            guess = a if line[0] == 1 else (a + b) // 2 if line[0] == 3 else paeth(a, b, c)
            rows[y + 1, x + 1] = (values[x] + guess) & 255
    return rows[1:, 1:]


def paeth(a, b, c):
    p = a + b - c
    to_a, to_b, to_c = (abs(p - value) for value in (a, b, c))
    return numpy.where((to_a <= to_b) & (to_a <= to_c), a, numpy.where(to_b <= to_c, b, c))


