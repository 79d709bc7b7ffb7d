"""Scenes for scripts/compare-povray.sh: each is described once and written for the Renderer and for POV-Ray.

    scenes.py NAME FOLDER WIDTH HEIGHT SAMPLES DEPTH

writes NAME.obj, NAME.mtl, NAME.scn, and NAME.pov, which takes Declare=Pass=...: 0 the picture with our law for the
shadow of glass, 1 with POV-Ray's own, 2 with black ones, 3 the number of the part that each pixel shows.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data", "tools"))
import mesh    # noqa: E402
import solids  # noqa: E402

FADE = 1e-3  # POV-Ray's light falls off as 2 / (1 + (d / FADE)^2): beyond some cm by the square of the distance


class Material:
    """A material of both renderers: matte under a mirror, or glass that leaves `tint` of the light after `distance`."""

    def __init__(self, diffuse=(0.0, 0.0, 0.0), mirror=0.0, glass=0.0, tint=(1.0, 1.0, 1.0), distance=1.0):
        self.diffuse, self.mirror, self.glass = diffuse, mirror, glass  # glass: index of refraction, or 0
        self.tint, self.distance = tint, distance


class Part:
    """One object of one material. `smooth`: shaded by the normals of a ball about its middle."""

    def __init__(self, name, material, surface, middle=None):
        self.name, self.material, self.points = name, material, surface.positions
        self.faces = [(f[0], f[i], f[i + 1]) for f in surface.faces for i in range(1, len(f) - 1)]
        self.normals = None
        if middle:
            self.normals = [mesh.normalize(mesh.sub(p, middle)) for p in self.points]


class Scene:
    def __init__(self, eye, look_at, fov, lights, parts):
        self.eye, self.look_at, self.fov, self.lights, self.parts = eye, look_at, fov, lights, parts


def quad(*corners):
    surface = mesh.Surface()
    surface.faces.append([surface.vertex(c) for c in corners])
    return surface


def squares(low, high, count, y, odd):
    """Every other square of a floor of count x count."""
    surface = mesh.Surface()
    step = (high - low) / count
    for i in range(count):
        for k in range(count):
            if (i + k) % 2 == odd:
                x, z = low + i * step, low + k * step
                surface.faces.append([surface.vertex(c) for c in
                                      ((x, y, z), (x, y, z + step), (x + step, y, z + step), (x + step, y, z))])
    return surface


def ball(centre, radius, levels):
    return solids.displaced(solids.icosphere(levels),
                            lambda p: mesh.add(centre, mesh.scale(p, radius)))


def turned_box(centre, half, degrees):
    """A box turned about the vertical; centre is the middle of its bottom."""
    a = math.radians(degrees)
    c, s = math.cos(a), math.sin(a)
    surface = solids.box((-half[0], 0.0, -half[2]), (half[0], 2 * half[1], half[2]))
    surface.positions = [mesh.snapped((centre[0] + c * x + s * z, centre[1] + y, centre[2] + c * z - s * x))
                         for x, y, z in surface.positions]
    return surface


def room():
    """Matte boxes in a matte room, two lights, a mirror on the wall, a mirrored block."""
    white, red, green = Material((0.75, 0.75, 0.7)), Material((0.7, 0.15, 0.1)), Material((0.15, 0.55, 0.2))
    blue, ochre, mirror = Material((0.1, 0.2, 0.65)), Material((0.7, 0.5, 0.2)), Material((0.2, 0.2, 0.2), mirror=0.8)
    x, y, z = 3.0, 3.0, 3.0
    at = (1.1, 0.35, 0.3)
    return Scene((0.4, 1.7, 2.8), (-0.1, 1.0, -1.0), 75.0, [
        ((-0.9, 2.3, 0.6), (2.0, 1.8, 1.5)),
        ((1.9, 1.6, 1.7), (0.4, 0.6, 1.0)),
    ], [
        Part("floor", ochre, quad((-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z))),
        Part("ceiling", white, quad((-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z))),
        Part("back", white, quad((-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z))),
        Part("front", blue, quad((x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z))),
        Part("left", red, quad((-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z))),
        Part("right", green, quad((x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z))),
        Part("mirror", mirror, quad((-1.6, 0.9, -2.95), (0.6, 0.9, -2.95), (0.6, 2.4, -2.75), (-1.6, 2.4, -2.75))),
        Part("block", mirror, turned_box((1.5, 0.0, -1.2), (0.45, 0.8, 0.35), 25.0)),
        Part("tall", white, turned_box((-1.3, 0.0, -1.4), (0.35, 0.7, 0.35), -20.0)),
        Part("low", blue, turned_box((0.1, 0.0, -0.6), (0.4, 0.25, 0.3), 35.0)),
        Part("bar", red, turned_box((-0.6, 1.1, -0.6), (0.9, 0.06, 0.06), 12.0)),
        Part("ball", white, ball(at, 0.35, 4), at),
    ])


def glass():
    """A block and a ball of glass and a mirrored ball above a chequered floor, in front of a matte wall."""
    light, dark = Material((0.8, 0.78, 0.72)), Material((0.12, 0.16, 0.3))
    wall, red = Material((0.55, 0.6, 0.6)), Material((0.75, 0.2, 0.12))
    clear, green = Material(glass=1.5), Material(glass=1.6, tint=(0.5, 0.9, 0.7), distance=0.6)
    mirror = Material(mirror=0.9)
    at, shiny = (0.75, 0.6, 0.5), (-0.2, 0.55, -0.8)
    return Scene((0.3, 1.7, 3.4), (0.0, 0.6, 0.0), 55.0, [((1.6, 3.2, 2.0), (4.0, 3.9, 3.6))], [
        Part("light squares", light, squares(-3.0, 3.0, 12, 0.0, 0)),
        Part("dark squares", dark, squares(-3.0, 3.0, 12, 0.0, 1)),
        Part("wall", wall, quad((-3, 0, -2.5), (3, 0, -2.5), (3, 3.5, -2.5), (-3, 3.5, -2.5))),
        Part("pillar", red, turned_box((1.5, 0.0, -1.5), (0.2, 0.9, 0.2), 30.0)),
        Part("mirrored ball", mirror, ball(shiny, 0.5, 5), shiny),
        Part("glass ball", clear, ball(at, 0.5, 5), at),
        Part("glass block", green, turned_box((-0.8, 0.1, 0.5), (0.35, 0.5, 0.3), 25.0)),
    ])


SCENES = {"room": room, "glass": glass}


def numbers(v):
    return "%.9g %.9g %.9g" % tuple(v)


def array(v):
    return "[%.9g, %.9g, %.9g]" % tuple(v)


def vector(v):
    return "<%.9g, %.9g, %.9g>" % tuple(v)


def write_obj(scene, name):
    with open(name + ".mtl", "w", encoding="ascii") as file:
        for part in scene.parts:
            file.write("newmtl %s\nKd 0 0 0\n" % part.name.replace(" ", "_"))
    with open(name + ".obj", "w", encoding="ascii") as file:
        file.write("mtllib %s.mtl\n" % os.path.basename(name))
        points, normals = 1, 1
        for part in scene.parts:
            label = part.name.replace(" ", "_")
            file.write("o %s\nusemtl %s\n" % (label, label))
            file.writelines("v %s\n" % numbers(p) for p in part.points)
            if part.normals:
                file.writelines("vn %s\n" % numbers(n) for n in part.normals)
                for f in part.faces:
                    file.write("f %s\n" % " ".join("%d//%d" % (points + i, normals + i) for i in f))
                normals += len(part.normals)
            else:
                file.writelines("f %d %d %d\n" % tuple(points + i for i in f) for f in part.faces)
            points += len(part.points)


def write_scn(scene, name, size, samples, depth):
    lines = ["version = 1", 'model = "%s.obj"' % os.path.basename(name), "creaseAngle = 0.0", "", "[camera]",
             "eye = " + array(scene.eye), "lookAt = " + array(scene.look_at), "fov = %.9g" % scene.fov]
    for place, intensity in scene.lights:
        lines += ["", "[[light]]", 'kind = "point"', "position = " + array(place), "intensity = " + array(intensity)]
    for part in scene.parts:
        m = part.material
        lines += ["", "[[material]]", 'name = "%s"' % part.name.replace(" ", "_"), "diffuse = " + array(m.diffuse),
                  "specular = [0.0, 0.0, 0.0]", "reflectivity = %.9g" % m.mirror]
        if m.glass:
            lines += ["opacity = 0.0", "indexOfRefraction = %.9g" % m.glass, "transmission = " + array(m.tint),
                      "attenuationDistance = %.9g" % m.distance]
    lines += ["", "[still]", "width = %d" % size[0], "height = %d" % size[1], "antialiasing = %d" % samples,
              "maxDepth = %d" % depth, "minContribution = 0.0"]
    with open(name + ".scn", "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


def pov_texture(material):
    m = material
    if m.glass:
        return ("texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 specular 0\n"
                "  reflection { 0, 1 fresnel on } conserve_energy } } " + pov_interior(m))
    return ("texture { pigment { rgb %s } finish { ambient 0 diffuse %.9g specular 0 reflection { %.9g } } }"
            % (vector(m.diffuse), 1 - m.mirror, m.mirror))


def pov_interior(material):
    """Absorbs by a medium: POV-Ray's fade_power leaves out what is mirrored inside."""
    extinction = [-math.log(t) / material.distance for t in material.tint]
    medium = "media { absorption rgb %s }" % vector(extinction) if max(extinction) > 0 else ""
    return "interior { ior %.9g %s } hollow" % (material.glass, medium)


