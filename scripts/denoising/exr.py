"""Reads the OpenEXR files that the Renderer writes: rows of 32-bit floats, compressed by ZIP in blocks of 16."""
import struct
import zlib

import numpy

ROWS = 16   # of a block
FLOAT, ZIP = 2, 3


class Exr:
    """The channels by name, height x width each, top row first, and the texts in the file."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        self.at, self.texts, self.names, self.size = 8, {}, [], None
        if self.data[:4] != b"\x76\x2f\x31\x01":
            raise SystemExit("%s: no OpenEXR file" % path)
        while self.data[self.at]:
            self._attribute(path)
        self.at += 1
        self.channels = self._pixels()
        del self.data

    def has(self, layer):
        return any(name.startswith(layer) for name in self.channels)

    def colours(self, layer=""):
        return numpy.stack([self.channels[layer + c] for c in "RGB"], axis=2).astype(float)

    def _word(self):
        end = self.data.index(b"\0", self.at)
        word, self.at = self.data[self.at:end].decode("utf-8", "replace"), end + 1
        return word

    def _attribute(self, path):
        name, kind = self._word(), self._word()
        length, = struct.unpack_from("<i", self.data, self.at)
        value = self.data[self.at + 4:self.at + 4 + length]
        self.at += 4 + length
        if kind == "string":
            self.texts[name] = value.decode("utf-8", "replace")
        elif name == "dataWindow":
            low_x, low_y, high_x, high_y = struct.unpack("<4i", value)
            self.size = high_x - low_x + 1, high_y - low_y + 1
        elif name == "channels":
            while value[0]:
                end = value.index(b"\0")
                self.names.append(value[:end].decode("ascii"))
                if struct.unpack_from("<i", value, end + 1)[0] != FLOAT:
                    raise SystemExit("%s: %s is not of 32-bit floats" % (path, self.names[-1]))
                value = value[end + 17:]
        elif name == "compression" and value[0] != ZIP:
            raise SystemExit("%s: its compression is not ZIP" % path)

    def _pixels(self):
        width, height = self.size
        planes = numpy.empty((len(self.names), height, width), numpy.float32)
        for top in range(0, height, ROWS):
            offset, = struct.unpack_from("<Q", self.data, self.at + 8 * (top // ROWS))
            length, = struct.unpack_from("<i", self.data, offset + 4)
            rows = min(ROWS, height - top)
            block = _unpacked(self.data[offset + 8:offset + 8 + length], 4 * planes[:, :rows, 0].size * width)
            planes[:, top:top + rows] = block.view("<f4").reshape(rows, len(self.names), width).transpose(1, 0, 2)
        return dict(zip(self.names, planes))


def _unpacked(packed, size):
    """ZIP's bytes are differences of neighbours, the even ones first. Blocks that would have grown are as they were."""
    if len(packed) == size:
        return numpy.frombuffer(packed, numpy.uint8)
    steps = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).astype(numpy.int64)
    steps[1:] -= 128
    halves = numpy.cumsum(steps).astype(numpy.uint8)
    whole = numpy.empty(size, numpy.uint8)
    whole[0::2], whole[1::2] = halves[:(size + 1) // 2], halves[(size + 1) // 2:]
    return whole
