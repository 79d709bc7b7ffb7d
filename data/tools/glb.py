"""Writes binary glTF 2.0: meshes, materials, embedded PNG textures, lights, cameras."""
import json
import struct
from array import array

from pictures import save

FLOAT, UINT32 = 5126, 5125
ARRAY_BUFFER, ELEMENT_BUFFER = 34962, 34963


class Model:
    """Collects meshes by material; each material becomes one mesh of the file."""

    def __init__(self):
        self._materials = {}
        self._meshes = {}
        self._images = []
        self._lights = []
        self._cameras = []
        self._extensions = set()
        self.triangles = 0

    def texture(self, png):
        """Embeds a PNG file's bytes, returns the number for material(..., texture=)."""
        self._images.append(png)
        return len(self._images) - 1

    def material(self, name, colour=(0.8, 0.8, 0.8), metallic=0.0, roughness=0.8, alpha=1.0, emissive=None,
                 texture=None, mode=None, cutoff=0.5, double_sided=False, ior=None, transmission=None):
        """Colours are linear; `mode` is OPAQUE, MASK or BLEND (default by alpha)."""
        surface = {"baseColorFactor": [*colour, alpha], "metallicFactor": metallic,
                   "roughnessFactor": roughness}
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
        entry = {"name": name, "pbrMetallicRoughness": surface}
        mode = mode or ("BLEND" if alpha < 1 else "OPAQUE")
        if mode != "OPAQUE":
            entry["alphaMode"] = mode
        if mode == "MASK":
            entry["alphaCutoff"] = cutoff
        if emissive:
            entry["emissiveFactor"] = [min(1.0, e) for e in emissive]
        if double_sided:
            entry["doubleSided"] = True
        if ior is not None:
            self._extend(entry, "KHR_materials_ior", {"ior": ior})
        if transmission is not None:
            self._extend(entry, "KHR_materials_transmission", {"transmissionFactor": transmission})
        self._materials[name] = entry
        self._meshes[name] = []
        return name

    def _extend(self, entry, name, value):
        entry.setdefault("extensions", {})[name] = value
        self._extensions.add(name)

    def add(self, mesh, material):
        self._meshes[material].append(mesh)
        self.triangles += len(mesh.faces)

    def light(self, name, kind, colour, intensity, position=(0, 0, 0), rotation=(0, 0, 0, 1), spot=None):
        """kind: point, spot, directional; shines along -z turned by the quaternion; spot = (inner, outer)."""
        entry = {"name": name, "type": kind, "color": list(colour), "intensity": intensity}
        if spot:
            entry["spot"] = {"innerConeAngle": spot[0], "outerConeAngle": spot[1]}
        self._lights.append((entry, position, rotation))

    def camera(self, name, eye, rotation, vertical_fov, aspect):
        """Looks along -z turned by the quaternion; the angle in radians."""
        entry = {"name": name, "type": "perspective",
                 "perspective": {"yfov": vertical_fov, "aspectRatio": aspect, "znear": 0.01}}
        self._cameras.append((entry, eye, rotation))

    def write(self, path):
        document, data = self._document()
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        data += b"\0" * (-len(data) % 4)
        header = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data))
        save(path, [header, struct.pack("<I4s", len(text), b"JSON"), text,
                    struct.pack("<I4s", len(data), b"BIN\0"), data])

    def _document(self):
        used = [name for name in self._materials if self._meshes[name]]
        writer = _Buffer()
        document = {"asset": {"version": "2.0", "generator": "data/tools/glb.py"}, "scene": 0, "nodes": []}
        document["materials"] = [self._materials[name] for name in used]
        document["meshes"] = [{"name": name, "primitives": [_primitive(writer, self._meshes[name], index)]}
                              for index, name in enumerate(used)]
        document["nodes"] = [{"name": name, "mesh": index} for index, name in enumerate(used)]
        self._add_images(document, writer)
        self._add_lights(document)
        self._add_cameras(document)
        if self._extensions:
            document["extensionsUsed"] = sorted(self._extensions)
        document["scenes"] = [{"nodes": list(range(len(document["nodes"])))}]
        document["accessors"], document["bufferViews"] = writer.accessors, writer.views
        document["buffers"] = [{"byteLength": len(writer.data) + (-len(writer.data) % 4)}]
        return document, writer.data

    def _add_images(self, document, writer):
        if self._images:
            document["images"] = [{"bufferView": writer.view(png), "mimeType": "image/png"}
                                  for png in self._images]
            document["samplers"] = [{"magFilter": 9729, "minFilter": 9729, "wrapS": 10497, "wrapT": 10497}]
            document["textures"] = [{"source": i, "sampler": 0} for i in range(len(self._images))]

    def _add_lights(self, document):
        if not self._lights:
            return
        self._extensions.add("KHR_lights_punctual")
        document["extensions"] = {"KHR_lights_punctual": {"lights": [entry for entry, _, _ in self._lights]}}
        for index, (entry, position, rotation) in enumerate(self._lights):
            document["nodes"].append({"name": entry["name"], "translation": list(position),
                                      "rotation": list(rotation),
                                      "extensions": {"KHR_lights_punctual": {"light": index}}})

    def _add_cameras(self, document):
        if self._cameras:
            document["cameras"] = [entry for entry, _, _ in self._cameras]
        for index, (entry, eye, rotation) in enumerate(self._cameras):
            document["nodes"].append({"name": entry["name"], "camera": index, "translation": list(eye),
                                      "rotation": list(rotation)})