def pov_mesh(part):
    def listed(key, rows):
        return "  %s { %d, %s }\n" % (key, len(rows), ", ".join("<%s>" % ",".join("%.9g" % x for x in r) for r in rows))

    text = "mesh2 {\n" + listed("vertex_vectors", part.points)
    if part.normals:
        text += listed("normal_vectors", part.normals)
    return text + listed("face_indices", part.faces) + "}\n"


def write_pov(scene, name, size, depth):
    forward = mesh.normalize(mesh.sub(scene.look_at, scene.eye))
    right = mesh.normalize(mesh.cross(forward, (0.0, 1.0, 0.0)))
    up = mesh.cross(right, forward)
    wide = 2 * math.tan(math.radians(scene.fov) / 2)
    with open(name + ".pov", "w", encoding="ascii") as file:
        file.write("#version 3.7;\n#ifndef (Pass) #declare Pass = 0; #end\n"
                   "global_settings { assumed_gamma 1.0 max_trace_level %d adc_bailout 0 }\n"
                   % (depth + 1))  # it counts the first ray
        file.write("camera { perspective location %s direction %s right %s up %s }\n" % (
            vector(scene.eye), vector(forward), vector(mesh.scale(right, wide)),
            vector(mesh.scale(up, wide * size[1] / size[0]))))
        for place, intensity in scene.lights:
            # Lambert's 1/pi is part of the surface there, of the light here.
            colour = mesh.scale(intensity, 1 / (2 * math.pi * FADE * FADE))
            file.write("light_source { %s rgb %s fade_distance %g fade_power 2 }\n"
                       % (vector(place), vector(colour), FADE))
        for number, part in enumerate(scene.parts, 1):
            write_pov_part(file, part, number)


