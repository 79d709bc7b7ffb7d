#!/usr/bin/env python3
"""Makes random glTF files that use the format as much as they can, each with a plain one that shows the same.

usage: make_gltf_census.py FOLDER COUNT [FIRST]

Writes FIRST.glb or FIRST.gltf and so on, FIRST.plain.glb and `census.txt`: a line for each with the name of the file
and how many parts are visible. The same bytes each time.
"""
import math
import pathlib
import random
import sys

sys.dont_write_bytecode = True
import gltf_shapes as shapes  # noqa: E402
import plain_glb  # noqa: E402
from gltf_pack import File, png  # noqa: E402


class Mesh:
    """An entry of `meshes` and its primitives: what each shows, in the mesh's own space."""

    def __init__(self):
        self.number, self.primitives, self.weights = None, [], None
        self.scale, self.offset = 1.0, 0.0  # of its nodes: for whole numbers as positions
        self.joints = 0  # that move it

    def to_node(self):
        return shapes.placement(translation=[self.offset] * 3, scale=[self.scale] * 3)


class Shown:
    """A primitive that shows triangles: lists by vertex, moves of its positions by targets, PlainMaterial."""

    def __init__(self, lists, moves, triangles, material):
        self.lists, self.moves, self.triangles, self.material = lists, moves, triangles, material


