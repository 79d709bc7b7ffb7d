"""The plainest glTF of a scene: one list of triangles for each part, floats, corners where they stand in the world."""
import json
import math
import pathlib
import struct


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _unit(v):
    size = math.sqrt(sum(c * c for c in v))
    return tuple(c / size for c in v) if size > 0 else (0.0, 0.0, 1.0)


def flat_normals(corners):
    """One for each corner of a list of triangles."""
    normals = []
    for k in range(0, len(corners), 3):
        a, b, c = corners[k:k + 3]
        edges = [tuple(q - p for p, q in zip(a, other)) for other in (b, c)]
        normals += [_unit(_cross(*edges))] * 3
    return normals


class PlainPart:
    """Corners of triangles, three by three; `normals` may be None, as may what a corner does not have. The image of the
    emission lies by coordinates of its own."""

    def __init__(self, name, corners, normals, texcoords, colours, material, emission_texcoords=None):
        self.name, self.corners, self.material = name, corners, material
        self.normals = normals or flat_normals(corners)
        self.texcoords, self.colours, self.emission_texcoords = texcoords, colours, emission_texcoords

    def attributes(self):
        lists = [("POSITION", 3, self.corners), ("NORMAL", 3, [_unit(n) for n in self.normals])]
        if self.texcoords:
            lists.append(("TEXCOORD_0", 2, self.texcoords))
        if self.emission_texcoords:
            lists.append(("TEXCOORD_1", 2, self.emission_texcoords))
        if self.colours:
            lists.append(("COLOR_0", 4, self.colours))
        return lists


class PlainMaterial:
    def __init__(self, colour, image=None, sampler=None, unlit=False, cutoff=None):
        self.colour, self.image, self.sampler = colour, image, sampler or {}
        self.unlit, self.cutoff = unlit, cutoff
        self.metallic, self.roughness = 0, 1
        self.emission, self.emission_image, self.emission_sampler = None, None, {}


def write(path, parts):
    """`parts`: PlainPart. Each has a material, a mesh and a node of its own."""
    data = bytearray()
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "bufferViews": [], "accessors": [],
            "meshes": [], "nodes": [], "materials": [], "extensionsUsed": ["KHR_materials_unlit"]}

    def view(content):
        data.extend(b"\0" * (-len(data) % 4))
        root["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(content)})
        data.extend(content)
        return len(root["bufferViews"]) - 1

    def accessor(numbers, components):
        content = b"".join(struct.pack(f"<{components}f", *n) for n in numbers)
        root["accessors"].append({"bufferView": view(content), "componentType": 5126, "count": len(numbers),
                                  "type": {2: "VEC2", 3: "VEC3", 4: "VEC4"}[components]})
        return len(root["accessors"]) - 1

    def texture(image, sampler):
        for name in ("images", "samplers", "textures"):
            root.setdefault(name, [])
        root["images"].append({"bufferView": view(image), "mimeType": "image/png"})
        root["samplers"].append(sampler)
        root["textures"].append({"source": len(root["images"]) - 1, "sampler": len(root["samplers"]) - 1})
        return len(root["textures"]) - 1

    def material(of):
        pbr = {"baseColorFactor": list(of.colour), "metallicFactor": of.metallic, "roughnessFactor": of.roughness}
        entry = {"pbrMetallicRoughness": pbr, "doubleSided": True}
        if of.image is not None:
            pbr["baseColorTexture"] = {"index": texture(of.image, of.sampler)}
        if of.emission is not None:
            entry["emissiveFactor"] = of.emission
            entry["emissiveTexture"] = {"index": texture(of.emission_image, of.emission_sampler), "texCoord": 1}
        if of.unlit:
            entry["extensions"] = {"KHR_materials_unlit": {}}
        if of.cutoff is not None:
            entry["alphaMode"], entry["alphaCutoff"] = "MASK", of.cutoff
        root["materials"].append(entry)
        return len(root["materials"]) - 1

    for part in parts:
        attributes = {name: accessor(numbers, components) for name, components, numbers in part.attributes()}
        root["meshes"].append({"primitives": [{"attributes": attributes, "material": material(part.material)}]})
        root["nodes"].append({"mesh": len(root["meshes"]) - 1, "name": part.name})
        root["scenes"][0]["nodes"].append(len(root["nodes"]) - 1)
    root["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    data.extend(b"\0" * (-len(data) % 4))
    head = struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A)
    pathlib.Path(path).write_bytes(head + text + struct.pack("<II", len(data), 0x004E4942) + data)
