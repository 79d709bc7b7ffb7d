"""Runs the suite's importer and Renderer on a model: its bounds, its mask and base colours."""
import json
import os
import struct
import sys

import programs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "denoising"))
import exr  # noqa: E402

HEAD, BOUNDS, ENTRY = 128, 48, 32  # of a .bsp: docs/formats.md
OPACITY, NAME = 12, 108            # in its materials
# Base colours alone: neither mirrors nor metal nor glass; holes stay.
PLAIN = """version = 2
model = "%s"
defaultLight = false
modelLights = false
background = [0, 0, 0]
[[material]]
name = "*"
roughness = 1.0
metallic = 0.0
specular = [0, 0, 0]
reflectivity = 0.0
coat = 0.0
opacity = 1.0
"""
NOTHING = 1e9                      # depth of the background is 1e10


def read_bsp(path):
    """low, high, number of triangles and of parts, opacity of materials by name."""
    with open(path, "rb") as file:
        head = file.read(HEAD)
        count, = struct.unpack_from("<I", head, 20)
        bounds = struct.unpack_from("<6f", head, BOUNDS)
        sections, content = {}, {}
        for entry in struct.iter_unpack("<12sIQQ", file.read(count * ENTRY)):
            sections[entry[0].rstrip(b"\0").decode()] = entry[1:]
        for name in ("materials", "strings"):
            size, offset, number = sections.get(name, (1, 0, 0))
            file.seek(offset)
            content[name] = file.read(size * number)
    opacities, size = {}, sections.get("materials", (1, 0, 0))[0]
    for at in range(0, len(content["materials"]), size):
        name, = struct.unpack_from("<I", content["materials"], at + NAME)
        name = content["strings"][name:content["strings"].index(b"\0", name)].decode("utf-8", "replace")
        opacities[name], = struct.unpack_from("<f", content["materials"], at + OPACITY)
    return {"low": bounds[:3], "high": bounds[3:], "opacities": opacities,
            "triangles": sections.get("triangles", (0, 0, 0))[2], "parts": sections.get("parts", (0, 0, 0))[2]}


def zero_of(report):
    """The point that the importer takes off from all positions, as its report says."""
    with open(report, encoding="utf-8", errors="replace") as file:
        for line in file:
            if line.startswith("zero "):
                return [float(word) for word in line.split()[1:]]
    return [0.0, 0.0, 0.0]


def sentence(line):
    """A message as the importer hands it over: a form and what goes into its braces, which may be one, too."""
    try:
        return plain(json.loads(line.split(" ", 1)[1]))
    except (IndexError, KeyError, ValueError):
        return line


def plain(message):
    if not isinstance(message, list):
        return str(message)
    form, *values = message
    return plain(form).format(*map(plain, values)) if values else plain(form)


class Ours:
    def __init__(self, importer, renderer):
        self.importer, self.renderer = importer, renderer

    def bounds(self, model, stem):
        """Raises Failed with the importer's sentence. Leaves STEM.bsp."""
        try:
            programs.run([self.importer, model, stem + ".bsp"], stem + ".import.log")
        except programs.Failed as failed:
            raise programs.Failed(sentence(str(failed))) from None
        return {**read_bsp(stem + ".bsp"), "zero": zero_of(stem + ".import.log")}

    def render(self, stem, view, side):
        """(mask, base colours, emitted light) of a view; the model is STEM.bsp."""
        with open(stem + ".scn", "w", encoding="utf-8") as file:
            file.write(PLAIN % (os.path.basename(stem) + ".bsp"))
        with open(stem + ".cam", "w", encoding="utf-8") as file:
            file.write("version = 1\n")
            for name, value in (("eye", view["eye"]), ("forward", view["forward"]), ("up", view["up"])):
                file.write("%s = [%s]\n" % (name, ", ".join("%.17g" % v if v else "0.0" for v in value)))
            file.write("orthographicWidth = %.17g\n" % view["width"])
        programs.run([self.renderer, stem + ".scn", "--camera=" + stem + ".cam", "-o", stem + ".ours.exr", "--aovs",
                      "-w", str(side), "-h", str(side), "--threads=1", "--progress=none"], stem + ".render.log")
        image = exr.Exr(stem + ".ours.exr")
        return image.channels["depth.Z"] < NOTHING, image.colours("albedo."), image.colours()
