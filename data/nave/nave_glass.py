"""Stained glass: panes in thin sheets between strips of lead."""
import math

from mesh import Surface
from solids import pointed_arc

TINTS = {
    "glass_blue": (0.06, 0.16, 0.75), "glass_ruby": (0.8, 0.05, 0.06), "glass_amber": (0.95, 0.6, 0.1),
    "glass_green": (0.12, 0.6, 0.2), "glass_violet": (0.4, 0.1, 0.6), "glass_pale": (0.85, 0.88, 0.8),
}
APSE = ["glass_blue"] * 5 + ["glass_ruby"] * 3 + ["glass_amber", "glass_violet"]
AISLE = ["glass_pale"] * 7 + ["glass_amber"] * 2 + ["glass_green", "glass_blue"]


class Sheet:
    """Gathers panes by tint, and the lead between them, of one flat or bent window."""

    def __init__(self, place):
        self.place = place
        self.parts = {}

    def quad(self, material, corners):
        part = self.parts.setdefault(material, Surface())
        part.quad(*(part.vertex(self.place(*c)) for c in corners))

    def pane(self, material, corners, lead=0.012):
        """The pane's quad shrunk by `lead`, framed by four strips of lead."""
        cx, cy = (sum(c[k] for c in corners) / 4 for k in (0, 1))
        inner = []
        for x, y in corners:
            n = math.hypot(x - cx, y - cy)
            s = max(0.3, 1 - 1.4 * lead / n)
            inner.append((cx + (x - cx) * s, cy + (y - cy) * s))
        self.quad(material, inner)
        for k in range(4):
            m = (k + 1) % 4
            self.quad("lead", [corners[k], corners[m], inner[m], inner[k]])


def lancet_glass(sheet, half, sill, springing, columns, rows, tints):
    """Rows of panes up to the springing, then columns that run into the arch."""
    height = pointed_arc(half, 1.25)
    us = [half * (2 * k / columns - 1) for k in range(columns + 1)]

    def tint(i, j):
        """A border of one colour, a field mirrored about the middle."""
        return tints[(3 * min(i, columns - 1 - i) + 5 * j + j // 3) % len(tints)]

    for j in range(rows):
        y0, y1 = (sill + (springing - sill) * (j + k) / rows for k in (0, 1))
        for i in range(columns):
            sheet.pane(tint(i, j), [(us[i], y0), (us[i + 1], y0), (us[i + 1], y1), (us[i], y1)])
    head = 3
    for i in range(columns):
        a, b = us[i], us[i + 1]
        for j in range(head):
            f0, f1 = j / head, (j + 1) / head
            corners = [(a, springing + height(a) * f0), (b, springing + height(b) * f0),
                       (b, springing + height(b) * f1), (a, springing + height(a) * f1)]
            sheet.pane(tint(i, rows + j), corners)


def rose_glass(sheet, radius):
    """Three rings of panes about the hub."""
    rings = [(0.03, 0.24, 12, ["glass_amber"]), (0.24, 0.45, 24, ["glass_ruby", "glass_blue"]),
             (0.45, 0.66, 24, ["glass_blue", "glass_amber", "glass_blue", "glass_violet"]),
             (0.66, 0.84, 36, ["glass_blue", "glass_ruby", "glass_green"]),
             (0.84, 1.0, 36, ["glass_ruby", "glass_blue", "glass_blue"])]
    for r0, r1, count, tints in rings:
        for k in range(count):
            a, b = 2 * math.pi * k / count, 2 * math.pi * (k + 1) / count
            corners = [(radius * r * math.sin(t), radius * r * math.cos(t)) for r, t in
                       ((r0, b), (r0, a), (r1, a), (r1, b))]
            sheet.pane(tints[k % len(tints)], corners)


def add_glass(model):
    model.material("lead", (0.03, 0.03, 0.032), roughness=0.7)
    for name, colour in TINTS.items():
        model.material(name, colour, roughness=0.0, alpha=0.1)
    sheets = []
    for z in (-12.5, -7.5, -2.5, 2.5, 7.5, 12.5):
        for side in (1, -1):
            sheets.append(Sheet(lambda u, y, s=side, z=z: (s * 9.93, y, z + u)))
            lancet_glass(sheets[-1], 0.75, 1.75, 4.5, 4, 8, AISLE)
    for side in (1, -1):
        sheets.append(Sheet(lambda u, y, s=side: (s * 7.175 + u, y, -15.6)))
        lancet_glass(sheets[-1], 0.75, 1.75, 4.5, 4, 8, APSE)
    for degrees in (-72, -36, 0, 36, 72):
        a = math.radians(degrees)
        sheets.append(Sheet(lambda u, y, s=math.sin(a),
                            c=math.cos(a): (4.2 * s + u * c, y, -15.5 - 4.2 * c + u * s)))
        lancet_glass(sheets[-1], 0.56, 2.4, 6.0, 4, 12, APSE)
    sheets.append(Sheet(lambda u, y: (u, 9.9 + y, 15.56)))
    rose_glass(sheets[-1], 2.3)
    for sheet in sheets:
        for material, part in sheet.parts.items():
            model.add(part.shaded(20), material)