def write_pov_part(file, part, number):
    file.write("#declare Shape = %s#if (Pass = 3)\nobject { Shape pigment { rgb %d/255 } "
               "finish { ambient 0 diffuse 0 emission 1 } no_shadow }\n#else\n" % (pov_mesh(part), number))
    file.write("object { Shape %s" % pov_texture(part.material))
    if part.material.glass:
        # The object that is seen casts no shadow, and the one that casts the shadow is not seen.
        file.write("\n  #if (Pass != 1) no_shadow #end }\n#if (Pass = 0 | Pass = 2)\n"
                   "object { Shape no_image no_reflection\n  #if (Pass = 2) pigment { rgb 0 } #else %s #end\n"
                   "  finish { ambient 0 diffuse 0 } %s }\n#end"
                   % (straight_shadow(part.material.glass), pov_interior(part.material)))
    else:
        file.write(" }")
    file.write("\n#end\n")


def straight_shadow(index):
    """A pigment that lets 1 - F of the light through at each face, F of the angle in front of it."""
    entries = []
    for i in range(256):
        cosine = 1 - i / 127.5
        entries.append("[%.9g rgbt <0, 0, 0, %.9g>]" % (math.acos(cosine) / math.pi, 1 - fresnel(abs(cosine), index)))
    return "pigment { aoi color_map { %s } }" % " ".join(entries)


def fresnel(cosine, index):
    """The reflectance of glass for unpolarised light that comes from air."""
    inside = math.sqrt(1 - (1 - cosine * cosine) / (index * index))
    s = (cosine - index * inside) / (cosine + index * inside)
    p = (index * cosine - inside) / (index * cosine + inside)
    return (s * s + p * p) / 2


def main():
    name, folder = sys.argv[1:3]
    width, height, samples, depth = map(int, sys.argv[3:7])
    scene, path = SCENES[name](), os.path.join(folder, name)
    write_obj(scene, path)
    write_scn(scene, path, (width, height), samples, depth)
    write_pov(scene, path, (width, height), depth)
    print("\n".join(part.name for part in scene.parts))


if __name__ == "__main__":
    main()
