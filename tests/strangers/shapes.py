"""Boxes, prisms and lathes in metres, z up, and files of them: OBJ with MTL, binary STL, binary glTF."""
import json
import math
import struct

GREY = (0.6, 0.6, 0.58)
KINDS = {  # name of a material: colour (linear), opacity
    "plaster": ((0.78, 0.76, 0.72), 1.0),
    "tiles": ((0.42, 0.13, 0.08), 1.0),
    "wood": ((0.36, 0.21, 0.1), 1.0),
    "cloth": ((0.2, 0.3, 0.5), 1.0),
    "grass": ((0.13, 0.24, 0.07), 1.0),
    "stone": ((0.4, 0.38, 0.35), 1.0),
    "glass": ((0.85, 0.9, 0.9), 0.2),
    "paint": ((0.5, 0.03, 0.03), 1.0),
    "rubber": ((0.03, 0.03, 0.03), 1.0),
    "leaf": ((0.1, 0.25, 0.04), 1.0),
    "water": ((0.02, 0.1, 0.14), 1.0),
    "heaven": ((0.3, 0.5, 0.85), 1.0),
    "horizon": ((0.7, 0.72, 0.75), 1.0),
    "earth": ((0.2, 0.17, 0.12), 1.0),
    "grey": (GREY, 1.0),
}


class Shape:
    """Faces by part: each a material, vertices and polygons, counter-clockwise seen from the front."""

    def __init__(self):
        self.parts = []
        self.camera = None  # eye and target; with it only glTF
        self.lamp = None  # position

    def part(self, name, material="grey"):
        self.parts.append((name, material, [], []))
        return self

    def _polygon(self, points):
        vertices, faces = self.parts[-1][2:]
        first = len(vertices)
        vertices.extend(points)
        faces.append(tuple(range(first, first + len(points))))

    def face(self, *points):
        self._polygon(points)
        return self

    def box(self, low, high, turn=0.0):
        """Turned about the upright axis through its middle, in degrees."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        mx, my = (x0 + x1) / 2, (y0 + y1) / 2
        corner = [(mx + (x - mx) * c - (y - my) * s, my + (x - mx) * s + (y - my) * c, z)
                  for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        for face in ((3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
            self._polygon([corner[i] for i in face])
        return self

    def lathe(self, profile, sides=24, centre=(0.0, 0.0), axis="z"):
        """(radius, height) from below along the outside; `axis` may be x or y as well."""
        def place(r, h, a):
            p = (centre[0] + r * math.cos(a), centre[1] + r * math.sin(a), h)
            return p if axis == "z" else (p[2], p[0], p[1]) if axis == "x" else (p[1], p[2], p[0])
        for (r0, h0), (r1, h1) in zip(profile, profile[1:]):
            for i in range(sides):
                a, b = 2 * math.pi * i / sides, 2 * math.pi * (i + 1) / sides
                points = [place(r0, h0, a), place(r0, h0, b), place(r1, h1, b), place(r1, h1, a)]
                if r0 == 0:
                    points = [points[0], points[2], points[3]]
                elif r1 == 0:
                    points = points[:3]
                self._polygon(points)
        return self

    def grid(self, size, steps, height, flip=False):
        """A square of `size` about the origin; `height` of (x, y)."""
        def at(i, j):
            x, y = (i / steps - 0.5) * size, (j / steps - 0.5) * size
            return (x, y, height(x, y))
        for i in range(steps):
            for j in range(steps):
                points = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
                self._polygon(points[::-1] if flip else points)
        return self

    def dome(self, radius, sides=32, rings=8, lowest=0.0):
        """Seen from within; from `lowest` (-1 to 0) of the radius to the zenith."""
        start = math.asin(lowest)
        profile = [(radius * math.cos(start + (math.pi / 2 - start) * k / rings),
                    radius * math.sin(start + (math.pi / 2 - start) * k / rings)) for k in range(rings)]
        faces = self.parts[-1][3]
        first = len(faces)
        self.lathe(profile + [(0.0, radius)], sides)
        faces[first:] = [face[::-1] for face in faces[first:]]
        return self

    def moved(self, x=0.0, y=0.0, z=0.0, names=None):
        """All parts, or those."""
        for i, (name, material, vertices, faces) in enumerate(self.parts):
            if names is None or name in names:
                self.parts[i] = (name, material, [(a + x, b + y, c + z) for a, b, c in vertices], faces)
        return self

    def add(self, other):
        self.parts.extend(other.parts)
        return self


def _placed(point, scale, up):
    x, y, z = (scale * c for c in point)
    return (x, y, z) if up == "z" else (x, z, -y)


def write_obj(shape, path, scale=1.0, up="y"):
    """Only colours, as a modeller's exporter with default options writes them."""
    used = sorted({material for _, material, _, _ in shape.parts})
    with open(path.with_suffix(".mtl"), "w") as out:
        for name in used:
            colour, opacity = KINDS[name]
            out.write(f"newmtl {name}\nKd {colour[0]} {colour[1]} {colour[2]}\nd {opacity}\n")
    with open(path, "w") as out:
        out.write(f"mtllib {path.with_suffix('.mtl').name}\n")
        first = 1
        for name, material, vertices, faces in shape.parts:
            out.write(f"o {name}\nusemtl {material}\n")
            for v in vertices:
                out.write("v {:.7g} {:.7g} {:.7g}\n".format(*_placed(v, scale, up)))
            for face in faces:
                out.write("f " + " ".join(str(first + i) for i in face) + "\n")
            first += len(vertices)