class _Buffer:
    """The binary chunk with its views and accessors."""

    def __init__(self):
        self.data = bytearray()
        self.views = []
        self.accessors = []

    def view(self, data, target=None):
        self.data += b"\0" * (-len(self.data) % 4)
        entry = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
        if target:
            entry["target"] = target
        self.data += data
        self.views.append(entry)
        return len(self.views) - 1

    def accessor(self, values, kind, width, bounds=False):
        integer = kind == UINT32
        numbers = array("I" if integer else "f", values)
        entry = {"bufferView": self.view(numbers.tobytes(), ELEMENT_BUFFER if integer else ARRAY_BUFFER),
                 "componentType": kind, "count": len(numbers) // width,
                 "type": {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}[width]}
        if bounds:
            entry["min"] = [min(numbers[i::width]) for i in range(width)]
            entry["max"] = [max(numbers[i::width]) for i in range(width)]
        self.accessors.append(entry)
        return len(self.accessors) - 1


def _primitive(writer, meshes, material):
    """One primitive of all meshes; either all of them have texture coordinates (or colours), or none."""
    positions, normals, uvs, colours, indices = [], [], [], [], []
    first = 0
    for mesh in meshes:
        for p in mesh.positions:
            positions += p
        for n in mesh.normals:
            normals += n
        for u, v in mesh.uvs or ():
            uvs += (u, 1 - v)              # glTF counts rows from the top
        for c in mesh.colours or ():
            colours += c
        for a, b, c in mesh.faces:
            indices += (a + first, b + first, c + first)
        first += len(mesh.positions)
    for name, values, width in (("texcoords", uvs, 2), ("colours", colours, 3)):
        if values and len(values) != first * width:
            raise ValueError(f"some meshes of a material have {name}, some have none")
    attributes = {"POSITION": writer.accessor(positions, FLOAT, 3, bounds=True),
                  "NORMAL": writer.accessor(normals, FLOAT, 3)}
    if uvs:
        attributes["TEXCOORD_0"] = writer.accessor(uvs, FLOAT, 2)
    if colours:
        attributes["COLOR_0"] = writer.accessor(colours, FLOAT, 3)
    return {"attributes": attributes, "indices": writer.accessor(indices, UINT32, 1), "material": material}