class Maker:
    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.file = File(self.rng)
        self.parts, self.bones = [], []
        self.materials = []
        self.meshes = [self.mesh() for _ in range(self.rng.randint(1, 3))]

    def chance(self, probability):
        return self.rng.random() < probability

    # --- materials ---

    def image_use(self, stretch):
        """A textureInfo, the image's bytes, its sampler and how coordinates, which are so many times as large as usual,
        go to it: set, 2 x 3 matrix."""
        rng = self.rng
        content = png(rng, rng.choice((4, 8)), rng.choice((4, 8)))
        sampler = {"wrapS": rng.choice((10497, 33071, 33648)), "wrapT": rng.choice((10497, 33071, 33648))}
        if self.chance(0.4):
            sampler["magFilter"] = rng.choice((9728, 9729))
        info = {"index": self.file.texture(content, sampler)}
        own = rng.choice((0, 0, 1))
        if own or self.chance(0.3):
            info["texCoord"] = own
        transform, matrix = None, ((1, 0, 0), (0, 1, 0))
        if stretch != 1 or self.chance(0.5):
            transform, own, matrix = self.transform(own, stretch)
            info["extensions"] = {"KHR_texture_transform": transform}
            self.file.use("KHR_texture_transform")
        return info, content, sampler, (own, matrix)

    def transform(self, own, stretch):
        rng, entry = self.rng, {}
        offset = [rng.uniform(-0.5, 0.5) for _ in range(2)] if self.chance(0.7) else None
        scale = [rng.choice((-1, 1)) * rng.uniform(0.4, 2.5) for _ in range(2)] if self.chance(0.7) else None
        if stretch != 1:
            scale = [c / stretch for c in scale or (1, 1)]
        rotation = rng.uniform(-3, 3) if self.chance(0.5) else None
        for name, value in (("offset", offset), ("scale", scale), ("rotation", rotation)):
            if value is not None:
                entry[name] = value
        if self.chance(0.3):
            own = entry["texCoord"] = 1 - own
        (ox, oy), (sx, sy), a = offset or (0, 0), scale or (1, 1), rotation or 0
        c, s = math.cos(a), math.sin(a)
        return entry, own, ((c * sx, s * sy, ox), (-s * sx, c * sy, oy))

    def material(self, stretch):
        """Its number (None: the format's own), what it looks like, and how its images lie: base colour, emission."""
        rng = self.rng
        if self.chance(0.05):
            look = plain_glb.PlainMaterial((1, 1, 1, 1))
            look.metallic = 1
            return None, look, (None, None)
        pbr, entry, place, shines = {"metallicFactor": 0, "roughnessFactor": rng.choice((1, 0.8))}, {}, None, None
        colour = (1, 1, 1, 1)
        if self.chance(0.8):
            colour = tuple(rng.uniform(0.2, 1) for _ in range(4))
            pbr["baseColorFactor"] = list(colour)
        look = plain_glb.PlainMaterial(colour)
        look.roughness = pbr["roughnessFactor"]
        if self.chance(0.6):
            pbr["baseColorTexture"], look.image, look.sampler, place = self.image_use(stretch)
        if self.chance(0.2):
            look.unlit = True
            entry["extensions"] = {"KHR_materials_unlit": {}}
            self.file.use("KHR_materials_unlit")
        elif self.chance(0.3):
            look.emission = entry["emissiveFactor"] = [rng.uniform(0.2, 1) for _ in range(3)]
            entry["emissiveTexture"], look.emission_image, look.emission_sampler, shines = self.image_use(stretch)
        if self.chance(0.3):
            look.cutoff = rng.uniform(0.1, 0.9)
            entry.update(alphaMode="MASK", alphaCutoff=look.cutoff)
            if self.chance(0.2):
                look.cutoff = 0.5
                del entry["alphaCutoff"]
            alpha = colour[3] * 0.5 / look.cutoff
            if alpha <= 1:  # the same holes by the usual cutoff
                look.colour, look.cutoff = (*colour[:3], alpha), 0.5
        elif self.chance(0.2):
            entry["alphaMode"] = "OPAQUE"
        if self.chance(0.7):
            entry["doubleSided"] = True
        if self.chance(0.7):
            entry["name"] = rng.choice(("red", "Wände", "a/b", ""))
        entry["pbrMetallicRoughness"] = pbr
        return self.file.add("materials", entry), look, (place, shines)

    # --- meshes ---

    def surface(self):
        rng = self.rng
        kind = rng.randint(0, 4)
        if kind == 0:
            return shapes.ball(rng.randint(3, 9), rng.randint(3, 14))
        if kind == 1:
            return shapes.hill(rng.randint(1, 6), rng.uniform(-0.5, 0.5))
        if kind == 2:
            return shapes.box(*(rng.uniform(0.3, 1) for _ in range(3)))
        return shapes.ribbon(rng.randint(1, 12)) if kind == 3 else shapes.disc(rng.randint(3, 16))

    def mesh(self):
        mesh = Mesh()
        mesh.scale, mesh.offset = self.rng.choice(((1.0, 0.0), (1.0, 0.0), (0.01, 0.0), (2.0, -1.0), (0.008, -1.0)))
        entry = {"primitives": []}
        if self.chance(0.2):
            mesh.weights = self.weights(self.rng.randint(1, 2))
        if self.chance(0.2):
            mesh.joints = self.rng.randint(1, 4)
        for _ in range(self.rng.choice((1, 1, 2, 3))):
            self.primitives(mesh, entry["primitives"])
        if mesh.weights:
            entry["weights"] = mesh.weights
        if self.chance(0.5):
            entry["name"] = self.rng.choice(("Mesh", "Körper 1", "x/y"))
        mesh.number = self.file.add("meshes", entry)
        return mesh

    def weights(self, count):
        return [self.rng.choice((0, 0.5, 1, -0.3)) for _ in range(count)]

    def primitives(self, mesh, entries):
        """One surface, of one material or cut into several that share their vertices."""
        rng, s = self.rng, self.surface()
        wanted = {"POSITION": [tuple((c - mesh.offset) / mesh.scale for c in p) for p in s.positions]}
        if self.chance(0.7):
            wanted["NORMAL"] = s.normals
        stretch = rng.choice((1, 1, 1, 1, 4095))
        for k in range(2):
            wanted[f"TEXCOORD_{k}"] = [tuple(c * stretch for c in uv) for uv in s.sets[k]]
        if self.chance(0.4):
            components = rng.choice((3, 4))
            wanted["COLOR_0"] = [tuple(rng.uniform(0.2, 1) for _ in range(components)) for _ in s.positions]
        if mesh.joints:
            self.bind(wanted, mesh.joints)
        indices = s.indices
        if self.chance(0.2):  # without a list of corners
            wanted = {name: [values[i] for i in indices] for name, values in wanted.items()}
            indices = list(range(len(indices)))
        attributes, lists = self.file.attributes(wanted)
        targets, moves = self.targets(lists, mesh.weights or [])
        cuts = [indices]
        if s.mode == shapes.TRIANGLES and len(indices) >= 12 and self.chance(0.3):
            at = rng.randint(1, len(indices) // 3 - 1) * 3
            cuts = [indices[:at], indices[at:]]
        for cut in cuts:
            number, look, places = self.material(stretch)
            entry = {"attributes": attributes}
            if number is not None:
                entry["material"] = number
            if cut != list(range(len(lists["POSITION"]))) or self.chance(0.3):
                entry["indices"] = self.file.indices(cut)
            if s.mode != shapes.TRIANGLES or self.chance(0.3):
                entry["mode"] = s.mode
            if targets:
                entry["targets"] = targets
            entries.append(entry)
            mesh.primitives.append(self.shown(lists, moves, shapes.triangles_of(s.mode, cut), look, places))
        if self.chance(0.1):
            entries.append({"attributes": attributes, "mode": rng.randint(0, 3)})

    def bind(self, wanted, joints):
        """Each vertex to up to four of them."""
        rng = self.rng
        count = len(wanted["POSITION"])
        wanted["JOINTS_0"] = [tuple(rng.randrange(joints) for _ in range(4)) for _ in range(count)]
        wanted["WEIGHTS_0"] = []
        for _ in range(count):
            weights = [rng.random() if k == 0 or self.chance(0.5) else 0.0 for k in range(4)]
            wanted["WEIGHTS_0"].append(tuple(w / sum(weights) for w in weights))

    def targets(self, lists, weights):
        """The entries, and by attribute how they move each vertex."""
        entries, moves = [], []
        reach = {"POSITION": 0.2 * max(abs(c) for p in lists["POSITION"] for c in p), "NORMAL": 0.3}
        names = [name for name in reach if name in lists]
        for _ in weights:
            entry, move = {}, {}
            for name in names:
                if name == "POSITION" or self.chance(0.5):
                    deltas = [[self.rng.uniform(-reach[name], reach[name]) for _ in range(3)] for _ in lists[name]]
                    entry[name], move[name] = self.file.floats(deltas)
            entries.append(entry)
            moves.append(move)
        return entries, moves

    def shown(self, lists, moves, triangles, look, places):
        own = dict(lists)
        for name, place in zip(("UV", "EMISSION_UV"), places):
            if place is None:
                continue
            chosen, (mu, mv) = place
            uv = lists["TEXCOORD_1" if chosen else "TEXCOORD_0"]
            own[name] = [(mu[0] * u + mu[1] * v + mu[2], mv[0] * u + mv[1] * v + mv[2]) for u, v in uv]
        return Shown(own, moves, triangles, look)

    # --- nodes ---

    def local(self, node):
        rng = self.rng
        t = [rng.uniform(-1.5, 1.5) for _ in range(3)] if self.chance(0.7) else None
        r = [rng.gauss(0, 1) for _ in range(4)] if self.chance(0.5) else None
        s = None
        if self.chance(0.5):
            s = [rng.choice((-1, 1, 1)) * rng.uniform(0.6, 1.5) for _ in range(3)]
        if r is not None:
            size = sum(c * c for c in r) ** 0.5
            r = [c / size for c in r]
        m = shapes.placement(t or (0, 0, 0), r or (0, 0, 0, 1), s or (1, 1, 1))
        if self.chance(0.4):
            node["matrix"] = [m[row][column] for column in range(4) for row in range(4)]
        else:
            node.update({name: v for name, v in (("translation", t), ("rotation", r), ("scale", s)) if v is not None})
        return m

    def instances(self, node):
        """The matrices of many; None: it stands there once."""
        if not self.chance(0.15):
            return None
        count, rng = self.rng.randint(1, 4), self.rng
        lists, stated = {}, {}
        for name, low, high in (("TRANSLATION", -2, 2), ("SCALE", 0.5, 1.3)):
            numbers = [[rng.uniform(low, high) for _ in range(3)] for _ in range(count)]
            if name == "TRANSLATION" or self.chance(0.6):
                stated[name], lists[name] = self.file.floats(numbers)
        if self.chance(0.6):
            turns = [[rng.gauss(0, 1) for _ in range(4)] for _ in range(count)]
            turns = [[c / sum(x * x for x in q) ** 0.5 for c in q] for q in turns]
            stated["ROTATION"], lists["ROTATION"] = self.file.rotations(turns)
        node["extensions"] = {**node.get("extensions", {}), "EXT_mesh_gpu_instancing": {"attributes": stated}}
        self.file.use("EXT_mesh_gpu_instancing", required=True)
        at = lambda name, k, otherwise: lists[name][k] if name in lists else otherwise  # noqa: E731
        return [shapes.placement(at("TRANSLATION", k, (0, 0, 0)), at("ROTATION", k, (0, 0, 0, 1)), at("SCALE", k, (1, 1, 1)))
                for k in range(count)]

    def node(self, above, visible, depth):
        """Its number; adds what it shows to the parts."""
        node = {}
        m = shapes.times(above, self.local(node))
        if self.chance(0.5):
            node["name"] = self.rng.choice(("Node", "Tür", "a/b", "Node.001"))
        if self.chance(0.1):
            hidden = self.chance(0.7)
            node["extensions"] = {"KHR_node_visibility": {"visible": not hidden}}
            self.file.use("KHR_node_visibility")
            visible = visible and not hidden
        children = []
        if depth == 0 or self.chance(0.4):
            children.append(self.leaf(m, visible))
        for _ in range(self.rng.randint(1, 2) if depth > 0 else 0):
            children.append(self.node(m, visible, depth - 1))
        if children:
            node["children"] = children
        return self.file.add("nodes", node)

    def leaf(self, above, visible):
        mesh = self.rng.choice(self.meshes)
        node = {"mesh": mesh.number}
        if (mesh.scale, mesh.offset) != (1, 0):
            node["scale"], node["translation"] = [mesh.scale] * 3, [mesh.offset] * 3
        m = shapes.times(above, mesh.to_node())
        weights = mesh.weights
        if weights and self.chance(0.5):
            weights = node["weights"] = self.weights(len(weights))
        if mesh.joints and self.chance(0.8):
            node["skin"], joints = self.skin(mesh)
            for shown in mesh.primitives if visible else ():
                self.show(shown, weights or [], self.pose(shown, joints))
            return self.file.add("nodes", node)
        instances = self.instances(node)
        for place in instances if instances is not None else [shapes.IDENTITY]:
            for shown in mesh.primitives if visible else ():
                self.show(shown, weights or [], [shapes.times(m, place)] * len(shown.lists["POSITION"]))
        return self.file.add("nodes", node)

    def skeleton(self):
        """A chain of nodes, made once: their numbers and where they stand."""
        if not self.bones:
            nodes, above = [], shapes.IDENTITY
            for _ in range(4):
                nodes.append({})
                above = shapes.times(above, self.local(nodes[-1]))
                self.bones.append([self.file.add("nodes", nodes[-1]), above])
            for node, (child, _) in zip(nodes, self.bones[1:]):
                node["children"] = [child]
        return self.bones

    def skin(self, mesh):
        """Its number, and where each joint moves the mesh."""
        bones = self.rng.sample(self.skeleton(), mesh.joints)
        binds = []
        for _, world in bones:
            turn = [self.rng.gauss(0, 0.3) for _ in range(3)] + [1]
            away = shapes.placement([self.rng.uniform(-1, 1) for _ in range(3)], turn, [self.rng.uniform(0.8, 1.2)] * 3)
            m = shapes.times(shapes.inverse(world), shapes.times(away, mesh.to_node()))
            binds.append([m[row][column] for column in range(4) for row in range(4)])
        number, kept = self.file.matrices(binds)
        skin = {"joints": [node for node, _ in bones], "inverseBindMatrices": number}
        joints = [shapes.times(world, [[bind[4 * column + row] for column in range(4)] for row in range(4)])
                  for (_, world), bind in zip(bones, kept)]
        return self.file.add("skins", skin), joints

    def pose(self, shown, joints):
        """The matrix of each vertex."""
        return [shapes.mixed([joints[int(k)] for k in numbers], [w / sum(weights) for w in weights])
                for numbers, weights in zip(shown.lists["JOINTS_0"], shown.lists["WEIGHTS_0"])]

    def show(self, shown, weights, matrices):
        """`matrices`: one for each vertex."""
        side = 1 if shapes.determinant(matrices[shown.triangles[0][0]]) > 0 else -1
        order = [i for a, b, c in shown.triangles for i in ((a, b, c) if side > 0 else (a, c, b))]
        moved = {name: shown.lists.get(name, []) for name in ("POSITION", "NORMAL")}
        for weight, move in zip(weights, shown.moves):
            for name, deltas in move.items():
                moved[name] = [tuple(a + weight * b for a, b in zip(v, d)) for v, d in zip(moved[name], deltas)]
        place = [shapes.point(m, p) for m, p in zip(matrices, moved["POSITION"])]
        normals = [tuple(side * sum(row[k] * n[k] for k in range(3)) for row in shapes.cofactors(m))
                   for m, n in zip(matrices, moved["NORMAL"])]
        pick = lambda values: [values[i] for i in order] if values else None  # noqa: E731
        colours = [(*c, 1.0)[:4] for c in shown.lists.get("COLOR_0", [])]
        self.parts.append(plain_glb.PlainPart(f"part{len(self.parts)}", pick(place), pick(normals),
                                              pick(shown.lists.get("UV")), pick(colours), shown.material,
                                              pick(shown.lists.get("EMISSION_UV"))))

    def scenes(self):
        """The shown one among others."""
        shown = [self.node(shapes.IDENTITY, True, self.rng.randint(0, 3)) for _ in range(self.rng.randint(1, 3))]
        kept, self.parts = self.parts, []
        others = [[self.node(shapes.IDENTITY, True, 0)] for _ in range(self.rng.choice((0, 0, 1, 2)))]
        self.parts = kept
        if self.bones:
            shown.append(self.bones[0][0])
        if not others and self.chance(0.15):
            return  # all nodes that are no children
        number = self.rng.randint(0, len(others))
        lists = others[:number] + [shown] + others[number:]
        self.file.root["scenes"] = [{"nodes": roots} for roots in lists]
        if number or self.chance(0.5):
            self.file.root["scene"] = number


def make(folder, number):
    """The name of the file, and how many parts it shows; nothing where it shows none."""
    maker = Maker(number)
    maker.scenes()
    if not maker.parts:
        return None
    plain_glb.write(folder / f"{number}.plain.glb", maker.parts)
    return maker.file.write(folder, str(number)), len(maker.parts)


def main():
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__.strip())
    folder, first = pathlib.Path(sys.argv[1]), int(sys.argv[3]) if len(sys.argv) == 4 else 1
    folder.mkdir(parents=True, exist_ok=True)
    made, number, lines = 0, first, []
    while made < int(sys.argv[2]):
        result = make(folder, number)
        number += 1
        if result is not None:
            made += 1
            lines.append("{} {}".format(*result))
    (folder / "census.txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
