"""Writes a Scene for the Renderer (.obj, .mtl, .scn) and for render_cycles.py (.npz, .json)."""
import hashlib
import json
import math
import os
import shutil
import sys

import numpy

from geometry import beside

sys.path.insert(0, beside("..", "..", "data", "tools"))
import pictures  # noqa: E402


def write(scene, path):
    """Writes path.*, and gives the checksum of what both programs get of the scene."""
    corners, coordinates, material = scene.soup.whole()
    points, index = numpy.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    index = index.reshape(-1, 3)
    textures = copied_textures(scene, path)
    if scene.sky is not None:
        write_sky(scene.sky, path)
    write_obj(path, points, index, coordinates, material, len(scene.materials))
    write_mtl(path, textures)
    write_scn(scene, path, set(material.tolist()))
    numpy.savez(path + ".npz", points=points, index=index.astype(numpy.int32), coordinates=coordinates, material=material)
    text = json.dumps(told(scene, textures, os.path.basename(path)), indent=1)
    with open(path + ".json", "w", encoding="ascii") as file:
        file.write(text)
    sum_ = hashlib.sha256(text.encode())
    for part in (points, index, coordinates, material, scene.sky):
        sum_.update(b"" if part is None else numpy.ascontiguousarray(part).tobytes())
    return sum_.hexdigest()[:16]


def copied_textures(scene, path):
    """The textures' names beside `path`, by material; "" where there is none."""
    names = []
    for number, material in enumerate(scene.materials):
        name = "%s-%d.png" % (os.path.basename(path), number) if material.texture else ""
        if name:
            shutil.copyfile(material.texture, os.path.join(os.path.dirname(path), name))
        names.append(name)
    return names


def write_sky(sky, path):
    """Blender's images of the sky begin a quarter further left."""
    height, width, _ = sky.shape
    for ending, image in (("-sky.hdr", sky), ("-their-sky.hdr", numpy.roll(sky, -width // 4, axis=1))):
        pictures.write_hdr(path + ending, width, height, [[tuple(map(float, c)) for c in row] for row in image])


def write_obj(path, points, index, coordinates, material, count):
    mapped = bool(coordinates.any())
    with open(path + ".obj", "w", encoding="ascii") as file:
        file.write("mtllib %s.mtl\n" % os.path.basename(path))
        file.write("".join("v %.9g %.9g %.9g\n" % tuple(p) for p in points.tolist()))
        if mapped:
            file.write("".join("vt %.9g %.9g\n" % tuple(p) for p in coordinates.reshape(-1, 2).tolist()))
        for number in range(count):
            chosen = numpy.flatnonzero(material == number)
            if not len(chosen):
                continue
            file.write("usemtl m%d\n" % number)
            corners = (index[chosen] + 1).tolist()
            if mapped:
                file.write("".join("f %d/%d %d/%d %d/%d\n" % (a, 3 * t + 1, b, 3 * t + 2, c, 3 * t + 3)
                                   for (a, b, c), t in zip(corners, chosen.tolist())))
            else:
                file.write("".join("f %d %d %d\n" % tuple(three) for three in corners))


def write_mtl(path, textures):
    with open(path + ".mtl", "w", encoding="ascii") as file:
        for number, texture in enumerate(textures):
            file.write("newmtl m%d\nKd 1 1 1\nKs 0 0 0\n%s" % (number, "map_Kd %s\n" % texture if texture else ""))


def array(values):
    return "[%s]" % ", ".join("%.9g" % v for v in values)


def write_scn(scene, path, used):
    name = os.path.basename(path)
    lines = ["version = 2", 'model = "%s.obj"' % name, "creaseAngle = 0.0", "defaultLight = false",
             "background = " + array(scene.background), "", "[camera]", "eye = " + array(scene.eye),
             "lookAt = " + array(scene.look_at), "fov = %.9g" % scene.fov]
    for number, material in enumerate(scene.materials):
        if number in used:
            lines += ["", "[[material]]", 'name = "m%d"' % number] + material_lines(material)
    for light in scene.lights:
        lines += ["", "[[light]]", 'kind = "%s"' % light.kind, "intensity = " + array(light.intensity)]
        if light.kind != "directional":
            lines.append("position = " + array(light.position))
        if light.kind in ("directional", "rectangle"):
            lines.append("direction = " + array(light.direction))
        if light.kind == "sphere":
            lines.append("radius = %.9g" % light.radius)
        if light.kind == "rectangle":
            lines += ["right = " + array(light.right), "width = %.9g" % light.size[0], "height = %.9g" % light.size[1]]
    if scene.sky is not None:
        lines += ["", "[[environment]]", 'name = "sky"', 'equirectangular = "%s-sky.hdr"' % name]
    lines += ["", "[still]", 'integrator = "path"', "path.bounces = %d" % scene.bounces,
              "path.caustics = %s" % str(scene.caustics).lower(), "path.clampIndirect = 0", 'path.emitters = "on"',
              "maxDepth = %d" % max(scene.bounces, 1), "denoise.passes = 0", "skyLight.on = true"]
    with open(path + ".scn", "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


def material_lines(material):
    m = material
    lines = ["diffuse = " + array(m.metal or m.diffuse), "emission = " + array(m.emission)]
    if m.metal:
        return lines + ["metallic = 1.0", "roughness = %.9g" % m.roughness]
    if m.glass and m.roughness:
        lines += ["metallic = 0.0", "roughness = %.9g" % m.roughness]
    else:
        lines += ["specular = [0.0, 0.0, 0.0]", "reflectivity = %.9g" % m.mirror]
    if m.glass:
        lines += ["opacity = 0.0", "indexOfRefraction = %.9g" % m.glass,
                  "transmission = " + array([math.exp(-e) for e in m.absorbs or (0.0, 0.0, 0.0)])]
        lines += ["attenuationDistance = 1.0"] if m.absorbs else []
    if m.pane:
        lines += ["opacity = 0.0", "indexOfRefraction = 1.0", "transmission = " + array(m.pane)]
    return lines


def told(scene, textures, name):
    """The facts that render_cycles.py reads beside the triangles."""
    materials = [dict(vars(m), texture=texture) for m, texture in zip(scene.materials, textures)]
    return {"eye": scene.eye, "lookAt": scene.look_at, "fov": scene.fov, "bounces": scene.bounces,
            "caustics": scene.caustics, "background": scene.background, "materials": materials,
            "sky": name + "-their-sky.hdr" if scene.sky is not None else "", "lights": [vars(light) for light in scene.lights]}
