"""Triangles for the scenes that two programs render: made of polygons, or read from .obj and .glb files. Needs numpy."""
import json
import os
import struct

import numpy


class Soup:
    """Triangles by their corners (float32 n x 3 x 3), texture coordinates (n x 3 x 2), and number of material (n)."""

    def __init__(self):
        self.parts = []

    def add(self, corners, material, coordinates=None):
        corners = numpy.asarray(corners, numpy.float32).reshape(-1, 3, 3)
        if coordinates is None:
            coordinates = numpy.zeros((len(corners), 3, 2), numpy.float32)
        number = numpy.broadcast_to(numpy.asarray(material, numpy.int32), len(corners))
        self.parts.append((corners, numpy.asarray(coordinates, numpy.float32).reshape(-1, 3, 2), number))

    def polygon(self, material, *corners):
        self.add([(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)], material)

    def surface(self, material, surface):
        """A Surface of data/tools/mesh.py."""
        for face in surface.faces:
            self.polygon(material, *(surface.positions[i] for i in face))

    def whole(self):
        """Corners, coordinates and materials of all; without triangles that have no area, and each place only once.

        (CornellBox-Original.obj has one face twice. Rays of Cycles that leave the one are stopped by the other.)
        """
        corners, coordinates, material = (numpy.concatenate(column) for column in zip(*self.parts))
        wide = corners.astype(float)
        normal = numpy.cross(wide[:, 1] - wide[:, 0], wide[:, 2] - wide[:, 0])
        kept = numpy.einsum("ij,ij->i", normal, normal) > 0
        number = numpy.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)[1].reshape(-1, 3)
        once = numpy.zeros(len(kept), bool)
        once[numpy.unique(numpy.sort(number, axis=1), axis=0, return_index=True)[1]] = True
        kept &= once
        return corners[kept], coordinates[kept], material[kept]


def read_obj(path):
    """Corners, coordinates or None, number of material of each triangle, and the materials' names."""
    points, places, names, material = [], [], [], 0
    faces, mapped, numbers = [], [], []
    with open(path, encoding="utf-8", errors="replace") as lines:
        for words in map(str.split, lines):
            if not words:
                continue
            if words[0] == "v":
                points.append(tuple(map(float, words[1:4])))
            elif words[0] == "vt":
                places.append(tuple(map(float, words[1:3])))
            elif words[0] == "usemtl":
                name = " ".join(words[1:])
                if name not in names:
                    names.append(name)
                material = names.index(name)
            elif words[0] == "f":
                corners = [_corner(word, len(points), len(places)) for word in words[1:]]
                for i in range(1, len(corners) - 1):
                    three = corners[0], corners[i], corners[i + 1]
                    faces.append([c[0] for c in three])
                    mapped.append([c[1] for c in three])
                    numbers.append(material)
    corners = numpy.array(points, numpy.float32)[numpy.array(faces)]
    coordinates = numpy.array(places + [(0, 0)], numpy.float32)[numpy.array(mapped)] if places else None
    return corners, coordinates, numpy.array(numbers), names or ["default"]


def _corner(word, points, places):
    """Indices of a corner's position and texture coordinates (-1: none), counted from 0."""
    fields = word.split("/")
    index = [int(field) if field else 0 for field in fields[:2]] + [0]
    return (index[0] - 1 if index[0] > 0 else points + index[0],
            -1 if index[1] == 0 else index[1] - 1 if index[1] > 0 else places + index[1])


def read_glb(path):
    """As read_obj, but with the materials as the file has them, each with "image" (bytes of its base colour) or not."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    tree, binary = json.loads(data[20:20 + length]), data[28 + length:]

    def view(number):
        it = tree["bufferViews"][number]
        start = it.get("byteOffset", 0)
        return it, binary[start:start + it["byteLength"]]

    def accessor(number):
        it = tree["accessors"][number]
        kind = {5121: "u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}[it["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[it["type"]]
        layout, raw = view(it["bufferView"])
        size = numpy.dtype(kind).itemsize
        return numpy.ndarray((it["count"], width), kind, raw, it.get("byteOffset", 0),
                             (layout.get("byteStride", size * width), size))

    columns = []
    for node in tree["nodes"]:
        if set(node) & {"matrix", "rotation", "scale", "translation"}:
            raise SystemExit("%s: nodes that are moved are not read" % path)
        for part in tree["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            at = accessor(part["indices"])[:, 0].astype(int)
            has = part["attributes"]
            places = accessor(has["TEXCOORD_0"])[at] * (1, -1) + (0, 1) if "TEXCOORD_0" in has else numpy.zeros((len(at), 2))
            columns.append((accessor(has["POSITION"])[at].reshape(-1, 3, 3), places.reshape(-1, 3, 2),
                            numpy.full(len(at) // 3, part["material"])))
    for material in tree["materials"]:
        texture = material.get("pbrMetallicRoughness", {}).get("baseColorTexture")
        if texture:
            source = tree["textures"][texture["index"]]["source"]
            material["image"] = view(tree["images"][source]["bufferView"])[1]
    corners, coordinates, numbers = (numpy.concatenate(column) for column in zip(*columns))
    return corners, coordinates, numbers, tree["materials"]


def mtl_values(path, key):
    """The numbers or words behind `key` of each material of an .mtl file."""
    values, name = {}, None
    with open(path, encoding="utf-8", errors="replace") as lines:
        for words in map(str.split, lines):
            if words and words[0] == "newmtl":
                name = " ".join(words[1:])
            elif words and words[0] == key:
                values[name] = words[1:]
    return values


def png_channels(path):
    with open(path, "rb") as file:
        return {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[file.read(26)[25]]


def beside(*names):
    return os.path.join(os.path.dirname(os.path.abspath(__file__)), *names)
