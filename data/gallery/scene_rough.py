"""Spheres from rough to smooth, of metal and of plastic, under two softboxes."""
import math

from mesh import Surface
from pictures import png_bytes, srgb_bytes
from rooms import slab
from solids import beveled_box, sphere

COUNT = 6


def squares(size=64):
    rows = []
    for j in range(size):
        row = bytearray()
        for i in range(size):
            row += srgb_bytes((0.5, 0.5, 0.48) if (2 * i // size + 2 * j // size) % 2 else (0.16, 0.17, 0.19))
        rows.append(bytes(row))
    return png_bytes(size, size, rows)


def stage(model):
    """A floor that bends up into the wall behind."""
    profile = [(7.0, 0.0), (-2.0, 0.0)]
    profile += [(-2.0 - 1.6 * math.sin(a), 1.6 - 1.6 * math.cos(a))
                for a in (math.pi / 2 * k / 24 for k in range(1, 25))]
    profile += [(-3.6, 7.0)]
    surface = Surface()
    surface.grid([[(x, y, z) for x in (-10.0, 10.0)] for z, y in profile])
    model.add(surface.shaded(30, lambda p, n: (p[0] / 1.2, (p[2] - p[1]) / 1.2)), "stage")


def build(model):
    model.material("stage", (1, 1, 1), roughness=1.0, texture=model.texture(squares()), double_sided=True)
    model.material("step", (0.28, 0.29, 0.31), roughness=1.0)
    for name in ("left panel", "right panel"):
        model.material(name, (0.0, 0.0, 0.0), roughness=1.0)
    stage(model)
    model.add(beveled_box((-2.9, 0.0, -1.25), (2.9, 0.5, -0.35), 0.015).shaded(20), "step")
    for k in range(COUNT):
        roughness, x = 1 - k / (COUNT - 1), 0.92 * (k - (COUNT - 1) / 2)
        metal = model.material(f"gold {k}", (1.0, 0.71, 0.29), metallic=1.0, roughness=roughness)
        plastic = model.material(f"plastic {k}", (0.5, 0.025, 0.03), roughness=roughness)
        model.add(sphere(0.4, 128, 64, (x, 0.9, -0.8)).shaded(60), metal)
        model.add(sphere(0.4, 128, 64, (x, 0.4, 0.25)).shaded(60), plastic)
    slab(model, (-4.6, 1.2, 0.4), (-4.55, 3.8, 2.6), "left panel")
    slab(model, (4.2, 1.0, 1.6), (4.25, 3.8, 2.0), "right panel")
