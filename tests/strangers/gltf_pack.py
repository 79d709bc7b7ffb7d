"""Numbers, images and buffers of a glTF file, packed in as many ways as the format knows."""
import base64
import json
import pathlib
import struct
import urllib.parse
import zlib

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
CODES = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f"}
RANGES = {BYTE: (-127, 127), UBYTE: (0, 255), SHORT: (-32767, 32767), USHORT: (0, 65535)}
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def png(rng, width, height):
    """Of a few colours and alphas, in fields of four texels each."""
    fields = {}
    rows = b""
    for y in range(height * 2):
        rows += b"\0"
        for x in range(width * 2):
            at = (x // 2, y // 2)
            if at not in fields:
                fields[at] = bytes(rng.choice((30, 120, 200, 255)) for _ in range(3)) + bytes([rng.choice((0, 128, 255, 255))])
            rows += fields[at]

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    head = struct.pack(">IIBBBBB", width * 2, height * 2, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


class Packing:
    """How numbers of one list are stored."""

    def __init__(self, component=FLOAT, normalized=False):
        self.component, self.normalized = component, normalized

    def pack(self, element):
        return struct.pack(f"<{len(element)}{CODES[self.component]}", *self.codes(element))

    def codes(self, element):
        if self.component == FLOAT:
            return element
        low, high = RANGES[self.component]
        return [min(max(round(c * high if self.normalized else c), low), high) for c in element]

    def rounded(self, element):
        """As it is stored."""
        return struct.unpack(f"<{len(element)}{CODES[self.component]}", self.pack(element))

    def meaning(self, element):
        """What is left of it."""
        if self.component == FLOAT:
            return self.rounded(element)
        return tuple(c / RANGES[self.component][1] if self.normalized else float(c) for c in self.codes(element))

    def size(self, components):
        return components * struct.calcsize(CODES[self.component])


def packings(name, elements):
    """Those that the format allows for the attribute, and that lose little of it."""
    low, high = min(min(e) for e in elements), max(max(e) for e in elements)
    unsigned = [Packing(UBYTE, True), Packing(USHORT, True)] if low >= 0 and high <= 1 else []
    signed = [Packing(BYTE, True), Packing(SHORT, True)] if low >= -1 and high <= 1 else []
    if name.startswith("TEXCOORD"):
        if high > 50:
            return [Packing(USHORT), Packing(SHORT)]
        return unsigned + [Packing(SHORT, True)] if signed else unsigned
    if name in ("COLOR_0", "WEIGHTS_0"):
        return unsigned
    if name == "JOINTS_0":
        return [Packing(UBYTE), Packing(USHORT)]
    if name == "POSITION" and high - low > 50:
        unsigned = [Packing(UBYTE), Packing(USHORT)] if low >= 0 and high <= 255 else []
        signed = [Packing(BYTE), Packing(SHORT)] if low >= -127 and high <= 127 else []
    return unsigned + signed if name in ("POSITION", "NORMAL") else []


class File:
    def __init__(self, rng):
        self.rng, self.root = rng, {"asset": {"version": "2.0", "generator": "make_gltf_census.py"}}
        self.buffers, self.images = [bytearray()], []
        if rng.random() < 0.3:
            self.buffers.append(bytearray())
        self.used, self.required = set(), set()

    def use(self, name, required=False):
        self.used.add(name)
        if required:
            self.required.add(name)

    def add(self, name, entry):
        self.root.setdefault(name, []).append(entry)
        return len(self.root[name]) - 1

    # --- buffers ---

    def view(self, content, stride=None, before=0):
        """`before`: bytes that belong to nothing."""
        number = self.rng.randrange(len(self.buffers))
        to = self.buffers[number]
        to.extend(b"\xAB" * (-len(to) % 4))
        entry = {"buffer": number, "byteOffset": len(to), "byteLength": before + len(content)}
        if stride:
            entry["byteStride"] = stride
        if entry["byteOffset"] == 0 and self.rng.random() < 0.5:
            del entry["byteOffset"]
        to.extend(b"\xCD" * before + content)
        return self.add("bufferViews", entry)

    def accessor(self, count, components, packing, view=None, offset=0):
        entry = {"componentType": packing.component, "count": count, "type": TYPES[components]}
        if packing.normalized:
            entry["normalized"] = True
        if view is not None:
            entry["bufferView"] = view
        if offset or self.rng.random() < 0.2:
            entry["byteOffset"] = offset
        if view is None:
            entry.pop("byteOffset", None)
        return self.add("accessors", entry)

    def tight(self, elements, packing):
        """Elements behind each other, each of which begins at a multiple of four."""
        size = packing.size(len(elements[0]))
        stride = size + -size % 4
        before = self.rng.choice((0, 0, 4, 20))
        content = b"".join(packing.pack(e).ljust(stride, b"\xEE") for e in elements)
        if self.rng.random() < 0.3:
            content = content[:len(content) - (stride - size)]  # the last one ends where the view does
        view = self.view(content, stride if stride != size or self.rng.random() < 0.3 else None, before)
        return self.accessor(len(elements), len(elements[0]), packing, view, before)

    def sparse(self, elements, packing):
        """Zeros, or other numbers, that are replaced."""
        rng, count, components = self.rng, len(elements), len(elements[0])
        zero = (0.0,) * components
        replaced = [i for i in range(count) if rng.random() < 0.5] or [0]
        if rng.random() < 0.5:
            replaced = [i for i in range(count) if packing.meaning(elements[i]) != zero] or [0]
            number = self.accessor(count, components, packing)
        else:
            chosen = set(replaced)
            other = packing.meaning((1.0,) * components)
            number = self.tight([other if i in chosen else e for i, e in enumerate(elements)], packing)
        kinds = [k for k in (UBYTE, USHORT, UINT) if count <= 256 or k != UBYTE]
        kind = rng.choice(kinds)
        where = self.view(struct.pack(f"<{len(replaced)}{CODES[kind]}", *replaced))
        what = self.view(b"".join(packing.pack(elements[i]) for i in replaced))
        self.root["accessors"][number]["sparse"] = {
            "count": len(replaced), "indices": {"bufferView": where, "componentType": kind}, "values": {"bufferView": what}}
        return number

    # --- lists ---

    def stored(self, elements, packing):
        return (self.sparse if self.rng.random() < 0.2 else self.tight)(elements, packing)

    def floats(self, elements):
        packing = Packing()
        return self.stored([tuple(e) for e in elements], packing), [packing.meaning(e) for e in elements]

    def matrices(self, elements):
        packing = Packing()
        return self.tight(elements, packing), [packing.meaning(e) for e in elements]

    def rotations(self, elements):
        packing = self.rng.choice((Packing(), Packing(SHORT, True), Packing(BYTE, True)))
        return self.tight(elements, packing), [packing.meaning(e) for e in elements]

    def indices(self, numbers):
        kinds = [k for k, high in ((UBYTE, 255), (USHORT, 65535), (UINT, 1 << 32)) if max(numbers) < high]
        kind = self.rng.choice(kinds)
        before = self.rng.choice((0, 0, 4))
        content = struct.pack(f"<{len(numbers)}{CODES[kind]}", *numbers)
        return self.accessor(len(numbers), 1, Packing(kind), self.view(content, None, before), before)

    def packing(self, name, elements):
        choices = packings(name, elements)
        if name != "JOINTS_0" and (not choices or self.rng.random() < 0.5):
            return Packing()
        packing = self.rng.choice(choices)
        core = name in ("COLOR_0", "WEIGHTS_0", "JOINTS_0") or (
            name.startswith("TEXCOORD") and packing.normalized and packing.component in (UBYTE, USHORT))
        if not core:
            self.use("KHR_mesh_quantization", required=True)
        return packing

    def attributes(self, wanted):
        """By name the number of the accessor, and what its elements mean."""
        chosen = {name: self.packing(name, elements) for name, elements in wanted.items()}
        meaning = {name: [chosen[name].meaning(e) for e in elements] for name, elements in wanted.items()}
        if self.rng.random() < 0.35:
            numbers = self.interleaved(wanted, chosen)
        else:
            numbers = {name: self.stored(elements, chosen[name]) for name, elements in wanted.items()}
        self.bound(numbers["POSITION"], [chosen["POSITION"].rounded(e) for e in wanted["POSITION"]])
        return numbers, meaning

    def bound(self, accessor, elements):
        """Which the format demands of positions."""
        for name, of in (("min", min), ("max", max)):
            self.root["accessors"][accessor][name] = [of(column) for column in zip(*elements)]

    def interleaved(self, wanted, chosen):
        names = list(wanted)
        self.rng.shuffle(names)
        offsets, stride = {}, 0
        for name in names:
            offsets[name] = stride
            size = chosen[name].size(len(wanted[name][0]))
            stride += size + -size % 4
        stride += self.rng.choice((0, 0, 8))
        count = len(wanted["POSITION"])
        content = bytearray(b"\xBB" * (stride * count))
        for name in names:
            for i, element in enumerate(wanted[name]):
                packed = chosen[name].pack(element)
                at = stride * i + offsets[name]
                content[at:at + len(packed)] = packed
        view = self.view(bytes(content), stride)
        return {name: self.accessor(count, len(wanted[name][0]), chosen[name], view, offsets[name]) for name in wanted}

    # --- images and files ---

    def texture(self, content, sampler):
        entry, way = {}, self.rng.randrange(3)
        if way == 0:
            entry["uri"] = "data:image/png;base64," + base64.b64encode(content).decode()
        elif way == 1:
            entry["bufferView"], entry["mimeType"] = self.view(content), "image/png"
        else:
            entry["uri"] = None
            self.images.append((len(self.root.get("images", [])), content))
        texture = {"source": self.add("images", entry)}
        if sampler != {"wrapS": 10497, "wrapT": 10497} or self.rng.random() < 0.5:
            texture["sampler"] = self.add("samplers", sampler)
        return self.add("textures", texture)

    def beside(self, folder, name, content):
        """Writes it there, and returns its URI."""
        (folder / name).write_bytes(content)
        return urllib.parse.quote(name, safe="/()")

    def write(self, folder, name):
        """Returns the name of the file."""
        binary = self.rng.random() < 0.5
        for number, content in self.images:
            file = self.rng.choice(("{}-{}.png", "{} image {}.png", "{}-Ärger#{}.png")).format(name, number)
            self.root["images"][number]["uri"] = self.beside(folder, file, content)
        entries = []
        for k, content in enumerate(self.buffers):
            entry = {"byteLength": len(content)}
            if binary and k == 0:
                pass
            elif self.rng.random() < 0.5:
                kind = self.rng.choice(("octet-stream", "gltf-buffer"))
                entry["uri"] = f"data:application/{kind};base64," + base64.b64encode(content).decode()
            else:
                file = self.rng.choice(("{}-{}.bin", "{} my buffer {}.bin", "{}-é%{}.bin")).format(name, k)
                entry["uri"] = self.beside(folder, file, content)
            entries.append(entry)
        self.root["buffers"] = entries
        if self.used:
            self.root["extensionsUsed"] = sorted(self.used)
        if self.required:
            self.root["extensionsRequired"] = sorted(self.required)
        path = pathlib.Path(folder) / (name + (".glb" if binary else ".gltf"))
        if binary:
            path.write_bytes(self.chunks())
        else:
            path.write_text(json.dumps(self.root, indent=self.rng.choice((None, 2)), ensure_ascii=self.rng.random() < 0.5),
                            encoding="utf-8")
        return path.name

    def chunks(self):
        """Of lengths that are multiples of four, as they must be, or not."""
        odd = self.rng.random() < 0.3
        text = json.dumps(self.root).encode()
        text += b" " * (self.rng.randint(0, 3) if odd else -len(text) % 4)
        content = bytes(self.buffers[0])
        content += b"\0" * (0 if odd else -len(content) % 4)
        head = struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(content), len(text), 0x4E4F534A)
        return head + text + struct.pack("<II", len(content), 0x004E4942) + content