def _triangles(part):
    _, _, vertices, faces = part
    for face in faces:
        for k in range(1, len(face) - 1):
            yield vertices[face[0]], vertices[face[k]], vertices[face[k + 1]]


def write_stl(shape, path, scale=1000.0, up="z"):
    triangles = [t for part in shape.parts for t in _triangles(part)]
    with open(path, "wb") as out:
        out.write(b"binary".ljust(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            corners = [c for p in triangle for c in _placed(p, scale, up)]
            out.write(struct.pack("<12fH", 0, 0, 0, *corners, 0))


def _rotation(eye, target):
    """The quaternion that turns -z to the target with y up."""
    def unit(v):
        n = math.sqrt(sum(c * c for c in v))
        return tuple(c / n for c in v)

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    back = unit(tuple(e - t for e, t in zip(eye, target)))
    right = unit(cross((0, 1, 0), back))
    up = cross(back, right)
    m = [[right[i], up[i], back[i]] for i in range(3)]
    w = math.sqrt(max(0.0, 1 + m[0][0] + m[1][1] + m[2][2])) / 2
    if w > 1e-3:
        return [(m[2][1] - m[1][2]) / (4 * w), (m[0][2] - m[2][0]) / (4 * w), (m[1][0] - m[0][1]) / (4 * w), w]
    return [0, 1, 0, 0]


def write_glb(shape, path, scale=1.0, unlit=()):
    """Names of `unlit` get KHR_materials_unlit."""
    names = sorted({material for _, material, _, _ in shape.parts})
    data, views, accessors, meshes, nodes = bytearray(), [], [], [], []
    for part in shape.parts:
        flat, normals = [], []
        for a, b, c in ([_placed(p, scale, "y") for p in t] for t in _triangles(part)):
            u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            size = math.sqrt(sum(c * c for c in n))
            if size == 0:
                continue
            flat += [a, b, c]
            normals += [tuple(c / size for c in n)] * 3
        attributes = {}
        for key, values in (("POSITION", flat), ("NORMAL", normals)):
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": 12 * len(values)})
            data += b"".join(struct.pack("<3f", *v) for v in values)
            accessor = {"bufferView": len(views) - 1, "componentType": 5126, "count": len(values), "type": "VEC3"}
            if key == "POSITION":
                accessor["min"] = [struct.unpack("f", struct.pack("f", min(v[i] for v in values)))[0] for i in range(3)]
                accessor["max"] = [struct.unpack("f", struct.pack("f", max(v[i] for v in values)))[0] for i in range(3)]
            accessors.append(accessor)
            attributes[key] = len(accessors) - 1
        meshes.append({"name": part[0], "primitives": [{"attributes": attributes, "material": names.index(part[1])}]})
        nodes.append({"name": part[0], "mesh": len(meshes) - 1})
    materials = []
    for name in names:
        colour, opacity = KINDS[name]
        entry = {"name": name, "pbrMetallicRoughness": {
            "baseColorFactor": [*colour, opacity], "metallicFactor": 0.0, "roughnessFactor": 0.7}}
        if opacity < 1:
            entry["alphaMode"] = "BLEND"
        if name in unlit:
            entry["extensions"] = {"KHR_materials_unlit": {}}
        materials.append(entry)
    document = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(data)}], "bufferViews": views,
                "accessors": accessors, "meshes": meshes, "materials": materials}
    used = ["KHR_materials_unlit"] if unlit else []
    if shape.camera:
        eye, target = (_placed(p, scale, "y") for p in shape.camera)
        document["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01}}]
        nodes.append({"name": "Camera", "camera": 0, "translation": list(eye), "rotation": _rotation(eye, target)})
    if shape.lamp:
        document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 50}]}}
        used.append("KHR_lights_punctual")
        nodes.append({"name": "Bulb", "translation": list(_placed(shape.lamp, scale, "y")),
                      "extensions": {"KHR_lights_punctual": {"light": 0}}})
    if used:
        document["extensionsUsed"] = used
    document["nodes"] = nodes
    document["scenes"], document["scene"] = [{"nodes": list(range(len(nodes)))}], 0
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    with open(path, "wb") as out:
        out.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data)))
        out.write(struct.pack("<I4s", len(text), b"JSON") + text)
        out.write(struct.pack("<I4s", len(data), b"BIN\0") + data)
